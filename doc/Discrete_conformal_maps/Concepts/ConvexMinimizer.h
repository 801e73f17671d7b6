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
  /// minimizes `energy`, starting from `u`.
  /// \tparam Energy a model of `ConvexEnergy`
  /// \tparam Visitor a model of `MinimizationVisitor`, or a reference to one
  /// \param energy the energy; afterwards it has been evaluated at `u`
  /// \param u the point to start from; afterwards the visited point with the least gradient (max
  ///   norm), finite if the start is finite. Fixed variables keep their values. A component without
  ///   fixed variables keeps its mean, up to rounding.
  /// \param domain the fixed variables, and the directions along which the energy is constant
  /// \param visitor is notified of every step; if it throws, `u` is the best point so far. It can be omitted;
  ///   `domain` can be omitted too if all variables are free.
  /// \pre `u` has the size of the energy.
  template <typename Energy, typename Visitor>
  CGAL::Discrete_conformal_maps::Minimization_result
  operator()(Energy& energy, Eigen::VectorXd& u,
             const CGAL::Discrete_conformal_maps::Minimization_domain& domain,
             Visitor&& visitor) const;
};
