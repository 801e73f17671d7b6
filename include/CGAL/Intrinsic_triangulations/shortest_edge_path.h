// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// finds a shortest path along edges (Dijkstra).
///
/// \param surface a model of `IntrinsicSurface`
/// \param source the vertex where it starts
/// \param target the vertex where it ends
/// \returns its halfedges from `source` to `target`; none if the two are equal, or there is no path
///
/// Complexity: \f$O(m \log m)\f$ for \f$m\f$ edges within the distance of `target`.
template <typename Surface>
std::vector<Halfedge_index> shortest_edge_path(const Surface& surface, Vertex_index source,
                                               Vertex_index target)
{
  typedef Length_of<Surface> FT;
  typedef std::pair<FT, Halfedge_index> Step; // the length of a path, and its last halfedge
  const Delta_complex& mesh = surface.mesh();
  std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
  std::unordered_map<std::size_t, Halfedge_index> last;
  const auto go_on_from = [&](Vertex_index v, const FT& length) {
    if(!mesh.is_isolated(v))
      for_each_spoke(v, mesh, [&](Halfedge_index h) {
        if(last.count(mesh.target(h).idx()) == 0)
          queue.push({length + internal::edge_length(h, surface), h});
      });
  };
  last[source.idx()] = Delta_complex::null_halfedge();
  go_on_from(source, FT(0));
  while(!queue.empty() && last.count(target.idx()) == 0) {
    const auto [length, h] = queue.top();
    queue.pop();
    if(last.emplace(mesh.target(h).idx(), h).second)
      go_on_from(mesh.target(h), length);
  }
  std::vector<Halfedge_index> result;
  if(last.count(target.idx()) > 0)
    for(Halfedge_index h = last[target.idx()]; h.is_valid(); h = last[mesh.source(h).idx()])
      result.push_back(h);
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H
