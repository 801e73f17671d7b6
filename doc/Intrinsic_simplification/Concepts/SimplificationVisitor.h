// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicSimplificationConcepts
/// \cgalConcept
///
/// sees every removal of a simplification: to show progress, to record, or to stop it by an exception, which
/// leaves the surface valid and Delaunay.
///
/// \cgalHasModel `CGAL::Intrinsic_simplification::Default_simplification_visitor`
class SimplificationVisitor
{
public:
  /// is called before a vertex is removed.
  /// \param star the flattened star of the vertex
  /// \param cost its cost
  void before_removal(const CGAL::Intrinsic_simplification::Flattened_star& star, double cost);

  /// is called after a vertex has been removed and the triangulation has become Delaunay again. It is left
  /// out if the vertex turns out not to be separable.
  void after_removal(CGAL::Intrinsic_simplification::Vertex_index v);
};
