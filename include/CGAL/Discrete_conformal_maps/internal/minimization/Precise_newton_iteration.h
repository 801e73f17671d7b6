// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_PRECISE_NEWTON_ITERATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_PRECISE_NEWTON_ITERATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Laplacian_elimination.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_direction.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Variable_groups.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/root_of_increasing.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Implements Newton's method with steps in the digits of the energy. Its Hessian is a Laplacian, or
// the sum of a Laplacian and a positive diagonal matrix. If vertices are much closer to each other
// than to all others, their scale factors are nearly equal. A common step in `double` would change
// the differences by more than the distances allow.
//
// A step that changes these differences by a few times as much as distances allow makes angles zero
// or pi. Such angles do not change any more until the scale factors have returned exactly to their
// old values. So steps stay close to the path on which all entries of the gradient shrink
// proportionally, from the start to zero. Angles on the path lie between the angles of the start
// and the prescribed angles.
//
// Variables may have lower bounds. At its bound, a variable may have a derivative that is greater
// than on the path, and is then excluded from the step. Close to a bound, the slope can behave like
// a root. Then a derivative at the bound is known up to the square root of a rounding error.
template <typename Energy>
class Precise_newton_iteration
{
  typedef typename Energy::FT FT;
  typedef Eigen::VectorXd Vector;

public:
  // If `lower_bound` is empty, variables have no bounds.
  // \pre The scale factors of the energy are not below `lower_bound`.
  Precise_newton_iteration(Energy& energy, const Minimization_domain& domain,
                           std::vector<FT> lower_bound = {})
    : m_energy(energy),
      m_variables(domain, energy.size()),
      m_lower_bound(std::move(lower_bound)),
      m_solver(m_variables.indices(), energy.shared_order())
  {
    move_to(energy.scale_factors());
    std::vector<char> is_fixed(energy.size(), 1);
    for(Eigen::Index v : m_variables.indices())
      is_fixed[std::size_t(v)] = 0;
    if(m_gradient.allFinite())
      m_groups = Variable_groups(energy.Hessian(), is_fixed).groups();
  }

  // Takes steps until no entry of the gradient is above `tolerance`, or twice its rounding error.
  template <typename Visitor>
  Minimization_result run(double tolerance, std::size_t maximum_number_of_steps, Visitor& visitor)
  {
    start_path();
    Minimization_status status = Minimization_status::converged;
    while(m_norm > (std::max)(tolerance, 2 * m_energy.gradient_error()) &&
          status == Minimization_status::converged)
      if(m_result.iterations == maximum_number_of_steps || m_energy.has_worked_enough())
        status = Minimization_status::iteration_limit;
      else {
        status = step();
        visitor.after_iteration(++m_result.iterations, m_norm, m_length);
      }
    m_result.status = status;
    m_result.gradient_norm = m_norm;
    m_result.gradient_error = m_energy.gradient_error();
    return m_result;
  }

private:
  // This is the greatest distance from the path, relative to the greatest entry of the gradient on
  // it.
  static constexpr double greatest_distance = 0.01;
  static constexpr int number_of_corrections = 10, number_of_trials = 10;
  // One step covers at least this part of the path.
  static constexpr double least_part = 1e-7;
  static constexpr double longest_step_within_bounds = 100, longest_damped_step = 10;
  static constexpr double greatest_change = 2; // of scale factors in a step
  // Derivatives at bounds have this error.
  inline static const double bound_error = std::sqrt(tolerance::rounding_of_gradient<FT>());

  void start_path()
  {
    m_start = excess(0);
    m_position = 1;
  }

  bool has_bounds() const { return !m_lower_bound.empty(); }
  bool is_at_bound(std::size_t v) const
  {
    return has_bounds() && m_energy.scale_factor(v) == m_lower_bound[v];
  }

  // Returns the difference between the gradient and the gradient at this position of the path. At
  // bounds, only a derivative that is certainly too small counts.
  Vector excess(double position) const
  {
    Vector result = m_gradient;
    if(position > 0)
      result -= position * m_start;
    if(has_bounds())
      for(Eigen::Index v : m_variables.indices())
        if(result[v] > -bound_error && is_at_bound(std::size_t(v)))
          result[v] = 0;
    return result;
  }

  void move_to(const std::vector<FT>& u)
  {
    m_energy.set_origin(u);
    m_energy.evaluate(Vector::Zero(Eigen::Index(m_energy.size())));
    ++m_result.evaluations;
    m_gradient = m_energy.gradient();
    m_variables.set_fixed_to_zero(m_gradient);
    m_norm = m_gradient.allFinite() ? max_norm(excess(0)) : std::numeric_limits<double>::infinity();
    m_removed = m_gradient;
    m_variables.remove_means(m_gradient);
    m_removed -= m_gradient;
  }

  // Moves to a point of the path that is closer to its end. The better the previous step has been,
  // the farther away the point may be. While all variables are above their bounds, they can move
  // together, the Hessian is singular, and no path exists.
  Minimization_status step()
  {
    if(!factorize(m_position))
      return has_bounds() && take_damped_step() ? Minimization_status::converged
                                                : Minimization_status::not_finite;
    const std::vector<FT> base = m_energy.scale_factors();
    const Vector gradient = m_gradient;
    const auto to_start = m_elimination.solve(m_start), to_minimum = m_elimination.solve(-gradient);
    m_part = (std::min)(2 * m_part, 1.);
    for(; m_part > least_part && !m_energy.has_worked_enough(); m_part /= 2) {
      const double position = m_part < 1 ? (1 - m_part) * m_position : 0;
      std::vector<FT> direction = to_minimum;
      for(std::size_t v = 0; v < direction.size(); ++v)
        direction[v] += FT(position) * to_start[v];
      m_length = length(direction);
      if(is_too_long(direction))
        continue;
      move(base, direction);
      if(has_reached(position)) {
        m_position = position;
        if(position == 0)
          start_path();
        return Minimization_status::converged;
      }
    }
    move_to(base);
    if(m_energy.has_worked_enough())
      return Minimization_status::iteration_limit;
    return has_bounds() && take_damped_step() ? Minimization_status::converged
                                              : Minimization_status::rounding_limit;
  }

  // Moves each variable towards the minimum, by at most `longest_damped_step`, and restarts the
  // path. If the variables are far away, no step reaches a point of the path. Returns whether any
  // variable has moved.
  bool take_damped_step()
  {
    const Vector wrong = excess(0);
    if(!factorize(0, damping(m_energy.Hessian(), wrong, longest_damped_step, 0)))
      return false;
    const std::vector<FT> base = m_energy.scale_factors();
    search_line(base, m_elimination.solve(-wrong), wrong, 0);
    m_length = max_norm(change_from(base));
    start_path();
    return m_gradient.allFinite() && m_length > 0;
  }

  // Corrects the distance from a point of the path. Returns whether the distance is small
  // afterwards, and false if it is NaN.
  bool has_reached(double position)
  {
    const double limit =
      greatest_distance * (position > 0 ? position : m_position) * max_norm(m_start);
    double before = 8 * limit; // a step that is good needs no more than a correction
    for(int i = 0; i <= number_of_corrections && !m_energy.has_worked_enough(); ++i) {
      double now = max_norm(excess(position));
      if(now > limit && !(now <= before / 2)) {
        const std::vector<FT> base = m_energy.scale_factors();
        relax(position, limit);
        if(!(max_norm(excess(position)) < now))
          move_to(base);
        now = max_norm(excess(position));
      }
      if(now <= limit)
        return true;
      before = now;
      if(i < number_of_corrections && !correct(position))
        return false;
    }
    return false;
  }

  // Takes a step of Newton's method to this position of the path. Returns whether such a step
  // exists.
  bool correct(double position)
  {
    if(!factorize(position))
      return false;
    const std::vector<FT> base = m_energy.scale_factors(),
                          direction = m_elimination.solve(position * m_start - m_gradient);
    if(is_too_long(direction))
      return false;
    search_line(base, direction, m_gradient - position * m_start, position);
    return true;
  }

  // Takes a step, from the gradient `before`. Shortens it while it exceeds the minimum on its line
  // so far that the slope is half of the initial slope. If slopes behave like a root, as for angles
  // of needles that open, the next steps would oscillate.
  void search_line(const std::vector<FT>& base, std::vector<FT> direction, const Vector& before,
                   double position)
  {
    move(base, direction);
    for(int trial = 0; trial < number_of_trials && !m_energy.has_worked_enough(); ++trial) {
      const Vector change = change_from(base);
      const double slope = before.dot(change), now = (m_gradient - position * m_start).dot(change);
      if(!(slope < 0) || now <= -slope / 2)
        return;
      const double part = std::isfinite(now) ? (std::max)(0.1, slope / (slope - now)) : 0.1;
      for(FT& x : direction)
        x *= FT(part);
      move(base, direction);
    }
  }

  Vector change_from(const std::vector<FT>& base) const
  {
    Vector result(Eigen::Index(base.size()));
    for(std::size_t v = 0; v < base.size(); ++v)
      result[Eigen::Index(v)] = static_cast<double>(FT(m_energy.scale_factor(v) - base[v]));
    return result;
  }

  // Moves groups of variables as one, and then their parts, until the entries of the gradient equal
  // the entries on the path. The movement of a group hardly depends on differences within the
  // group. Within bounds, variables that are not tied strongly to others would move far, and steps
  // of all variables are as good.
  void relax(double position, double limit)
  {
    if(!m_gradient.allFinite())
      return;
    const Vector wanted = position * m_start + m_removed, ground = ground_of(m_energy.Hessian());
    std::vector<FT> u = m_energy.scale_factors();
    for(const auto& group : m_groups)
      if(const double weight = outer_weight(group, ground);
         !m_energy.has_worked_enough() && (!has_bounds() || weight > tolerance::weight_of_group))
        relax(group, weight, wanted, limit / 4, u);
    move_to(u);
  }

  void relax(const std::vector<std::size_t>& group, double weight, const Vector& all_wanted,
             double limit, std::vector<FT>& u)
  {
    double wanted = 0;
    for(std::size_t v : group)
      wanted += all_wanted[Eigen::Index(v)];
    std::vector<FT> values(group.size());
    const auto error = [&](const FT& x) {
      if(m_energy.has_worked_enough())
        return std::numeric_limits<double>::quiet_NaN(); // which ends the search for the root
      for(std::size_t i = 0; i < group.size(); ++i)
        values[i] = u[group[i]] + x;
      return m_energy.derivative_at(group, values) - wanted;
    };
    if(!has_bounds())
      return move_group(group, root_of_increasing<FT>(error, weight, limit), u);
    const FT least = least_move(group, u);
    const auto error_within_bounds = [&](const FT& x) {
      if(x > least)
        return error(x);
      const double at_least = error(least);
      return at_least >= -limit ? 0 : at_least; // as far as the group may move
    };
    const FT x = root_of_increasing<FT>(error_within_bounds, weight, limit);
    move_group(group, (std::max)(x, least), u);
  }

  // Returns how far a group can move down, a number that is not positive.
  FT least_move(const std::vector<std::size_t>& group, const std::vector<FT>& u) const
  {
    FT result(m_lower_bound[group[0]] - u[group[0]]);
    for(std::size_t v : group)
      result = (std::max)(result, FT(m_lower_bound[v] - u[v]));
    return result;
  }

  void move_group(const std::vector<std::size_t>& group, const FT& x, std::vector<FT>& u) const
  {
    for(std::size_t v : group)
      u[v] = in_bounds(v, u[v] + x);
  }

  // Returns `u`, moved to its bound if it is below it, or within some rounding errors.
  FT in_bounds(std::size_t v, const FT& u) const
  {
    if(!has_bounds())
      return u;
    const FT& bound = m_lower_bound[v];
    const FT margin = tolerance::roundings_of_variable * std::numeric_limits<FT>::epsilon() *
                      (bound < 0 ? FT(-bound) : bound);
    return u - bound <= margin ? bound : u;
  }

  // Returns the sum of the weights between a group and other variables, or the ground.
  double outer_weight(std::vector<std::size_t> group, const Vector& ground) const
  {
    std::sort(group.begin(), group.end());
    double result = 0;
    const auto& hessian = m_energy.Hessian();
    for(std::size_t v : group) {
      result += ground[Eigen::Index(v)];
      for(Eigen::SparseMatrix<double>::InnerIterator i(hessian, Eigen::Index(v)); i; ++i)
        if(!std::binary_search(group.begin(), group.end(), std::size_t(i.row())))
          result -= i.value();
    }
    return result > 0 ? result : 1;
  }

  // Prepares steps to this position of the path.
  bool factorize(double position)
  {
    return factorize(position, Vector::Zero(Eigen::Index(m_energy.size())));
  }
  // Prepares steps with `lift` added to the diagonal.
  bool factorize(double position, const Vector& lift)
  {
    const auto& hessian = m_energy.Hessian();
    ++m_result.factorizations;
    return m_gradient.allFinite() && hessian.coeffs().allFinite() &&
           m_elimination.factorize(hessian,
                                   grounding(hessian, m_variables) + ground_of(hessian) + lift,
                                   movable(m_solver.order(hessian), position));
  }

  // Returns the excess of the diagonal. With bounds, which only the sphere has, the Hessian is a
  // Laplacian, and the excess is rounding.
  Vector ground_of(const Eigen::SparseMatrix<double>& hessian) const
  {
    return has_bounds() ? Vector(Vector::Zero(hessian.cols()))
                        : excess_of_diagonal(hessian, m_variables);
  }

  // Returns the variables of `order` that can move within their bounds.
  std::vector<Eigen::Index> movable(std::vector<Eigen::Index> order, double position) const
  {
    if(!has_bounds())
      return order;
    const Vector wrong = excess(position);
    order.erase(
      std::remove_if(order.begin(), order.end(),
                     [&](Eigen::Index v) { return wrong[v] == 0 && is_at_bound(std::size_t(v)); }),
      order.end());
    return order;
  }

  void move(std::vector<FT> u, const std::vector<FT>& direction)
  {
    for(std::size_t v = 0; v < u.size(); ++v)
      u[v] = in_bounds(v, u[v] + direction[v]);
    move_to(u);
  }

  // Returns whether a step is useless, because it causes very many flips. If all variables can move
  // far together, the greatest difference of neighbors decides. Otherwise the length of the step
  // decides.
  bool is_too_long(const std::vector<FT>& direction) const
  {
    if(has_bounds())
      return !(length(direction) <= longest_step_within_bounds);
    const double change = m_variables.has_zero_row_sums()
                            ? greatest_difference(m_energy.Hessian(), direction)
                            : length(direction);
    return !(change <= greatest_change);
  }

  static double length(const std::vector<FT>& direction)
  {
    double result = 0;
    for(const FT& x : direction)
      result = (std::max)(result, std::abs(static_cast<double>(x)));
    return result;
  }

  Energy& m_energy;
  Free_variables m_variables;
  std::vector<FT> m_lower_bound;                // none if it is empty
  std::vector<Variable_groups::Group> m_groups; // at the start
  Newton_direction::Solver m_solver;            // of which the order is used
  Laplacian_elimination<FT> m_elimination;
  double m_length = 0;                   // of a step
  Vector m_gradient;                     // without the part that no step can change
  Vector m_removed;                      // this part
  double m_norm = 0;                     // with it
  Vector m_start;                        // the gradient at the start of the path
  double m_position = 1, m_part = 0.125; // the part of it that is left, and that a step takes
  Minimization_result m_result;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_PRECISE_NEWTON_ITERATION_H
