// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_SEGMENT_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_SEGMENT_SEARCH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Crossed_segment.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_face_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Segment_end.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/trace.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds segments in a face of one triangulation on the other. Of all ways between the regions of
// both ends over pieces of edges that the segment meets up to rounding, it takes one that crosses
// the fewest. So the regions are connected, whatever rounding says about vertices. In a face
// without inserted vertices there is one way.
template <typename Traits>
class Segment_search
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;
  typedef Barycentric_coordinates<FT> Coordinates;
  typedef Input_face_walk<Traits> Regions;
  typedef typename Regions::Place Place;
  typedef typename Regions::Face_of_place Face_of_place;

public:
  Segment_search(const Correspondence<Traits>& correspondence, Side side, Face_index f)
    : m_correspondence(correspondence),
      m_regions(correspondence),
      m_other(correspondence.mesh(other(side))),
      m_on(side),
      m_face(f),
      m_side(sides(f, correspondence.mesh(side)))
  {}

  // Returns the start of the segment, the points where it leaves faces, and its end.
  std::vector<Surface_point<FT>> operator()(const Segment_end<FT>& p,
                                            const Segment_end<FT>& q) const
  {
    const End from = located(p), to = located(q);
    Crossed_segment<FT> segment(p.p, q.p);
    const std::vector<Step> steps = way(from, to, segment);
    std::vector<Surface_point<FT>> places{place_of(from, steps.front().region)};
    for(std::size_t i = 0; i + 1 < steps.size(); ++i)
      places.push_back(crossing(steps[i], segment));
    places.push_back(place_of(to, steps.back().region));
    return places;
  }

private:
  struct End
  {
    Segment_end<FT> point;
    Place region;
    bool is_vertex; // of T2
  };

  // a region and the corner after which a segment leaves it
  struct Step
  {
    Place region;
    std::size_t corner;
  };

  Face_of_place face(const Place& region) const { return {region, m_regions}; }

  // ---- Ends ----

  End located(const Segment_end<FT>& p) const
  {
    const Place region = m_on == Side::input ? region_on_input(p) : region_on_intrinsic(p);
    return {p, region, corner_at(p.p, face(region)).has_value()};
  }

  Place region_on_intrinsic(const Segment_end<FT>& p) const
  {
    if(p.side == Segment_end<FT>::inside)
      return m_regions.place_in_face(m_face, p.p);
    const Halfedge_index h = m_side[p.side];
    const size_type n = m_correspondence.number_of_crossings(m_on, Edge_index(h)),
                    before = is_first_halfedge(h) ? p.rank.rank : n - p.rank.rank;
    return m_regions.place_at({h, p.is_corner ? 0 : before});
  }

  Place region_on_input(const Segment_end<FT>& p) const
  {
    if(p.is_on_side())
      return region_at_rank(m_side[p.side], p.rank);
    return p.is_corner ? m_regions.place_at_source(m_side[p.side])
                       : m_regions.place_of({m_face, p.p});
  }

  Place region_at_rank(Halfedge_index h, const Rank_on_edge& x) const
  {
    const Edge_index e(h);
    const auto& part = m_correspondence.part(e, x.part);
    if(part.is_shared)
      return m_regions.place_at({outgoing_at_part(h, x.part), 0});
    const size_type n = m_correspondence.number_of_crossings(Side::input, e),
                    before = part.first - m_correspondence.part(e, 0).first,
                    p = is_first_halfedge(h) ? x.rank : n - x.rank;
    const bool is_last = x.rank == before + (is_first_halfedge(h) ? part.count : 0);
    return m_regions.place_at_crossing(h, is_last ? p - 1 : p, is_last);
  }

  // Returns the halfedge of T2 at which a part of the halfedge `h` of T1 starts.
  Halfedge_index outgoing_at_part(Halfedge_index h, size_type part) const
  {
    const Edge_index e(h);
    const bool is_at_source = is_first_halfedge(h) && part == 0;
    const Vertex_index v = is_at_source
                             ? m_correspondence.mesh(Side::input).source(h)
                             : m_correspondence.part(e, is_first_halfedge(h) ? part - 1 : part).end;
    return find_curve(h, v, m_correspondence.triangulation()).outgoing;
  }

  // Returns the corner of a region that is the vertex at `p`, if there is one.
  std::optional<std::size_t> corner_at(const Coordinates& p, const Face_of_place& face) const
  {
    for(std::size_t c = 0; c < face.region.size(); ++c)
      if(face.region[c].is_vertex() && face.corner(m_on, c) == p)
        return c;
    return {};
  }

  bool is_at(const End& end, const Place& region) const
  {
    return end.is_vertex ? corner_at(end.point.p, face(region)).has_value() : region == end.region;
  }

  Surface_point<FT> place_of(const End& end, const Place& region) const
  {
    const Face_of_place face = this->face(region);
    const Face_index f = face.face(other(m_on));
    if(const auto c = corner_at(end.point.p, face))
      return place_of_vertex({f, face.corner(other(m_on), *c)}, face.region[*c].side);
    const Face_location<FT> location(f, face.map_from(m_on)(end.point.p));
    const Halfedge_index along =
      end.point.is_on_side() ? shared_halfedge(end.point) : Delta_complex::null_halfedge();
    return along.is_valid() ? crossing_on(edge_point(along, location, m_other))
                            : Surface_point<FT>(location);
  }

  Surface_point<FT> place_of_vertex(const Face_location<FT>& p, std::size_t corner) const
  {
    const bool is_inside =
      m_on == Side::intrinsic && !m_correspondence.outgoing_before(m_on, m_side[corner]).is_valid();
    return is_inside ? Surface_point<FT>(p) : surface_point(p, m_other);
  }

  // Returns the halfedge of the other triangulation that lies along the side of the face at a
  // point; null if there is none.
  Halfedge_index shared_halfedge(const Segment_end<FT>& p) const
  {
    const Halfedge_index h = m_side[p.side];
    if(m_on == Side::intrinsic)
      return m_correspondence.is_shared(m_on, Edge_index(h))
               ? m_correspondence.outgoing_before(m_on, h)
               : Delta_complex::null_halfedge();
    return m_correspondence.part(Edge_index(h), p.rank.part).is_shared
             ? outgoing_at_part(h, p.rank.part)
             : Delta_complex::null_halfedge();
  }

  // ---- From region to region ----

  // Returns the regions from one end to the other. Where rounding displaces crossings by more, the
  // segment is as wide as it takes; in the end all regions of the face are allowed.
  std::vector<Step> way(const End& from, const End& to, const Crossed_segment<FT>& segment) const
  {
    FT width = region_tolerance<FT>();
    for(;;) {
      const std::vector<Step> steps = way(from, to, segment, width);
      if(!steps.empty())
        return steps;
      width = width > 0 ? FT(1024 * width) : FT(1);
    }
  }

  std::vector<Step> way(const End& from, const End& to, const Crossed_segment<FT>& segment,
                        const FT& width) const
  {
    std::map<Place, Step> reached_from{{from.region, {from.region, 0}}};
    std::vector<Place> reached{from.region};
    for(std::size_t i = 0; i < reached.size(); ++i) {
      const Place place = reached[i];
      if(is_at(to, place))
        return steps_to(place, from, reached_from);
      const Face_of_place face = this->face(place);
      m_regions.for_each_exit(m_on, place, [&](std::size_t c, const Place& neighbor) {
        if(segment.meets(face.corner(m_on, c), face.corner(m_on, c + 1), width) &&
           reached_from.try_emplace(neighbor, Step{place, c}).second)
          reached.push_back(neighbor);
      });
    }
    return {};
  }

  // A segment from a vertex starts in the last region there.
  std::vector<Step> steps_to(const Place& last, const End& from,
                             const std::map<Place, Step>& reached_from) const
  {
    std::vector<Step> steps{{last, 0}};
    while(!is_at(from, steps.back().region))
      steps.push_back(reached_from.at(steps.back().region));
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

  // Returns where the segment leaves a region, on the edge of the other triangulation there.
  Surface_point<FT> crossing(const Step& step, Crossed_segment<FT>& segment) const
  {
    const Face_of_place face = this->face(step.region);
    const std::size_t c = step.corner, d = c + 1 == face.region.size() ? 0 : c + 1;
    const FT t = segment.next_crossing_on(face.corner(m_on, c), face.corner(m_on, d));
    const FT at_c = (1 - t) * face.scale(m_on, c), at_d = t * face.scale(m_on, d);
    const Coordinates p = point_between(face.corner(other(m_on), c), face.corner(other(m_on), d),
                                        place_between(FT(0), FT(1), at_c, at_d));
    const Halfedge_index along = m_regions.halfedge_after(m_on, step.region, c);
    return crossing_on(edge_point(along, Face_location<FT>(face.face(other(m_on)), p), m_other));
  }

  const Correspondence<Traits>& m_correspondence;
  Regions m_regions;
  const Delta_complex& m_other;
  Side m_on;
  Face_index m_face;
  std::array<Halfedge_index, 3> m_side;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_SEGMENT_SEARCH_H
