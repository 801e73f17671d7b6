// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVATURE_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVATURE_PATH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Metric_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Pyramid_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Radii.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Follows pyramids whose curvatures at the apex are t times the curvatures of equal large radii
// (Bobenko and Izmestiev 2008). It starts at t = 1 and ends towards t = 0, where they form a convex
// polyhedron. On the path, the curvatures at the apex are positive and less than the curvatures of
// the surface, and they determine the radii.
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
  double t() const { return at(m_place).t; }
  std::size_t newton_steps() const { return m_newton_steps; }

  // Continues to `t`, or as far as possible.
  void follow_to(double t)
  {
    const double end = std::log(t / (1 + m_rest_at_start - t));
    const auto least = [&] { return at(m_place).t < late ? least_late_step : least_step; };
    for(double step = 1; m_place > end && step > least() && m_newton_steps < most_steps;)
      step *= reach((std::max)(end, m_place - step)) ? 2 : 0.5;
  }

private:
  static constexpr double least_step = 1e-6, greatest_start = 1e20, least_rest = 1e-30;
  // Positions can be corrected afterwards if few digits are left for t.
  static constexpr double late = 1e-3, least_late_step = 0.01;
  // Predictions fail if derivatives jump. Steps without predictions are short.
  static constexpr double small_step = 0.01;
  static constexpr std::size_t most_predicting = 5;
  static constexpr int steps_of_Newton = 12;
  static constexpr std::size_t most_steps = 20000; // of the whole path
  // Errors of curvatures are relative to the distance of the curvatures from the ends of their
  // range.
  static constexpr double curvature_error = 1e-5, greatest_curvature_error = 0.03;

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
      throw Numerical_error("rounding prevents a Delaunay triangulation");
    const double circumradius = greatest_circumradius();
    const auto least_part = [&](const Vector& x) {
      return (x.array() / m_metric_curvature.array()).minCoeff();
    };
    bool is_start = false;
    for(double factor = 2; factor < greatest_start && !is_start; factor *= 2) {
      m_radii = Radii(n, factor * circumradius);
      const Apex_curvatures first = apex_curvatures(m_surface, m_radii);
      if(!first.exist)
        continue;
      m_first_curvature = first.curvature_minus(Vector::Zero(m_metric_curvature.size()));
      m_first_excess = first.excess_minus(Vector::Zero(m_metric_curvature.size()));
      is_start = least_part(m_first_curvature) > 0.5;
    }
    if(!is_start)
      throw Numerical_error("the vertices have no distances from an apex far away");
    m_rest_at_start = (std::max)(least_rest, least_part(m_first_excess));
    m_place = -std::log(m_rest_at_start);
    m_history = {{m_place, m_radii}};
  }

  double greatest_circumradius() const
  {
    double result = 0;
    for(Face_index f : m_surface.mesh().faces())
      result = (std::max)(result, Face_metric<Double_double>(f, m_surface).circumradius().high());
    return result;
  }

  struct Fraction
  {
    double t, rest; // and 1 - t
  };

  // A position on the path is a function of t that is logarithmic at both ends. At the beginning
  // 1 - t is the inverse square of radii.
  Fraction at(double place) const
  {
    const double x = std::exp(place), all = 1 + m_rest_at_start;
    return {all * x / (1 + x), all / (1 + x) - m_rest_at_start};
  }

  // Returns the radii at a position, extrapolated by a polynomial through the last radii.
  Radii prediction(double place) const
  {
    const bool are_large = at(place).t > 0.5;
    const auto variable = [&](double p) { return are_large ? p : at(p).t; };
    std::vector<const Radii*> radii;
    std::vector<double> factors;
    for(const auto& [p, at_p] : m_history) {
      radii.push_back(&at_p);
      factors.push_back(1);
      for(const auto& other : m_history)
        if(other.first != p)
          factors.back() *=
            (variable(place) - variable(other.first)) / (variable(p) - variable(other.first));
    }
    return Radii::mean_of(radii, factors, are_large);
  }

  // Returns whether the path has reached the pyramids for a position.
  bool reach(double place)
  {
    const bool is_predicted = m_history.size() > 1 && reach(place, prediction(place));
    return is_predicted ||
           ((m_history.size() == 1 || m_place - place < small_step) && reach(place, m_radii));
  }

  // Takes steps of Newton's method, with the logarithms of radii as variables.
  bool reach(double place, Radii radii)
  {
    Metric_surface surface = m_surface;
    double before = std::numeric_limits<double>::infinity();
    const Fraction fraction = at(place);
    const Vector target = fraction.t * m_first_curvature,
                 target_excess = m_first_excess + fraction.rest * m_first_curvature,
                 range = target.array().min(target_excess.array());
    for(int step = 0; step < steps_of_Newton; ++step) {
      if(!radii.are_positive() || !make_convex(surface, radii, flip_limit()))
        return false;
      const Apex_curvatures current = apex_curvatures(surface, radii);
      ++m_newton_steps;
      if(!current.exist)
        return false;
      const Vector rest = fraction.t > 0.5 ? current.excess_minus(target_excess)
                                           : Vector(-current.curvature_minus(target));
      const double error = (rest.array().abs() / range.array()).maxCoeff();
      const bool is_best = !(error < before) && step > 2; // rounding prevents progress
      if(error < (is_best && fraction.t < late ? greatest_curvature_error : curvature_error))
        return keep(place, surface, radii);
      if(is_best)
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

  bool keep(double place, const Metric_surface& surface, const Radii& radii)
  {
    m_surface = surface;
    m_radii = radii;
    m_place = place;
    m_history.emplace_back(place, radii);
    if(m_history.size() > most_predicting)
      m_history.erase(m_history.begin());
    return true;
  }

  // Returns the changes of the logarithms of radii. They are not finite if the equations have no
  // solution. The matrix is indefinite.
  static Vector newton_step(const Apex_curvatures& current, const Radii& radii, const Vector& rest)
  {
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<Double_double>, Eigen::Upper> solver;
    solver.compute(current.derivative);
    if(solver.info() != Eigen::Success)
      return Vector::Constant(rest.size(), std::numeric_limits<double>::quiet_NaN());
    const auto changes = solver.solve(rest.cast<Double_double>()).eval();
    Vector result(rest.size());
    for(Eigen::Index i = 0; i < rest.size(); ++i)
      result[i] = (changes[i] / radii.radius(static_cast<std::size_t>(i))).high();
    return result;
  }

  Metric_surface m_surface;
  Vector m_metric_curvature, m_first_curvature, m_first_excess;
  Radii m_radii;
  double m_place = 0, m_rest_at_start = 1;
  std::vector<std::pair<double, Radii>> m_history; // the last positions, with their radii
  std::size_t m_newton_steps = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVATURE_PATH_H
