// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicSimplificationConcepts
/// \cgalConcept
///
/// says how bad it is to remove a vertex. `CGAL::Intrinsic_simplification::simplify()` removes the
/// vertex of least cost first.
///
/// A cost is computed anew when the star of the vertex has changed, by the removal of a neighbor or
/// a flip after it (Algorithm 6). So if it is a function of the star alone, the cheapest vertex is
/// removed each time. If it also depends on what `after_removal()` changes at the neighbors, it is
/// computed anew only when the vertex comes first; if it has become smaller by such a change, the
/// vertex may be removed later than it should.
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
