// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONFORMAL_BARYCENTER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONFORMAL_BARYCENTER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the point of hyperbolic space that balances masses at infinity: the weighted sum of the
// directions to the masses vanishes (Baden et al. 2018). One mass is at infinity of the upper
// half-space. All other masses lie in the boundary plane of the half-space.
//
// Newton's method minimizes the weighted sum of the distances to horospheres, which is convex
// along geodesics. A step starts at the center of the sphere of directions. After each step, the
// plane is shifted and scaled such that the current point becomes the center.
template <typename FT>
class Conformal_barycenter
{
  typedef Eigen::Vector3d Vector;

public:
  typedef std::array<FT, 2> Point;

  // Computes the barycenter. Complexity: linear in the number of masses for each iteration. The
  // number of iterations is about five plus at most the hyperbolic distance from the start to the
  // result.
  // \throws Numerical_error if the iteration does not converge because of rounding
  // \pre no mass is half of all masses or more
  Conformal_barycenter(const std::vector<Point>& position, const std::vector<double>& mass,
                       std::size_t at_infinity)
    : m_position(position), m_mass(mass), m_at_infinity(at_infinity), m_direction(mass.size())
  {
    double total = 0;
    for(const double m : mass)
      total += m;
    for(double& m : m_mass)
      m /= total;
    start();
    for(int i = 0; i < iteration_limit; ++i)
      if(iterate())
        return;
    throw Intrinsic_triangulations::Numerical_error("the center of the sphere cannot be found");
  }

  // Returns the point of the plane below the barycenter.
  const Point& base() const { return m_base; }
  const FT& height() const { return m_height; }

  // Returns the position of `p` after the plane has been shifted and scaled such that the
  // barycenter is at height one above the origin.
  Point centered(const Point& p) const
  {
    return {(p[0] - m_base[0]) / m_height, (p[1] - m_base[1]) / m_height};
  }

private:
  static constexpr double longest_step = 8;
  // The limit of iterations grows with the number of digits of `FT`.
  static constexpr int iteration_limit = 10 * (std::numeric_limits<FT>::digits10 + 100);

  // Sets the start above the mean of the masses, at the mean distance from them.
  void start()
  {
    m_base = {FT(0), FT(0)};
    m_height = 1;
    FT total(0);
    for_each_finite([&](std::size_t v) {
      total += FT(m_mass[v]);
      for(std::size_t c = 0; c < 2; ++c)
        m_base[c] += FT(m_mass[v]) * m_position[v][c];
    });
    m_base = {m_base[0] / total, m_base[1] / total};
    FT distance(0);
    for_each_finite([&](std::size_t v) {
      using std::abs;
      for(std::size_t c = 0; c < 2; ++c)
        distance += FT(m_mass[v]) * abs(m_position[v][c] - m_base[c]);
    });
    if(distance > 0)
      m_height = distance / total;
  }

  // Makes one step. Returns whether it was the last one.
  bool iterate()
  {
    Vector sum = Vector::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    for(std::size_t v = 0; v < m_mass.size(); ++v) {
      const Vector p = m_direction[v] = direction(v);
      sum += m_mass[v] * p;
      hessian += m_mass[v] * (Eigen::Matrix3d::Identity() - p * p.transpose());
    }
    // If an iteration that converges quadratically makes no progress, rounding of the point limits
    // it.
    const double last = std::exchange(m_norm, sum.norm());
    if(m_norm <= tolerance::center || (m_norm <= tolerance::near_center && m_norm > last / 2))
      return true;
    // If all masses lie in two points, the energy has no curvature along the line through both
    // points.
    hessian += tolerance::least_curvature * Eigen::Matrix3d::Identity();
    const Vector step = hessian.ldlt().solve(sum);
    const double length = step.norm();
    move(step / length, step_length(step / length, (std::min)(length, longest_step)));
    return false;
  }

  template <typename Function>
  void for_each_finite(const Function& function) const
  {
    for(std::size_t v = 0; v < m_mass.size(); ++v)
      if(v != m_at_infinity)
        function(v);
  }

  // Returns the direction of `v` as seen from the center. Infinity is below.
  Vector direction(std::size_t v) const
  {
    if(v == m_at_infinity)
      return -Vector::UnitZ();
    typedef Difference_of<FT> Number;
    const Number height = converted<Number>(m_height);
    const Number x = converted<Number>(FT(m_position[v][0] - m_base[0])) / height,
                 y = converted<Number>(FT(m_position[v][1] - m_base[1])) / height;
    const Number square = x * x + y * y, scale = 1 / (1 + square);
    return {static_cast<double>(2 * x * scale), static_cast<double>(2 * y * scale),
            static_cast<double>((1 - square) * scale)};
  }

  // Returns the slope of the energy at parameter `t` of the geodesic with unit direction `d`.
  double slope(const Vector& d, double t) const
  {
    double result = 0;
    const double c = std::cosh(t), s = std::sinh(t);
    for(std::size_t v = 0; v < m_mass.size(); ++v) {
      const double a = m_direction[v].dot(d);
      result += m_mass[v] * (s - c * a) / (c - s * a);
    }
    return result;
  }

  // Returns the length of the step. Beyond the minimum along the geodesic, a length is accepted
  // only if the slope is at most half of the initial slope.
  double step_length(const Vector& d, double t) const
  {
    const double first = slope(d, 0);
    for(int trial = 0; trial < 40; ++trial) {
      const double last = slope(d, t);
      if(last <= -first / 2 || last <= tolerance::center)
        break;
      t *= (std::max)(0.1, first / (first - last));
    }
    return t;
  }

  void move(const Vector& d, double t)
  {
    const double r = std::tanh(t / 2), c = std::cosh(t / 2);
    const double to_infinity = (r * d + Vector::UnitZ()).squaredNorm();
    for(std::size_t i = 0; i < 2; ++i)
      m_base[i] += m_height * FT(2 * r * d[Eigen::Index(i)] / to_infinity);
    m_height *= FT(1 / (c * c * to_infinity));
  }

  const std::vector<Point>& m_position;
  std::vector<double> m_mass; // the masses, whose sum is one
  std::size_t m_at_infinity;
  std::vector<Vector> m_direction;
  Point m_base;
  FT m_height;
  double m_norm = 1; // the norm of the sum of directions
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONFORMAL_BARYCENTER_H
