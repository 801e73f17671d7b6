// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PATH_CARRIER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PATH_CARRIER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Carried_piece.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Carried_places.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_face_segment.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Point_of_face.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds the places of a path on the other triangulation.
template <typename Traits>
class Path_carrier
{
  typedef typename Traits::FT FT;
  typedef Point_of_face<FT> Point;
  typedef boost::container::static_vector<Point, 3> Points;
  typedef Surface_place<FT> Place;
  typedef Delta_complex::size_type size_type;

public:
  Path_carrier(const Correspondence<Traits>& correspondence, Side side)
    : m_correspondence(correspondence),
      m_side(side),
      m_mesh(correspondence.mesh(side)),
      m_other(correspondence.mesh(other(side))),
      m_ranks(correspondence, side),
      m_places(m_other)
  {}

  std::vector<Place> operator()(const std::vector<Place>& path)
  {
    for(std::size_t k = 0; k + 1 < path.size(); ++k)
      carry(path[k], path[k + 1], k > 0, k + 2 < path.size());
    if(!path.empty())
      add_end(path.back());
    return m_places.release();
  }

private:
  // `is_inner`, `is_next_inner`: whether the path comes to `p`, and goes on from `q`
  void carry(const Place& p, const Place& q, bool is_inner, bool is_next_inner)
  {
    if(is_at_vertex(p) && is_at_vertex(q))
      return carry_along(p.along);
    const Face_index f = face_of_piece(p, q, is_inner);
    if(!is_at(q, f))
      throw Invalid_input("two consecutive places of the path share no face");
    const auto [from, to] =
      nearest(f, starts_of_piece(p, f, is_inner), ends_of_piece(q, f, is_next_inner), is_inner);
    const bool is_point = from.coordinates == to.coordinates;
    with_piece(f, from, to, [&](const auto& piece) {
      if(!piece.starts_at_vertex())
        add_point(p, piece, is_inner);
      else if(!is_point) // twice the same vertex would be a loop
        add_vertex(piece.start());
      m_crossings_of_piece.clear();
      piece.add_crossings(m_crossings_of_piece);
      for(const Place& x : m_crossings_of_piece)
        m_places.add_crossing(x);
      if(!is_next_inner || piece.ends_at_vertex())
        note_end(piece);
      else
        forget_end();
    });
  }

  template <typename Visit>
  void with_piece(Face_index f, const Point& from, const Point& to, const Visit& visit) const
  {
    if(m_side == Side::input && m_correspondence.contains_inserted(f))
      visit(Input_face_segment<Traits>(m_correspondence, f, from, to));
    else
      visit(Carried_piece<Traits>(m_correspondence, m_side, f, from, to));
  }

  // ---- Points of faces ----

  // A path leaves a face through `along`; where rounding has moved it, through the opposite.
  Face_index face_of_piece(const Place& p, const Place& q, bool is_inner) const
  {
    const bool is_on_edge = p.along.is_valid() && !is_at_vertex(p);
    const Face_index f =
      is_inner && is_on_edge ? m_mesh.face(m_mesh.opposite(p.along)) : p.location.first;
    if(!is_on_edge || (f.is_valid() && is_at(q, f)))
      return f;
    const Face_index left = m_mesh.face(p.along);
    return left.is_valid() && left != f ? left : m_mesh.face(m_mesh.opposite(p.along));
  }

  // returns whether a place is in a face or on its boundary
  bool is_at(const Place& p, Face_index f) const
  {
    const auto h = sides(f, m_mesh);
    return p.location.first == f || std::any_of(h.begin(), h.end(), [&](Halfedge_index side) {
             return is_at_vertex(p) ? m_mesh.source(side) == m_mesh.source(p.along)
                                    : p.along.is_valid() && Edge_index(side) == Edge_index(p.along);
           });
  }

  static Point corner(std::size_t s)
  {
    return {Point::corner, s, {}, barycentric_coordinates(s, FT(0))};
  }

  // A path comes in through the opposite of the halfedge through which it has left the face before.
  Points starts_of_piece(const Place& p, Face_index f, bool is_inner) const
  {
    if(!is_at_vertex(p))
      return points(p, f, is_inner && p.along.is_valid() ? m_mesh.opposite(p.along) : p.along,
                    !is_inner);
    const auto& b = p.location.second;
    return {corner(b[0] != 0 ? 0 : b[1] != 0 ? 1 : 2)};
  }

  Points ends_of_piece(const Place& q, Face_index f, bool is_inner) const
  {
    if(!is_at_vertex(q))
      return points(q, f, q.along, !is_inner);
    const auto h = sides(f, m_mesh);
    Points result;
    for(std::size_t s = 0; s < 3; ++s)
      if(m_mesh.source(h[s]) == m_mesh.source(q.along))
        result.push_back(corner(s));
    return result;
  }

  // returns the points of a face where a place is: two if the face meets itself and the path does
  // not cross its edge there
  Points points(const Place& p, Face_index f, Halfedge_index h, bool is_end) const
  {
    Points result{point(p, f, h)};
    if(h.is_valid() && m_mesh.face(m_mesh.opposite(h)) == m_mesh.face(h) &&
       (is_end || result.front().is_inserted))
      result.push_back(point(p, f, m_mesh.opposite(h)));
    return result;
  }

  // A path that has crossed a side ends at the corner opposite to it if it can.
  std::pair<Point, Point> nearest(Face_index f, const Points& from, const Points& to,
                                  bool is_inner) const
  {
    std::pair<Point, Point> best(from.front(), to.front());
    const auto length = [&](const Point& p, const Point& q) {
      const bool has_crossed = is_inner && p.kind == Point::on_side && !p.is_inserted;
      return has_crossed && q.kind == Point::corner && q.side == (p.side + 2) % 3
               ? FT(0)
               : segment_length(m_correspondence.triangulation().surface(m_side),
                                Curve_segment<FT>{f, p.coordinates, q.coordinates});
    };
    if(from.size() * to.size() > 1)
      for(const Point& p : from)
        for(const Point& q : to)
          if(length(p, q) < length(best.first, best.second))
            best = {p, q};
    return best;
  }

  // a point in face `f`, or on its side `h` or the opposite of that, not at a vertex of `m_mesh`
  Point point(const Place& p, Face_index f, Halfedge_index h) const
  {
    if(!h.is_valid())
      return {Point::inside, 0, {}, p.location.second};
    if(m_mesh.face(h) != f)
      h = m_mesh.opposite(h);
    const Edge_index e(h);
    const std::size_t s = side_number(h, m_mesh);
    const Edge_point<FT> on_edge = point_on_edge(p);
    const FT t = place_on_first_halfedge(on_edge);
    if(m_side == Side::input)
      if(const auto part = m_ranks.part_to_inserted(e, t)) {
        const FT at = triangulation().place_along(h, m_correspondence.part(e, *part).end);
        return {Point::on_side, s, {*part, 0}, barycentric_coordinates(s, at), true};
      }
    return {Point::on_side, s, m_ranks(e, t),
            barycentric_coordinates(s, h == on_edge.halfedge ? on_edge.t : FT(1 - on_edge.t))};
  }

  // returns the place on `along`, or on its opposite if that is a border halfedge
  Edge_point<FT> point_on_edge(const Place& p) const
  {
    return edge_point(m_mesh.is_border(p.along) ? m_mesh.opposite(p.along) : p.along, p.location,
                      m_mesh);
  }

  const auto& triangulation() const { return m_correspondence.triangulation(); }

  // ---- Places on the other triangulation ----

  // The halfedge `h` of this triangulation, from vertex to vertex.
  void carry_along(Halfedge_index h)
  {
    const Edge_index e(h);
    add_vertex(vertex_across(m_correspondence, m_side, m_mesh.source(h), spoke_at(h)));
    const size_type n = m_side == Side::input ? m_correspondence.number_of_parts(e) : 1,
                    crossings = m_correspondence.number_of_crossings(m_side, e);
    for(size_type i = 0, p = 0; i < n; ++i) {
      const size_type part = is_first_halfedge(h) ? i : n - 1 - i;
      if(i > 0)
        m_places.add(place_of_inserted(h, part));
      const size_type end =
        p + (m_side == Side::input ? m_correspondence.part(e, part).count : crossings);
      for(; p < end; ++p)
        m_places.add(
          crossing_on(reversed(m_correspondence.crossing(m_side, h, p).across, m_other), m_other));
    }
    forget_end();
  }

  // the vertex of T2 on the halfedge `h` of T1 at which part `part` begins
  Place place_of_inserted(Halfedge_index h, size_type part) const
  {
    const Halfedge_index spoke =
      m_mesh.is_border(h) ? spoke_on_border(h, part) : spoke_at_part(h, part, m_correspondence);
    return place_on(Edge_point<FT>{spoke, FT(0)}, m_other);
  }

  // parts of border edges are shared
  Halfedge_index spoke_on_border(Halfedge_index h, size_type part) const
  {
    return m_other.opposite(spoke_at_part(m_mesh.opposite(h), part, m_correspondence));
  }

  // returns the last spoke of the other triangulation at or clockwise from `h`
  Halfedge_index spoke_at(Halfedge_index h) const
  {
    if(!m_mesh.is_border(h))
      return m_correspondence.spoke_before(m_side, h);
    if(m_side == Side::intrinsic)
      return m_other.opposite(m_correspondence.spoke_before(m_side, m_mesh.opposite(h)));
    const Edge_index e(h);
    return spoke_on_border(h, is_first_halfedge(h) ? 0 : m_correspondence.number_of_parts(e) - 1);
  }

  // Crossings of an edge are places if that is in the other triangulation too.
  template <typename Piece>
  void add_point(const Place& p, const Piece& piece, bool is_inner)
  {
    const bool is_crossing = is_inner && p.along.is_valid();
    if(!is_crossing)
      m_places.add(place_of(p, piece.start()));
    else if(shared_part(p))
      m_places.add_crossing(place_of(p, p));
  }

  void add_vertex(const Place& place)
  {
    if(m_ends_at_vertex && is_at_vertex(place))
      m_places.come_to_vertex(m_end->along);
    m_places.add(m_places.is_empty() ? start_at(place) : place);
  }

  // A path that starts at a vertex inserted on an edge goes on in the face of `along`.
  Place start_at(const Place& place) const
  {
    if(!place.along.is_valid() || is_at_vertex(place) ||
       m_other.is_border(m_other.opposite(place.along)))
      return place;
    return place_on(reversed(edge_point(place.along, place.location, m_other), m_other), m_other);
  }

  // returns the part of its edge on which a place lies, if that is in the other triangulation too
  std::optional<size_type> shared_part(const Place& p) const
  {
    if(!p.along.is_valid())
      return {};
    const Edge_index e(p.along);
    if(m_side == Side::intrinsic)
      return m_correspondence.is_shared(m_side, e) ? std::optional<size_type>(0) : std::nullopt;
    const size_type part = m_ranks.part_at(e, place_on_first_halfedge(point_on_edge(p)));
    return m_correspondence.part(e, part).is_shared ? std::optional(part) : std::nullopt;
  }

  // `inside` is where `p` is if its edge is not shared
  Place place_of(const Place& p, const Place& inside) const
  {
    const auto part = shared_part(p);
    if(!part)
      return inside;
    const Edge_point<FT> on_edge = point_on_edge(p);
    const Edge_point<FT> result =
      m_side == Side::input ? on_intrinsic(on_edge, *part) : on_input(on_edge);
    return crossing_on(on_edge.halfedge == p.along ? result : reversed(result, m_other), m_other);
  }

  Edge_point<FT> on_intrinsic(const Edge_point<FT>& p, size_type part) const
  {
    const Halfedge_index there = spoke_at_part(p.halfedge, part, m_correspondence);
    const auto range =
      part_of_edge(p.halfedge, m_other.source(there), m_other.target(there), triangulation());
    return {there, (p.t - range.begin) / (range.end - range.begin)};
  }

  Edge_point<FT> on_input(const Edge_point<FT>& p) const
  {
    const Halfedge_index there = m_correspondence.spoke_before(Side::intrinsic, p.halfedge);
    const auto range =
      part_of_edge(there, m_mesh.source(p.halfedge), m_mesh.target(p.halfedge), triangulation());
    return {there, range(p.t)};
  }

  void add_end(const Place& q)
  {
    if(is_at_vertex(q)) {
      const Vertex_index v = m_mesh.source(q.along);
      return add_vertex(
        vertex_across(m_correspondence, m_side, v,
                      spoke_at(m_mesh.is_border(q.along) ? first_spoke(v, m_mesh) : q.along)));
    }
    if(!m_end)
      note_end_of_point(q);
    m_ends_at_vertex ? add_vertex(*m_end) : m_places.add(place_of(q, *m_end));
  }

  // for a path of one place
  void note_end_of_point(const Place& q)
  {
    const Point p = starts_of_piece(q, q.location.first, false).front();
    with_piece(q.location.first, p, p, [&](const auto& piece) { note_end(piece); });
  }

  void forget_end()
  {
    m_end = std::nullopt;
    m_ends_at_vertex = false;
  }

  template <typename Piece>
  void note_end(const Piece& piece)
  {
    m_end = piece.end();
    m_ends_at_vertex = piece.ends_at_vertex();
  }

  const Correspondence<Traits>& m_correspondence;
  Side m_side;
  const Delta_complex &m_mesh, &m_other;
  Edge_ranks<Traits> m_ranks;
  Carried_places<FT> m_places;
  std::vector<Place> m_crossings_of_piece;
  std::optional<Place> m_end;    // of the last piece
  bool m_ends_at_vertex = false; // whether that is a vertex of the other triangulation
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PATH_CARRIER_H
