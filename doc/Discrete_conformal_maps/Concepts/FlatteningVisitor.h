// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgDiscreteConformalMapsConcepts
/// \cgalConcept
///
/// observes the progress of `CGAL::Discrete_conformal_maps::flatten()`: to show it, to measure times, or
/// to stop the work by an exception.
///
/// \cgalRefines{MinimizationVisitor}
///
/// \cgalHasModel `CGAL::Discrete_conformal_maps::Default_flattening_visitor`
class FlatteningVisitor
{
public:
  /// is called when a stage of the work begins, in their order. The flips to \f$T_2\f$, before the
  /// first stage, have no stage. `after_iteration()` is called in
  /// `CGAL::Discrete_conformal_maps::Flattening_stage::optimize` only. If the minimization is
  /// repeated, after a further cone or in extended precision, iterations are counted from one
  /// again. On a surface with boundary, `flatten()` traces and subdivides before the layout: the
  /// subdivision determines which edges of \f$T_3\f$ belong to the surface.
  /// `CGAL::Discrete_conformal_maps::map_to_sphere()` repeats the stages of optimization and layout
  /// if the first result is no success. An exception leaves `flatten()`.
  void start(CGAL::Discrete_conformal_maps::Flattening_stage stage);
};
