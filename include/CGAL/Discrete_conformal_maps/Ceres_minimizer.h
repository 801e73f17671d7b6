// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CERES_MINIMIZER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CERES_MINIMIZER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Ceres_iteration.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Iterative_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <cstddef>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// minimizes a convex energy by the L-BFGS method of the Ceres Solver, in coordinates in which the
/// Hessian is the identity at the start.
///
/// It takes about twenty steps with two or three factorizations; `Newton_minimizer` takes seven of
/// each. Its line search compares values of the energy. If these cancel, it computes their
/// difference from the gradients at both points. So the gradient becomes as small as with Newton's
/// method.
///
/// The header needs the Ceres Solver: the component and target `Ceres` of the package.
///
/// An iteration evaluates the energy and its gradient once or a few times. The Hessian is
/// factorized again after thirty iterations, and if no step makes progress.
///
/// \cgalModels `ConvexMinimizer`
class Ceres_minimizer : public internal::Iterative_minimizer<internal::Ceres_iteration>
{
public:
  /// makes a minimizer.
  /// \param gradient_tolerance the greatest absolute value of an entry of the gradient at the
  ///   minimum, or the rounding error of the gradient if that is greater
  /// \param maximum_number_of_iterations the number of steps that may be taken
  /// \pre `gradient_tolerance` is not negative.
  explicit Ceres_minimizer(double gradient_tolerance = internal::tolerance::gradient,
                           std::size_t maximum_number_of_iterations = 1000)
    : internal::Iterative_minimizer<internal::Ceres_iteration>(gradient_tolerance,
                                                               maximum_number_of_iterations)
  {}
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CERES_MINIMIZER_H
