// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DIFFERENCE_BOUNDED_NEWTON_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DIFFERENCE_BOUNDED_NEWTON_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Laplacian_elimination.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_direction.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Implements Newton's method for a convex energy whose Hessian is a Laplacian. Steps bound the
// differences of neighbors, and use the changes of the gradient along earlier steps.
//
// Angles of needles jump by pi within distances that are far shorter than a step. The Hessian on
// one side of such a jump contains no information about the jump. So steps correct the Hessian by
// the changes of the gradient along the last steps, as the method of Broyden, Fletcher, Goldfarb
// and Shanno does. The matrix of that method is the Hessian here, see Nocedal (1980). With such a
// correction, a step follows the edge of a jump. Lewis and Overton (2013) show this for functions
// that are not smooth.
//
// A step ends where its slope has risen by half, or where slopes prove that the energy is less.
// After a step that would go too far, the bound is smaller. Steps have the digits of the energy.
template <typename Energy>
class Difference_bounded_newton
{
  typedef typename Logarithm_of<typename Energy::FT>::type FT;
  typedef std::vector<FT> Values;
  typedef Eigen::VectorXd Vector;
  typedef Eigen::SparseMatrix<double> Matrix;

public:
  Difference_bounded_newton(Energy& energy, const Minimization_domain& domain)
    : m_energy(energy),
      m_variables(domain, energy.size()),
      m_solver(m_variables.indices(), energy.shared_order())
  {}

  // Takes steps from the origin of the energy until no entry of the gradient is above `tolerance`.
  // An entry of at most twice its rounding error is enough, if a map may have such an error.
  template <typename Visitor>
  Minimization_result run(double tolerance, std::size_t maximum_number_of_steps, Visitor& visitor)
  {
    Minimization_status status =
      move_to(position()) ? Minimization_status::converged : Minimization_status::not_finite;
    while(status == Minimization_status::converged && !is_within(tolerance))
      if(m_result.iterations == maximum_number_of_steps || m_energy.has_worked_enough())
        status = Minimization_status::iteration_limit;
      else {
        status = step();
        visitor.after_iteration(++m_result.iterations, max_norm(m_gradient), m_length);
      }
    m_result.status = status;
    m_result.gradient_norm = max_norm(m_gradient);
    m_result.gradient_error = m_energy.gradient_error();
    return m_result;
  }

private:
  // The bound of the differences of neighbors stays between these numbers.
  static constexpr double least_bound = 0.02, greatest_bound = 0.75;
  static constexpr std::size_t number_of_secants = 100;
  static constexpr int number_of_trials = 40;

  // Stores a step, the change of the gradient along it, and the inverse of their product.
  struct Secant
  {
    Values step;
    Vector change;
    FT inverse;
  };

  Values position() const
  {
    Values result;
    for(const auto& u : m_energy.scale_factors())
      result.push_back(converted<FT>(u));
    return result;
  }

  // Returns whether the gradient is known at `u`.
  bool move_to(const Values& u)
  {
    ++m_result.evaluations;
    m_energy.set_origin({u.begin(), u.end()});
    m_energy.evaluate(Vector::Zero(Eigen::Index(m_energy.size())));
    m_gradient = m_energy.gradient();
    m_variables.set_fixed_to_zero(m_gradient);
    m_variables.remove_means(m_gradient);
    return m_gradient.allFinite() && m_energy.gradient_error() <= tolerance::curvature_at_start;
  }

  bool is_within(double tolerance) const
  {
    return max_norm(m_gradient) <= (std::max)(tolerance, (std::min)(tolerance::promised_angle / 2,
                                                                    2 * m_energy.gradient_error()));
  }

  Minimization_status step()
  {
    Values direction;
    if(!find(direction))
      return Minimization_status::not_finite;
    const Values base = position();
    const Vector gradient = m_gradient;
    const double slope = product(gradient, direction);
    if(!(slope < 0) && !m_secants.empty()) { // by rounding
      m_secants.clear();
      return step();
    }
    const double part = slope < 0 ? search_line(base, direction, slope) : 0;
    if(part == 0)
      return Minimization_status::rounding_limit;
    for(FT& x : direction)
      x *= FT(part);
    remember(direction, m_gradient - gradient);
    return Minimization_status::converged;
  }

  // Moves along a direction, and returns how far; zero if no gradient is known on it. In a convex
  // function, slopes at both ends bound the change between.
  double search_line(const Values& base, const Values& direction, double slope)
  {
    double low = 0, low_slope = slope, high = 1, high_slope = 0;
    double part = 1;
    bool is_known = false, goes_on = true;
    for(int trial = 0; goes_on && trial < number_of_trials && !m_energy.has_worked_enough();
        ++trial) {
      if(trial > 0)
        part = next_part(trial, low, low_slope, high, high_slope);
      is_known = move(base, direction, part);
      const double now =
        is_known ? product(m_gradient, direction) : std::numeric_limits<double>::infinity();
      (now < 0 ? low : high) = part;
      (now < 0 ? low_slope : high_slope) = now;
      goes_on = now < 0 ? part < 1 && now < slope / 2
                        : now > -slope / 2 && low * low_slope + (high - low) * now > 0;
    }
    m_length *= part;
    m_bound = part == 1 ? (std::min)(greatest_bound, 2 * m_bound)
                        : std::clamp(8 * m_length, least_bound, greatest_bound);
    return is_known ? part : 0;
  }

  // Returns a point between two given points. By turns, their slopes determine it, or it is the
  // middle.
  static double next_part(int trial, double low, double low_slope, double high, double high_slope)
  {
    if(trial % 2 == 0)
      return (low + high) / 2;
    const double zero = low_slope / (low_slope - high_slope);
    return low + (high - low) * std::clamp(zero, 0.05, 0.95);
  }

  bool move(Values u, const Values& direction, double part)
  {
    for(std::size_t v = 0; v < u.size(); ++v)
      u[v] += FT(part) * direction[v];
    return move_to(u);
  }

  // Stores a step, unless rounding hides the convexity along it.
  void remember(const Values& step, const Vector& change)
  {
    const FT curvature = precise_product(change, step);
    if(curvature > 0)
      m_secants.push_back({step, change, FT(1) / curvature});
    if(m_secants.size() > number_of_secants)
      m_secants.pop_front();
  }

  // Returns whether there is a direction.
  bool find(Values& direction)
  {
    const Matrix& matrix = m_energy.Hessian();
    ++m_result.factorizations;
    if(!matrix.coeffs().allFinite() ||
       !m_elimination.factorize(matrix, grounding(matrix, m_variables), m_solver.order(matrix)))
      return false;
    direction = solve(-m_gradient);
    m_length = greatest_difference(matrix, direction);
    if(m_length > m_bound) {
      for(FT& x : direction)
        x *= FT(m_bound / m_length);
      m_length = m_bound;
    }
    return true;
  }

  // Solves with the corrected Hessian, by the recursion of Nocedal (1980).
  Values solve(Vector right_side) const
  {
    std::vector<FT> part(m_secants.size());
    for(std::size_t k = m_secants.size(); k-- > 0;) {
      part[k] = precise_product(right_side, m_secants[k].step) * m_secants[k].inverse;
      right_side -= static_cast<double>(part[k]) * m_secants[k].change;
    }
    Values result = m_elimination.solve(right_side);
    for(std::size_t k = 0; k < m_secants.size(); ++k) {
      const Secant& secant = m_secants[k];
      const FT x = part[k] - precise_product(secant.change, result) * secant.inverse;
      for(std::size_t v = 0; v < result.size(); ++v)
        result[v] += x * secant.step[v];
    }
    return result;
  }

  static FT precise_product(const Vector& x, const Values& y)
  {
    FT result(0);
    for(std::size_t v = 0; v < y.size(); ++v)
      if(const double factor = x[Eigen::Index(v)]; factor != 0)
        result += FT(factor) * y[v];
    return result;
  }
  static double product(const Vector& x, const Values& y)
  {
    return static_cast<double>(precise_product(x, y));
  }

  Energy& m_energy;
  Free_variables m_variables;
  Newton_direction::Solver m_solver; // only its order is used
  Laplacian_elimination<FT> m_elimination;
  std::deque<Secant> m_secants; // of the last steps
  Vector m_gradient;
  double m_bound = greatest_bound;
  double m_length = 0; // of a step: its greatest difference
  Minimization_result m_result;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DIFFERENCE_BOUNDED_NEWTON_H
