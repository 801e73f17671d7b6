// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_SEGMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_SEGMENT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
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

// Returns the halfedge of T2 at which a part of the halfedge `h` of T1 starts.
template <typename Traits>
Halfedge_index spoke_at_part(Halfedge_index h, Delta_complex::size_type part,
                             const Correspondence<Traits>& correspondence)
{
  const Edge_index e(h);
  const bool is_at_source = is_first_halfedge(h) && part == 0;
  const Vertex_index v = is_at_source
                           ? correspondence.mesh(Side::input).source(h)
                           : correspondence.part(e, is_first_halfedge(h) ? part - 1 : part).end;
  return find_curve(h, v, correspondence.triangulation()).spoke;
}

// Finds segments in a face of T1 on T2 if the face contains vertices of T2. Of all ways between the
// regions of both ends over pieces of edges that the segment meets up to rounding, it takes one
// that crosses the fewest. So the regions are connected, whatever rounding says about vertices.
template <typename Traits>
class Input_face_segment
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;
  typedef Barycentric_coordinates<FT> Coordinates;
  typedef Input_face_walk<Traits> Regions;
  typedef typename Regions::Place Place;
  typedef typename Regions::Face_of_place Face_of_place;

public:
  Input_face_segment(const Correspondence<Traits>& correspondence, Face_index f)
    : m_correspondence(correspondence),
      m_regions(correspondence),
      m_mesh(correspondence.mesh(Side::intrinsic)),
      m_face(f),
      m_side(sides(f, correspondence.mesh(Side::input)))
  {}

  // Returns the start of the segment, the points where it leaves faces of T2, and its end.
  std::vector<Surface_place<FT>> operator()(const Segment_end<FT>& p,
                                            const Segment_end<FT>& q) const
  {
    const End from = located(p), to = located(q);
    Crossed_segment<FT> segment(p.p, q.p);
    const std::vector<Step> steps = way(from, to, segment);
    std::vector<Surface_place<FT>> places{place_of(from, steps.front().region)};
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

  // ---- Ends ----

  End located(const Segment_end<FT>& p) const
  {
    const Place region = region_of(p);
    return {p, region, corner_at(p.p, {region, m_regions}).has_value()};
  }

  Place region_of(const Segment_end<FT>& p) const
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
      return m_regions.place_at({spoke_at_part(h, x.part, m_correspondence), 0});
    const size_type n = m_correspondence.number_of_crossings(Side::input, e),
                    before = part.first - m_correspondence.part(e, 0).first,
                    p = is_first_halfedge(h) ? x.rank : n - x.rank;
    const bool is_last = x.rank == before + (is_first_halfedge(h) ? part.count : 0);
    return m_regions.place_at_crossing(h, is_last ? p - 1 : p, is_last);
  }

  // Returns the corner of a region that is the vertex of T2 at `p`, if there is one.
  static std::optional<std::size_t> corner_at(const Coordinates& p, const Face_of_place& face)
  {
    for(std::size_t c = 0; c < face.region.size(); ++c)
      if(face.region[c].is_vertex() && face.corner(c) == p)
        return c;
    return {};
  }

  bool is_at(const End& end, const Place& region) const
  {
    return end.is_vertex ? corner_at(end.point.p, {region, m_regions}).has_value()
                         : region == end.region;
  }

  Surface_place<FT> place_of(const End& end, const Place& region) const
  {
    const Face_of_place face(region, m_regions);
    if(const auto c = corner_at(end.point.p, face))
      return place_on(Edge_point<FT>{halfedge(region, face.region[*c]), FT(0)}, m_mesh);
    const Face_location<FT> location(region.first, face.map.inverse()(end.point.p));
    if(!end.point.is_on_side())
      return {Delta_complex::null_halfedge(), location};
    const Halfedge_index h = m_side[end.point.side];
    const size_type part = end.point.rank.part;
    if(!m_correspondence.part(Edge_index(h), part).is_shared)
      return {Delta_complex::null_halfedge(), location};
    return crossing_on(edge_point(spoke_at_part(h, part, m_correspondence), location, m_mesh),
                       m_mesh);
  }

  // Returns the halfedge of T2 on which a corner of a region lies, or which starts there.
  Halfedge_index halfedge(const Place& region, const Region_corner& corner) const
  {
    return sides(region.first, m_mesh)[corner.side];
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
      const Face_of_place face(place, m_regions);
      m_regions.for_each_exit(place, [&](std::size_t c, const Place& neighbor) {
        if(segment.meets(face.corner(c), face.corner(c + 1), width) &&
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

  Surface_place<FT> crossing(const Step& step, Crossed_segment<FT>& segment) const
  {
    const Face_of_place face(step.region, m_regions);
    const std::size_t c = step.corner, d = c + 1 == face.region.size() ? 0 : c + 1;
    const Region_corner &begin = face.region[c], &end = face.region[d];
    const FT t = segment.next_crossing_on(face.corner(c), face.corner(d));
    const FT first = begin.is_vertex() ? FT(0) : face.marks.here(begin.side, begin.mark),
             last = end.is_vertex() ? FT(1) : face.marks.here(end.side, end.mark);
    const FT place =
      place_between(first, last, FT((1 - t) / face.map.scale(c)), FT(t / face.map.scale(d)));
    return crossing_on(Edge_point<FT>{halfedge(step.region, begin), place}, m_mesh);
  }

  const Correspondence<Traits>& m_correspondence;
  Regions m_regions;
  const Delta_complex& m_mesh;
  Face_index m_face; // of T1
  std::array<Halfedge_index, 3> m_side;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_SEGMENT_H
