// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDITY_DELTA_COMPLEX_DEFECT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDITY_DELTA_COMPLEX_DEFECT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

template <typename P>
std::ptrdiff_t Euler_characteristic(const Surface_mesh<P>& mesh)
{
  return std::ptrdiff_t(mesh.number_of_vertices()) - std::ptrdiff_t(mesh.number_of_edges()) +
         std::ptrdiff_t(mesh.number_of_faces());
}

template <typename P>
std::string halfedge_defect(SM_Halfedge_index h, const Surface_mesh<P>& mesh)
{
  const SM_Halfedge_index n = mesh.next(h);
  if(!mesh.has_valid_index(n) || mesh.is_removed(n) || mesh.prev(n) != h)
    return "next and prev disagree";
  if(mesh.source(n) != mesh.target(h))
    return "the next halfedge starts elsewhere";
  if(mesh.face(n) != mesh.face(h))
    return "the next halfedge is in another face";
  if(mesh.is_border(h))
    return mesh.is_border(mesh.opposite(h)) ? "no face on either side" : "";
  if(mesh.next(mesh.next(n)) != h)
    return "its face is not a triangle";
  return mesh.is_removed(mesh.face(h)) ? "its face is removed" : "";
}

// Returns the number of halfedges with target `v` that are reached from halfedge(v), at most
// `limit` + 1.
template <typename P>
std::size_t fan_size(SM_Vertex_index v, std::size_t limit, const Surface_mesh<P>& mesh)
{
  std::size_t count = 0;
  SM_Halfedge_index h = mesh.halfedge(v);
  do {
    h = mesh.opposite(mesh.next(h));
    ++count;
  } while(h != mesh.halfedge(v) && count <= limit);
  return count;
}

template <typename P>
std::string vertex_defect(SM_Vertex_index v, std::size_t degree, std::size_t border_degree,
                          const Surface_mesh<P>& mesh)
{
  if(mesh.is_isolated(v))
    return degree == 0 ? "" : "it has edges but no halfedge";
  const SM_Halfedge_index h = mesh.halfedge(v);
  if(!mesh.has_valid_index(h) || mesh.is_removed(h) || mesh.target(h) != v)
    return "its halfedge does not lead to it";
  if(border_degree == 1 && !mesh.is_border(h))
    return "it is on the boundary but its halfedge is not";
  if(border_degree > 1 || fan_size(v, degree, mesh) != degree)
    return "it has more than one vertex fan";
  return {};
}

// Returns the first defect of `mesh` as a Delta-complex in words, empty if it is valid.
template <typename P>
std::string Delta_complex_defect(const Surface_mesh<P>& mesh)
{
  std::vector<std::size_t> degree(mesh.num_vertices(), 0), border_degree(degree);
  for(SM_Halfedge_index h : mesh.halfedges()) {
    const std::string defect = halfedge_defect(h, mesh);
    if(!defect.empty())
      return "halfedge " + std::to_string(h.idx()) + ": " + defect;
    ++degree[mesh.target(h).idx()];
    if(mesh.is_border(h))
      ++border_degree[mesh.target(h).idx()];
  }
  for(SM_Face_index f : mesh.faces())
    if(mesh.face(mesh.halfedge(f)) != f)
      return "face " + std::to_string(f.idx()) + ": its halfedge is in another face";
  for(SM_Vertex_index v : mesh.vertices()) {
    const std::string defect = vertex_defect(v, degree[v.idx()], border_degree[v.idx()], mesh);
    if(!defect.empty())
      return "vertex " + std::to_string(v.idx()) + ": " + defect;
  }
  return {};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDITY_DELTA_COMPLEX_DEFECT_H
