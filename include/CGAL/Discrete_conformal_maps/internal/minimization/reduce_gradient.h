// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_REDUCE_GRADIENT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_REDUCE_GRADIENT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Dirichlet_solver.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Takes steps with the Hessian at the start, close to the minimum. Each step gains as many digits
// as `double` has near the minimum. Stops if the gradient is within `limit`, or a step gains less
// than a digit. Returns the remaining gradient.
template <typename Energy, typename Visitor>
double reduce_gradient(Energy& energy, const Free_variables& variables,
                       const std::vector<char>& is_fixed,
                       const std::shared_ptr<Shared_order>& order, double limit, Visitor& visitor)
{
  Eigen::VectorXd gradient;
  const auto norm = [&] {
    gradient = energy.gradient();
    variables.set_fixed_to_zero(gradient);
    return max_norm(gradient);
  };
  double before = 1, now = norm();
  if(!(now > limit))
    return now;
  Dirichlet_solver solver(energy.Hessian(), is_fixed, order);
  for(std::size_t i = 1; now > limit && now < before / 10; ++i) {
    energy.move_origin();
    const Eigen::VectorXd step = -solver.solve(gradient);
    energy.evaluate(step);
    before = std::exchange(now, norm());
    visitor.after_iteration(i, now, max_norm(step));
  }
  if(now < before)
    return now;
  energy.evaluate(Eigen::VectorXd::Zero(gradient.size()));
  return before;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_REDUCE_GRADIENT_H
