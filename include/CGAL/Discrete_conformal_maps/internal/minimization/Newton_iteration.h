// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_NEWTON_ITERATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_NEWTON_ITERATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Abstract_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Descent.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Gradient_path.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_direction.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Discrete_conformal_maps::internal {

// Runs Newton's method once.
template <typename Energy, typename Visitor, typename Variables = Free_variables,
          typename Direction = Newton_direction>
class Newton_iteration
{
public:
  Newton_iteration(Energy& energy, Eigen::VectorXd& best, const Variables& variables,
                   const Minimization_limits& limits, Visitor& visitor)
    : m_descent(energy, best, variables, limits),
      m_visitor(visitor),
      m_direction(variables, Order_of_energy<Energy>::get(energy))
  {}

  Minimization_result run()
  {
    Minimization_result result = m_descent.result(minimize());
    result.iterations = m_iterations;
    result += m_direction.solver().counts();
    result.gradient_error = (std::max)(result.gradient_error, m_largest_error);
    return result;
  }

private:
  typedef Minimization_status Status;

  Status minimize()
  {
    if(const std::optional<Status> end = m_descent.start())
      return *end;
    while(!m_descent.has_converged()) {
      if(is_enough())
        return Status::converged;
      if(m_descent.is_at_limit(m_iterations))
        return Status::iteration_limit;
      if(is_far_off())
        return follow_path();
      if(const std::optional<Status> end = iterate())
        return is_lost(*end) ? follow_path() : *end;
    }
    polish();
    return Status::converged;
  }

  // Close enough to a minimum, ten steps suffice, and none of them is long.
  static constexpr std::size_t usual_iterations = 16;
  static constexpr double usual_length = 100;

  bool has_path() const
  {
    return std::is_same<Direction, Newton_direction>::value &&
           Has_smooth_gradient<Energy>::get(m_descent.energy());
  }

  bool is_far_off() const
  {
    return has_path() && (m_iterations >= usual_iterations || m_bound > usual_length);
  }

  bool is_lost(Status end) const
  {
    return has_path() && (end == Status::no_descent || end == Status::not_finite);
  }

  // Continues from the best point so far, on a path of proportionally shrinking gradients.
  Status follow_path()
  {
    if constexpr(std::is_same<Direction, Newton_direction>::value &&
                 Has_smooth_gradient<Energy>::is_possible) {
      m_largest_error = 0; // the path has no points to store
      m_descent.move_to_best();
      Gradient_path path(m_descent, m_direction);
      while(!m_descent.has_converged()) {
        if(m_descent.is_at_limit(m_iterations))
          return Status::iteration_limit;
        if(const std::optional<Status> end = path.take_step())
          return *end;
        m_visitor.after_iteration(++m_iterations, m_descent.norm(), path.step_length());
      }
    }
    return Status::converged;
  }

  // Takes a step. Returns the status if it was the last one.
  std::optional<Status> iterate()
  {
    const Eigen::SparseMatrix<double>& hessian = m_descent.energy().Hessian();
    if(!hessian.coeffs().allFinite())
      return Status::not_finite;
    if(!m_direction.find(hessian, m_descent.gradient(), m_descent.point(), m_bound))
      return Status::no_descent;
    m_base = m_descent.point();
    m_base_slope = slope();
    m_base_error = m_descent.energy().gradient_error();
    m_base_norm = m_descent.norm();
    const double noise = rounding_error(hessian).dot(m_direction.direction().cwiseAbs());
    const std::optional<Status> end =
      -m_base_slope > noise ? search_line() : step_within_rounding();
    if(end)
      return end;
    const double length = m_step * m_direction.length();
    m_last_length = m_direction.length();
    correct();
    m_visitor.after_iteration(++m_iterations, m_descent.norm(), length);
    return leads_nowhere() ? std::optional(Status::rounding_limit) : std::nullopt;
  }

  // Returns whether the point is good enough. Damped steps, and steps that do not make the gradient
  // smaller, are not yet near the minimum.
  bool is_enough() const
  {
    const Minimization_limits& limits = m_descent.limits();
    return limits.is_enough && m_iterations > 0 && !m_direction.is_damped() &&
           m_descent.is_at_best() && limits.is_enough(m_descent.point(), m_last_length);
  }

  // Returns whether several successive steps were at most the rounding of each variable, and none
  // was damped. Steps also count if they do not reduce a gradient that is as small as `double`
  // permits.
  bool leads_nowhere()
  {
    const bool is_short =
      ((m_descent.point() - m_base).array().abs() <= tolerance::variable * m_base.array().abs())
        .all();
    const double before = std::exchange(m_least_norm, m_descent.best_norm());
    const bool is_idle = before <= tolerance::gradient && m_least_norm > before / 2;
    m_idle_steps = (is_short || is_idle) && !m_direction.is_damped() ? m_idle_steps + 1 : 0;
    return m_idle_steps == 3;
  }

  double slope() const { return m_descent.gradient().dot(m_direction.direction()); }

  // Returns for each entry of the gradient the error of its computation, plus the error by the
  // rounding of the point.
  Eigen::VectorXd rounding_error(const Eigen::SparseMatrix<double>& hessian)
  {
    const double unit = std::numeric_limits<double>::epsilon() / 2;
    Eigen::VectorXd error = unit * (hessian.cwiseAbs() * m_descent.point().cwiseAbs());
    error.array() += m_descent.energy().gradient_error();
    m_descent.variables().set_fixed_to_zero(error);
    m_largest_error = max_norm(error);
    return error;
  }

  // Takes a step, and returns whether the gradient is known at its end. Far away, rounding can
  // leave no digit of angles.
  bool step(double t)
  {
    m_step = t;
    return m_descent.move_to(m_base + t * m_direction.direction()) &&
           m_descent.energy().gradient_error() <= (std::max)(tolerance::known_angle, m_base_error);
  }

  // Searches along a line. The slope grows from a negative value at its start. A step is good if it
  // exceeds the minimum only as far as the slope is at most half of the initial slope.
  std::optional<Status> search_line()
  {
    bool is_finite = true;
    double t = 1;
    for(int trial = 0; trial < 40; ++trial) {
      const bool was_finite = is_finite;
      is_finite = step(t);
      if(m_descent.point() == m_base && !(trial == 0 && m_direction.is_damped()))
        return trial == 0 ? Status::rounding_limit : failure(was_finite); // lost in rounding
      if(is_finite && slope() <= -m_base_slope / 2) {
        accept();
        return std::nullopt;
      }
      // This is the zero of the secant.
      t *= is_finite ? (std::max)(0.1, m_base_slope / (m_base_slope - slope())) : 0.1;
    }
    return failure(is_finite);
  }

  static Status failure(bool is_finite)
  {
    return is_finite ? Status::no_descent : Status::not_finite;
  }

  void accept()
  {
    if(m_direction.is_damped())
      m_bound = m_step < 1 ? 2 * m_step * m_direction.length()
                           : (std::min)(4 * m_bound, 1e100); // beyond any use, but finite
    m_descent.keep_if_best();
  }

  // Continues with the factorization of a full step while that makes the gradient much smaller.
  // After k corrections, the error of a step is of order k + 2 (Shamanskii's method).
  void correct()
  {
    double before = m_base_norm;
    for(std::size_t i = 0; i < m_descent.limits().corrections && is_contracting(before); ++i) {
      before = m_descent.norm();
      if(!m_direction.find_again(m_descent.gradient()))
        return;
      if(!m_descent.move_to(m_descent.point() + m_direction.direction()) ||
         !m_descent.keep_if_best())
        return m_descent.move_to_best();
      if(m_descent.norm() <= tolerance::contraction * before)
        m_last_length = m_direction.length();
    }
  }

  bool is_contracting(double before) const
  {
    return m_step == 1 && !m_direction.is_damped() && m_descent.is_at_best() &&
           !m_descent.has_converged() && m_descent.norm() <= tolerance::contraction * before;
  }

  // Takes the full step, which may be good although slopes have few digits. Repeated failures end
  // the minimization.
  std::optional<Status> step_within_rounding()
  {
    const double before = m_descent.best_norm();
    const bool is_good = step(1) && m_descent.keep_if_best();
    const bool goes_on = is_good || !search_line();
    m_failures = m_descent.best_norm() < before ? 0 : m_failures + 1;
    return goes_on && m_failures < 3 ? std::nullopt : std::optional(Status::rounding_limit);
  }

  // Takes another step with the last factorization, which costs little.
  void polish()
  {
    if(m_iterations == 0 || m_direction.is_damped() ||
       m_descent.norm() <= m_descent.energy().gradient_error() ||
       !m_direction.find_again(m_descent.gradient()))
      return;
    m_base = m_descent.point();
    if(step(1))
      m_descent.keep_if_best();
  }

  Descent<Energy, Variables> m_descent;
  Visitor& m_visitor;
  std::size_t m_iterations = 0;

  Direction m_direction;
  double m_bound = 10; // of the length of steps where the Hessian is not to be trusted
  Eigen::VectorXd m_base;
  double m_base_slope = 0;
  double m_base_error = 0; // of the gradient
  double m_base_norm = 0;  // of the gradient
  double m_step = 0;
  double m_last_length = 0;   // of the last direction, twice the distance of the minimum at least
  double m_largest_error = 0; // rounding error of the gradient
  double m_least_norm = std::numeric_limits<double>::infinity();
  int m_idle_steps = 0;
  int m_failures = 0; // steps within rounding, in a row, that were not good
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_NEWTON_ITERATION_H
