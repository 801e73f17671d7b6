// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_POINT_ACROSS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_POINT_ACROSS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Correspondence_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_face_walk.h>
#include <CGAL/Intrinsic_triangulations/trace.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// the sides of a face, traced one by one
template <typename Traits>
class Traced_marks
{
  typedef typename Traits::FT FT;

public:
  Traced_marks(Side side, Face_index f, const Intrinsic_triangulation<Traits>& tri)
    : m_side(side), m_halfedge(sides(f, tri.surface(side).mesh())), m_tri(tri)
  {
    for(std::size_t s = 0; s < 3; ++s)
      m_trace[s] = side == Side::input ? internal::scaled_input_trace(m_halfedge[s], tri)
                                       : internal::scaled_intrinsic_trace(m_halfedge[s], tri);
  }

  // an edge has two ends, and so has its trace
  std::size_t crossings(std::size_t s) const { return m_trace[s].points.size() - 2; }
  FT here(std::size_t s, std::size_t p) const
  {
    const Trace_point<FT>& point = m_trace[s].points[p + 1];
    return m_side == Side::input ? point.on_input.t : point.on_intrinsic.t;
  }
  Edge_point<FT> across(std::size_t s, std::size_t p) const
  {
    return reversed(there(s, p + 1), other());
  }
  FT scale(std::size_t s, std::size_t p) const
  {
    const FT on_input = m_trace[s].scale(p + 1);
    return m_side == Side::input ? on_input : FT(1 / on_input);
  }
  Halfedge_index outgoing_before(std::size_t s) const { return there(s, 0).halfedge; }
  Face_location<FT> vertex_across(std::size_t s, const Edge_point<FT>& at) const
  {
    return m_side == Side::input ? face_location(at, m_tri.mesh())
                                 : m_tri.input_location(m_tri.mesh().source(m_halfedge[s]), at);
  }

private:
  const Delta_complex& other() const { return m_tri.surface(internal::other(m_side)).mesh(); }

  const Edge_point<FT>& there(std::size_t s, std::size_t point) const
  {
    const Trace_point<FT>& p = m_trace[s].points[point];
    return m_side == Side::input ? p.on_intrinsic : p.on_input;
  }

  Side m_side;
  std::array<Halfedge_index, 3> m_halfedge;
  const Intrinsic_triangulation<Traits>& m_tri;
  std::array<Scaled_trace<Traits>, 3> m_trace;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// finds the point `p` of one triangulation on the other.
///
/// The map is linear on the regions of the common subdivision, or projective in a geometry whose
/// crossings have scales (see the concept `GeodesicStrip`), and continuous; a vertex goes to the
/// vertex, exactly, and a point of a shared edge to that edge. There and back is the identity up
/// to rounding.
/// \param correspondence the crossings of both
/// \param side the triangulation on which `p` lies
/// \param p a point with barycentric coordinates that are not negative and sum up to one
/// Complexity: logarithmic in the number of crossings on the sides of the face. In a face of
/// \f$T_1\f$ that contains inserted vertices: linear in the regions of the subdivision on the way
/// from a corner, and logarithmic in their crossings.
template <typename Traits>
Face_location<typename Traits::FT> point_across(const Correspondence<Traits>& correspondence,
                                                Side side,
                                                const Face_location<typename Traits::FT>& p)
{
  typedef internal::Correspondence_marks<Traits> Marks;
  if(side == Side::input && correspondence.contains_inserted(p.first) &&
     !is_at_vertex(surface_point(p, correspondence.mesh(side))))
    return internal::Input_face_walk<Traits>(correspondence)(p);
  const Marks marks(side, p.first, correspondence);
  const Delta_complex& other = correspondence.mesh(internal::other(side));
  return internal::Face_map<typename Traits::FT, Marks>(marks, other)(p.second);
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// finds a single point `p` of one triangulation on the other, without a correspondence: the sides
/// of its face are traced. Complexity: that of `trace_input_edge()` or `trace_intrinsic_edge()` for
/// these sides; if `p` is on \f$T_1\f$ and vertices have been inserted, that of `Correspondence`.
template <typename Traits>
Face_location<typename Traits::FT> point_across(const Intrinsic_triangulation<Traits>& tri,
                                                Side side,
                                                const Face_location<typename Traits::FT>& p)
{
  typedef internal::Traced_marks<Traits> Marks;
  if(side == Side::input && tri.number_of_inserted_vertices() > 0)
    return point_across(Correspondence<Traits>(tri), side, p);
  const Marks marks(side, p.first, tri);
  const Delta_complex& other = side == Side::input ? tri.mesh() : tri.input_mesh();
  return internal::Face_map<typename Traits::FT, Marks>(marks, other)(p.second);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_POINT_ACROSS_H
