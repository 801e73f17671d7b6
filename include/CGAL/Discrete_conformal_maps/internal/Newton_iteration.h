// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_NEWTON_ITERATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_NEWTON_ITERATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/Newton_direction.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

// When a minimization ends.
struct Minimization_limits
{
  double gradient_tolerance;
  std::size_t iterations;
};

// One run of Newton's method. The best point seen is always in the caller's hands.
template <typename Energy, typename Visitor>
class Newton_iteration
{
public:
  Newton_iteration(Energy& energy, Eigen::VectorXd& best, const Free_variables& variables,
                   const Minimization_limits& limits, Visitor& visitor)
    : m_energy(energy),
      m_best(best),
      m_variables(variables),
      m_limits(limits),
      m_visitor(visitor),
      m_point(best),
      m_direction(variables)
  {}

  Minimization_result run()
  {
    m_result.status = minimize();
    if(m_point != m_best)
      move_to(m_best);
    m_result.factorizations = m_direction.solver().factorizations();
    m_result.symbolic_analyses = m_direction.solver().symbolic_analyses();
    m_result.orderings = m_direction.solver().orderings();
    m_result.gradient_norm = m_norm;
    m_result.gradient_error = (std::max)(m_energy.gradient_error(), m_largest_error);
    return m_result;
  }

private:
  typedef Minimization_status Status;

  Status minimize()
  {
    if(!move_to(m_point))
      return Status::not_finite;
    if(m_excess > tolerance())
      return Status::unbounded;
    m_best_norm = m_norm;
    while(m_norm > tolerance()) {
      if(m_result.iterations == m_limits.iterations)
        return Status::iteration_limit;
      if(const std::optional<Status> end = iterate())
        return *end;
    }
    polish();
    return Status::converged;
  }

  double tolerance() const
  {
    return (std::max)(m_limits.gradient_tolerance, m_energy.gradient_error());
  }

  // Returns false if the gradient is not finite there.
  bool move_to(const Eigen::VectorXd& point)
  {
    m_energy.evaluate(point);
    ++m_result.evaluations;
    m_gradient = m_energy.gradient();
    m_variables.set_fixed_to_zero(m_gradient);
    m_norm = Newton_direction::max_norm(m_gradient);
    m_excess = m_variables.remove_means(m_gradient);
    return m_gradient.allFinite();
  }

  // Takes a step; returns the status if that was the last.
  std::optional<Status> iterate()
  {
    const Eigen::SparseMatrix<double>& hessian = m_energy.Hessian();
    if(!hessian.coeffs().allFinite())
      return Status::not_finite;
    if(!m_direction.find(hessian, m_gradient, m_bound))
      return Status::no_descent;
    m_base = m_point;
    m_base_slope = slope();
    const double noise = rounding_error(hessian).dot(m_direction.direction().cwiseAbs());
    const std::optional<Status> end =
      -m_base_slope > noise ? search_line() : step_within_rounding();
    if(!end)
      m_visitor.after_iteration(++m_result.iterations, m_norm, m_step * m_direction.length());
    return end;
  }

  double slope() const { return m_gradient.dot(m_direction.direction()); }

  // For each entry of the gradient: the error of its computation and that of the rounding of the point.
  Eigen::VectorXd rounding_error(const Eigen::SparseMatrix<double>& hessian)
  {
    const double unit = std::numeric_limits<double>::epsilon() / 2;
    Eigen::VectorXd error = unit * (hessian.cwiseAbs() * m_point.cwiseAbs());
    error.array() += m_energy.gradient_error();
    m_variables.set_fixed_to_zero(error);
    m_largest_error = Newton_direction::max_norm(error);
    return error;
  }

  bool step(double t)
  {
    m_step = t;
    m_point = m_base + t * m_direction.direction();
    return move_to(m_point);
  }

  // The slope along a line grows from a negative value at its start. A step is good if it does not go
  // beyond the minimum by so much that the slope is half of that again.
  std::optional<Status> search_line()
  {
    bool is_finite = false;
    double t = 1;
    for(int trial = 0; trial < 40; ++trial) {
      is_finite = step(t);
      if(is_finite && slope() <= -m_base_slope / 2) {
        accept();
        return std::nullopt;
      }
      // the secant's zero
      t *= is_finite ? (std::max)(0.1, m_base_slope / (m_base_slope - slope())) : 0.1;
    }
    return is_finite ? Status::no_descent : Status::not_finite;
  }

  void accept()
  {
    if(m_step < 1)
      m_bound = 2 * m_step * m_direction.length();
    else if(m_direction.is_damped())
      m_bound = (std::min)(4 * m_bound, 1e100); // beyond any use, but finite
    keep_if_best();
  }

  // Slopes say little now, but the full step may well be good. Failures in a row are the end.
  std::optional<Status> step_within_rounding()
  {
    const double before = m_best_norm;
    const bool is_good = step(1) && keep_if_best();
    const bool goes_on = is_good || !search_line();
    m_failures = m_best_norm < before ? 0 : m_failures + 1;
    return goes_on && m_failures < 3 ? std::nullopt : std::optional(Status::rounding_limit);
  }

  bool keep_if_best()
  {
    if(!(m_norm <= m_best_norm))
      return false;
    const bool is_better = m_norm < m_best_norm;
    m_best = m_point;
    m_best_norm = m_norm;
    return is_better;
  }

  // Another step with the last factorization costs little.
  void polish()
  {
    if(m_result.iterations == 0 || m_direction.is_damped() || m_norm <= m_energy.gradient_error() ||
       !m_direction.find_again(m_gradient))
      return;
    m_base = m_point;
    if(step(1))
      keep_if_best();
  }

  Energy& m_energy;
  Eigen::VectorXd& m_best;
  const Free_variables& m_variables;
  const Minimization_limits m_limits;
  Visitor& m_visitor;

  Eigen::VectorXd m_point;
  Eigen::VectorXd m_gradient; // at the point, without the part that no step can change
  double m_norm = 0;          // of the gradient, with that part
  double m_excess = 0;        // that part: the greatest mean
  double m_best_norm = 0;

  Newton_direction m_direction;
  double m_bound = 10; // of the length of steps where the Hessian is not to be trusted
  Eigen::VectorXd m_base;
  double m_base_slope = 0;
  double m_step = 0;
  double m_largest_error = 0;
  int m_failures = 0; // steps within rounding, in a row, that were not good
  Minimization_result m_result;
};

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_NEWTON_ITERATION_H
