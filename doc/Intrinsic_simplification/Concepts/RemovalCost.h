// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicSimplificationConcepts
/// \cgalConcept
///
/// tells what it costs to remove a vertex. Vertices are removed in the order of their costs.
///
/// A cost may depend on the star of the vertex, flattened or not, and on anything that is known about the
/// vertices there. The cost of a vertex is asked for again before it is removed, but as long as its old cost
/// is not the least of all, it counts: costs should grow, by and large, while vertices are removed around.
///
/// \cgalHasModel `CGAL::Intrinsic_simplification::Transport_cost`
class RemovalCost
{
public:
  /// returns the cost of removing the center of `star`.
  double operator()(const CGAL::Intrinsic_simplification::Flattened_star& star);

  /// is called after the center of `star` has been removed; `star` still shows it as it was before.
  void after_removal(const CGAL::Intrinsic_simplification::Flattened_star& star);
};
