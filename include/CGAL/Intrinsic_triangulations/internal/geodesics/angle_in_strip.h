// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_ANGLE_IN_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_ANGLE_IN_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_course.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>

#include <complex>
#include <cstddef>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the position of the source of a halfedge of T2 in the face of T1 into which it leads. In
// the layout of this face, the outgoing halfedge before the halfedge is on the x-axis. If the
// source lies inside the face f, halfedge(f) is on the x-axis.
template <typename Traits>
struct Start_in_input_face
{
  typedef typename Traits::FT FT;

  Start_in_input_face(Halfedge_index h, const Intrinsic_triangulation<Traits>& tri)
    : location(tri.input_location(h)),
      axis(tri.input_outgoing_before(h).is_valid() ? tri.input_outgoing_before(h)
                                                   : tri.input_mesh().halfedge(location.first)),
      face(axis, tri.input()),
      place(coordinates_from(axis, location, tri.input_mesh()))
  {}

  // Returns the coordinates of the point, beginning with the corner opposite to side `s`.
  typename Flat_face<FT>::Place place_beyond(std::size_t s) const
  {
    return {place[(s + 2) % 3], place[s], place[(s + 1) % 3]};
  }

  Face_location<FT> location;
  Halfedge_index axis;
  Flat_face<FT> face;
  typename Flat_face<FT>::Place place; // the coordinate of the source of the axis first
};

// Returns the angle between the x-axis of `start` and the halfedge `h` of T2, in (-pi, 2 pi).
template <typename Traits>
typename Traits::FT angle_in_strip(const Start_in_input_face<Traits>& start, Halfedge_index h,
                                   const Edge_course& course,
                                   const Intrinsic_triangulation<Traits>& tri,
                                   Euclidean_strip<typename Traits::FT>& strip)
{
  const Delta_complex& mesh = tri.input_mesh();
  const Start_in_input_face<Traits> end(tri.mesh().opposite(h), tri);
  if(course.empty())
    return std::arg(
      start.face.between(start.place, coordinates_from(start.axis, end.location, mesh)));
  const std::size_t first = side_number(course[0], start.axis, mesh);
  const std::size_t last = side_number(opposite(course[course.size() - 1]), end.axis, mesh);
  lay_out_strip(strip, tri.input(), course,
                std::make_pair(start.place_beyond(first), end.place_beyond(last)));
  if(!tri.traits().is_length_object()(strip.length()))
    throw Numerical_error("the strip of edge " + std::to_string(tri.mesh().edge(h).idx()) +
                          " has no positive finite length");
  return std::arg(start.face.to_corner(first, start.place)) + strip.angle();
}

// Returns the angle on the surface, counterclockwise to the halfedge `h` of T2. It starts from the
// outgoing halfedge of T1 before `h`, or from halfedge(f) if the source lies inside the face f of
// T1.
template <typename Traits>
typename Traits::FT angle_from_outgoing(Halfedge_index h, const Edge_course& course,
                                        const Intrinsic_triangulation<Traits>& tri,
                                        Euclidean_strip<typename Traits::FT>& strip)
{
  typedef typename Traits::FT FT;
  if(tri.coordinates().is_shared(tri.mesh().edge(h)))
    return FT(0);
  const FT angle = angle_in_strip(Start_in_input_face<Traits>(h, tri), h, course, tri, strip);
  const bool is_in_face = !tri.input_outgoing_before(h).is_valid();
  return is_in_face && angle < 0 ? angle + 2 * pi<FT>() : angle;
}

// Returns the angle of the outgoing halfedge of T1 before the halfedge `h` of T2, in the frame of
// T1. The source of `h` is an inserted vertex. If it lies inside the face f, returns the angle of
// halfedge(f).
template <typename Traits>
typename Traits::FT angle_of_inserted_outgoing(Halfedge_index h,
                                               const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::FT FT;
  const Halfedge_index outgoing = tri.input_outgoing_before(h);
  return outgoing.is_valid() && tri.number_of_inserted_outgoing(outgoing) == 1 ? pi<FT>() : FT(0);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_ANGLE_IN_STRIP_H
