// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicTriangulationsConcepts
/// \cgalConcept
///
/// observes every flip that `CGAL::Intrinsic_triangulations::make_Delaunay()` makes: to show progress,
/// to record the flips, or to stop them by an exception.
///
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Default_flip_visitor`
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Angular_coordinates`
class FlipVisitor
{
public:
  /// is called after the edge of `h` has been turned: `h` leads along the new edge. The
  /// triangulation is valid then, and must not be changed here. An exception leaves
  /// `make_Delaunay()`.
  void after_flip(CGAL::Intrinsic_triangulations::Halfedge_index h);

  /// is called if lengths leave too many decisions undecided, or if edges are bent. \f$T_2\f$ has
  /// been reset to \f$T_1\f$, with the inserted vertices, and flipping restarts with exact
  /// decisions.
  void before_exact_flips();
};
