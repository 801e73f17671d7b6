// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicTriangulationsConcepts
/// \cgalConcept
///
/// observes every change that `CGAL::Intrinsic_triangulations::refine()` makes: to show progress, to
/// keep data up to date, or to stop by an exception.
///
/// When a function is called, the triangulation is valid, but may have elements marked as removed;
/// it must not be changed. After an exception, the triangulation is valid and
/// without garbage.
///
/// Every model is a model of `FlipVisitor`.
///
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Default_refinement_visitor`
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Angular_coordinates`
class RefinementVisitor
{
public:
  /// is called after the edge of `h` has been turned, also by a removal and by `make_Delaunay()`:
  /// `h` leads along the new edge.
  void after_flip(CGAL::Intrinsic_triangulations::Halfedge_index h);

  /// is called if lengths leave too many decisions undecided, or if edges are bent. \f$T_2\f$ has
  /// been reset to \f$T_1\f$, with the inserted vertices, and flipping restarts with exact
  /// decisions.
  void before_exact_flips();

  /// is called after the vertex `v` has been inserted by `inserter`, before any edge is flipped.
  template <typename Traits>
  void after_insertion(CGAL::Intrinsic_triangulations::Vertex_index v,
                       const CGAL::Intrinsic_triangulations::Vertex_inserter<Traits>& inserter);

  /// is called after the vertex `v` has been removed; the face `f` remains.
  void after_removal(CGAL::Intrinsic_triangulations::Vertex_index v,
                     CGAL::Intrinsic_triangulations::Face_index f);

  /// is called after the elements of the triangulation have got other indices (see
  /// `CGAL::Intrinsic_triangulations::Intrinsic_triangulation::collect_garbage()`).
  void after_renumbering();

  /// is called if rounding leaves too many decisions undecided. \f$T_2\f$ has been reset to
  /// \f$T_1\f$, without flips and only with the vertices that it had at the start. Then refinement
  /// restarts with exact decisions.
  void before_exact_refinement();
};
