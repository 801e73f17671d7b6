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
/// The line search uses the slope of the energy, never its values, which cancel near the minimum.
/// Far from its minimum, an energy may be linear. A singular or nearly singular Hessian is damped,
/// so that steps remain small. The damping vanishes at the minimum, and convergence is quadratic.
/// The fill-reducing order of the factorization is reused while it is good. The symbolic
/// factorization is reused while the pattern of the Hessian does not change. CHOLMOD factorizes if
/// the macro `CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD` is defined, Eigen otherwise.
///
/// Most minimizations take about ten iterations. Hundreds can be necessary if the slopes of the
/// energy change sharply at many points between start and minimum, as in a linear program.
///
/// Results are bitwise reproducible.
///
/// An iteration takes a sparse Cholesky factorization, or two if the Hessian is damped. It
/// evaluates the energy once in most cases, and at most 40 times.
///
/// \cgalModels `ConvexMinimizer`
class Newton_minimizer : public internal::Iterative_minimizer<internal::Newton_steps>
{
public:
  /// makes a minimizer.
  /// \param gradient_tolerance the greatest absolute value of an entry of the gradient at the
  ///   minimum, or the rounding error of the gradient if that is greater
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
