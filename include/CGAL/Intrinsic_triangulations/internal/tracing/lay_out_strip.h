// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_LAY_OUT_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_LAY_OUT_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Lays out the triangles of `surface` that a line passes which leaves a face through each of the
// halfedges `exits`, at least one. The line starts at the corner opposite to the first exit and
// ends at the one beyond the last; or if `ends` is a pair of barycentric coordinates, at the points
// with these in the same triangles, that of the corner first.
template <typename Strip, typename Surface, typename Exits, typename... Ends>
void lay_out_strip(Strip& strip, const Surface& surface, const Exits& exits, const Ends&... ends)
{
  const Delta_complex& mesh = surface.mesh();
  const auto& length_map = surface.length_map();
  const auto length = [&](Halfedge_index h) -> decltype(auto) { return length_map[mesh.edge(h)]; };
  Halfedge_index ij = exits[0];
  strip.start(length(mesh.prev(ij)), length(ij), length(mesh.next(ij)), ends.first...);
  for(std::size_t m = 1; m < exits.size(); ++m) {
    const Halfedge_index ji = mesh.opposite(ij), il = mesh.next(ji), lj = mesh.prev(ji);
    if((ij = exits[m]) == il)
      strip.turn_around_source(length(ji), length(lj), length(il));
    else
      strip.turn_around_target(length(ji), length(lj), length(il));
  }
  const Halfedge_index ji = mesh.opposite(ij);
  strip.finish(length(ji), length(mesh.prev(ji)), length(mesh.next(ji)), ends.second...);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_LAY_OUT_STRIP_H
