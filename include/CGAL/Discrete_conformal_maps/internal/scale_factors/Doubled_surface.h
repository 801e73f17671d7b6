// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_SURFACE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_SURFACE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents a surface and a copy of some of its faces, glued along the boundary (Section 4.3.4).
// It is the double of the surface, or a sufficient part of it. The surface itself keeps its
// indices, and its border halfedges become halfedges of copied faces. The copy has a border between
// copied and other faces.
class Doubled_surface
{
  typedef Delta_complex::size_type size_type;

public:
  // `has_copy` states for each face of `half`, which has no garbage, whether it is copied. Either
  // all faces at a vertex on the boundary are copied, or none is.
  Doubled_surface(const Delta_complex& half, const std::vector<char>& has_copy)
    : m_half(half),
      m_mesh(half),
      m_has_copy(has_copy),
      m_edge(half.num_edges()),
      m_face(half.num_faces()),
      m_corner(half.num_halfedges())
  {
    for(Vertex_index v : half.vertices())
      m_original.push_back(v);
    for(Face_index f : half.faces())
      m_original_face.push_back(f);
    add_copies();
    for(Face_index f : half.faces())
      if(has_copy[f.idx()])
        link_copy(f);
    for(Edge_index e : m_seams)
      link_border(border(e));
  }

  const Delta_complex& mesh() const { return m_mesh; }

  // Returns for each vertex the vertex that it equals or copies. If the copies of the faces around
  // a vertex are not connected, it has several copies.
  const std::vector<Vertex_index>& originals() const { return m_original; }

  // Returns for each face the face that it equals or copies.
  const std::vector<Face_index>& original_faces() const { return m_original_face; }

  // Returns the edges of the surface between a face with and a face without a copy.
  const std::vector<Edge_index>& seams() const { return m_seams; }

  // Returns the copy of an edge, or the edge itself on the boundary and if it has no copy.
  Edge_index mirrored(Edge_index e) const { return m_edge[e.idx()]; }

  // Returns the triangulation with the lengths of the edges of the surface.
  Intrinsic_triangulations::Intrinsic_triangulation<>
  triangulation(const std::vector<double>& length_on_surface) const
  {
    std::vector<double> length(m_mesh.num_edges());
    for(Edge_index e : m_half.edges())
      length[e.idx()] = length[mirrored(e).idx()] = length_on_surface[e.idx()];
    return Intrinsic_triangulations::Intrinsic_triangulation<>(
      m_mesh, Intrinsic_triangulations::parameters::edge_length_map(
                boost::make_function_property_map<Edge_index>(
                  [&](Edge_index e) { return length[e.idx()]; })));
  }

  // Returns the triangulation with the positions of the vertices of the surface. Rounded lengths of
  // a thin face may be lengths of a face without area, but positions are not.
  Intrinsic_triangulations::Intrinsic_triangulation<>
  triangulation(const std::vector<std::array<double, 3>>& point_on_surface) const
  {
    return Intrinsic_triangulations::Intrinsic_triangulation<>(
      m_mesh, CGAL::parameters::vertex_point_map(
                boost::make_function_property_map<Vertex_index>([&](Vertex_index v) {
                  const auto& [x, y, z] = point_on_surface[m_original[v.idx()].idx()];
                  return Simple_cartesian<double>::Point_3(x, y, z);
                })));
  }

private:
  bool is_copied(Halfedge_index h) const
  {
    return !m_half.is_border(h) && m_has_copy[m_half.face(h).idx()];
  }

  // Returns the mirrored halfedge, which leads from the mirrored target to the mirrored source.
  Halfedge_index mirrored(Halfedge_index h) const
  {
    using namespace Intrinsic_triangulations;
    const Edge_index e(h);
    return opposite(m_half.is_border(e) ? h : oriented_like(h, first_halfedge(m_edge[e.idx()])));
  }

  void add_copies()
  {
    for(Face_index f : m_half.faces())
      if(m_has_copy[f.idx()]) {
        m_face[f.idx()] = m_mesh.add_face();
        m_original_face.push_back(f);
      }
    for(Edge_index e : m_half.edges()) {
      const Halfedge_index h = m_half.halfedge(e), o = m_half.opposite(h);
      const bool is_inside = !m_half.is_border(e) && (is_copied(h) || is_copied(o));
      m_edge[e.idx()] = is_inside ? Edge_index(m_mesh.add_edge()) : e;
      if(is_inside && is_copied(h) != is_copied(o))
        m_seams.push_back(e);
    }
    for(Vertex_index v : m_half.vertices())
      if(!m_half.is_isolated(v))
        add_corners(v);
  }

  // Adds a copy of `v` for every sequence of copied faces around it.
  void add_corners(Vertex_index v)
  {
    if(m_half.is_border(v)) {
      for(Halfedge_index h : m_half.halfedges_around_target(m_half.halfedge(v)))
        m_corner[h.idx()] = v;
      return;
    }
    Halfedge_index first = m_half.halfedge(v);
    const auto next = [this](Halfedge_index h) { return m_half.opposite(m_half.next(h)); };
    for(Halfedge_index h = next(first); is_copied(first) && h != first; h = next(h))
      if(!is_copied(h))
        first = h;
    Vertex_index copy;
    Halfedge_index h = first;
    do {
      if(!is_copied(h))
        copy = Vertex_index();
      else if(!copy.is_valid()) {
        copy = m_mesh.add_vertex();
        m_original.push_back(v);
      }
      m_corner[h.idx()] = copy;
      h = next(h);
    } while(h != first);
  }

  void link_copy(Face_index f)
  {
    const Face_index copy = m_face[f.idx()];
    Halfedge_index h = m_half.halfedge(f);
    m_mesh.set_halfedge(copy, mirrored(h));
    do {
      const Vertex_index source = m_corner[m_half.prev(h).idx()];
      m_mesh.set_next(mirrored(m_half.next(h)), mirrored(h));
      m_mesh.set_target(mirrored(h), source);
      m_mesh.set_face(mirrored(h), copy);
      if(source.idx() >= m_half.num_vertices())
        m_mesh.set_halfedge(source, mirrored(h));
      h = m_half.next(h);
    } while(h != m_half.halfedge(f));
  }

  // Returns the border halfedge of the copy of a seam.
  Halfedge_index border(Edge_index e) const
  {
    const Halfedge_index h = m_half.halfedge(e);
    return mirrored(is_copied(h) ? m_half.opposite(h) : h);
  }

  void link_border(Halfedge_index border)
  {
    const auto turned = [this](Halfedge_index h) {
      return m_mesh.opposite(m_mesh.prev(m_mesh.opposite(h)));
    };
    Halfedge_index next = turned(border);
    const Vertex_index v = m_mesh.source(next);
    while(!m_mesh.is_border(next))
      next = turned(m_mesh.opposite(next));
    m_mesh.set_target(border, v);
    m_mesh.set_halfedge(v, border);
    m_mesh.set_next(border, next);
  }

  const Delta_complex& m_half;
  Delta_complex m_mesh;
  const std::vector<char>& m_has_copy;
  std::vector<Vertex_index> m_original;
  std::vector<Face_index> m_original_face;
  std::vector<Edge_index> m_edge;
  std::vector<Face_index> m_face;
  std::vector<Vertex_index> m_corner; // the copy at the target of each halfedge of a copied face
  std::vector<Edge_index> m_seams;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_SURFACE_H
