// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXPONENTIAL_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXPONENTIAL_MAP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Geodesic.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/check_finite.h>

#include <CGAL/assertions.h>
#include <CGAL/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Walks from face to face along a straight line. The state is a point and a direction in the frame
// of the halfedge `m_h`. It needs constant memory for lines of any length.
template <typename EdgeLengthMap, typename OutputIterator>
class Geodesic_tracer
{
public:
  typedef typename boost::property_traits<EdgeLengthMap>::value_type FT;
  typedef typename Flat_face<FT>::Vector Vector;
  static_assert(std::is_floating_point<FT>::value, "directions at vertices are angles");

  Geodesic_tracer(const Surface_view<EdgeLengthMap>& surface, At_boundary at_boundary,
                  OutputIterator path)
    : m_surface(surface), m_mesh(surface.mesh()), m_at_boundary(at_boundary), m_path(path)
  {}

  Geodesic<FT> from(Vertex_index v, const Vector& vector)
  {
    check_point(v, m_mesh);
    CGAL_precondition(!m_mesh.is_isolated(v));
    start(first_outgoing_halfedge(v, m_mesh), {FT(1), FT(0), FT(0)}, vector);
    leave_vertex(Angles(m_h, m_surface), wrapped(std::arg(m_start)));
    return trace();
  }

  Geodesic<FT> from(const Face_location<FT>& p, const Vector& vector)
  {
    check_point(p, m_mesh);
    start(m_mesh.halfedge(p.first), p.second, vector);
    if(const Surface_point<FT> point = surface_point(p, m_mesh); is_at_vertex(point)) {
      turn_frame(side_number(halfedge_of(point), m_mesh));
      leave_corner();
    }
    return trace();
  }

private:
  typedef Flat_face<FT> Face;
  typedef typename Face::Place Place;
  typedef Vertex_angles<FT> Angles;

  void start(Halfedge_index h, const Place& place, const Vector& vector)
  {
    if(!is_finite_value(vector))
      throw Invalid_input("the tangent vector is infinite or NaN");
    m_h = h;
    m_place = place;
    m_remaining = m_total = std::abs(vector);
    m_start = m_direction = m_total > 0 ? vector / m_total : Vector(1);
  }

  // Traces the line. The loop ends, because every step uses a part of the remaining length, or
  // `use_up()` counts it as idle.
  Geodesic<FT> trace()
  {
    while(m_remaining > 0 && m_status != Geodesic_status::stopped_at_boundary)
      m_status == Geodesic_status::slid_along_boundary ? slide() : cross_face();
    const Face_index f = m_mesh.face(m_h);
    const std::size_t s = side_number(m_mesh.halfedge(f), m_h, m_mesh);
    turn_frame(s);
    return {
      m_status, {f, m_place}, m_direction, m_direction * std::conj(m_start), m_total - m_remaining};
  }

  // Makes side `s` of the face the new x-axis.
  void turn_frame(std::size_t s) { turn_frame(Face(m_h, m_surface), s); }
  void turn_frame(const Face& face, std::size_t s)
  {
    m_direction *= std::conj(face.direction(s));
    m_place = {m_place[s], m_place[(s + 1) % 3], m_place[(s + 2) % 3]};
    m_h = s == 0 ? m_h : s == 1 ? m_mesh.next(m_h) : m_mesh.prev(m_h);
  }

  // ---- Faces and edges ----

  void cross_face()
  {
    const Face face(m_h, m_surface);
    const auto exit = face.exit(m_place, m_direction);
    if(CGAL::abs(m_remaining - exit.distance) <= face.tolerance())
      end_at(exit.place);
    else if(m_remaining < exit.distance)
      end_between(exit.place, m_remaining / exit.distance);
    else {
      use_up(exit.distance);
      m_place = exit.place;
      turn_frame(face, exit.index);
      exit.is_corner ? pass_vertex() : pass_edge();
    }
  }

  void end_at(const Place& place)
  {
    m_place = place;
    m_remaining = 0;
  }

  void end_between(const Place& place, const FT& t)
  {
    for(std::size_t k = 0; k < 3; ++k)
      m_place[k] = (1 - t) * m_place[k] + t * place[k];
    m_remaining = 0;
  }

  // Subtracts `distance` from the remaining length. Steps around a vertex that is almost hit may
  // have no length, but are fewer than the halfedges. If steps vanish in the rounding of the
  // remaining length, the loop would not end.
  void use_up(const FT& distance)
  {
    const FT before = m_remaining;
    m_remaining -= distance;
    m_idle_steps = m_remaining < before ? 0 : m_idle_steps + 1;
    if(m_idle_steps > 1000 + m_mesh.number_of_halfedges())
      throw Numerical_error("the steps of a geodesic are below the rounding of its length");
  }

  void pass_edge()
  {
    const Halfedge_index o = m_mesh.opposite(m_h);
    if(m_mesh.is_border(o)) {
      meet_border_edge();
      return;
    }
    record(m_place[1]);
    m_h = o;
    std::swap(m_place[0], m_place[1]);
    m_direction = normalized(Vector(-m_direction.real(), (std::max)(-m_direction.imag(), FT(0))));
  }

  void record(const FT& t) { record({m_h, t}); }
  void record(const Edge_point<FT>& p) { *m_path++ = p; }

  // ---- Vertices ----

  // Turns `phi` by multiples of 2 pi to [-pi/2, 3 pi/2). On the boundary, directions that point out
  // of the surface are below 0 if they are nearer to the first outgoing halfedge. They are above pi
  // if they are nearer to the last.
  static FT wrapped(const FT& phi)
  {
    return phi < -pi<FT>() / 2      ? phi + 2 * pi<FT>()
           : phi < 3 * pi<FT>() / 2 ? phi
                                    : phi - 2 * pi<FT>();
  }

  // Leaves corner 0, where the direction may point out of the face.
  void leave_corner()
  {
    const FT angle = std::arg(m_direction);
    if(angle >= 0 && angle <= angle_at_source(m_h, m_surface))
      return;
    const Angles angles(m_h, m_surface);
    leave_vertex(angles, angles.normalized(angle));
  }

  // Continues straight: the normalized direction is opposite to the direction back.
  void pass_vertex()
  {
    const Angles angles(m_h, m_surface);
    const FT back = std::clamp(std::arg(-m_direction), FT(0), angle_at_source(m_h, m_surface));
    const FT phi = wrapped(angles.normalized(back) + pi<FT>());
    if(angles.is_border() && m_at_boundary == At_boundary::stop)
      return pass_border_vertex(angles, angles.on_surface(angles.normalized(back)));
    record({m_mesh.prev(m_h), FT(1)});
    angles.is_border() ? meet_border_vertex(phi) : leave_vertex(angles, phi);
  }

  // Continues if only one side of the direction back has a direction at the angle pi. If both sides
  // have one, neither direction is straighter than the other.
  void pass_border_vertex(const Angles& angles, const FT& back)
  {
    const FT tolerance = 2 * pi<FT>() * rounding_unit<FT>();
    const bool left = back + pi<FT>() <= angles.sum() + tolerance,
               right = back >= pi<FT>() - tolerance;
    if(left == right) {
      m_status = Geodesic_status::stopped_at_boundary;
      return;
    }
    record({m_mesh.prev(m_h), FT(1)});
    m_h = first_outgoing_halfedge(m_mesh.source(m_h), m_mesh);
    turn_to(std::clamp(left ? back + pi<FT>() : back - pi<FT>(), FT(0), angles.sum()),
            rounding_unit<FT>() * angles.sum());
  }

  // Leaves the source of `m_h` in the direction with normalized angle `phi`.
  void leave_vertex(const Angles& angles, FT phi)
  {
    const FT whole = 2 * pi<FT>();
    if(angles.is_border()) {
      if(phi < -whole * rounding_unit<FT>() || phi > whole * (FT(0.5) + rounding_unit<FT>()))
        return meet_border_vertex(phi);
      phi = std::clamp(phi, FT(0), pi<FT>());
    } else
      phi -= whole * std::floor(phi / whole);
    m_h = first_outgoing_halfedge(m_mesh.source(m_h), m_mesh);
    turn_to(angles.on_surface(phi), rounding_unit<FT>() * angles.sum());
  }

  // Turns to the face in the direction `angle` counterclockwise from the first outgoing halfedge
  // `m_h`. A direction within the tolerance of an outgoing halfedge is along it.
  void turn_to(const FT& angle, const FT& tolerance)
  {
    const Halfedge_index first = m_h;
    FT before(0), corner = angle_at_source(m_h, m_surface);
    while(angle - before > corner - tolerance) {
      const Halfedge_index next = next_around_source(m_h, m_mesh);
      if(m_mesh.is_border(next)) {
        m_direction = std::polar(FT(1), corner);
        return;
      }
      m_h = next;
      if(next == first) {
        m_direction = Vector(1);
        return;
      }
      before += corner;
      corner = angle_at_source(m_h, m_surface);
    }
    m_direction = angle - before > tolerance ? std::polar(FT(1), angle - before) : Vector(1);
  }

  // ---- The boundary ----

  // Chooses one of the two directions along `m_h`. `old` is the previous direction in the same
  // frame.
  void start_to_slide(bool forward, Vector old)
  {
    m_status = Geodesic_status::slid_along_boundary;
    m_direction = Vector(forward ? 1 : -1);
    m_start *= m_direction * std::conj(old); // the tangent turns, transported vectors do not
  }

  void meet_border_edge()
  {
    if(m_at_boundary == At_boundary::stop) {
      m_status = Geodesic_status::stopped_at_boundary;
      return;
    }
    record(m_place[1]);
    start_to_slide(m_direction.real() >= 0, m_direction);
  }

  // Handles a vertex on the boundary; `phi` is the normalized direction out of the surface.
  void meet_border_vertex(const FT& phi)
  {
    if(m_at_boundary == At_boundary::stop) {
      m_status = Geodesic_status::stopped_at_boundary;
      return;
    }
    const Vertex_index v = m_mesh.source(m_h);
    const bool forward = phi < pi<FT>() / 2;
    m_h = forward ? first_outgoing_halfedge(v, m_mesh)
                  : m_mesh.opposite(m_mesh.next(m_mesh.halfedge(v)));
    m_place = end_of_side(!forward);
    start_to_slide(forward, std::polar(FT(1), phi));
  }

  static Place end_of_side(bool target) { return {FT(target ? 0 : 1), FT(target ? 1 : 0), FT(0)}; }

  // Continues to the end of the border edge of `m_h`, and to the next border edge.
  void slide()
  {
    const bool forward = m_direction.real() > 0;
    const FT distance = m_place[forward ? 0 : 1] * edge_length(m_h, m_surface);
    if(m_remaining <= distance) {
      end_between(end_of_side(forward), m_remaining / distance);
      return;
    }
    use_up(distance);
    record(FT(forward ? 1 : 0));
    const Halfedge_index border = m_mesh.opposite(m_h);
    m_h = m_mesh.opposite(forward ? m_mesh.prev(border) : m_mesh.next(border));
    m_place = end_of_side(!forward);
  }

  Surface_view<EdgeLengthMap> m_surface;
  const Delta_complex& m_mesh;
  At_boundary m_at_boundary;
  OutputIterator m_path;

  Halfedge_index m_h;
  Place m_place;
  Vector m_direction;
  Vector m_start; // the direction at the start, in the frame of the start
  FT m_total, m_remaining;
  Geodesic_status m_status = Geodesic_status::reached;
  std::size_t m_idle_steps = 0;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTangent
/// follows the geodesic that starts at `source` with the tangent vector `vector`, for the length of
/// this vector: the exponential map.
///
/// At a vertex the angle of the vector is normalized as in `Tangent_frames`. At a point of a face
/// the vector is in the frame of the face `f`, whose real axis is along `halfedge(f)`. For a point
/// of an edge, it is the face of `face_location()`. From
/// a point on an edge it may point out of the face. At a corner its angle is measured from the
/// sides of the face, on the surface, and may lead beyond the face too. Angles of more than half a
/// turn need `tangent_vector_at_angle()`.
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
/// \param source the start: a vertex that is not isolated, a `Face_location`, an `Edge_location` or
///        a `Surface_point`. Coordinates are not negative and sum up to one
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
/// \throws Invalid_input if the vector is infinite or NaN, or if the surface has no such point
/// \throws Numerical_error if the angles at a vertex that it passes have no positive finite sum,
///   or the length is so great that steps vanish beside it
template <typename Surface, typename Source, typename OutputIterator = CGAL::Emptyset_iterator>
Geodesic<Length_of<Surface>> trace_geodesic(const Surface& surface, const Source& source,
                                            const std::complex<Length_of<Surface>>& vector,
                                            At_boundary at_boundary = At_boundary::stop,
                                            OutputIterator path = OutputIterator())
{
  internal::Geodesic_tracer tracer(internal::view_of(surface), at_boundary, path);
  return internal::use_source(source, surface.mesh(),
                              [&](const auto& start) { return tracer.from(start, vector); });
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
/// \param tri both triangulations
/// \param side the triangulation that the geodesic crosses
/// \param v the vertex at which the geodesic starts
/// \param vector the direction and the length of the geodesic, in the frame of `v`
/// \param at_boundary whether the geodesic ends at the boundary or follows it
/// \param path an output iterator for the points at which the geodesic crosses edges
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
