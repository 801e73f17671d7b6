// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgDiscreteConformalMapsConcepts
/// \cgalConcept
///
/// sees the progress of `CGAL::Discrete_conformal_maps::flatten()`: to show it, to take times, or
/// to stop the work by an exception.
///
/// \cgalRefines{MinimizationVisitor}
///
/// \cgalHasModel `CGAL::Discrete_conformal_maps::Default_flattening_visitor`
class FlatteningVisitor
{
public:
  /// is called when a stage of the work begins, in their order. What happens before the first, the
  /// making of \f$T^B\f$, has no stage. `after_iteration()` is called in
  /// `CGAL::Discrete_conformal_maps::Flattening_stage::optimize` only; where the minimization is
  /// repeated (after a further cone, or in extended precision), iterations are counted from one
  /// again. On a surface with boundary, `flatten()` traces and subdivides before the layout: the
  /// subdivision determines which edges of \f$T^C\f$ belong to the surface.
  /// In `CGAL::Discrete_conformal_maps::map_to_sphere()` the stages of optimization and layout come
  /// more than once if the first result is not good. An exception leaves `flatten()`.
  void start(CGAL::Discrete_conformal_maps::Flattening_stage stage);
};
