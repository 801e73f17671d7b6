// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_SURFACE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_SURFACE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>

#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Two copies of a surface, glued along the boundary (Section 4.3.4). The first keeps its numbers;
// the border halfedges of the surface become those of the second copy. Components without boundary
// are not copied, nor are isolated vertices.
class Doubled_surface
{
  typedef Delta_complex::size_type size_type;

public:
  // `has_copy` says of each face of `half`, which has no garbage, whether it is to be copied: those
  // of components with boundary.
  Doubled_surface(const Delta_complex& half, const std::vector<char>& has_copy)
    : m_half(half),
      m_mesh(half),
      m_vertex(half.num_vertices()),
      m_edge(half.num_edges()),
      m_face(half.num_faces())
  {
    add_copies(has_copy);
    for(Face_index f : half.faces())
      if(m_face[f.idx()] != f)
        link_copy(f);
    for(Vertex_index v : half.vertices())
      if(m_vertex[v.idx()] != v)
        m_mesh.set_halfedge(m_vertex[v.idx()], mirrored(half.opposite(half.halfedge(v))));
  }

  const Delta_complex& mesh() const { return m_mesh; }

  // what is opposite to an element of the first copy; itself on the boundary and where there is no
  // copy
  Vertex_index mirrored(Vertex_index v) const { return m_vertex[v.idx()]; }
  Edge_index mirrored(Edge_index e) const { return m_edge[e.idx()]; }

  // It leads from the mirrored target to the mirrored source.
  Halfedge_index mirrored(Halfedge_index h) const
  {
    using namespace Intrinsic_triangulations;
    const Edge_index e(h);
    return opposite(m_half.is_border(e) ? h : directed_as(h, first_halfedge(m_edge[e.idx()])));
  }

private:
  void add_copies(const std::vector<char>& has_copy)
  {
    const auto is_copied = [&](Halfedge_index h) {
      return has_copy[m_half.face(m_half.is_border(h) ? m_half.opposite(h) : h).idx()] != 0;
    };
    for(Vertex_index v : m_half.vertices()) {
      const bool stays =
        m_half.is_isolated(v) || m_half.is_border(v) || !is_copied(m_half.halfedge(v));
      m_vertex[v.idx()] = stays ? v : m_mesh.add_vertex();
    }
    for(Edge_index e : m_half.edges()) {
      const bool stays = m_half.is_border(e) || !is_copied(m_half.halfedge(e));
      m_edge[e.idx()] = stays ? e : Edge_index(m_mesh.add_edge());
    }
    for(Face_index f : m_half.faces())
      m_face[f.idx()] = has_copy[f.idx()] ? m_mesh.add_face() : f;
  }

  void link_copy(Face_index f)
  {
    const Face_index copy = m_face[f.idx()];
    Halfedge_index h = m_half.halfedge(f);
    m_mesh.set_halfedge(copy, mirrored(h));
    do {
      m_mesh.set_next(mirrored(m_half.next(h)), mirrored(h));
      m_mesh.set_target(mirrored(h), mirrored(m_half.source(h)));
      m_mesh.set_face(mirrored(h), copy);
      h = m_half.next(h);
    } while(h != m_half.halfedge(f));
  }

  const Delta_complex& m_half;
  Delta_complex m_mesh;
  std::vector<Vertex_index> m_vertex;
  std::vector<Edge_index> m_edge;
  std::vector<Face_index> m_face;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_SURFACE_H
