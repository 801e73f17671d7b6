// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicSimplificationConcepts
/// \cgalConcept
///
/// returns the cost of removing a vertex. `CGAL::Intrinsic_simplification::simplify()` removes the
/// vertex of least cost first.
///
/// A cost is computed again when a removal of a neighbor or a later flip has changed the star of
/// the vertex (Algorithm 6). So if it depends on the star alone, the cheapest vertex is removed
/// each time. It may also depend on changes of `after_removal()` at the neighbors. Then it is
/// computed again only when the vertex comes first. If such a change decreases it, the vertex may
/// be removed too late.
///
/// \cgalHasModel `CGAL::Intrinsic_simplification::Transport_cost`
class RemovalCost
{
public:
  /// returns the cost of removing the center of `star`. The star is flattened, so that the changes
  /// of lengths and angles at the neighbors are known. The cost must not be NaN; with an infinite
  /// cost the vertex is removed after all others.
  double operator()(const CGAL::Intrinsic_simplification::Flattened_star& star);

  /// is called after the center of `star` has been removed. `star` is the star before the removal.
  void after_removal(const CGAL::Intrinsic_simplification::Flattened_star& star);
};
