// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicSimplificationConcepts
/// \cgalConcept
///
/// says how bad it is to remove a vertex. `CGAL::Intrinsic_simplification::simplify()` removes the
/// vertex of least cost first.
///
/// A cost that has been computed is kept until the vertex is the next to be removed, and is
/// computed afresh then. So if removals nearby make a cost smaller, the vertex may be removed later
/// than it should; greater costs have no such effect.
///
/// \cgalHasModel `CGAL::Intrinsic_simplification::Transport_cost`
class RemovalCost
{
public:
  /// returns the cost of removing the center of `star`, which has been flattened: how lengths and
  /// angles at the neighbors would change is known. It must not be NaN; with an infinite cost the
  /// vertex is removed after all others.
  double operator()(const CGAL::Intrinsic_simplification::Flattened_star& star);

  /// is called after the center of `star` has been removed. `star` is as it was before.
  void after_removal(const CGAL::Intrinsic_simplification::Flattened_star& star);
};
