// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_SEGMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_SEGMENT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Correspondence_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Crossed_segment.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Segment_end.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds segments in a face on the other triangulation if the face contains no inserted vertices.
// The edges that a segment crosses are those that separate the regions of its ends.
template <typename Traits>
class Face_segment
{
  typedef typename Traits::FT FT;
  typedef Correspondence_marks<Traits> Marks;
  typedef Segment_end<FT> End;
  typedef std::vector<Surface_place<FT>> Places;

public:
  Face_segment(const Correspondence<Traits>& correspondence, Side side, Face_index f)
    : m_correspondence(correspondence),
      m_side(side),
      m_halfedge(sides(f, correspondence.mesh(side))),
      m_other(correspondence.mesh(other(side))),
      m_marks(side, f, correspondence),
      m_map(m_marks, m_other)
  {}

  // Returns the start of the segment, the points where it leaves faces, and its end.
  Places operator()(const End& p, const End& q) const
  {
    const std::size_t first = region_of(p), last = region_of(q);
    auto from = regions().curves_before(first), to = regions().curves_before(last);
    if(is_apex(p))
      from.fan = to.fan;
    else if(is_apex(q))
      to.fan = from.fan;
    Crossed_segment<FT> segment(p.p, q.p);
    Places places{place_of(p, first, from.fan)};
    const auto cross = [&](std::size_t begin, std::size_t end, const auto& curve) {
      for(std::size_t j = begin; j < end; ++j)
        add(curve(j), true, segment, places);
      for(std::size_t j = begin; j > end; --j)
        add(curve(j - 1), false, segment, places);
    };
    const auto cross_around = [&](bool is_outward) {
      for(std::size_t s = 0; s < 3; ++s)
        if((from.around[s] < to.around[s]) == is_outward)
          cross(from.around[s], to.around[s],
                [&](std::size_t j) { return regions().curve_around(s, j); });
    };
    cross_around(true);
    cross(from.fan, to.fan, [&](std::size_t j) { return curve_from_apex(j); });
    cross_around(false);
    places.push_back(place_of(q, last, to.fan));
    return places;
  }

private:
  typedef std::array<Region_corner, 2> Curve; // with what comes before it on its left

  const Face_regions& regions() const { return m_map.regions(); }

  Curve curve_from_apex(std::size_t j) const
  {
    return {regions().end_of_curve(j), {regions().apex(), Region_corner::none, false}};
  }

  bool is_apex(const End& p) const
  {
    return p.is_corner && regions().leaving() > 0 && p.side == regions().apex();
  }

  std::size_t region_of(const End& p) const
  {
    if(p.side == End::inside)
      return m_map.region_of(p.p);
    const std::size_t n = m_marks.crossings(p.side);
    const bool is_first = is_first_halfedge(m_halfedge[p.side]);
    return regions().region_at_side(p.side, p.is_corner ? 0
                                            : is_first  ? p.rank.rank
                                                        : n - p.rank.rank);
  }

  // Returns the place of an end, which is in region `m`, or between the curves `fan - 1` and `fan`
  // if it is the apex.
  Surface_place<FT> place_of(const End& p, std::size_t m, std::size_t fan) const
  {
    if(p.is_corner) {
      const Halfedge_index spoke = spoke_before(p, fan);
      return {spoke, m_marks.vertex_across(p.side, {spoke, FT(0)})};
    }
    const auto [f, map] = m_map.region_map(m);
    const Face_location<FT> image(f, map(p.p));
    if(p.side == End::inside || !m_correspondence.is_shared(m_side, Edge_index(m_halfedge[p.side])))
      return {Delta_complex::null_halfedge(), image};
    return crossing_on(edge_point(m_marks.spoke_before(p.side), image, m_other), m_other);
  }

  // Returns the last spoke of the other triangulation at or clockwise from a segment that starts at
  // a corner.
  Halfedge_index spoke_before(const End& p, std::size_t fan) const
  {
    if(!is_apex(p) || fan == 0)
      return m_marks.spoke_before(p.side);
    const Region_corner end = regions().end_of_curve(fan - 1);
    return m_marks.across(end.side, end.mark).halfedge;
  }

  FT scale(const Region_corner& c) const
  {
    return c.is_vertex() ? FT(1) : m_marks.scale(c.side, c.mark);
  }

  // Adds the point where the segment crosses a curve, forward if it leaves the left of the curve.
  void add(const Curve& c, bool is_forward, Crossed_segment<FT>& segment, Places& places) const
  {
    const Edge_point<FT> begin = reversed(m_marks.across(c[0].side, c[0].mark), m_other);
    const FT t = segment.next_crossing_on(m_map.coordinates(c[0]), m_map.coordinates(c[1]));
    const Edge_point<FT> crossing{begin.halfedge,
                                  place_between(begin.t, place_of_end(c[1], begin.halfedge),
                                                FT((1 - t) * scale(c[0])), FT(t * scale(c[1])))};
    places.push_back(crossing_on(is_forward ? crossing : reversed(crossing, m_other), m_other));
  }

  // Returns the place of the end of a curve on its halfedge of the other triangulation.
  FT place_of_end(const Region_corner& end, Halfedge_index h) const
  {
    if(!end.is_vertex())
      return m_marks.across(end.side, end.mark).t;
    return edge_point(h, m_marks.vertex_across(end.side, Edge_point<FT>{h, FT(1)}), m_other).t;
  }

  const Correspondence<Traits>& m_correspondence;
  Side m_side;
  std::array<Halfedge_index, 3> m_halfedge; // of the face
  const Delta_complex& m_other;
  Marks m_marks;
  Face_map<FT, Marks> m_map;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_SEGMENT_H
