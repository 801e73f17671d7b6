// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXPONENTIAL_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXPONENTIAL_MAP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Geodesic.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Geodesic_tracer.h>

#include <CGAL/iterator.h>

#include <complex>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTangent
/// follows the geodesic that starts at `source` with the tangent vector `vector`, for the length of
/// this vector: the exponential map.
///
/// At a vertex the angle of the vector is normalized as in `Tangent_frames`. At a point of a face
/// the vector is in the frame of the face, whose real axis is along `halfedge(source.first)`. From
/// a point on an edge it may point out of the face. At a corner its angle is measured from the
/// sides of the face, on the surface, and may lead beyond the face too.
///
/// In every face the geodesic is straight, and it runs straight from face to face. If it hits an
/// interior vertex (within `rounding_unit()`), it continues with half of the angles of the vertex
/// on either side. If the end is within rounding of an edge or a vertex, it snaps to it, with
/// coordinates that are exactly zero.
///
/// A geodesic may run in the boundary. With `At_boundary::stop` it passes a vertex on the boundary
/// if it can continue with the angle pi on one of its sides. So it follows a straight border. It
/// stops if no side or both sides of the surface have this angle.
///
/// Thin triangles lose no digits: end and length are accurate to rounding of the longest edge for
/// every face passed. Geodesics on either side of a vertex with curvature diverge. A geodesic that
/// passes a vertex at the distance of rounding errors ends on one of its two sides.
///
/// \param surface a model of `IntrinsicSurface` with floating point lengths; loops, parallel edges
///        and faces that meet themselves are allowed
/// \param source the start: a vertex that is not isolated, or a `Face_location` with coordinates
///        that are not negative and sum up to one
/// \param vector the tangent vector
/// \param at_boundary whether the geodesic stops at the boundary or continues along it. A geodesic
///   that continues stays on the boundary until its length is used up
/// \param path an output iterator for `Edge_point`s. If the geodesic crosses an edge, it receives
///   the halfedge through which it leaves a face. If the geodesic passes a vertex, it receives a
///   halfedge that ends at the vertex. On the boundary it receives a halfedge that starts at the
///   vertex if the geodesic slides against the halfedges of the faces. Start and end are not part
///   of it.
///
/// Complexity: linear in the faces passed, and the degrees of vertices hit.
/// \throws Numerical_error if the angles at a vertex that it passes have no positive finite sum,
///   or the length is so great that steps vanish beside it
template <typename Surface, typename Source, typename OutputIterator = CGAL::Emptyset_iterator>
Geodesic<Length_of<Surface>> trace_geodesic(const Surface& surface, const Source& source,
                                            const std::complex<Length_of<Surface>>& vector,
                                            At_boundary at_boundary = At_boundary::stop,
                                            OutputIterator path = OutputIterator())
{
  return internal::Geodesic_tracer(internal::view_of(surface), at_boundary, path)
    .from(source, vector);
}

namespace internal {

// Starts at a vertex that only T2 has, over T1. Its frame is the frame of its face, or of its
// first outgoing halfedge.
template <typename Traits, typename OutputIterator>
Geodesic<typename Traits::FT> trace_from_inserted(const Intrinsic_triangulation<Traits>& tri,
                                                  Vertex_index v,
                                                  const std::complex<typename Traits::FT>& vector,
                                                  At_boundary at_boundary, OutputIterator path)
{
  typedef typename Traits::FT FT;
  const auto input = tri.input();
  const Delta_complex& mesh = input.mesh();
  if(tri.outgoing_halfedges().degree(v) == 0)
    return trace_geodesic(input, face_location(tri.inserted_vertex(v), mesh), vector, at_boundary,
                          path);
  const Halfedge_index axis = tri.outgoing_halfedges().halfedge(v, 0);
  const Face_location<FT> p = face_location(Edge_point<FT>{axis, tri.place_along(axis, v)}, mesh);
  const std::complex<FT> turn =
    Flat_face<FT>(mesh.halfedge(p.first), input).direction(side_number(axis, mesh));
  Geodesic<FT> result = trace_geodesic(input, p, vector * turn, at_boundary, path);
  result.transport *= turn;
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTangent
/// follows the geodesic on one of the two triangulations of `tri` that starts at a vertex of
/// \f$T_2\f$. On \f$T_1\f$ this may be an inserted vertex; for its frame see `angle_on_input()`.
/// Complexity: linear in the number of crossed edges.
template <typename Traits, typename OutputIterator = CGAL::Emptyset_iterator>
Geodesic<typename Traits::FT>
trace_geodesic(const Intrinsic_triangulation<Traits>& tri, Side side, Vertex_index v,
               const std::complex<typename Traits::FT>& vector,
               At_boundary at_boundary = At_boundary::stop, OutputIterator path = OutputIterator())
{
  if(side == Side::input && tri.is_inserted(v))
    return internal::trace_from_inserted(tri, v, vector, at_boundary, path);
  return trace_geodesic(tri.surface(side), v, vector, at_boundary, path);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXPONENTIAL_MAP_H
