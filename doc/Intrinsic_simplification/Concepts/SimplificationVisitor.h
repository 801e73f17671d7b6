// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicSimplificationConcepts
/// \cgalConcept
///
/// observes every removal by `CGAL::Intrinsic_simplification::simplify()`. It can show progress, keep
/// levels of a hierarchy, or stop by an exception.
///
/// \cgalHasModel `CGAL::Intrinsic_simplification::Default_simplification_visitor`
class SimplificationVisitor
{
public:
  /// is called before the center of `star` is removed. In rare cases the removal fails, and
  /// `after_removal()` is not called.
  /// \param star the flattened star of the vertex
  /// \param cost its cost
  void before_removal(const CGAL::Intrinsic_simplification::Flattened_star& star, double cost);

  /// is called after the vertex `v` has been removed and the triangulation has become Delaunay
  /// again. The function must not change the surface. An exception leaves `simplify()` with the
  /// surface valid.
  void after_removal(CGAL::Intrinsic_simplification::Vertex_index v);
};
