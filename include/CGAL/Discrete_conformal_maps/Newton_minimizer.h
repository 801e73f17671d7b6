// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_NEWTON_MINIMIZER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_NEWTON_MINIMIZER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Iterative_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_iteration.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <cstddef>

namespace CGAL::Discrete_conformal_maps {

namespace internal {
template <typename Energy, typename Visitor>
using Newton_steps = Newton_iteration<Energy, Visitor>;
} // namespace internal

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// minimizes a convex energy by Newton's method with a sparse Cholesky factorization.
///
/// Steps are judged by the slope of the energy along them, never by its values, which cancel near
/// the minimum. Where the Hessian is singular or almost so (an energy may become linear far from
/// its minimum), it is damped there, so that no step is out of proportion; the damping vanishes at
/// the minimum, where convergence is quadratic. The fill-reducing order of the factorization is
/// kept while it is good, the symbolic factorization while the pattern of the Hessian stays. If the
/// macro `CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD` is defined, CHOLMOD factorizes, otherwise
/// Eigen.
///
/// Some ten iterations are usual. An energy whose slopes change sharply in many places, far below
/// the distance between start and minimum, is almost a linear program: it can take hundreds.
///
/// Results are bitwise reproducible.
///
/// Complexity of an iteration: a sparse Cholesky factorization (two where the Hessian has to be
/// damped) and an evaluation of the energy, rarely more, at most 40.
///
/// \cgalModels `ConvexMinimizer`
class Newton_minimizer : public internal::Iterative_minimizer<internal::Newton_steps>
{
public:
  /// makes a minimizer.
  /// \param gradient_tolerance the greatest entry of the gradient with which the energy counts as
  ///        minimized; the rounding error of the gradient takes its place if that is greater
  /// \param maximum_number_of_iterations the number of steps that may be taken
  /// \pre `gradient_tolerance` is not negative.
  explicit Newton_minimizer(double gradient_tolerance = internal::tolerance::gradient,
                            std::size_t maximum_number_of_iterations = 500)
    : internal::Iterative_minimizer<internal::Newton_steps>(gradient_tolerance,
                                                            maximum_number_of_iterations)
  {}
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_NEWTON_MINIMIZER_H
