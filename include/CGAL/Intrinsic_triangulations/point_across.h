// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_POINT_ACROSS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_POINT_ACROSS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Correspondence_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_face_walk.h>
#include <CGAL/Intrinsic_triangulations/trace.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Sets the marks on the sides of the face `f` of T1, which has no inserted vertices.
template <typename Traits>
void trace_sides(Face_index f, const Intrinsic_triangulation<Traits>& tri,
                 Face_marks<Traits>& marks)
{
  marks.start(Side::input, f);
  for(std::size_t s = 0; s < 3; ++s) {
    const Scaled_trace<Traits> trace = scaled_input_trace(marks.side(s), tri);
    marks.set_outgoing_before(s, trace.points.front().on_intrinsic.halfedge);
    for(std::size_t p = 1; p + 1 < trace.points.size(); ++p)
      marks.add(s, trace.points[p].on_input.t, reversed(trace.points[p].on_intrinsic, tri.mesh()),
                trace.scale(p));
  }
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// maps the point `p` of one triangulation to the other.
///
/// The map is continuous, and linear on the regions of the common subdivision. In a geometry whose
/// crossings have scales (see the concept `GeodesicStrip`) it is projective on them. A vertex maps
/// to the vertex, exactly, and a point of a shared edge to that edge. Mapping a point to the other
/// triangulation and back is the identity up to rounding.
/// \param correspondence the crossings of both
/// \param side the triangulation on which `p` lies
/// \param p a `Face_location`, an `Edge_location` or a `Surface_point`, with coordinates that are
///        not negative and sum up to one
///
/// Complexity: logarithmic in the number of crossings on the sides of the face. In a face of
/// \f$T_1\f$ that contains inserted vertices, it is linear in the regions of the subdivision
/// between the point and a corner. It is logarithmic in their crossings.
template <typename Traits, typename Point = Face_location<typename Traits::FT>>
Face_location<typename Traits::FT> point_across(const Correspondence<Traits>& correspondence,
                                                Side side, const Point& p)
{
  typedef internal::Correspondence_marks<Traits> Marks;
  const auto& q = face_location(p, correspondence.mesh(side));
  if(side == Side::input && correspondence.contains_inserted(q.first) &&
     !is_at_vertex(surface_point(q, correspondence.mesh(side))))
    return internal::Input_face_walk<Traits>(correspondence)(q);
  const Marks marks(side, q.first, correspondence);
  const Delta_complex& other = correspondence.mesh(internal::other(side));
  return internal::Face_map<typename Traits::FT, Marks>(marks, other)(q.second);
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// maps a single point `p` of one triangulation to the other, without a correspondence: the sides
/// of its face are traced. Complexity: the complexity of `trace_input_edge()` or
/// `trace_intrinsic_edge()` for these sides. If `p` is on \f$T_1\f$ and vertices have been
/// inserted, it is the complexity of `Correspondence`.
/// \param tri both triangulations
/// \param side the triangulation with the point
/// \param p the point, as with a correspondence
/// \returns the point on the other triangulation
template <typename Traits, typename Point = Face_location<typename Traits::FT>>
Face_location<typename Traits::FT> point_across(const Intrinsic_triangulation<Traits>& tri,
                                                Side side, const Point& p)
{
  typedef internal::Face_marks<Traits> Marks;
  if(side == Side::input && tri.number_of_inserted_vertices() > 0)
    return point_across(Correspondence<Traits>(tri), side, p);
  const auto& q = face_location(p, tri.surface(side).mesh());
  Marks marks(tri);
  if(side == Side::input)
    internal::trace_sides(q.first, tri, marks);
  else
    marks.set_face(q.first, internal::Edge_courses<Traits>(tri));
  const Delta_complex& other = side == Side::input ? tri.mesh() : tri.input_mesh();
  return internal::Face_map<typename Traits::FT, Marks>(marks, other)(q.second);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_POINT_ACROSS_H
