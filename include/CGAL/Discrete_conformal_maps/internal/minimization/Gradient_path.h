// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_GRADIENT_PATH_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_GRADIENT_PATH_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_direction.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Discrete_conformal_maps::internal {

// Follows the path on which the gradient g of an energy shrinks to zero proportionally. Angle
// defects move from their present values to the prescribed values. Its tangent is Newton's
// direction. A step covers a part t of it such that the greatest |g_i| shrinks by at least the
// fraction t/4. The slope along the direction suffices near a minimum. It can vanish if single
// defects have grown to 2 pi, and Newton's method hardly moves from such points.
//
// The range in which the tangent is accurate depends on changes of neighbors relative to each
// other, not on their common change. The scale factors of a strip can move by hundreds in one step.
// So a bound holds for differences of neighbors, which grows and shrinks with the success of steps.
template <typename Descent>
class Gradient_path
{
public:
  typedef Minimization_status Status;

  // `descent` is at a point with a finite gradient.
  Gradient_path(Descent& descent, Newton_direction& direction)
    : m_descent(descent), m_direction(direction)
  {}

  // Takes a step. Returns the status if no step could be taken, or if a minimum should have been
  // found before. Paths of 200 steps are rare, and longer ones never succeed.
  std::optional<Status> take_step()
  {
    if(m_steps++ == greatest_number_of_steps)
      return Status::iteration_limit;
    const Eigen::SparseMatrix<double>& hessian = m_descent.energy().Hessian();
    if(!hessian.coeffs().allFinite())
      return Status::not_finite;
    if(!m_direction.find(hessian, m_descent.gradient(), m_descent.point(), longest))
      return Status::no_descent;
    return search(greatest_difference(hessian, m_direction.direction()));
  }

  double step_length() const { return m_step * m_direction.length(); }

private:
  static constexpr double longest = 1e100;
  static constexpr std::size_t greatest_number_of_steps = 250;

  std::optional<Status> search(double difference)
  {
    const Eigen::VectorXd base = m_descent.point();
    const double norm = max_norm(m_descent.gradient()), base_slope = slope(),
                 known = (std::max)(tolerance::known_angle, m_descent.energy().gradient_error());
    bool has_been_finite = false;
    m_step = difference > m_bound ? m_bound / difference : 1;
    for(int trial = 0; trial < 20 && !m_descent.has_worked_enough(); ++trial) {
      const bool is_finite = m_descent.move_to(base + m_step * m_direction.direction()) &&
                             m_descent.energy().gradient_error() <= known;
      if(m_descent.point() == base)
        return Status::rounding_limit;
      if(is_finite && max_norm(m_descent.gradient()) <= (1 - m_step / 4) * norm) {
        m_bound = (trial == 0 ? (std::max)(m_bound, 2 * m_step * difference) : m_step * difference);
        m_descent.move_origin();
        m_short_steps = m_step < 1e-3 ? m_short_steps + 1 : 0;
        return m_short_steps < 30 ? std::nullopt : std::optional(Status::no_descent);
      }
      has_been_finite |= is_finite;
      // The step goes to the zero of the secant of slopes, but neither far from this point nor
      // close to the last one.
      const double beyond = is_finite ? slope() : 0;
      m_step *= beyond > 0 ? std::clamp(base_slope / (base_slope - beyond), 0.1, 0.5) : 0.5;
    }
    if(m_descent.has_worked_enough())
      return Status::iteration_limit;
    return has_been_finite ? Status::rounding_limit : Status::not_finite;
  }

  double slope() const { return m_descent.gradient().dot(m_direction.direction()); }

  Descent& m_descent;
  Newton_direction& m_direction;
  double m_bound = 0.25; // of the differences of neighbors
  double m_step = 0;
  int m_short_steps = 0; // in a row
  std::size_t m_steps = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_GRADIENT_PATH_H
