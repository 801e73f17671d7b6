// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/mended_topology.h"

#include <CGAL/Intrinsic_simplification/pinch_handles.h>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

Mended_topology::Mended_topology(const Triangulation& start, double closed_length,
                                 double pinched_length)
  : m_number_of_vertices(start.mesh().number_of_vertices()),
    m_before(IT::topological_type(start.mesh())),
    m_surface(start)
{
  if(closed_length > 0)
    m_closed = IS::close_boundary_loops(m_surface, closed_length);
  if(pinched_length > 0)
    m_pinched = IS::pinch_handles(m_surface, pinched_length);
}

void Mended_topology::describe(Statistics& statistics) const
{
  const IT::Topological_type after = IT::topological_type(m_surface.mesh());
  statistics["closed_loops"] = m_closed;
  statistics["pinched_handles"] = m_pinched;
  statistics["boundary_loops_before"] = m_before.boundary_loops;
  statistics["boundary_loops_after"] = after.boundary_loops;
  statistics["genus_before"] = m_before.genus;
  statistics["genus_after"] = after.genus;
  statistics["filled_area"] = m_surface.filled_area();
}

// An apex comes after the vertices around its disk, or their originals.
std::vector<std::vector<Mesh::Vertex_index>> Mended_topology::sources_of_new_vertices() const
{
  std::vector<std::vector<Mesh::Vertex_index>> result;
  const IS::Delta_complex& mesh = m_surface.mesh();
  for(auto i = m_number_of_vertices; i < mesh.number_of_vertices(); ++i) {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(i));
    result.emplace_back();
    if(m_surface.original_vertex(v).is_valid()) {
      result.back().push_back(m_surface.original_vertex(v));
      continue;
    }
    IS::for_each_outgoing_halfedge(v, mesh, [&](IS::Halfedge_index h) {
      const Mesh::Vertex_index u = m_surface.original_vertex(mesh.target(h));
      if(u.is_valid() || mesh.target(h) < v)
        result.back().push_back(u.is_valid() ? u : mesh.target(h));
    });
  }
  return result;
}
