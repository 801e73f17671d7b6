// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_MAKE_SIMPLICIAL_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_MAKE_SIMPLICIAL_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/refine.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/is_simplicial.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Returns the edges in the order of decreasing lengths.
inline std::deque<Edge_index> longest_edges_first(const Evolving_surface::Triangulation& tri)
{
  std::deque<Edge_index> result(tri.mesh().edges_begin(), tri.mesh().edges_end());
  std::stable_sort(result.begin(), result.end(),
                   [&](Edge_index e, Edge_index f) { return tri.length(e) > tri.length(f); });
  return result;
}

// Splits the edge of `h` in the middle, or near it: the third corner of a face without area can lie
// in the middle. The edge has two faces, so three points suffice.
inline Vertex_index split_near_middle(Halfedge_index h,
                                      Intrinsic_triangulations::Vertex_inserter<>& inserter)
{
  for(double t : {0.5, 0.375})
    try {
      return inserter.split_edge(h, t);
    } catch(const Intrinsic_triangulations::Numerical_error&) {
    }
  return inserter.split_edge(h, 0.625);
}

// Inserts vertices until the surface is simplicial, and returns their number. Splits loops in the
// middle, and of several edges with the same ends all but the shortest. Then a face whose corners
// another face has gets a vertex inside. No edge is flipped, so new vertices have simple
// coordinates, however thin a face is. A new edge is a loop, or has the ends of another edge, only
// if corners of split faces coincide, so few splits suffice.
inline std::size_t make_simplicial(Evolving_surface& surface)
{
  namespace IT = Intrinsic_triangulations;
  Evolving_surface::Triangulation tri =
    constrained_triangulation(Surface_level(surface), surface.surface());
  const Delta_complex& mesh = tri.mesh();
  IT::Default_refinement_visitor silent;
  Refinement_follower<IT::Default_refinement_visitor> follower(tri, surface, silent);
  IT::Vertex_inserter<> inserter(tri);
  std::deque<Edge_index> edges = longest_edges_first(tri);
  for(; !edges.empty(); edges.pop_front())
    if(const Halfedge_index h = mesh.halfedge(edges.front()); !is_simplicial(h, mesh)) {
      const Vertex_index m = split_near_middle(h, inserter);
      follower.after_insertion(m, inserter);
      for_each_outgoing_halfedge(m, mesh, [&](Halfedge_index x) { edges.push_back(mesh.edge(x)); });
    }
  const std::vector<Face_index> faces(mesh.faces_begin(), mesh.faces_end());
  for(Face_index f : faces)
    if(!is_simplicial(f, mesh))
      follower.after_insertion(
        inserter.insert(IT::Face_location<double>(f, {1. / 3, 1. / 3, 1. / 3})), inserter);
  follower.take_lengths();
  return tri.number_of_inserted_vertices();
}

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_MAKE_SIMPLICIAL_H
