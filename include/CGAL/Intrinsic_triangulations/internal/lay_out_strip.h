// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_LAY_OUT_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_LAY_OUT_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The distances of a point from the source and the target of a halfedge of its face.
template <typename FT>
struct End_distances
{
  FT source, target;
};

// Lays out the triangles of `mesh` that a line passes which leaves a face through each of the halfedges
// exit(0), ..., exit(n - 1). n > 0. The line starts at distances `first` from the ends of exit(0), and ends
// beyond exit(n - 1) at distances `last` from its ends.
template <typename Strip, typename LengthMap, typename Exit, typename FT>
void lay_out_strip(Strip& strip, const Delta_complex& mesh, const LengthMap& length_map,
                   const Exit& exit, std::size_t n, const End_distances<FT>& first,
                   const End_distances<FT>& last)
{
  const auto length = [&](Halfedge_index h) -> decltype(auto) { return length_map[mesh.edge(h)]; };
  Halfedge_index ij = exit(0);
  strip.start(first.source, length(ij), first.target);
  for(std::size_t m = 1; m <= n; ++m) {
    const Halfedge_index ji = mesh.opposite(ij), il = mesh.next(ji), lj = mesh.prev(ji);
    if(m == n)
      strip.finish(length(ij), last.target, last.source);
    else if((ij = exit(m)) == il)
      strip.turn_around_source(length(ji), length(lj), length(il));
    else
      strip.turn_around_target(length(ji), length(lj), length(il));
  }
}

// The same from the corner opposite to exit(0) to the one beyond exit(n - 1).
template <typename Strip, typename LengthMap, typename Exit>
void lay_out_strip(Strip& strip, const Delta_complex& mesh, const LengthMap& length_map,
                   const Exit& exit, std::size_t n)
{
  typedef typename boost::property_traits<LengthMap>::value_type FT;
  const auto distances = [&](Halfedge_index ij) {
    return End_distances<FT>{length_map[mesh.edge(mesh.prev(ij))],
                             length_map[mesh.edge(mesh.next(ij))]};
  };
  const End_distances<FT> last = distances(mesh.opposite(exit(n - 1)));
  lay_out_strip(strip, mesh, length_map, exit, n, distances(exit(0)),
                End_distances<FT>{last.target, last.source});
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_LAY_OUT_STRIP_H
