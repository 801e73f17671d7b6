// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CARRIED_PIECE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CARRIED_PIECE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Correspondence_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Crossed_segment.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Point_of_face.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the place of the vertex `v` of `side` on the other triangulation. `spoke` is the last one
// there at or clockwise from where a path goes on.
template <typename Traits>
Surface_place<typename Traits::FT> vertex_across(const Correspondence<Traits>& correspondence,
                                                 Side side, Vertex_index v, Halfedge_index spoke)
{
  typedef typename Traits::FT FT;
  const auto& triangulation = correspondence.triangulation();
  if(side == Side::input)
    return place_on(Edge_point<FT>{spoke, FT(0)}, triangulation.mesh());
  const Delta_complex& input = triangulation.input_mesh();
  if(!triangulation.is_inserted(v))
    return place_on(Edge_point<FT>{spoke, FT(0)}, input);
  if(!spoke.is_valid())
    return triangulation.inserted_vertex(v);
  const Edge_point<FT> on_spoke{spoke, triangulation.place_along(spoke, v)};
  const bool leaves_surface = input.is_border(input.opposite(spoke));
  return place_on(leaves_surface ? on_spoke : reversed(on_spoke, input), input);
}

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
                const Point& from, const Point& to)
    : m_correspondence(correspondence),
      m_side(side),
      m_halfedge(sides(f, correspondence.mesh(side))),
      m_other(correspondence.mesh(other(side))),
      m_marks(side, f, correspondence),
      m_map(m_marks, m_other),
      m_from(from),
      m_to(to)
  {}

  // returns the places of its ends on the other triangulation
  Surface_place<FT> start() const { return place_of(m_from, m_to); }
  Surface_place<FT> end() const { return place_of(m_to, m_from); }

  // returns whether its ends are vertices
  bool starts_at_vertex() const { return m_from.kind == Point::corner; }
  bool ends_at_vertex() const { return m_to.kind == Point::corner; }

  // Adds the crossings of the curves between its ends.
  void add_crossings(Places& places) const
  {
    const Point &p = m_from, &q = m_to;
    Crossed_segment<FT> segment(p.coordinates, q.coordinates);
    const Depths from = depths(p, q), to = depths(q, p);
    for(std::size_t s = 0; s < 3; ++s)
      for(std::size_t j = from.around[s]; j < to.around[s]; ++j)
        add(around(s, j), true, segment, places);
    for(std::size_t j = from.fan; j < to.fan; ++j)
      add(from_apex(j), true, segment, places);
    for(std::size_t j = from.fan; j > to.fan; --j)
      add(from_apex(j - 1), false, segment, places);
    for(std::size_t s = 0; s < 3; ++s)
      for(std::size_t j = from.around[s]; j > to.around[s]; --j)
        add(around(s, j - 1), false, segment, places);
  }

private:
  // returns the place of one end, given the other
  Surface_place<FT> place_of(const Point& p, const Point& q) const
  {
    if(p.kind == Point::corner)
      return vertex_across(m_correspondence, m_side,
                           m_correspondence.mesh(m_side).source(m_halfedge[p.side]),
                           spoke_before(p.side, q));
    const Depths d = depths(p, p);
    std::size_t region = regions().first_of_rest() + d.fan;
    for(std::size_t s = 0; s < 3; ++s)
      if(d.around[s] < regions().around(s))
        region = regions().around_corner(s, d.around[s]);
    const auto [f, map] = m_map.region_map(region);
    return {Delta_complex::null_halfedge(), {f, map(p.coordinates)}};
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
    return (std::min)(n, p.side == s ? rank(p) : m_marks.crossings(p.side) - rank(p));
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
    return rank(p) < before ? 0 : (std::min)(n, rank(p) - before);
  }

  // returns the number of crossings before a point along its side
  std::size_t rank(const Point& p) const
  {
    return is_first_halfedge(m_halfedge[p.side]) ? p.on_edge.rank
                                                 : m_marks.crossings(p.side) - p.on_edge.rank;
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
  void add(const Curve& c, bool is_forward, Crossed_segment<FT>& segment, Places& places) const
  {
    const Edge_point<FT> begin = reversed(m_marks.across(c.begin.side, c.begin.mark), m_other);
    const FT t = segment.next_crossing_on(m_map.coordinates(c.begin), m_map.coordinates(c.end));
    const Edge_point<FT> crossing{
      begin.halfedge, place_between(begin.t, place_of_end(c, begin.halfedge),
                                    FT((1 - t) * scale(c.begin)), FT(t * scale(c.end)))};
    places.push_back(crossing_on(is_forward ? crossing : reversed(crossing, m_other), m_other));
  }

  // the place of the end of a curve on its halfedge of the other triangulation
  FT place_of_end(const Curve& c, Halfedge_index h) const
  {
    if(!c.end.is_vertex())
      return m_marks.across(c.end.side, c.end.mark).t;
    const auto p = m_marks.vertex_across(c.end.side, Edge_point<FT>{h, FT(1)});
    return edge_point(h, p, m_other).t;
  }

  const Correspondence<Traits>& m_correspondence;
  Side m_side;
  std::array<Halfedge_index, 3> m_halfedge; // of the face
  const Delta_complex& m_other;
  Marks m_marks;
  Map m_map;
  Point m_from, m_to;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CARRIED_PIECE_H
