// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_EXACT_PROMISES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_EXACT_PROMISES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/Map_status.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Laplacian_elimination.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_direction.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the errors of scale factors at a point, compared with the minimum of an energy.
struct Scale_errors
{
  double gradient = 0, step = 0; // the greatest derivative, and change in a step of Newton's method
};

// Returns the greatest change of a variable in a step of Newton's method, for an energy whose
// Hessian is a Laplacian. It is infinite if no such step exists.
template <typename Energy>
double newton_step(const Energy& energy, const Free_variables& variables, Eigen::VectorXd gradient)
{
  const auto& hessian = energy.Hessian();
  Newton_direction::Solver solver(variables.indices(), energy.shared_order());
  Laplacian_elimination<typename Energy::FT> elimination;
  if(!hessian.coeffs().allFinite() ||
     !elimination.factorize(hessian, grounding(hessian, variables), solver.order(hessian)))
    return std::numeric_limits<double>::infinity();
  variables.remove_means(gradient);
  const auto solution = elimination.solve(-gradient);
  Eigen::VectorXd step(gradient.size());
  for(Eigen::Index v = 0; v < step.size(); ++v)
    step[v] = static_cast<double>(solution[std::size_t(v)]);
  variables.remove_means(step);
  return max_norm(step);
}

// Returns the errors at the point at which an energy has been evaluated. If the weights of a
// Laplacian differ strongly, derivatives hardly determine scale factors. If the Hessian is a
// Laplacian, a step of Newton's method is measured, too.
template <bool has_Laplacian, typename Energy>
Scale_errors scale_errors(const Energy& energy, const Minimization_domain& domain)
{
  const Free_variables variables(domain, energy.size());
  Eigen::VectorXd gradient = energy.gradient();
  variables.set_fixed_to_zero(gradient);
  const double infinity = std::numeric_limits<double>::infinity();
  if(!gradient.allFinite())
    return {infinity, infinity};
  return {max_norm(gradient), has_Laplacian ? newton_step(energy, variables, gradient) : 0};
}

// Returns the promises of rounded lengths and scale factors on the exact surface. Returns nothing
// if 1024 bits do not suffice. `measure()` returns the errors of the scale factors, while the
// problem has lengths of the exact surface. A problem that already had them keeps them.
template <typename Measure>
std::vector<Map_promise> exact_promises(Doubled_problem& problem, const Measure& measure)
{
  std::vector<Map_promise> result;
  if(!problem.is_measured())
    return result;
  const bool has_lengths = problem.has_precise_lengths();
  try {
    const double length_error = problem.take_exact_lengths();
    const Scale_errors errors = measure();
    result = {
      {"exact_lengths", greater_error(length_error, errors.step), tolerance::promised_exact_length,
       Map_status::not_conformal},
      {"exact_curvature", errors.gradient, tolerance::promised_angle, Map_status::wrong_curvature}};
  } catch(const Intrinsic_triangulations::Error&) {
  }
  if(!has_lengths)
    problem.drop_exact_lengths();
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_EXACT_PROMISES_H
