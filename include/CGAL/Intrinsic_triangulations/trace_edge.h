// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACE_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACE_EDGE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns the position of the source of the halfedge `h` of `side` on the other triangulation.
template <typename Traits>
Edge_point<typename Traits::FT> end_of_edge(Side side, Halfedge_index h,
                                            const Correspondence<Traits>& correspondence)
{
  typedef typename Traits::FT FT;
  if(side == Side::intrinsic)
    return correspondence.triangulation().start_on_outgoing(h);
  return {correspondence.outgoing_before(side, h), FT(0)};
}

// Adds to the trace of the halfedge `h` of T1 the vertices of T2 that lie inside it.
template <typename Traits>
void add_inserted_vertices(Halfedge_index h, const Correspondence<Traits>& correspondence,
                           std::vector<Trace_point<typename Traits::FT>>& trace)
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;
  const auto& tri = correspondence.triangulation();
  const Edge_index e(h);
  const size_type parts = correspondence.number_of_parts(e);
  const size_type crossings = correspondence.number_of_crossings(Side::input, e);
  for(size_type i = 0; i + 1 < parts; ++i) { // from the target of h backwards
    const bool is_first = is_first_halfedge(h);
    const auto& part = correspondence.part(e, is_first ? parts - 2 - i : i);
    const size_type before = part.first + part.count - correspondence.part(e, 0).first;
    const Halfedge_index outgoing = first_outgoing_halfedge(part.end, tri.mesh());
    const std::ptrdiff_t place = 1 + std::ptrdiff_t(is_first ? before : crossings - before);
    trace.insert(trace.begin() + place,
                 Trace_point<FT>{{h, tri.place_along(h, part.end)}, {outgoing, FT(0)}});
  }
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the trace of the halfedge `h` of `side` over the other triangulation. The points are the
/// points of `trace_input_edge()` and `trace_intrinsic_edge()`. They are taken from
/// `correspondence`. Complexity: linear in the crossings of `h`.
template <typename Traits>
std::vector<Trace_point<typename Traits::FT>>
trace_edge(Side side, Halfedge_index h, const Correspondence<Traits>& correspondence)
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;
  const Side other = internal::other(side);
  const auto point = [side](const Edge_point<FT>& here, const Edge_point<FT>& there) {
    return side == Side::input ? Trace_point<FT>{here, there} : Trace_point<FT>{there, here};
  };
  std::vector<Trace_point<FT>> trace;
  trace.push_back(point({h, FT(0)}, internal::end_of_edge(side, h, correspondence)));
  for(size_type p = 0; p < correspondence.number_of_crossings(side, Edge_index(h)); ++p) {
    const auto c = correspondence.crossing(side, h, p);
    trace.push_back(point(c.here, reversed(c.across, correspondence.mesh(other))));
  }
  const auto back =
    internal::end_of_edge(side, correspondence.mesh(side).opposite(h), correspondence);
  trace.push_back(point({h, FT(1)}, internal::reversed_if_valid(back, correspondence.mesh(other))));
  if(side == Side::input)
    internal::add_inserted_vertices(h, correspondence, trace);
  return trace;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACE_EDGE_H
