// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PATH_CARRIER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PATH_CARRIER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Correspondence_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A point of a face: corner `side`, or on this side after `rank` of its crossings, or inside.
template <typename FT>
struct Point_of_face
{
  enum Kind
  {
    corner,
    on_side,
    inside
  } kind;
  std::size_t side, rank;
  std::array<FT, 3> coordinates;
};

// The curves of the other triangulation in a face, and which of them a straight piece crosses. A
// point on a side has a rank among the crossings there; the ranks of both ends determine the curves
// between them.
template <typename Traits>
class Carried_piece
{
  typedef typename Traits::FT FT;
  typedef Correspondence_marks<Traits> Marks;
  typedef Face_map<FT, Marks> Map;
  typedef Point_of_face<FT> Point;
  typedef std::vector<Surface_place<FT>> Places;

public:
  Carried_piece(const Correspondence<Traits>& correspondence, Side side, Face_index f,
                const Delta_complex& other)
    : m_marks(side, f, correspondence), m_other(other), m_map(m_marks, other)
  {}

  // Adds the crossings of the curves between two points, in the order from `p` to `q`.
  void add_crossings(const Point& p, const Point& q, Places& places) const
  {
    const Depths from = depths(p, q), to = depths(q, p);
    for(std::size_t s = 0; s < 3; ++s)
      for(std::size_t j = from.around[s]; j < to.around[s]; ++j)
        add(around(s, j), p, q, true, places);
    for(std::size_t j = from.fan; j < to.fan; ++j)
      add(from_apex(j), p, q, true, places);
    for(std::size_t j = from.fan; j > to.fan; --j)
      add(from_apex(j - 1), p, q, false, places);
    for(std::size_t s = 0; s < 3; ++s)
      for(std::size_t j = from.around[s]; j > to.around[s]; --j)
        add(around(s, j - 1), p, q, false, places);
  }

  // returns the place of a point on the other triangulation
  Face_location<FT> location(const Point& p) const
  {
    const Depths d = depths(p, p);
    std::size_t region = regions().first_of_rest() + d.fan;
    for(std::size_t s = 0; s < 3; ++s)
      if(d.around[s] < regions().around(s))
        region = regions().around_corner(s, d.around[s]);
    const auto [f, map] = m_map.region_map(region);
    return {f, map(p.coordinates)};
  }

  // returns the last spoke of the other triangulation at or clockwise from the piece that leads
  // from corner `s` to `q`
  Halfedge_index spoke_before(std::size_t s, const Point& q) const
  {
    if(regions().leaving() > 0 && regions().apex() == s)
      if(const std::size_t n = depths(q, q).fan; n > 0) {
        const Region_corner end = regions().end_of_curve(n - 1);
        return m_marks.across(end.side, end.mark).halfedge;
      }
    return m_marks.spoke_before(s);
  }

private:
  // the numbers of curves around each corner, and of those from the apex, that lie before a point
  struct Depths
  {
    std::array<std::size_t, 3> around;
    std::size_t fan;
  };

  // a curve with what comes before it on its left
  struct Curve
  {
    Region_corner begin, end;
  };

  const Face_regions& regions() const { return m_map.regions(); }

  Depths depths(const Point& p, const Point& q) const
  {
    Depths result{{}, 0};
    for(std::size_t s = 0; s < 3; ++s)
      result.around[s] = depth_around(s, p);
    const bool is_apex = p.kind == Point::corner && p.side == regions().apex();
    if(regions().leaving() > 0)
      result.fan = depth_in_fan(is_apex ? q : p);
    return result;
  }

  std::size_t depth_around(std::size_t s, const Point& p) const
  {
    const std::size_t n = regions().around(s);
    if(p.kind == Point::corner)
      return p.side == s ? 0 : n;
    if(p.kind == Point::inside)
      return count(n, [&](std::size_t j) { return !is_on_left(around(s, j), p); });
    if(p.side == (s + 1) % 3)
      return n;
    return (std::min)(n, p.side == s ? p.rank : m_marks.crossings(p.side) - p.rank);
  }

  std::size_t depth_in_fan(const Point& p) const
  {
    const std::size_t n = regions().leaving(), near = (regions().apex() + 1) % 3,
                      last = (near + 1) % 3;
    if(p.kind == Point::corner || (p.kind == Point::on_side && p.side != near))
      return p.side == last ? n : 0;
    if(p.kind == Point::inside)
      return count(n, [&](std::size_t j) { return !is_on_left(from_apex(j), p); });
    const std::size_t before = regions().around(near);
    return p.rank < before ? 0 : (std::min)(n, p.rank - before);
  }

  // the number of curves that a point has passed, which are the first ones
  template <typename Is_passed>
  static std::size_t count(std::size_t n, const Is_passed& is_passed)
  {
    std::size_t result = 0;
    for(std::size_t step = n; step > 0; step /= 2)
      while(result + step <= n && is_passed(result + step - 1))
        result += step;
    return result;
  }

  Curve around(std::size_t s, std::size_t j) const
  {
    const auto curve = regions().curve_around(s, j);
    return {curve[0], curve[1]};
  }

  Curve from_apex(std::size_t j) const
  {
    return {regions().end_of_curve(j), {regions().apex(), Region_corner::none, false}};
  }

  bool is_on_left(const Curve& c, const Point& p) const
  {
    return orientation(m_map.coordinates(c.begin), m_map.coordinates(c.end), p.coordinates) > 0;
  }

  FT scale(const Region_corner& c) const
  {
    return c.is_vertex() ? FT(1) : m_marks.scale(c.side, c.mark);
  }

  // Adds where the piece crosses a curve, which leaves the face on the left of the curve if
  // `is_forward`.
  void add(const Curve& c, const Point& p, const Point& q, bool is_forward, Places& places) const
  {
    const Edge_point<FT> begin = reversed(m_marks.across(c.begin.side, c.begin.mark), m_other);
    const auto distance = [&](const Region_corner& x) -> FT {
      return CGAL::abs(orientation(p.coordinates, q.coordinates, m_map.coordinates(x)));
    };
    const FT at_begin = distance(c.end) * scale(c.begin), at_end = distance(c.begin) * scale(c.end);
    const FT sum = at_begin + at_end, t = sum > 0 ? FT(at_end / sum) : FT(0.5);
    const Edge_point<FT> crossing{begin.halfedge,
                                  (1 - t) * begin.t + t * place_of_end(c, begin.halfedge)};
    places.push_back(place_on(is_forward ? crossing : reversed(crossing, m_other), m_other));
  }

  // the place of the end of a curve on its halfedge of the other triangulation
  FT place_of_end(const Curve& c, Halfedge_index h) const
  {
    if(!c.end.is_vertex())
      return m_marks.across(c.end.side, c.end.mark).t;
    const auto p = m_marks.vertex_across(c.end.side, Edge_point<FT>{h, FT(1)});
    return edge_point(h, p, m_other).t;
  }

  Marks m_marks;
  const Delta_complex& m_other;
  Map m_map;
};

// Finds the places of a path on the other triangulation.
template <typename Traits>
class Path_carrier
{
  typedef typename Traits::FT FT;
  typedef Point_of_face<FT> Point;
  typedef Surface_place<FT> Place;
  typedef std::array<FT, 3> Coordinates;

public:
  Path_carrier(const Correspondence<Traits>& correspondence, Side side)
    : m_correspondence(correspondence),
      m_side(side),
      m_mesh(correspondence.mesh(side)),
      m_other(correspondence.mesh(side == Side::input ? Side::intrinsic : Side::input))
  {}

  std::vector<Place> operator()(const std::vector<Place>& path)
  {
    for(std::size_t k = 0; k + 1 < path.size(); ++k)
      carry(path, k);
    if(!path.empty())
      add_end(path);
    return std::move(m_places);
  }

private:
  static bool is_vertex(const Place& p) { return is_corner(p.location.second); }

  void carry(const std::vector<Place>& path, std::size_t k)
  {
    const Place &p = path[k], &q = path[k + 1];
    if(is_vertex(p) && is_vertex(q))
      return carry_along(p.along);
    const bool is_crossing = k > 0 && p.along.is_valid() && !is_vertex(p);
    const Halfedge_index entry = is_crossing ? m_mesh.opposite(p.along) : p.along;
    const Face_index f = is_crossing || is_vertex(p) ? m_mesh.face(entry) : p.location.first;
    if(m_side == Side::input && m_correspondence.contains_inserted(f))
      throw Invalid_input("the path passes a face of the input that contains inserted vertices");
    const Point from = is_vertex(p) ? corner(side_number(entry, m_mesh)) : point(p, f);
    const Point to = end_of_piece(q, f, is_crossing ? entry : Delta_complex::null_halfedge());
    const Carried_piece<Traits> piece(m_correspondence, m_side, f, m_other);
    if(is_vertex(p))
      add_vertex(m_mesh.source(entry), piece.spoke_before(from.side, to));
    else
      add_point(p, from, piece, k == 0);
    piece.add_crossings(from, to, m_places);
    m_end = std::nullopt;
    if(k + 2 == path.size() && to.kind != Point::corner)
      m_end = place_of(q, to, piece);
  }

  // ---- Points of faces ----

  static Point corner(std::size_t s)
  {
    return {Point::corner, s, 0, barycentric_coordinates(s, FT(0))};
  }

  // a point in face `f` or on its boundary, not at a vertex
  Point point(const Place& p, Face_index f) const
  {
    if(!p.along.is_valid())
      return {Point::inside, 0, 0, p.location.second};
    const Halfedge_index stored = m_mesh.is_border(p.along) ? m_mesh.opposite(p.along) : p.along;
    Edge_point<FT> on_edge = edge_point(stored, p.location, m_mesh);
    const std::size_t rank = rank_on_first_halfedge(on_edge),
                      n = m_correspondence.number_of_crossings(m_side, Edge_index(stored));
    if(m_mesh.face(stored) != f)
      on_edge = reversed(on_edge, m_mesh);
    const std::size_t s = side_number(on_edge.halfedge, m_mesh);
    return {Point::on_side, s, is_first_halfedge(on_edge.halfedge) ? rank : n - rank,
            barycentric_coordinates(s, on_edge.t)};
  }

  std::size_t rank_on_first_halfedge(const Edge_point<FT>& p) const
  {
    const Edge_index e(p.halfedge);
    const FT t = place_on_first_halfedge(p);
    std::size_t low = 0, high = m_correspondence.number_of_crossings(m_side, e);
    while(low < high) {
      const std::size_t middle = (low + high) / 2;
      const auto crossing = m_correspondence.crossing(
        m_side, first_halfedge(e), static_cast<Delta_complex::size_type>(middle));
      (crossing.here.t <= t ? low : high) = crossing.here.t <= t ? middle + 1 : middle;
    }
    return low;
  }

  // `entry` is the side through which the piece has come into its face; null if none
  Point end_of_piece(const Place& q, Face_index f, Halfedge_index entry) const
  {
    if(!is_vertex(q))
      return point(q, f);
    const Vertex_index v = m_mesh.source(q.along);
    if(entry.is_valid() && m_mesh.source(m_mesh.prev(entry)) == v)
      return corner(side_number(m_mesh.prev(entry), m_mesh));
    const auto h = sides(f, m_mesh);
    return corner(m_mesh.source(h[0]) == v ? 0 : m_mesh.source(h[1]) == v ? 1 : 2);
  }

  // ---- Places on the other triangulation ----

  // The halfedge `h` of this triangulation, from vertex to vertex.
  void carry_along(Halfedge_index h)
  {
    add_vertex(m_mesh.source(h), spoke_at(h));
    const auto n = m_correspondence.number_of_crossings(m_side, Edge_index(h));
    for(Delta_complex::size_type p = 0; p < n; ++p)
      m_places.push_back(
        place_on(reversed(m_correspondence.crossing(m_side, h, p).across, m_other), m_other));
    m_end = std::nullopt;
  }

  // border edges are in both triangulations
  Halfedge_index spoke_at(Halfedge_index h) const
  {
    return m_mesh.is_border(h)
             ? m_other.opposite(m_correspondence.spoke_before(m_side, m_mesh.opposite(h)))
             : m_correspondence.spoke_before(m_side, h);
  }

  const auto& triangulation() const { return m_correspondence.triangulation(); }

  // `spoke` is the last one at or clockwise from where the path goes on
  void add_vertex(Vertex_index v, Halfedge_index spoke)
  {
    const Place place = place_of_vertex(v, spoke);
    if(!m_places.empty() && is_vertex(place) && is_vertex(m_places.back()))
      direct_to(m_other.source(place.along), m_places.back());
    m_places.push_back(place);
  }

  // A path through a face from vertex to vertex follows an edge.
  void direct_to(Vertex_index next, Place& from) const
  {
    const Halfedge_index h = from.along;
    if(m_other.target(h) != next)
      from = place_on(Edge_point<FT>{m_other.opposite(m_other.prev(h)), FT(0)}, m_other);
  }

  Place place_of_vertex(Vertex_index v, Halfedge_index spoke) const
  {
    if(m_side == Side::input || !triangulation().is_inserted(v))
      return place_on(Edge_point<FT>{spoke, FT(0)}, m_other);
    if(!spoke.is_valid())
      return triangulation().inserted_vertex(v);
    const Edge_point<FT> on_spoke{spoke, triangulation().place_along(spoke, v)};
    const bool leaves_surface = m_other.is_border(m_other.opposite(spoke));
    return place_on(leaves_surface ? on_spoke : reversed(on_spoke, m_other), m_other);
  }

  // Crossings of an edge are places if that is in the other triangulation too.
  void add_point(const Place& p, const Point& in_face, const Carried_piece<Traits>& piece,
                 bool is_start)
  {
    if(is_start || !p.along.is_valid() || m_correspondence.is_shared(m_side, Edge_index(p.along)))
      m_places.push_back(place_of(p, in_face, piece));
  }

  Place place_of(const Place& p, const Point& in_face, const Carried_piece<Traits>& piece) const
  {
    if(p.along.is_valid() && m_correspondence.is_shared(m_side, Edge_index(p.along)))
      return place_on(on_shared(p), m_other);
    return {Delta_complex::null_halfedge(), piece.location(in_face)};
  }

  Edge_point<FT> on_shared(const Place& p) const
  {
    const Halfedge_index h = m_mesh.is_border(p.along) ? m_mesh.opposite(p.along) : p.along;
    const Halfedge_index there = m_correspondence.spoke_before(m_side, h);
    Edge_point<FT> result{there, edge_point(h, p.location, m_mesh).t};
    if(m_side == Side::intrinsic) {
      const Vertex_index end = m_mesh.target(h);
      const FT from = triangulation().place_along(there, m_mesh.source(h));
      const FT to =
        triangulation().is_inserted(end) ? triangulation().place_along(there, end) : FT(1);
      result.t = (1 - result.t) * from + result.t * to;
    }
    return h == p.along ? result : reversed(result, m_other);
  }

  void add_end(const std::vector<Place>& path)
  {
    const Place& q = path.back();
    if(is_vertex(q)) {
      const Vertex_index v = m_mesh.source(q.along);
      add_vertex(v, spoke_at(m_mesh.is_border(q.along) ? first_spoke(v, m_mesh) : q.along));
    } else if(m_end)
      m_places.push_back(*m_end);
    else if(path.size() == 1) {
      const Carried_piece<Traits> piece(m_correspondence, m_side, q.location.first, m_other);
      m_places.push_back(place_of(q, point(q, q.location.first), piece));
    }
  }

  const Correspondence<Traits>& m_correspondence;
  Side m_side;
  const Delta_complex &m_mesh, &m_other;
  std::vector<Place> m_places;
  std::optional<Place> m_end; // if it is not a vertex
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PATH_CARRIER_H
