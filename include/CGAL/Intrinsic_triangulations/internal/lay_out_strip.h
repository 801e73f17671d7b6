// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_LAY_OUT_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_LAY_OUT_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Lays out the triangles of `mesh` that a line passes which leaves a face through each of the halfedges
// exit(0), ..., exit(n - 1), from the corner opposite to the first to the one beyond the last. n > 0.
template <typename Strip, typename LengthMap, typename Exit>
void lay_out_strip(Strip& strip, const Delta_complex& mesh, const LengthMap& length_map,
                   const Exit& exit, std::size_t n)
{
  const auto length = [&](Halfedge_index h) -> decltype(auto) { return length_map[mesh.edge(h)]; };
  Halfedge_index ij = exit(0);
  strip.start(length(mesh.prev(ij)), length(ij), length(mesh.next(ij)));
  for(std::size_t m = 1; m <= n; ++m) {
    const Halfedge_index ji = mesh.opposite(ij), il = mesh.next(ji), lj = mesh.prev(ji);
    if(m == n)
      strip.finish(length(ij), length(lj), length(il));
    else if((ij = exit(m)) == il)
      strip.turn_around_source(length(ji), length(lj), length(il));
    else
      strip.turn_around_target(length(ji), length(lj), length(il));
  }
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_LAY_OUT_STRIP_H
