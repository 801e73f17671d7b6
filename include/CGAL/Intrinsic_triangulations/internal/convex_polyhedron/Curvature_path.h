// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVATURE_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVATURE_PATH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Metric_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Pyramid_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Radii.h>

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Follows pyramids whose curvatures at the apex are t times the curvatures of equal large radii
// (Bobenko and Izmestiev 2008). It starts at t = 1 and ends towards t = 0, where they form a
// convex polyhedron. In between, these curvatures are positive and less than the curvatures of the
// surface, and determine the radii.
class Curvature_path
{
  typedef Eigen::VectorXd Vector;

public:
  // The curvatures of `surface` are positive.
  explicit Curvature_path(const Metric_surface& surface)
    : m_surface(surface), m_metric_curvature(vector_of(surface.curvatures()))
  {
    start();
  }

  const Metric_surface& surface() const { return m_surface; }
  const Radii& radii() const { return m_radii; }
  double t() const { return m_t; }
  std::size_t newton_steps() const { return m_newton_steps; }

  // Goes on to `t`, as far as that is possible.
  void follow_to(double t)
  {
    for(double step = 1; m_t > t && step > least_step && m_newton_steps < most_steps;)
      step *= reach((std::max)(t, at(place_of(m_t) - step))) ? 2 : 0.5;
  }

private:
  static constexpr double least_step = 1e-6, greatest_start = 1e20;
  static constexpr int steps_of_Newton = 12;
  static constexpr std::size_t most_steps = 20000; // in all
  // This is the greatest error of curvatures, relative to their distance from the ends of their
  // range.
  static constexpr double curvature_error = 1e-5;

  static Vector vector_of(const std::vector<double>& x)
  {
    return Eigen::Map<const Vector>(x.data(), static_cast<Eigen::Index>(x.size()));
  }

  // With large radii the curvatures at the apex are nearly the curvatures of the surface.
  void start()
  {
    // With equal radii, a convex surface has a Delaunay triangulation.
    const std::size_t n = m_surface.mesh().num_vertices();
    if(!make_convex(m_surface, Radii(n, 1), flip_limit()))
      throw Numerical_error("rounding keeps the surface from becoming Delaunay");
    const double circumradius = greatest_circumradius();
    Apex_curvatures first{false, {}, {}};
    const auto is_start = [&] {
      return first.exist && (first.curvature.array() / m_metric_curvature.array()).minCoeff() > 0.5;
    };
    for(double factor = 2; factor < greatest_start && !is_start(); factor *= 2) {
      m_radii = Radii(n, factor * circumradius);
      first = apex_curvatures(m_surface, m_radii);
    }
    if(!is_start())
      throw Numerical_error("the vertices have no distances from an apex far away");
    m_first_curvature = first.curvature;
    m_history = {{1., m_radii}};
    m_rest_at_start =
      (std::max)(1e-14, (1 - m_first_curvature.array() / m_metric_curvature.array()).minCoeff());
  }

  double greatest_circumradius() const
  {
    double result = 0;
    for(Face_index f : m_surface.mesh().faces()) {
      const auto h = sides(f, m_surface.mesh());
      const Double_double a = m_surface.length(h[0]), b = m_surface.length(h[1]),
                          c = m_surface.length(h[2]);
      result = (std::max)(result, (a * b * c / quadrupled_area(a, b, c)).high());
    }
    return result;
  }

  // Steps are measured in a function of t that is logarithmic at both ends: at the beginning
  // 1 - t is the inverse square of radii.
  double place_of(double t) const { return std::log(t / (1 + m_rest_at_start - t)); }
  double at(double place) const
  {
    const double x = std::exp(place);
    return (1 + m_rest_at_start) * x / (1 + x);
  }

  // Returns the radii for `t` on a polynomial through the last ones.
  Radii prediction(double t) const
  {
    const bool are_large = t > 0.5;
    const auto place = [&](double s) { return are_large ? place_of(s) : s; };
    std::vector<const Radii*> radii;
    std::vector<double> factors;
    for(const auto& [s, at_s] : m_history) {
      radii.push_back(&at_s);
      factors.push_back(1);
      for(const auto& other : m_history)
        if(other.first != s)
          factors.back() *= (place(t) - place(other.first)) / (place(s) - place(other.first));
    }
    return Radii::mean_of(radii, factors, are_large);
  }

  // Returns whether it has reached the pyramids for `t`.
  bool reach(double t)
  {
    return (m_history.size() > 1 && reach(t, prediction(t))) || reach(t, m_radii);
  }

  // Newton's method, with the logarithms of radii as variables.
  bool reach(double t, Radii radii)
  {
    Metric_surface surface = m_surface;
    double before = std::numeric_limits<double>::infinity();
    const Vector target = t * m_first_curvature;
    const Vector range = target.array().min(m_metric_curvature.array() - target.array()).max(1e-18);
    for(int step = 0; step < steps_of_Newton; ++step) {
      if(!radii.are_positive() || !make_convex(surface, radii, flip_limit()))
        return false;
      const Apex_curvatures current = apex_curvatures(surface, radii);
      ++m_newton_steps;
      if(!current.exist)
        return false;
      const Vector rest = target - current.curvature;
      const double error = (rest.array().abs() / range.array()).maxCoeff();
      if(error < curvature_error)
        return keep(t, surface, radii);
      if(!(error < before) && step > 2)
        return false;
      before = error;
      const Vector change = newton_step(current, radii, rest);
      if(!change.allFinite())
        return false;
      radii = radii.scaled(change);
    }
    return false;
  }

  std::size_t flip_limit() const { return 100 * std::size_t(m_surface.mesh().num_edges()); }

  bool keep(double t, const Metric_surface& surface, const Radii& radii)
  {
    m_surface = surface;
    m_radii = radii;
    m_t = t;
    m_history.emplace_back(t, radii);
    if(m_history.size() > 3)
      m_history.erase(m_history.begin());
    return true;
  }

  // Returns the changes of the logarithms of radii; not finite if there are none. The matrix is
  // indefinite.
  static Vector newton_step(const Apex_curvatures& current, const Radii& radii, const Vector& rest)
  {
    Vector radius(rest.size());
    for(Eigen::Index i = 0; i < rest.size(); ++i)
      radius[i] = radii.radius(static_cast<std::size_t>(i)).high();
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver;
    solver.compute(current.derivative * radius.asDiagonal());
    return solver.info() == Eigen::Success
             ? Vector(solver.solve(rest))
             : Vector::Constant(rest.size(), std::numeric_limits<double>::quiet_NaN());
  }

  Metric_surface m_surface;
  Vector m_metric_curvature, m_first_curvature;
  Radii m_radii;
  double m_t = 1, m_rest_at_start = 1;
  std::vector<std::pair<double, Radii>> m_history; // the last values of t, with their radii
  std::size_t m_newton_steps = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVATURE_PATH_H
