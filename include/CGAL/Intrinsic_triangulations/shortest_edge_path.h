// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Dijkstra_search.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>

#include <algorithm>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// finds a shortest path along edges (Dijkstra).
///
/// \param surface a model of `IntrinsicSurface`
/// \param source the vertex where it starts
/// \param target the vertex where it ends
/// \returns its halfedges from `source` to `target`; none if the two are equal, or if there is no
///   path. Of equally short paths to a vertex, the one whose last halfedge has the least index
///   counts.
///
/// Complexity: \f$O(n + m \log m)\f$ for \f$n\f$ vertices, and \f$m\f$ edges within the distance
/// of `target`.
template <typename Surface>
std::vector<Halfedge_index> shortest_edge_path(const Surface& surface, Vertex_index source,
                                               Vertex_index target)
{
  typedef Length_of<Surface> FT;
  const Delta_complex& mesh = surface.mesh();
  Dijkstra_search<Vertex_index, FT> search(mesh.num_vertices());
  if(!mesh.is_isolated(source))
    search.reach(source, FT(0));
  for(Vertex_index v = search.next(); v.is_valid() && v != target; v = search.next())
    for_each_outgoing_halfedge(v, mesh, [&, distance = search.distance(v)](Halfedge_index h) {
      const Vertex_index w = mesh.target(h);
      const FT length = distance + internal::edge_length(h, surface);
      if(!search.reach(w, length, h) && !search.is_final(w) && length == search.distance(w) &&
         h < search.entry(w))
        search.set_entry(w, h);
    });
  std::vector<Halfedge_index> result;
  if(search.is_final(target))
    for(Halfedge_index h = search.entry(target); h.is_valid(); h = search.entry(mesh.source(h)))
      result.push_back(h);
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H
