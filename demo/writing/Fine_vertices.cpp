// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Fine_vertices.h"

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

Fine_vertices::Fine_vertices(std::size_t number_of_input_vertices, const Triangulation* split)
  : m_split(split), m_size(split ? split->mesh().number_of_vertices() : number_of_input_vertices)
{}

// An apex comes after the vertices around its disk, or their originals.
void Fine_vertices::add(const IS::Surface_surgery& surgery)
{
  const IS::Delta_complex& mesh = surgery.mesh();
  for(auto i = size(); i < mesh.number_of_vertices(); ++i) {
    const Vertex_index v(static_cast<Vertex_index::size_type>(i));
    m_sources.emplace_back();
    if(surgery.original_vertex(v).is_valid()) {
      m_sources.back().push_back(surgery.original_vertex(v));
      continue;
    }
    IS::for_each_outgoing_halfedge(v, mesh, [&](IS::Halfedge_index h) {
      const Vertex_index u = surgery.original_vertex(mesh.target(h));
      if(u.is_valid() || mesh.target(h) < v)
        m_sources.back().push_back(u.is_valid() ? u : mesh.target(h));
    });
  }
}

Fine_vertices::Weights Fine_vertices::weights(std::size_t i) const
{
  if(i >= m_size)
    return weights(m_sources[i - m_size].front());
  const Vertex_index v(static_cast<Vertex_index::size_type>(i));
  if(m_split && m_split->is_inserted(v))
    return IT::vertex_weights(m_split->inserted_vertex(v), m_split->input_mesh());
  return {1, {v}, {1}};
}
