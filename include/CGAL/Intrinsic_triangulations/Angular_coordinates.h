// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ANGULAR_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ANGULAR_COORDINATES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/angle_in_strip.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>

#include <cmath>
#include <complex>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTangent
/// stores the directions of all halfedges of \f$T_2\f$ in the frames of \f$T_1\f$, which flips do
/// not change.
///
/// The angular coordinate of a halfedge is its normalized angle at its source (Section 2.3.2), as
/// `angle_on_input()` gives it. The object is a visitor that keeps the angles up to date:
/// \code
/// Angular_coordinates<> angles(tri);
/// make_Delaunay(tri, parameters::visitor(std::ref(angles)));
/// refine(tri, parameters::visitor(std::ref(angles)));
/// \endcode
/// A new halfedge goes between its two neighbors in the proportion of the two corners. So the
/// errors of angles do not grow with the number of flips, up to the rounding of each. After other
/// changes of `tri` the functions below must be called. After
/// `Intrinsic_triangulation::collect_garbage()`, which renumbers halfedges, `recompute()` must be
/// called.
///
/// The object refers to the triangulation. Memory: two numbers for each halfedge and one for each
/// vertex.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraits` with a floating point type `FT`
/// \cgalModels `RefinementVisitor`, `FlipVisitor`
template <typename Traits_ = Euclidean_geometry_traits<double>>
class Angular_coordinates
{
public:
  /// the geometry.
  typedef Traits_ Traits;
  /// the type of the triangulation.
  typedef Intrinsic_triangulation<Traits> Triangulation;
  /// the type of angles.
  typedef typename Traits::FT FT;
  static_assert(std::is_floating_point<FT>::value, "directions are angles");

  /// computes the angles from the integer coordinates and the lengths of \f$T_1\f$.
  /// Complexity: linear in the vertices, edges and crossings.
  /// \throws Numerical_error if the angles at a vertex have no positive finite sum, or if the
  ///         layout of an edge has no positive finite length
  /// \throws Overflow_error if there are more crossings than a `Surface_mesh` can number
  explicit Angular_coordinates(const Triangulation& tri) : m_tri(tri), m_frames(tri.input())
  {
    recompute();
  }

  Angular_coordinates(Triangulation&&) =
    delete; // it would refer to an object that no longer exists

  /// returns the triangulation.
  const Triangulation& triangulation() const { return m_tri; }

  /// returns the normalized angle \f$\varphi\f$ in which the halfedge `h` of \f$T_2\f$ leaves its
  /// source, in the frame of \f$T_1\f$. It is between 0 and \f$2\pi\f$, up to rounding.
  const FT& angle(Halfedge_index h) const { return m_angle[h.idx()]; }

  /// returns the parallel transport \f$R_{ij}\f$ along the halfedge `h` of \f$T_2\f$ between the
  /// frames of \f$T_1\f$ (see `Tangent_frames::transport()`).
  std::complex<FT> transport(Halfedge_index h) const
  {
    return -std::polar(FT(1), angle(m_tri.mesh().opposite(h)) - angle(h));
  }

  /// returns the frames of \f$T_1\f$ at its vertices. For frames at inserted vertices see
  /// `angle_on_input()`.
  const Tangent_frames<FT>& frames() const { return m_frames; }

  /// computes all angles, as the constructor does. This function must be called after other
  /// changes of \f$T_2\f$, or if its elements have been renumbered.
  void recompute()
  {
    const Delta_complex& mesh = m_tri.mesh();
    const internal::Edge_courses<Traits> courses(m_tri, Concurrency());
    m_angle.resize(mesh.num_halfedges());
    for(Halfedge_index h : mesh.halfedges())
      m_angle[h.idx()] = angle_in_strip(h, courses(h));
  }

  /// computes the angles of the edge of `h`, which has just been flipped, from its two faces. A
  /// shared edge gets the angles of \f$T_1\f$. Complexity: constant.
  void after_flip(Halfedge_index h)
  {
    set_angle(h);
    set_angle(m_tri.mesh().opposite(h));
  }

  /// calls `recompute()`.
  void before_exact_flips() { recompute(); }

  /// computes the angles of all edges at `v`, which has just been inserted. The direction of one
  /// edge comes from the triangles of \f$T_1\f$ that it passes. This edge is shared, or passes a
  /// single triangle, or is the longest. Complexity: linear in the degree of `v` and the crossings
  /// on this edge.
  /// \param v the vertex
  /// \param inserter the object that has inserted it
  /// \throws Numerical_error if the layout of the edge has no positive finite length
  void after_insertion(Vertex_index v, const Vertex_inserter<Traits>& inserter)
  {
    const Delta_complex& mesh = m_tri.mesh();
    m_angle.resize(mesh.num_halfedges());
    const Halfedge_index start = outgoing_to_start_with(v);
    set_angles_around(v, start, angle_in_strip(start, inserter.courses()(start)));
    for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) { set_angle(mesh.opposite(h)); });
  }

  /// updates the sides of the face `f`, which has replaced the vertex `v`. Shared sides get the
  /// angles of \f$T_1\f$. Complexity: constant.
  void after_removal(Vertex_index /* v */, Face_index f)
  {
    for(Halfedge_index h : sides(f, m_tri.mesh()))
      for(Halfedge_index x : {h, m_tri.mesh().opposite(h)})
        if(is_shared(x))
          set_angle(x);
  }

  /// calls `recompute()`.
  void after_renumbering() { recompute(); }

  /// calls `recompute()`.
  void before_exact_refinement() { recompute(); }

private:
  bool is_shared(Halfedge_index h) const
  {
    return m_tri.coordinates().is_shared(m_tri.mesh().edge(h));
  }

  bool starts_at_inserted(Halfedge_index h) const
  {
    return m_tri.is_inserted(m_tri.mesh().source(h));
  }

  // The surface is flat at inserted vertices.
  FT scale_at(Halfedge_index h) const
  {
    return starts_at_inserted(h) ? FT(1) : m_frames.scale(m_tri.mesh().source(h));
  }

  FT angle_of_outgoing_before(Halfedge_index h) const
  {
    return starts_at_inserted(h) ? internal::angle_of_inserted_outgoing(h, m_tri)
                                 : m_frames.angle(m_tri.input_outgoing_before(h));
  }

  FT angle_in_strip(Halfedge_index h, const Edge_course& course)
  {
    return angle_of_outgoing_before(h) +
           scale_at(h) * internal::angle_from_outgoing(h, course, m_tri, m_strip);
  }

  void set_angle(Halfedge_index h)
  {
    m_angle[h.idx()] = is_shared(h) ? angle_of_outgoing_before(h) : angle_between_neighbors(h);
  }

  // Returns a shared halfedge if one exists, otherwise one inside a face of T1. If several exist,
  // returns the longest one, whose direction has the smallest error.
  Halfedge_index outgoing_to_start_with(Vertex_index v) const
  {
    const auto rank = [this](Halfedge_index h) {
      return std::make_tuple(is_shared(h), m_tri.coordinates().crossings(h) == 0,
                             m_tri.length(m_tri.mesh().edge(h)));
    };
    Halfedge_index best = first_outgoing_halfedge(v, m_tri.mesh());
    for_each_outgoing_halfedge(v, m_tri.mesh(), [&](Halfedge_index h) {
      if(rank(best) < rank(h))
        best = h;
    });
    return best;
  }

  // Sets the angles of the outgoing halfedges of the inserted vertex `v` in the ratio of the
  // corners, from one known angle.
  void set_angles_around(Vertex_index v, Halfedge_index start, const FT& angle_of_start)
  {
    const Delta_complex& mesh = m_tri.mesh();
    FT sum(0);
    for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
      m_angle[h.idx()] = sum;
      sum += mesh.is_border(h) ? FT(0) : corner(h);
    });
    const FT before_start = angle(start), whole = (mesh.is_border(v) ? 1 : 2) * pi<FT>();
    for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
      const FT part = sum > 0 ? (angle(h) - before_start) / sum : FT(0);
      m_angle[h.idx()] =
        is_shared(h) ? angle_of_outgoing_before(h) : wrapped(angle_of_start + whole * part);
    });
  }

  static FT wrapped(const FT& angle)
  {
    const FT turn = 2 * pi<FT>();
    return angle < 0 ? angle + turn : angle < turn ? angle : angle - turn;
  }

  FT corner(Halfedge_index h) const { return internal::angle_at_source(h, m_tri); }

  // Returns the angle of `h` between its neighbors. The difference between this angle and the sum
  // of both corners is distributed over the corners.
  FT angle_between_neighbors(Halfedge_index h) const
  {
    const Halfedge_index before = previous_around_source(h, m_tri.mesh());
    const FT scale = scale_at(h), turn = 2 * pi<FT>();
    const FT right = scale * corner(before), both = right + scale * corner(h);
    const FT gap = angle(next_around_source(h, m_tri.mesh())) - angle(before);
    const FT lack = std::remainder(gap - both, turn);
    return wrapped(angle(before) + right + (both > 0 ? lack * (right / both) : FT(0)));
  }

  const Triangulation& m_tri;
  Tangent_frames<FT> m_frames;
  std::vector<FT> m_angle; // of each halfedge of T2, at its source
  Euclidean_strip<FT> m_strip;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ANGULAR_COORDINATES_H
