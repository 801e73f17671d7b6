// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Cut_graph.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Flat_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// The positions of the vertices of a sphere in the plane, one vertex of it at infinity. `length`
// has the lengths of edges in the plane; the remaining surface is flat (Section 4.4.5).
template <typename FT>
class Plane_layout
{
public:
  typedef std::array<FT, 2> Point;

  // `order` is that of the vertices
  Plane_layout(const Delta_complex& mesh, const std::vector<FT>& length, Vertex_index at_infinity,
               const Shared_order& order)
    : m_mesh(mesh), m_length(length), m_at_infinity(at_infinity), m_position(mesh.num_vertices())
  {
    const std::vector<char> is_used = finite_faces();
    if(std::count(is_used.begin(), is_used.end(), 1) > 0)
      lay_out_faces(is_used, order);
    else
      lay_out_edges();
  }

  // that of the vertex at infinity has no meaning
  const std::vector<Point>& positions() const { return m_position; }

private:
  std::vector<char> finite_faces() const
  {
    std::vector<char> result(m_mesh.num_faces(), 1);
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.target(h) == m_at_infinity)
        result[m_mesh.face(h).idx()] = 0;
    return result;
  }

  void lay_out_faces(const std::vector<char>& is_used, const Shared_order& order)
  {
    std::vector<char> is_wall(m_mesh.num_edges()), is_terminal(m_mesh.num_vertices(), 0);
    std::vector<double> rounded(m_mesh.num_edges());
    for(Edge_index e : m_mesh.edges()) {
      const Halfedge_index h = m_mesh.halfedge(e);
      rounded[e.idx()] = static_cast<double>(m_length[e.idx()]);
      is_wall[e.idx()] =
        !is_used[m_mesh.face(h).idx()] || !is_used[m_mesh.face(m_mesh.opposite(h)).idx()];
      if(is_wall[e.idx()])
        is_terminal[m_mesh.source(h).idx()] = is_terminal[m_mesh.target(h).idx()] = 1;
    }
    const Cut_graph cut(m_mesh, rounded, is_wall, is_used, is_terminal);
    const Flat_layout<FT> layout(m_mesh, m_length, cut, order);
    for(Halfedge_index h : m_mesh.halfedges())
      if(is_used[m_mesh.face(h).idx()])
        m_position[m_mesh.source(h).idx()] = layout.exact_position(h);
  }

  // No face remains: a path of edges, from one end to the other, on a line.
  void lay_out_edges()
  {
    FT x(0);
    Halfedge_index h = first_edge_of_path();
    while(h.is_valid()) {
      m_position[m_mesh.source(h).idx()] = {x, FT(0)};
      x += m_length[Edge_index(h).idx()];
      m_position[m_mesh.target(h).idx()] = {x, FT(0)};
      h = after_on_path(h);
    }
  }

  Halfedge_index first_edge_of_path() const
  {
    for(Halfedge_index h : m_mesh.halfedges())
      if(is_on_path(h) && !after_on_path(m_mesh.opposite(h)).is_valid())
        return h;
    return Halfedge_index();
  }

  bool is_on_path(Halfedge_index h) const
  {
    return m_mesh.source(h) != m_at_infinity && m_mesh.target(h) != m_at_infinity;
  }

  // null at the end
  Halfedge_index after_on_path(Halfedge_index h) const
  {
    Halfedge_index result;
    Intrinsic_triangulations::for_each_spoke(m_mesh.target(h), m_mesh, [&](Halfedge_index x) {
      if(is_on_path(x) && x != m_mesh.opposite(h))
        result = x;
    });
    return result;
  }

  const Delta_complex& m_mesh;
  const std::vector<FT>& m_length;
  Vertex_index m_at_infinity;
  std::vector<Point> m_position;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_LAYOUT_H
