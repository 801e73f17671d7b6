// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_BOUNDED_NEWTON_MINIMIZER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_BOUNDED_NEWTON_MINIMIZER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Bounded_direction.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Descent.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_iteration.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// minimizes a convex energy under lower bounds of its variables (Section 4.4.4).
///
/// Every step leads towards the minimum of the quadratic model of the energy under the bounds. The
/// set of active bounds determines this minimum. Line search, damping and factorizations are as in
/// `Newton_minimizer`. Convergence is quadratic once the active set does not change. All visited
/// points satisfy the bounds. A variable whose bound is active at the minimum is bitwise equal to
/// the bound.
///
/// Results are bitwise reproducible.
class Bounded_Newton_minimizer
{
public:
  /// makes a minimizer.
  /// \param gradient_tolerance the greatest absolute value of a derivative at the minimum, or the
  ///   rounding error of the gradient if that is greater. At an active bound, only negative
  ///   derivatives count
  /// \param maximum_number_of_iterations the number of steps that may be taken
  /// \pre `gradient_tolerance` is not negative.
  explicit Bounded_Newton_minimizer(double gradient_tolerance = internal::tolerance::gradient,
                                    std::size_t maximum_number_of_iterations = 500)
    : m_limits{gradient_tolerance, maximum_number_of_iterations}
  {
    CGAL_precondition(gradient_tolerance >= 0);
  }

  /// minimizes `energy`, starting from `u`. An iteration evaluates the energy once, and factorizes
  /// a sparse matrix for each active set that it tries, mostly one or two.
  /// \tparam Energy a model of `ConvexEnergy`
  /// \tparam Visitor a model of `MinimizationVisitor`
  /// \param energy the energy; afterwards it has been evaluated at `u`
  /// \param u the point to start from; variables below their bounds start at the bounds. Afterwards
  ///   the visited point with the least gradient (max norm, without positive entries at bounds).
  /// \param lower_bound the bounds; minus infinity for none
  /// \param domain which variables are fixed; their bounds are ignored
  /// \param visitor is notified of every step; if it throws, `u` is the best point so far
  /// \pre `u` and `lower_bound` have the size of the energy, and `domain` has no components.
  template <typename Energy, typename Visitor>
  Minimization_result operator()(Energy& energy, Eigen::VectorXd& u,
                                 const Eigen::VectorXd& lower_bound,
                                 const Minimization_domain& domain, Visitor&& visitor) const
  {
    typedef internal::Bounded_variables Variables;
    CGAL_precondition(static_cast<std::size_t>(u.size()) == energy.size());
    CGAL_precondition(lower_bound.size() == u.size());
    const Variables variables(domain, lower_bound);
    u = variables.feasible(u);
    internal::Newton_iteration<Energy, Visitor, Variables, internal::Bounded_direction> iteration(
      energy, u, variables, m_limits, visitor);
    return iteration.run();
  }

  /// minimizes without a visitor.
  template <typename Energy>
  Minimization_result operator()(Energy& energy, Eigen::VectorXd& u,
                                 const Eigen::VectorXd& lower_bound,
                                 const Minimization_domain& domain = Minimization_domain()) const
  {
    return (*this)(energy, u, lower_bound, domain, Default_minimization_visitor());
  }

private:
  internal::Minimization_limits m_limits;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_BOUNDED_NEWTON_MINIMIZER_H
