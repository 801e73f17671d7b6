// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_MERGED_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_MERGED_EDGE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The edge that takes the place of two at an inserted vertex which lie along one edge of T1.
struct Merged_edge
{
  // `side` will lead from the target of the spoke `x` to that of the spoke `y`
  template <typename Traits>
  Merged_edge(const Triangulation_pair<Traits>& pair, Halfedge_index x, Halfedge_index y,
              Halfedge_index side)
    : side(side),
      r_source(pair.coordinates().roundabout(opposite(x))),
      r_target(pair.coordinates().roundabout(opposite(y))),
      is_constrained(pair.is_constrained(Edge_index(x)) && pair.is_constrained(Edge_index(y)))
  {}

  Merged_edge() = default;

  Halfedge_index side; // null if there are no such two
  Delta_complex::size_type r_source = 0, r_target = 0;
  bool is_constrained = false;
};

// \pre `v` has three spokes
template <typename Traits>
Merged_edge merged_edge(const Triangulation_pair<Traits>& pair, Vertex_index v)
{
  const Delta_complex& mesh = pair.mesh();
  const Halfedge_index a = first_spoke(v, mesh);
  if(mesh.is_border(v))
    return Merged_edge(pair, next_spoke(next_spoke(a, mesh), mesh), a, a);
  Halfedge_index x = a;
  do {
    const Halfedge_index y = next_spoke(x, mesh);
    if(pair.coordinates().is_shared(Edge_index(x)) && pair.coordinates().is_shared(Edge_index(y)))
      return Merged_edge(pair, x, y, mesh.next(x));
    x = y;
  } while(x != a);
  return {};
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_MERGED_EDGE_H
