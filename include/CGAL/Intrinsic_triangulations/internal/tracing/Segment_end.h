// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_SEGMENT_END_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_SEGMENT_END_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// The position of a point among the crossings of an edge, which are numbered from the source of its
// first halfedge. An edge of T1 has several parts if vertices have been inserted on it.
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

// An end of a segment in a face.
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
// faces there, so that segments with a common end stay connected.
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_SEGMENT_END_H
