// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgDiscreteConformalMapsConcepts
/// \cgalConcept
///
/// finds the minimum of a convex energy.
///
/// \cgalRefines{CopyConstructible}
///
/// \cgalHasModel `CGAL::Discrete_conformal_maps::Newton_minimizer`
/// \cgalHasModel `CGAL::Discrete_conformal_maps::Ceres_minimizer`
class ConvexMinimizer
{
public:
  /// minimizes `energy` from `u` on.
  /// \tparam Energy a model of `ConvexEnergy`
  /// \tparam Visitor a model of `MinimizationVisitor`, or a reference to one
  /// \param energy the energy; afterwards it has been evaluated at `u`
  /// \param u the point to start from; afterwards the point with the least gradient (max norm) that
  ///        has been seen, finite if the start was. Fixed variables keep their values; on a
  ///        component without one, the mean stays, up to rounding.
  /// \param domain which variables are fixed, and where the energy is constant
  /// \param visitor sees every step; if it throws, `u` is the best point so far. It can be left
  ///        out, and so can `domain` if all variables move.
  /// \pre The size of `u` is that of the energy.
  template <typename Energy, typename Visitor>
  CGAL::Discrete_conformal_maps::Minimization_result
  operator()(Energy& energy, Eigen::VectorXd& u,
             const CGAL::Discrete_conformal_maps::Minimization_domain& domain,
             Visitor&& visitor) const;
};
