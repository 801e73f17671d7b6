// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SEAM_PRUNING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SEAM_PRUNING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Closes open edges from the ends of their graph on: around a vertex with one open edge that is no
// terminal, all faces fit. `is_open` says of each edge whether it is open, and then whether it
// still is.
inline void close_ends(const Delta_complex& mesh, const std::vector<char>& is_terminal,
                       std::vector<char>& is_open)
{
  std::vector<int> count(mesh.num_vertices(), 0);
  for(Halfedge_index h : mesh.halfedges())
    count[mesh.source(h).idx()] += is_open[Edge_index(h).idx()];
  std::vector<Vertex_index> ends;
  const auto note = [&](Vertex_index v) {
    if(count[v.idx()] == 1 && !is_terminal[v.idx()])
      ends.push_back(v);
  };
  for(Vertex_index v : mesh.vertices())
    note(v);
  while(!ends.empty()) {
    const Vertex_index v = ends.back();
    ends.pop_back();
    Halfedge_index open;
    if(count[v.idx()] == 1)
      Intrinsic_triangulations::for_each_spoke(v, mesh, [&](Halfedge_index h) {
        if(is_open[Edge_index(h).idx()])
          open = h;
      });
    if(!open.is_valid())
      continue;
    is_open[Edge_index(open).idx()] = 0;
    --count[v.idx()];
    --count[mesh.target(open).idx()];
    note(mesh.target(open));
  }
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SEAM_PRUNING_H
