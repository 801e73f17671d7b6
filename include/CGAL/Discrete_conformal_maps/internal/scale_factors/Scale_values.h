// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_VALUES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_VALUES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/Map_status.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores scale factors with all their digits, and the end of their search.
struct Scale_state
{
  Eigen::VectorXd m_u;
  std::variant<std::vector<double>, std::vector<Double_double>, std::vector<Decimal_115>> m_precise;
  bool m_is_wide = false;
  Minimization_result m_result;
  Map_status m_status = Map_status::success;
  bool m_has_layout = true;
  double m_max_curvature_error = 0;
  double m_rounding_error = 0; // of the curvatures
};

// Returns the greatest difference of logarithmic scale factors.
template <typename Range>
double spread(const Range& log_scale)
{
  if(log_scale.size() == 0)
    return 0;
  const auto [least, greatest] = std::minmax_element(log_scale.begin(), log_scale.end());
  return static_cast<double>(*greatest - *least);
}

// Returns whether logarithmic scale factors differ so much that products of lengths may be beyond
// the range of `double`.
template <typename Range>
bool are_far_apart(const Range& log_scale)
{
  return spread(log_scale) > tolerance::narrow_log_scales;
}

// Represents scale factors at the vertices of the surface of a doubled problem.
class Scale_values : protected Scale_state
{
public:
  typedef Eigen::VectorXd Vector;

  // Returns the scale factors, rounded to `double`.
  const Vector& values() const { return m_u; }
  // Returns whether scale factors have more digits, because `double` has too few.
  bool is_extended() const { return m_precise.index() > 0; }
  // Returns whether `Double_double` has too few digits.
  bool has_115_digits() const { return m_precise.index() > 1; }
  // Returns whether lengths with these scale factors may be beyond the range of `double`.
  bool is_wide() const { return m_is_wide; }
  // Returns the scale factors as `Double_double` or `Decimal_115`, with the available digits.
  template <typename FT>
  std::vector<FT> precise_values() const
  {
    std::vector<FT> result(m_u.begin(), m_u.end());
    std::visit(
      [&](const auto& u) {
        for(std::size_t v = 0; v < u.size(); ++v)
          if(!m_problem.is_fixed()[v])
            result[v] = converted<FT>(u[v]);
      },
      m_precise);
    return result;
  }

  const Minimization_result& result() const { return m_result; }
  // Returns the greatest error of vertices with prescribed curvatures.
  double max_curvature_error() const { return m_max_curvature_error; }
  Map_status status() const { return m_status; }
  // Records that a numerical error has ended the search.
  void stop() { m_status = Map_status::not_converged; }
  // Returns whether all faces satisfy the triangle inequality, up to rounding.
  bool has_layout() const { return m_has_layout; }

  void start_from(const std::vector<double>& log_scale)
  {
    m_u = Eigen::Map<const Vector>(log_scale.data(), m_u.size());
    m_precise = std::vector<double>();
  }

protected:
  Scale_values(Doubled_problem& problem, const Vector& start) : m_problem(problem) { m_u = start; }

  Scale_state& state() { return *this; }

  // Returns whether scale factors differ so much that intermediate lengths may be beyond the range
  // of `double`.
  bool is_beyond_range() const
  {
    return m_problem.flipping() == Flipping::to_Delaunay && !has_115_digits() && are_far_apart(m_u);
  }

  // Stores the scale factors of an energy, rounded to `double`, and measures their errors.
  template <typename Energy>
  void note_values(const Energy& energy)
  {
    m_max_curvature_error = 0;
    const Vector bends = m_problem.bends();
    m_rounding_error = energy.gradient_error();
    for(std::size_t v = 0; v < m_problem.size(); ++v) {
      const auto i = static_cast<Eigen::Index>(v);
      m_u[i] = static_cast<double>(energy.scale_factor(v));
      if(!m_problem.is_fixed()[v])
        m_max_curvature_error = greater_error(
          m_max_curvature_error, std::abs(energy.gradient()[i] + m_problem.part(v) * bends[i]));
    }
  }

  template <typename FT>
  void note_rounded(const std::vector<FT>& u)
  {
    for(std::size_t v = 0; v < u.size(); ++v)
      m_u[Eigen::Index(v)] = static_cast<double>(u[v]);
  }

  // Stores scale factors with all their digits.
  template <typename FT>
  void store(const std::vector<FT>& u)
  {
    typedef std::conditional_t<std::is_same_v<FT, Decimal_115>, FT, Double_double> Precise;
    std::vector<Precise> result;
    for(const FT& x : u)
      result.push_back(converted<Precise>(x));
    m_precise = std::move(result);
  }

  // Returns whether the error is within `tolerance`, where rounding counts, too.
  bool is_within(double tolerance) const
  {
    return m_max_curvature_error <= tolerance && m_result.gradient_error <= tolerance;
  }

  // Returns whether more digits might reach the tolerance. Returns false if the minimizer accepted
  // a greater error, or must not continue.
  bool is_rounded(double tolerance) const
  {
    const bool has_been_stopped = m_result.status != Minimization_status::converged &&
                                  m_result.status != Minimization_status::iteration_limit;
    return m_result.gradient_error > tolerance ||
           (m_max_curvature_error > tolerance && has_been_stopped);
  }

  // Returns whether no solution exists. In a fixed triangulation, reasons other than rounding may
  // stop the minimization.
  bool has_no_solution() const
  {
    return m_status == Map_status::no_minimum ||
           (m_status == Map_status::triangle_inequality &&
            m_result.status == Minimization_status::iteration_limit);
  }

  bool needs_digits(double tolerance) const { return is_rounded(tolerance) && !has_no_solution(); }
  bool needs_most_digits(double tolerance) const
  {
    return m_problem.has_precise_lengths() && needs_digits(tolerance);
  }

  // Returns whether a solution exists that the minimizer has not found, unless it must not
  // continue.
  bool is_lost(double tolerance) const
  {
    return m_problem.flipping() == Flipping::to_Delaunay && !m_problem.has_radii() &&
           !is_within(tolerance) && m_status == Map_status::not_converged &&
           m_problem.is_balanced() &&
           (m_result.status != Minimization_status::iteration_limit ||
            m_result.iterations >= tolerance::steps_to_lose_the_way);
  }

  // Returns whether a search has ended far from a solution, at a point whose angles are known.
  bool is_far_off(double tolerance) const
  {
    return is_lost(tolerance) && m_max_curvature_error > tolerance::lost_curvature &&
           std::isfinite(m_max_curvature_error);
  }

  // Returns whether the error of curvatures moves no side in the plane by more than promised.
  bool can_be_laid_out(const Doubled_problem::Triangulation& triangulation) const
  {
    const auto [shortest, longest] = range_of_lengths(triangulation);
    return (std::max)(m_max_curvature_error, m_rounding_error) * longest <=
           tolerance::promised_length * shortest;
  }

  Doubled_problem& m_problem;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_VALUES_H
