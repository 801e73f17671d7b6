// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GLUE_BOUNDARY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GLUE_BOUNDARY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// a closed surface that has been made of surfaces with boundary.
struct Glued_surface
{
  /// the surface, with lengths: see `stored_length_map<double>()`.
  Delta_complex mesh;
  /// the vertex that each vertex of the parts has become, by index; null if that has no face.
  std::vector<Vertex_index> vertices;
};

namespace internal {

// Returns the numbers of halfedges after glued edges have become one.
template <typename P>
std::vector<Halfedge_index>
glued_halfedges(const Surface_mesh<P>& mesh,
                const std::vector<std::pair<Halfedge_index, Halfedge_index>>& pairs)
{
  std::vector<Halfedge_index> partner(mesh.num_halfedges());
  for(Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(mesh.edge(h)))
      partner[h] = mesh.opposite(h);
  for(const auto& [h, o] : pairs) {
    if(h == o || mesh.is_border(h) || mesh.is_border(o) || partner[h].is_valid() ||
       partner[o].is_valid())
      throw Invalid_input("a side of face " + std::to_string(mesh.face(h).idx()) +
                          " is glued twice, or is not on the boundary");
    partner[h] = o;
    partner[o] = h;
  }
  std::vector<Halfedge_index> result(mesh.num_halfedges());
  Delta_complex::size_type n = 0;
  for(Halfedge_index h : mesh.halfedges()) {
    if(mesh.is_border(h) || result[h].is_valid())
      continue;
    if(!partner[h].is_valid())
      throw Invalid_input("the side from vertex " + std::to_string(mesh.source(h).idx()) +
                          " to vertex " + std::to_string(mesh.target(h).idx()) + " is not glued");
    result[h] = Halfedge_index(n++);
    result[partner[h]] = Halfedge_index(n++);
  }
  return result;
}

// Sets `v` as the target of all halfedges that lead to the target of `h`, and records the vertices
// that it replaces.
template <typename P>
void join_targets(Halfedge_index h, Vertex_index v, const Surface_mesh<P>& parts,
                  const std::vector<Halfedge_index>& before, Glued_surface& result)
{
  result.mesh.set_halfedge(v, h);
  Halfedge_index x = h;
  do {
    result.mesh.set_target(x, v);
    result.vertices[parts.target(before[x])] = v;
    x = opposite(result.mesh.next(x));
  } while(x != h);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// glues sides of surfaces, for example the sides of a polygon in the plane, until no boundary is
/// left. A glued edge has the mean of both lengths. Vertices are numbered in the order of the
/// first of the vertices that were glued. Complexity: linear.
///
/// \param mesh the parts, triangulated, without removed elements
/// \param length a readable property map from the edges of `mesh` to numbers of type `double`
/// \param pairs the halfedges that become opposite, each on the boundary and with a face on its
///   left. The source of one becomes the target of the other
/// \throws Invalid_input if a boundary edge is not in a pair, or more than once, or a halfedge of a
///   pair is not on the boundary
template <typename P, typename LengthMap>
Glued_surface glue_boundary(const Surface_mesh<P>& mesh, const LengthMap& length,
                            const std::vector<std::pair<Halfedge_index, Halfedge_index>>& pairs)
{
  CGAL_precondition(!mesh.has_garbage());
  const std::vector<Halfedge_index> after = internal::glued_halfedges(mesh, pairs);
  Glued_surface result;
  result.vertices.resize(mesh.num_vertices());
  Delta_complex::size_type n = 0;
  for(Halfedge_index h : after)
    n += h.is_valid();
  result.mesh.resize(0, n / 2, mesh.num_faces());
  auto glued_length = stored_length_map<double>(result.mesh);
  std::vector<Halfedge_index> before(n);
  for(Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(h)) {
      const Halfedge_index g = after[h];
      before[g] = h;
      result.mesh.set_next(g, after[mesh.next(h)]);
      result.mesh.set_face(g, mesh.face(h));
      glued_length[result.mesh.edge(g)] += get(length, mesh.edge(h)) / 2;
    }
  for(Face_index f : mesh.faces())
    result.mesh.set_halfedge(f, after[mesh.halfedge(f)]);
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v) && !result.vertices[v].is_valid()) {
      const Halfedge_index h = mesh.halfedge(v); // a border halfedge on the boundary
      internal::join_targets(after[mesh.is_border(h) ? mesh.prev(mesh.opposite(h)) : h],
                             result.mesh.add_vertex(), mesh, before, result);
    }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GLUE_BOUNDARY_H
