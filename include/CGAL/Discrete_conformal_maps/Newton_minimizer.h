// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_NEWTON_MINIMIZER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_NEWTON_MINIMIZER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Descent.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_iteration.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// minimizes a convex energy by Newton's method with a sparse Cholesky factorization.
///
/// Steps are judged by the slope of the energy along them, never by its values, which cancel near
/// the minimum. Where the Hessian is singular or almost so (an energy may become linear far from
/// its minimum), it is damped there, so that no step is out of proportion; the damping vanishes at
/// the minimum, where convergence is quadratic. The fill-reducing order of the factorization is
/// kept while it is good, the symbolic factorization while the pattern of the Hessian stays. If the
/// macro `CGAL_DISCRETE_CONFORMAL_MAPS_USE_CHOLMOD` is defined, CHOLMOD factorizes, otherwise
/// Eigen.
///
/// Some ten iterations are usual. An energy whose slopes change sharply in many places, far below
/// the distance between start and minimum, is almost a linear program: it can take hundreds.
///
/// The same input gives the same result, bit by bit.
///
/// \cgalModels `ConvexMinimizer`
class Newton_minimizer
{
public:
  /// makes a minimizer.
  /// \param gradient_tolerance the greatest entry of the gradient with which the energy counts as
  ///        minimized; the rounding error of the gradient takes its place if that is greater
  /// \param maximum_number_of_iterations the number of steps that may be taken
  /// \pre `gradient_tolerance` is not negative.
  explicit Newton_minimizer(double gradient_tolerance = 1e-13,
                            std::size_t maximum_number_of_iterations = 500)
    : m_limits{gradient_tolerance, maximum_number_of_iterations}
  {
    CGAL_precondition(gradient_tolerance >= 0);
  }

  /// minimizes `energy` from `u` on. Complexity of an iteration: a sparse Cholesky factorization
  /// (two where the Hessian has to be damped) and an evaluation of the energy, rarely more, at most
  /// 40.
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
    internal::Newton_iteration<Energy, Visitor> iteration(energy, u, variables, m_limits, visitor);
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

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_NEWTON_MINIMIZER_H
