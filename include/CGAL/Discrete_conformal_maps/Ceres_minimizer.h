// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CERES_MINIMIZER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CERES_MINIMIZER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Ceres_iteration.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Descent.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// minimizes a convex energy by the L-BFGS method of the Ceres Solver, which needs no Hessian.
///
/// It converges linearly, with hundreds of evaluations where `Newton_minimizer` needs ten, the more
/// the finer the mesh is. Its line search compares values of the energy, and these cancel near the
/// minimum: about half of the digits of the gradient are reached, 1e-7 to 1e-6 for a thousand
/// variables with terms of order one, less for more. What is reached is in the result; if it is
/// above the tolerance, the status is `Minimization_status::rounding_limit`.
///
/// The header needs the Ceres Solver.
///
/// \cgalModels `ConvexMinimizer`
class Ceres_minimizer
{
public:
  /// makes a minimizer.
  /// \param gradient_tolerance the greatest entry of the gradient with which the energy counts as
  ///        minimized; the rounding error of the gradient takes its place if that is greater
  /// \param maximum_number_of_iterations the number of steps that may be taken
  /// \pre `gradient_tolerance` is not negative.
  explicit Ceres_minimizer(double gradient_tolerance = 1e-6,
                           std::size_t maximum_number_of_iterations = 10000)
    : m_limits{gradient_tolerance, maximum_number_of_iterations}
  {
    CGAL_precondition(gradient_tolerance >= 0);
  }

  /// minimizes `energy` from `u` on. Complexity of an iteration: linear, and an evaluation of the
  /// energy, its value and gradient, or a few.
  /// \tparam Energy a model of `ConvexEnergy`
  /// \tparam Visitor a model of `MinimizationVisitor`
  /// \param energy the energy; afterwards it has been evaluated at `u`
  /// \param u the point to start from; afterwards the point with the least gradient (max norm) that
  ///        has been seen. Fixed variables keep their values; on a component without one, the mean
  ///        stays, but for rounding.
  /// \param domain which variables are fixed
  /// \param visitor sees every step; if it throws, `u` is the best point so far
  /// \pre The size of `u` is that of the energy.
  template <typename Energy, typename Visitor>
  Minimization_result operator()(Energy& energy, Eigen::VectorXd& u,
                                 const Minimization_domain& domain, Visitor&& visitor) const
  {
    CGAL_precondition(static_cast<std::size_t>(u.size()) == energy.size());
    const internal::Free_variables variables(domain, energy.size());
    internal::Ceres_iteration<Energy, Visitor> iteration(energy, u, variables, m_limits, visitor);
    return iteration.run();
  }

  /// the same without a visitor.
  template <typename Energy>
  Minimization_result operator()(Energy& energy, Eigen::VectorXd& u,
                                 const Minimization_domain& domain = Minimization_domain()) const
  {
    return (*this)(energy, u, domain, Default_minimization_visitor());
  }

private:
  internal::Minimization_limits m_limits;
};

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CERES_MINIMIZER_H
