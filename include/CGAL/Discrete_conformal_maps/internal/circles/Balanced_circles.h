// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_BALANCED_CIRCLES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_BALANCED_CIRCLES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores circles on the unit sphere. The circle with center p and angular radius R is represented
// by the vector (p / cos R, 1) of Minkowski space. Circles that are much smaller than the sphere
// need a number type with enough digits to distinguish their centers.
template <typename FT>
class Balanced_circles
{
public:
  typedef std::array<FT, 3> Point;

  // `mass` contains the mass of each vertex. `log_scale` and `position` describe the sphere for
  // radii of zero.
  explicit Balanced_circles(std::vector<double> mass, std::vector<Double_double> log_scale = {},
                            std::vector<Point> position = {})
    : m_mass(std::move(mass)), m_log_scale(std::move(log_scale)), m_pole(std::move(position))
  {
    double total = 0;
    for(const double m : m_mass)
      total += m;
    for(double& m : m_mass)
      m /= total;
  }

  void assign(std::vector<Double_double> log_scale, const std::vector<FT>& radii,
              std::vector<Point> position)
  {
    m_log_scale = std::move(log_scale);
    m_pole = std::move(position);
    for(std::size_t v = 0; v < radii.size(); ++v)
      m_pole[v] = times(m_pole[v], sqrt(1 + radii[v] * radii[v]));
  }

  const std::vector<double>& mass() const { return m_mass; }
  const std::vector<Double_double>& log_scale() const { return m_log_scale; }
  // Returns the point p / cos R, which is the pole of the plane of the circle.
  const Point& pole(Vertex_index v) const { return m_pole[v.idx()]; }
  // Returns the center of a circle.
  Point position(Vertex_index v) const { return times(pole(v), 1 / norm(pole(v))); }

  // Moves the center of mass of the centers to the center of the sphere. The condition determines
  // a minimum of the sum of distances to the planes of the circles, which is convex in hyperbolic
  // space. A move ends early if a circle would otherwise reach the size of a hemisphere.
  void balance()
  {
    std::vector<Double_double> shrinkage(m_pole.size(), Double_double(1));
    for(int i = 0; i < most_steps && balance_step(shrinkage); ++i) {
    }
    shrink(shrinkage);
  }

  // Moves a plane at this hyperbolic distance from the center to the center. Its normal vector has
  // nearly the unit length.
  void move_plane_to_center(const Eigen::Vector3d& normal, double distance)
  {
    std::vector<Double_double> shrinkage(m_pole.size(), Double_double(1));
    move(normal, distance, shrinkage);
    shrink(shrinkage);
  }

  // Applies the orthogonal map whose matrix has these rows.
  void rotate(const std::array<Point, 3>& row)
  {
    for(Point& q : m_pole)
      q = {dot(row[0], q), dot(row[1], q), dot(row[2], q)};
  }

  static FT dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static FT norm(const Point& a) { return sqrt(dot(a, a)); }
  static Point times(const Point& a, const FT& x) { return {x * a[0], x * a[1], x * a[2]}; }

private:
  static constexpr double longest_step = 1, least_cosine = 0.05;
  static constexpr int most_steps = 200;

  void shrink(const std::vector<Double_double>& shrinkage)
  {
    for(std::size_t v = 0; v < shrinkage.size(); ++v)
      m_log_scale[v] -= log(shrinkage[v]);
  }

  static Eigen::Vector3d rounded(const Point& q)
  {
    return {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2])};
  }

  // Makes one step of `balance()`, and multiplies the factors by which circles have shrunk by
  // theirs. Returns whether a step has been necessary.
  bool balance_step(std::vector<Double_double>& shrinkage)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d Hessian = tolerance::least_curvature * Eigen::Matrix3d::Identity();
    for(std::size_t v = 0; v < m_mass.size(); ++v) {
      const Eigen::Vector3d q = rounded(m_pole[v]), p = q.normalized();
      sum += m_mass[v] * p;
      Hessian += m_mass[v] / q.norm() * (Eigen::Matrix3d::Identity() - p * p.transpose());
    }
    const Eigen::Vector3d step = Hessian.ldlt().solve(sum);
    double length = (std::min)(longest_step, step.norm());
    while(length > tolerance::center && !can_move(step.normalized(), length))
      length /= 2;
    if(!(length > tolerance::center))
      return false;
    move(step.normalized(), length, shrinkage);
    return true;
  }

  // Returns whether all circles stay smaller than a hemisphere if the point at this distance
  // becomes the center.
  bool can_move(const Eigen::Vector3d& direction, double length) const
  {
    return std::all_of(m_pole.begin(), m_pole.end(), [&](const Point& q) {
      const Eigen::Vector3d p = rounded(q);
      const double time = std::cosh(length) - std::sinh(length) * direction.dot(p),
                   squared_radius = p.squaredNorm() - 1;
      return time > 0 && time * time > squared_radius * (least_cosine * least_cosine);
    });
  }

  void move(const Eigen::Vector3d& direction, double length, std::vector<Double_double>& shrinkage)
  {
    const Point d{direction[0], direction[1], direction[2]};
    const FT x = FT(length), e = exp(x), cosh = (e + 1 / e) / 2, unit = dot(d, d),
             sinh = (e - 1 / e) / 2 / sqrt(unit), along_factor = (cosh - 1) / unit;
    for(std::size_t v = 0; v < m_pole.size(); ++v) {
      Point& q = m_pole[v];
      const FT along = dot(d, q), time = cosh - sinh * along, shift = along_factor * along - sinh,
               inverse = 1 / time;
      for(std::size_t c = 0; c < 3; ++c)
        q[c] = inverse * (q[c] + shift * d[c]);
      shrinkage[v] *= converted<Double_double>(time);
    }
  }

  std::vector<double> m_mass; // the masses, whose sum is one
  std::vector<Double_double> m_log_scale;
  std::vector<Point> m_pole;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_BALANCED_CIRCLES_H
