// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_SEGMENT_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_SEGMENT_SEARCH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_face_walk.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/trace.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the position of a point among the crossings of an edge. They are numbered from the source
// of its first halfedge. An edge of T1 has several parts if vertices have been inserted on it.
struct Rank_on_edge
{
  Delta_complex::size_type part, rank;
  bool is_inserted; // whether the point is the vertex of T2 at the end of the part
};

// Returns the rank of the point at `t` on the first halfedge of `e`.
template <typename Traits>
Rank_on_edge rank_on_edge(const Correspondence<Traits>& correspondence, Side side, Edge_index e,
                          const typename Traits::FT& t)
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;
  const Halfedge_index h = first_halfedge(e);
  size_type part = 0, before = 0, count = correspondence.number_of_crossings(side, e);
  if(side == Side::input) {
    const FT least = t - rounding_unit<FT>();
    const auto end = [&](size_type i) {
      return correspondence.triangulation().place_along(h, correspondence.part(e, i).end);
    };
    const size_type last = correspondence.number_of_parts(e) - 1;
    part = first_where([&](size_type i) { return end(i) >= least; }, last);
    before = correspondence.part(e, part).first - correspondence.part(e, 0).first;
    count = correspondence.part(e, part).count;
    if(part < last && end(part) <= t + rounding_unit<FT>())
      return {part, before + count, true};
  }
  const auto is_after = [&](size_type p) {
    return correspondence.crossing(side, h, before + p).here.t > t;
  };
  return {part, before + first_where(is_after, count), false};
}

// Represents an end of a segment in a face.
template <typename FT>
struct Segment_end
{
  static constexpr std::size_t inside = 3;

  Barycentric_coordinates<FT> p;
  std::size_t side;  // the side of the face on which it lies or which starts at it, or `inside`
  bool is_corner;    // whether it is a corner of the face
  Rank_on_edge rank; // if it lies on a side

  bool is_on_side() const { return side != inside && !is_corner; }
};

// Returns the end of a segment at the point `p` of a face. Its rank on an edge is the same in both
// faces of the edge, so that segments with a common end stay connected.
template <typename Traits>
Segment_end<typename Traits::FT> segment_end(const Correspondence<Traits>& correspondence,
                                             Side side, Face_index f,
                                             const Barycentric_coordinates<typename Traits::FT>& p)
{
  typedef typename Traits::FT FT;
  const Delta_complex& mesh = correspondence.mesh(side);
  const Surface_point<FT> point = surface_point(Face_location<FT>(f, p), mesh);
  const Halfedge_index h = halfedge_of(point);
  Segment_end<FT> end{p, Segment_end<FT>::inside, is_at_vertex(point), {}};
  if(h.is_valid())
    end.side = side_number(h, mesh);
  if(end.is_corner)
    end.p = barycentric_coordinates(end.side, FT(0)); // exactly
  if(!end.is_on_side())
    return end;
  const Edge_index e(h);
  const std::size_t first = is_first_halfedge(h) ? end.side : (end.side + 1) % 3;
  end.rank = rank_on_edge(correspondence, side, e, FT(1 - p[first]));
  if(end.rank.is_inserted) {
    const Vertex_index v = correspondence.part(e, end.rank.part).end;
    end.p = barycentric_coordinates(end.side, correspondence.triangulation().place_along(h, v));
  }
  return end;
}

// Returns the position between two positions on an edge, with weights that are not negative. It is
// the middle if both weights are zero.
template <typename FT>
FT place_between(const FT& a, const FT& b, const FT& weight_of_a, const FT& weight_of_b)
{
  const FT sum = weight_of_a + weight_of_b, t = sum > 0 ? FT(weight_of_b / sum) : FT(0.5);
  return (1 - t) * a + t * b;
}

// Represents a straight segment in a face, in barycentric coordinates, and its crossings before its
// end.
template <typename FT>
class Crossed_segment
{
  typedef Barycentric_coordinates<FT> Coordinates;

public:
  Crossed_segment(const Coordinates& from, const Coordinates& to) : m_from(from), m_to(to) {}

  // Returns the position, from 0 to 1, where the segment crosses the segment from `a` to `b`.
  // Crossings are in order: if both segments are on one line up to rounding, the result is next to
  // the previous crossing.
  FT next_crossing_on(const Coordinates& a, const Coordinates& b)
  {
    const FT t = place_between(FT(0), FT(1), CGAL::abs(left(b)), CGAL::abs(left(a))),
             s = along(point_between(a, b, t));
    if(m_from != m_to && m_passed <= s && s <= 1) {
      m_passed = s;
      return t;
    }
    m_passed = (std::min)((std::max)(s, m_passed), FT(1));
    return closest_between(a, b, point_between(m_from, m_to, m_passed));
  }

  // Returns whether the segment comes within `width` of the segment from `a` to `b`.
  bool meets(const Coordinates& a, const Coordinates& b, const FT& width) const
  {
    const auto is_near = [&](const Coordinates& p, const Coordinates& from, const Coordinates& to) {
      return squared_distance(from, to, p) <= CGAL::square(width);
    };
    const Crossed_segment other(a, b);
    if((left(a) < 0) != (left(b) < 0) && (other.left(m_from) < 0) != (other.left(m_to) < 0))
      return true;
    return is_near(a, m_from, m_to) || is_near(b, m_from, m_to) || is_near(m_from, a, b) ||
           is_near(m_to, a, b);
  }

private:
  // Returns twice the signed area of the triangle of the segment and `p`, positive if `p` is on its
  // left. Points near to its start lose no digits.
  FT left(const Coordinates& p) const
  {
    const auto greatest =
      static_cast<std::size_t>(std::max_element(m_from.begin(), m_from.end()) - m_from.begin());
    const std::size_t x = (greatest + 1) % 3, y = (greatest + 2) % 3;
    return (m_to[x] - m_from[x]) * (p[y] - m_from[y]) - (m_to[y] - m_from[y]) * (p[x] - m_from[x]);
  }

  // Returns the position of the projection of `p` on the line, from 0 to 1 between the ends.
  FT along(const Coordinates& p) const
  {
    const FT square = dot(m_from, m_to, m_from, m_to);
    return square > 0 ? FT(dot(m_from, m_to, m_from, p) / square) : FT(0);
  }

  Coordinates m_from, m_to;
  FT m_passed = FT(0); // the place of the last crossing along the segment
};

// Finds segments in a face of one triangulation on the other. Paths between the regions of both
// ends lead over pieces of edges that the segment meets up to rounding. A path with the fewest
// crossings is used, so the regions are connected, however vertices are rounded. In a face without
// inserted vertices, only one path exists.
template <typename Traits>
class Segment_search
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;
  typedef Barycentric_coordinates<FT> Coordinates;
  typedef Input_face_walk<Traits> Regions;
  typedef typename Regions::Region_id Region_id;
  typedef typename Regions::Mapped_region Mapped_region;

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
    std::vector<Surface_point<FT>> places{point_of(from, steps.front().region)};
    for(std::size_t i = 0; i + 1 < steps.size(); ++i)
      places.push_back(crossing(steps[i], segment));
    places.push_back(point_of(to, steps.back().region));
    return places;
  }

private:
  struct End
  {
    Segment_end<FT> point;
    Region_id region;
    bool is_vertex; // of T2
  };

  // Stores a region and the corner after which a segment leaves it.
  struct Step
  {
    Region_id region;
    std::size_t corner;
  };

  Mapped_region face(const Region_id& region) const { return {region, m_regions}; }

  // ---- Ends ----

  End located(const Segment_end<FT>& p) const
  {
    const Region_id region = m_on == Side::input ? region_on_input(p) : region_on_intrinsic(p);
    return {p, region, corner_at(p.p, face(region)).has_value()};
  }

  Region_id region_on_intrinsic(const Segment_end<FT>& p) const
  {
    if(p.side == Segment_end<FT>::inside)
      return m_regions.region_in_face(m_face, p.p);
    const Halfedge_index h = m_side[p.side];
    const size_type n = m_correspondence.number_of_crossings(m_on, Edge_index(h)),
                    before = is_first_halfedge(h) ? p.rank.rank : n - p.rank.rank;
    return m_regions.region_at({h, p.is_corner ? 0 : before});
  }

  Region_id region_on_input(const Segment_end<FT>& p) const
  {
    if(p.is_on_side())
      return region_at_rank(m_side[p.side], p.rank);
    return p.is_corner ? m_regions.region_at_source(m_side[p.side])
                       : m_regions.region_of({m_face, p.p});
  }

  Region_id region_at_rank(Halfedge_index h, const Rank_on_edge& x) const
  {
    const Edge_index e(h);
    const auto& part = m_correspondence.part(e, x.part);
    if(part.is_shared)
      return m_regions.region_at({outgoing_at_part(h, x.part), 0});
    const size_type n = m_correspondence.number_of_crossings(Side::input, e),
                    before = part.first - m_correspondence.part(e, 0).first,
                    p = is_first_halfedge(h) ? x.rank : n - x.rank;
    const bool is_last = x.rank == before + (is_first_halfedge(h) ? part.count : 0);
    return m_regions.region_at_crossing(h, is_last ? p - 1 : p, is_last);
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

  // Returns the corner of a region that is the vertex at `p`, if one exists.
  std::optional<std::size_t> corner_at(const Coordinates& p, const Mapped_region& face) const
  {
    for(std::size_t c = 0; c < face.region.size(); ++c)
      if(face.region[c].is_vertex() && face.corner(m_on, c) == p)
        return c;
    return {};
  }

  bool is_at(const End& end, const Region_id& region) const
  {
    return end.is_vertex ? corner_at(end.point.p, face(region)).has_value() : region == end.region;
  }

  Surface_point<FT> point_of(const End& end, const Region_id& region) const
  {
    const Mapped_region face = this->face(region);
    const Face_index f = face.face(other(m_on));
    if(const auto c = corner_at(end.point.p, face))
      return point_of_vertex({f, face.corner(other(m_on), *c)}, face.region[*c].side);
    const Face_location<FT> location(f, face.map_from(m_on)(end.point.p));
    const Halfedge_index along =
      end.point.is_on_side() ? shared_halfedge(end.point) : Delta_complex::null_halfedge();
    return along.is_valid() ? crossing_on(edge_point(along, location, m_other))
                            : Surface_point<FT>(location);
  }

  Surface_point<FT> point_of_vertex(const Face_location<FT>& p, std::size_t corner) const
  {
    const bool is_inside =
      m_on == Side::intrinsic && !m_correspondence.outgoing_before(m_on, m_side[corner]).is_valid();
    return is_inside ? Surface_point<FT>(p) : surface_point(p, m_other);
  }

  // Returns the halfedge of the other triangulation along the side of the face at a point. Returns
  // null if none exists.
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

  // Returns the regions from one end to the other. If rounding displaces crossings by more than the
  // tolerance, the segment is widened. Finally all regions of the face are allowed.
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
    std::map<Region_id, Step> reached_from{{from.region, {from.region, 0}}};
    std::vector<Region_id> reached{from.region};
    for(std::size_t i = 0; i < reached.size(); ++i) {
      const Region_id id = reached[i];
      if(is_at(to, id))
        return steps_to(id, from, reached_from);
      const Mapped_region face = this->face(id);
      m_regions.for_each_exit(m_on, id, [&](std::size_t c, const Region_id& neighbor) {
        if(segment.meets(face.corner(m_on, c), face.corner(m_on, c + 1), width) &&
           reached_from.try_emplace(neighbor, Step{id, c}).second)
          reached.push_back(neighbor);
      });
    }
    return {};
  }

  // A segment from a vertex starts in the last region at the vertex.
  std::vector<Step> steps_to(const Region_id& last, const End& from,
                             const std::map<Region_id, Step>& reached_from) const
  {
    std::vector<Step> steps{{last, 0}};
    while(!is_at(from, steps.back().region))
      steps.push_back(reached_from.at(steps.back().region));
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

  // Returns the point at which the segment leaves a region, on an edge of the other triangulation.
  Surface_point<FT> crossing(const Step& step, Crossed_segment<FT>& segment) const
  {
    const Mapped_region face = this->face(step.region);
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
