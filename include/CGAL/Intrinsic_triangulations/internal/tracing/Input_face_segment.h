// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_SEGMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_SEGMENT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Crossed_segment.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_face_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Point_of_face.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds a straight segment in a face of T1 on T2, where the face may contain vertices of T2.
//
// Each vertex of T2 and each crossing on the sides of the face is on the left or on the right of
// the line through the segment. The line crosses the pieces of edges of T2 with one end on either
// side: from region to region these lead from where it enters the face to where it leaves, whatever
// rounding says about vertices inside. Then the regions before the segment and after it are left
// out. Those of its ends depend on the ends alone, so that a path does not tear there: what
// rounding leaves between them and the line is bridged.
template <typename Traits>
class Input_face_segment
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;
  typedef Point_of_face<FT> Point;
  typedef Barycentric_coordinates<FT> Coordinates;
  typedef Input_face_walk<Traits> Regions;
  typedef typename Regions::Place Place;
  typedef typename Regions::Piece Piece;
  typedef typename Regions::Face_of_place Face_of_place;

public:
  Input_face_segment(const Correspondence<Traits>& correspondence, Face_index f, const Point& from,
                     const Point& to)
    : m_correspondence(correspondence),
      m_regions(correspondence),
      m_mesh(correspondence.mesh(Side::intrinsic)),
      m_side(sides(f, correspondence.mesh(Side::input))),
      m_segment(from.coordinates, to.coordinates),
      m_from(end_of_line(f, from, end_on_line(from, to, from, true))),
      m_to(end_of_line(f, to, end_on_line(from, to, to, false)))
  {
    cross_regions();
  }

  // returns the places of its ends on T2
  Surface_place<FT> start() const { return place_of(m_from, m_first); }
  Surface_place<FT> end() const { return place_of(m_to, m_last); }

  // returns whether its ends are vertices of T2
  bool starts_at_vertex() const { return m_from.is_vertex; }
  bool ends_at_vertex() const { return m_to.is_vertex; }

  void add_crossings(std::vector<Surface_place<FT>>& places) const
  {
    places.insert(places.end(), m_crossings.begin(), m_crossings.end());
  }

private:
  // between two crossings or vertices of T2 on the boundary of the face
  struct Gap
  {
    std::size_t side;
    Rank_on_edge on_edge;
  };

  struct End
  {
    Point point;
    Gap on_line; // where the line enters or leaves the face
    Place region;
    bool is_vertex; // of T2
  };

  // a region and the corner after which the line leaves it
  struct Step
  {
    Place region;
    std::size_t corner;
  };

  // returns the halfedge of T2 on which a corner of a region lies, or which starts there
  Halfedge_index halfedge(const Place& region, const Region_corner& corner) const
  {
    return sides(region.first, m_mesh)[corner.side];
  }

  Edge_ranks<Traits> ranks() const { return {m_correspondence, Side::input}; }
  Edge_index edge(std::size_t s) const { return Edge_index(m_side[s]); }
  bool is_first(std::size_t s) const { return is_first_halfedge(m_side[s]); }

  // ---- Where the line enters and leaves the face ----

  Gap end_on_line(const Point& from, const Point& to, const Point& p, bool is_start) const
  {
    if(p.kind == Point::corner)
      return is_start ? first_gap(p.side) : last_gap((p.side + 2) % 3);
    if(p.kind == Point::on_side)
      return p.is_inserted ? gap_at_inserted(p, is_start) : Gap{p.side, p.on_edge};
    return gap_beyond(from, to, is_start);
  }

  Gap first_gap(std::size_t s) const
  {
    const size_type last = m_correspondence.number_of_parts(edge(s)) - 1;
    return {s, is_first(s) ? ranks().begin(edge(s), 0) : ranks().end(edge(s), last)};
  }

  Gap last_gap(std::size_t s) const
  {
    const size_type last = m_correspondence.number_of_parts(edge(s)) - 1;
    return {s, is_first(s) ? ranks().end(edge(s), last) : ranks().begin(edge(s), 0)};
  }

  // after the vertex if the segment starts there, otherwise before it
  Gap gap_at_inserted(const Point& p, bool is_start) const
  {
    const size_type part = p.on_edge.part;
    return {p.side, is_start == is_first(p.side) ? ranks().begin(edge(p.side), part + 1)
                                                 : ranks().end(edge(p.side), part)};
  }

  // The line goes on straight beyond an end inside the face.
  Gap gap_beyond(const Point& from, const Point& to, bool is_start) const
  {
    std::array<FT, 3> left; // distances of the corners from the line
    for(std::size_t s = 0; s < 3; ++s)
      left[s] = m_segment.left(barycentric_coordinates(s, FT(0)));
    std::array<bool, 3> is_right = sides_of_corners(from, to, left);
    std::size_t s = 0;
    while(s < 2 && (is_right[s] == is_start || is_right[(s + 1) % 3] != is_start))
      ++s;
    const FT a = CGAL::abs(left[s]), b = CGAL::abs(left[(s + 1) % 3]);
    const Edge_point<FT> p{m_side[s], a + b > 0 ? FT(a / (a + b)) : FT(0.5)};
    return {s, ranks()(edge(s), place_on_first_halfedge(p))};
  }

  // Corners next to an end on the boundary are on their side of the line whatever rounding says.
  static std::array<bool, 3> sides_of_corners(const Point& from, const Point& to,
                                              const std::array<FT, 3>& left)
  {
    std::array<bool, 3> is_right{left[0] < 0, left[1] < 0, left[2] < 0};
    const auto set = [&](const Point& p, bool next, bool last) {
      if(p.kind == Point::inside)
        return;
      is_right[p.side] = p.kind == Point::on_side && !next;
      is_right[(p.side + 1) % 3] = next;
      if(p.kind == Point::corner)
        is_right[(p.side + 2) % 3] = last;
    };
    set(from, true, false);
    set(to, false, true);
    return is_right;
  }

  // ---- Regions at the ends ----

  End end_of_line(Face_index f, const Point& p, const Gap& gap) const
  {
    const Place region =
      p.kind == Point::inside ? m_regions.place_of({f, p.coordinates}) : region_at(gap);
    return {p, gap, region, corner_at(p.coordinates, {region, m_regions}).has_value()};
  }

  // returns the region at a gap
  Place region_at(const Gap& gap) const
  {
    const Halfedge_index h = m_side[gap.side];
    const auto& part = m_correspondence.part(edge(gap.side), gap.on_edge.part);
    if(part.is_shared)
      return m_regions.place_at({spoke_at_part(h, gap.on_edge.part, m_correspondence), 0});
    const Rank_on_edge first = ranks().begin(edge(gap.side), gap.on_edge.part);
    const size_type n = m_correspondence.number_of_crossings(Side::input, edge(gap.side)),
                    passed = gap.on_edge.rank - first.rank,
                    p = is_first(gap.side) ? gap.on_edge.rank : n - gap.on_edge.rank;
    const bool is_last = passed == (is_first(gap.side) ? part.count : 0);
    return m_regions.place_at_crossing(h, is_last ? p - 1 : p, is_last);
  }

  // returns the corner of a region that is the vertex of T2 at `p`, if there is one
  static std::optional<std::size_t> corner_at(const Coordinates& p, const Face_of_place& face)
  {
    for(std::size_t c = 0; c < face.region.size(); ++c)
      if(face.region[c].is_vertex() && face.corner(c) == p)
        return c;
    return {};
  }

  bool is_at(const End& end, const Place& region) const
  {
    return end.is_vertex
             ? corner_at(end.point.coordinates, Face_of_place(region, m_regions)).has_value()
             : region == end.region;
  }

  Surface_place<FT> place_of(const End& end, const Place& region) const
  {
    const Face_of_place face(region, m_regions);
    if(const auto c = corner_at(end.point.coordinates, face))
      return place_on(Edge_point<FT>{halfedge(region, face.region[*c]), FT(0)}, m_mesh);
    return {Delta_complex::null_halfedge(),
            {region.first, face.map.inverse()(end.point.coordinates)}};
  }

  // ---- Left and right of the line ----

  // whether a corner of a region is on the right of the line; ends of the segment are not
  bool is_right(const Face_of_place& face, std::size_t c, const Place& region) const
  {
    const Region_corner& corner = face.region[c];
    if(!corner.is_vertex())
      return is_crossing_right(corner, region);
    const Coordinates& p = face.corner(c);
    if(is_corner(p))
      return is_between_gaps([&](const Gap& gap) { return side_after(p) <= gap.side; });
    const Vertex_index v = m_mesh.source(halfedge(region, corner));
    if(m_correspondence.triangulation().inserted_vertex(v).along.is_valid())
      return is_inserted_right(v, side_after(p));
    return p != m_from.point.coordinates && p != m_to.point.coordinates && m_segment.left(p) < 0;
  }

  // the side of the face of T1 on which `p` lies, or which starts there
  static std::size_t side_after(const Coordinates& p)
  {
    std::size_t s = 0;
    while(p[s] == 0 || p[(s + 2) % 3] != 0)
      ++s;
    return s;
  }

  // `precedes(gap)` is whether a point of the boundary comes before a gap, counterclockwise from
  // corner 0
  template <typename Precedes>
  bool is_between_gaps(const Precedes& precedes) const
  {
    const bool is_after_start = !precedes(m_from.on_line), is_before_end = precedes(m_to.on_line);
    return is_before(m_from.on_line, m_to.on_line) ? is_after_start && is_before_end
                                                   : is_after_start || is_before_end;
  }

  static bool is_same(const Gap& a, const Gap& b)
  {
    return a.side == b.side && a.on_edge.part == b.on_edge.part && a.on_edge.rank == b.on_edge.rank;
  }

  bool is_before(const Gap& a, const Gap& b) const
  {
    if(a.side != b.side)
      return a.side < b.side;
    const bool is_before_on_first =
      std::tie(a.on_edge.part, a.on_edge.rank) < std::tie(b.on_edge.part, b.on_edge.rank);
    return is_first(a.side) == is_before_on_first;
  }

  // `precedes_on_first(x)`: on the same side, along its first halfedge
  template <typename Precedes>
  bool is_right_on_side(std::size_t side, const Precedes& precedes_on_first) const
  {
    return is_between_gaps([&](const Gap& gap) {
      return side != gap.side ? side < gap.side : is_first(side) == precedes_on_first(gap.on_edge);
    });
  }

  bool is_inserted_right(Vertex_index v, std::size_t side) const
  {
    const FT t = m_correspondence.triangulation().place_along(first_halfedge(edge(side)), v);
    const size_type part = ranks().part_at(edge(side), t);
    return is_right_on_side(side, [&](const Rank_on_edge& x) { return part < x.part; });
  }

  bool is_crossing_right(const Region_corner& corner, const Place& region) const
  {
    const auto crossing = m_correspondence.crossing(Side::intrinsic, halfedge(region, corner),
                                                    static_cast<size_type>(corner.mark));
    const Halfedge_index outward = crossing.across.halfedge;
    const std::size_t side = side_number(corner.arc_follows ? opposite(outward) : outward,
                                         m_correspondence.mesh(Side::input));
    const size_type rank = m_correspondence.rank_on_input(crossing.id);
    return is_right_on_side(side, [&](const Rank_on_edge& x) { return rank < x.rank; });
  }

  // ---- From region to region ----

  void cross_regions()
  {
    const std::vector<Step> steps = steps_along_line();
    const std::size_t last = last_step(steps), first = first_step(steps, last);
    m_first = is_at(m_from, steps[first].region) ? steps[first].region : m_from.region;
    m_last = is_at(m_to, steps[last].region) ? steps[last].region : m_to.region;
    bridge(m_first, steps[first].region, m_from.point.coordinates);
    for(std::size_t i = first; i < last; ++i)
      add_crossing(steps[i], [this](const auto& p, const auto& q) {
        return m_segment.next_crossing_on(p, q);
      });
    bridge(steps[last].region, m_last, m_to.point.coordinates);
  }

  // Returns all regions that the line passes; the last has no corner. Since the pieces that it
  // crosses have one end on either side, no region is entered twice through the same piece.
  std::vector<Step> steps_along_line() const
  {
    if(is_same(m_from.on_line, m_to.on_line))
      return {{m_from.region, 0}};
    std::vector<Step> result{{region_at(m_from.on_line), 0}};
    std::optional<std::size_t> entry = entry_corner(result.front().region);
    while(entry) {
      Step& step = result.back();
      const Face_of_place face(step.region, m_regions);
      step.corner = exit_corner(face, *entry, step.region);
      entry = std::nullopt;
      if(const auto piece = m_regions.piece_after(face.region[step.corner], step.region)) {
        const Piece beyond = m_regions.reversed(*piece);
        result.push_back({m_regions.place_at(beyond), 0});
        entry = m_regions.corner_before(beyond, m_regions.region(result.back().region));
      }
    }
    return result;
  }

  // returns the corner after which the line enters the face of T1 into a region
  std::optional<std::size_t> entry_corner(const Place& region) const
  {
    const Face_of_place face(region, m_regions);
    for(std::size_t c = 0; c < face.region.size(); ++c)
      if(!m_regions.piece_after(face.region[c], region) && !is_right(face, c, region) &&
         is_right(face, next(c, face), region))
        return c;
    return {};
  }

  // returns the corner after which the line leaves a region that it has entered after `entry`
  std::size_t exit_corner(const Face_of_place& face, std::size_t entry, const Place& region) const
  {
    std::size_t c = next(entry, face);
    while(is_right(face, next(c, face), region))
      c = next(c, face);
    return c;
  }

  static std::size_t next(std::size_t c, const Face_of_place& face)
  {
    return c + 1 == face.region.size() ? 0 : c + 1;
  }

  // returns the step that reaches the end of the segment, or is next to it up to rounding
  std::size_t last_step(const std::vector<Step>& steps) const
  {
    for(std::size_t i = 0; i < steps.size(); ++i)
      if(is_at(m_to, steps[i].region))
        return i;
    std::size_t i = 0;
    while(i + 1 < steps.size() && along_segment(steps[i]) < 1)
      ++i;
    return i;
  }

  std::size_t first_step(const std::vector<Step>& steps, std::size_t last) const
  {
    for(std::size_t i = last + 1; i-- > 0;)
      if(is_at(m_from, steps[i].region))
        return i;
    std::size_t i = last;
    while(i > 0 && along_segment(steps[i - 1]) > 0)
      --i;
    return i;
  }

  // ---- Crossings ----

  // returns where on the segment, from 0 to 1, the line leaves a region
  FT along_segment(const Step& step) const
  {
    const Face_of_place face(step.region, m_regions);
    const Coordinates &p = face.corner(step.corner), &q = face.corner(step.corner + 1);
    const FT t = m_segment.line_on(p, q);
    return (1 - t) * m_segment.along(p) + t * m_segment.along(q);
  }

  // `on_piece(p, q)` is where the piece from `p` to `q` is crossed, from 0 to 1
  template <typename On_piece>
  void add_crossing(const Step& step, const On_piece& on_piece)
  {
    const Face_of_place face(step.region, m_regions);
    const std::size_t c = step.corner, d = next(c, face);
    const Region_corner &begin = face.region[c], &end = face.region[d];
    const FT t = on_piece(face.corner(c), face.corner(d));
    const FT first = begin.is_vertex() ? FT(0) : face.marks.here(begin.side, begin.mark),
             last = end.is_vertex() ? FT(1) : face.marks.here(end.side, end.mark);
    m_crossings.push_back(
      crossing_on(Edge_point<FT>{halfedge(step.region, begin),
                                 place_between(first, last, FT((1 - t) / face.map.scale(c)),
                                               FT(t / face.map.scale(d)))},
                  m_mesh));
  }

  // Adds crossings next to `p` on a way with the fewest from region to region.
  void bridge(Place from, const Place& to, const Coordinates& p)
  {
    std::map<Place, Place> toward{{to, to}};
    std::vector<Place> reached{to};
    for(std::size_t i = 0; toward.count(from) == 0; ++i) {
      const Place place = reached[i];
      m_regions.for_each_exit(place, [&](std::size_t, const Place& neighbor) {
        if(toward.try_emplace(neighbor, place).second)
          reached.push_back(neighbor);
      });
    }
    while(from != to) {
      const Place next = toward[from];
      std::optional<std::size_t> exit;
      m_regions.for_each_exit(from, [&](std::size_t c, const Place& neighbor) {
        if(neighbor == next)
          exit = c;
      });
      add_crossing({from, *exit}, [&](const Coordinates& a, const Coordinates& b) {
        return closest_between(a, b, p);
      });
      from = next;
    }
  }

  const Correspondence<Traits>& m_correspondence;
  Regions m_regions;
  const Delta_complex& m_mesh;
  std::array<Halfedge_index, 3> m_side; // of the face of T1
  Crossed_segment<FT> m_segment;
  End m_from, m_to;
  Place m_first, m_last; // the regions at the ends
  std::vector<Surface_place<FT>> m_crossings;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_SEGMENT_H
