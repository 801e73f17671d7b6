// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DESCENT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DESCENT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Abstract_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the limits of a minimization.
struct Minimization_limits
{
  double gradient_tolerance;
  std::size_t iterations;
  // Decides whether a point is good enough, given the length of the step to it.
  std::function<bool(const Eigen::VectorXd&, double)> is_enough = nullptr;
  // Limits the number of times that a factorization is used again after a step of full length.
  std::size_t corrections = 0;
};

// Follows the sequence of points of an energy, and always gives the best one to the caller.
// `Variables` determines the allowed points, and the distance of a gradient from the gradient of a
// minimum.
template <typename Energy, typename Variables = Free_variables>
class Descent
{
public:
  Descent(Energy& energy, Eigen::VectorXd& best, const Variables& variables,
          const Minimization_limits& limits)
    : m_energy(energy), m_best(best), m_variables(variables), m_limits(limits), m_point(best)
  {}

  // Moves to the start. Returns the status if the minimization ends at it.
  std::optional<Minimization_status> start()
  {
    if(!move_to(Eigen::VectorXd(m_best)))
      return Minimization_status::not_finite;
    m_best_norm = m_norm;
    if(m_excess > tolerance())
      return Minimization_status::unbounded;
    return std::nullopt;
  }

  // Returns false if the gradient at this point is not finite.
  bool move_to(const Eigen::VectorXd& point)
  {
    m_point = m_variables.feasible(point);
    m_energy.evaluate(m_point);
    ++m_evaluations;
    m_gradient = m_energy.gradient();
    m_variables.set_fixed_to_zero(m_gradient);
    m_norm = m_variables.norm(m_gradient, m_point);
    m_excess = m_variables.remove_means(m_gradient);
    return m_gradient.allFinite();
  }

  // Returns whether the gradient is less than at all earlier points. Keeps the point if the
  // gradient is not greater.
  bool keep_if_best()
  {
    if(!(m_norm <= m_best_norm))
      return false;
    const bool is_better = m_norm < m_best_norm;
    m_best = m_point;
    m_best_norm = m_norm;
    return is_better;
  }

  // Makes the point the best one and the origin of the energy. Steps from it have all digits of
  // the variables of the energy, which may be more than `double` has.
  void move_origin()
  {
    m_energy.move_origin();
    m_point.setZero();
    m_best = m_point;
    m_best_norm = m_norm;
  }

  double tolerance() const
  {
    return (std::max)(m_limits.gradient_tolerance, m_energy.gradient_error());
  }
  // Returns whether the point is a minimum. A point with a worse gradient than the best one, but
  // within a great rounding error, is not.
  bool has_converged() const { return m_norm <= tolerance() && m_norm <= m_best_norm; }

  // Returns whether the minimization may take no more steps.
  bool is_at_limit(std::size_t iterations) const
  {
    return iterations == m_limits.iterations || has_worked_enough();
  }
  bool has_worked_enough() const { return Work_of_energy<Energy>::is_done(m_energy); }

  bool is_at_best() const { return m_point == m_best; }

  void move_to_best()
  {
    if(!is_at_best())
      move_to(Eigen::VectorXd(m_best));
  }

  // Returns to the best point.
  Minimization_result result(Minimization_status status)
  {
    move_to_best();
    Minimization_result result;
    result.status = status;
    result.evaluations = m_evaluations;
    result.gradient_norm = m_norm;
    result.gradient_error = m_energy.gradient_error();
    return result;
  }

  Energy& energy() const { return m_energy; }
  const Variables& variables() const { return m_variables; }
  const Minimization_limits& limits() const { return m_limits; }
  const Eigen::VectorXd& point() const { return m_point; }
  const Eigen::VectorXd& gradient() const { return m_gradient; }
  double norm() const { return m_norm; }
  double best_norm() const { return m_best_norm; }

private:
  Energy& m_energy;
  Eigen::VectorXd& m_best;
  const Variables& m_variables;
  const Minimization_limits m_limits;

  Eigen::VectorXd m_point;
  Eigen::VectorXd m_gradient; // at the point, without the part that no step can change
  double m_norm = 0;          // of the gradient, with that part
  double m_excess = 0;        // that part: the greatest mean
  double m_best_norm = std::numeric_limits<double>::infinity();
  std::size_t m_evaluations = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DESCENT_H
