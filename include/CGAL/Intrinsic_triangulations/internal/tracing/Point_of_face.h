// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_POINT_OF_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_POINT_OF_FACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/trace.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// A place on an edge among the crossings and inserted vertices there, in the direction of the first
// halfedge: on part `part`, after `rank` crossings on all parts.
struct Rank_on_edge
{
  Delta_complex::size_type part, rank;
};

// A point of a face: corner `side`, or on this side, or inside.
template <typename FT>
struct Point_of_face
{
  enum Kind
  {
    corner,
    on_side,
    inside
  } kind;
  std::size_t side;
  Rank_on_edge on_edge; // if it is on a side
  std::array<FT, 3> coordinates;
  bool is_inserted = false; // whether it is a vertex of T2 on a side of a face of T1
};

// The order of points along the edges of one side of a correspondence.
template <typename Traits>
class Edge_ranks
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;

public:
  Edge_ranks(const Correspondence<Traits>& correspondence, Side side)
    : m_correspondence(correspondence), m_side(side)
  {}

  // returns the rank of the point at `t` on the first halfedge of `e`
  Rank_on_edge operator()(Edge_index e, const FT& t) const
  {
    const size_type part = part_at(e, t);
    const Rank_on_edge first = begin(e, part);
    const auto is_after = [&](size_type p) {
      return m_correspondence.crossing(m_side, first_halfedge(e), first.rank + p).here.t > t;
    };
    return {part, first.rank + first_where(is_after, count(e, part))};
  }

  // returns the rank at the begin of a part, and at its end
  Rank_on_edge begin(Edge_index e, size_type part) const
  {
    return {part, m_side == Side::intrinsic
                    ? 0
                    : m_correspondence.part(e, part).first - m_correspondence.part(e, 0).first};
  }
  Rank_on_edge end(Edge_index e, size_type part) const
  {
    return {part, begin(e, part).rank + count(e, part)};
  }

  // returns the first part of `e` that does not end before `t`; an inserted vertex ends its part
  size_type part_at(Edge_index e, const FT& t) const
  {
    return first_where([&](size_type i) { return place_of_end(e, i) >= t; },
                       number_of_parts(e) - 1);
  }

  // returns the part of `e` that ends at an inserted vertex at `t`, if there is one
  std::optional<size_type> part_to_inserted(Edge_index e, const FT& t) const
  {
    const size_type part = part_at(e, t - rounding_unit<FT>());
    if(part + 1 < number_of_parts(e) && place_of_end(e, part) <= t + rounding_unit<FT>())
      return part;
    return {};
  }

private:
  size_type number_of_parts(Edge_index e) const
  {
    return m_side == Side::intrinsic ? 1 : m_correspondence.number_of_parts(e);
  }

  size_type count(Edge_index e, size_type part) const
  {
    return m_side == Side::intrinsic ? m_correspondence.number_of_crossings(m_side, e)
                                     : m_correspondence.part(e, part).count;
  }

  FT place_of_end(Edge_index e, size_type part) const
  {
    return m_correspondence.triangulation().place_along(first_halfedge(e),
                                                        m_correspondence.part(e, part).end);
  }

  const Correspondence<Traits>& m_correspondence;
  Side m_side;
};

// Returns where the halfedge `h` of T1, no border halfedge, goes on on T2 at the begin of one of
// its parts: the last spoke at or clockwise from it. Complexity: linear in the degree of the vertex
// there.
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_POINT_OF_FACE_H
