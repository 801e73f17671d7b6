// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Fine_level.h"

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

Fine_level::Fine_level(const Mesh& input, const Triangulation* split)
  : m_input(&input),
    m_split(split),
    m_vertices(split ? split->mesh().number_of_vertices() : input.number_of_vertices()),
    m_edges(split ? split->mesh().number_of_edges() : input.number_of_edges()),
    m_faces(split ? split->mesh().number_of_faces() : input.number_of_faces())
{}

// Adds vertices. An apex comes after the vertices around its disk, or their originals.
void Fine_level::add_vertices(const IS::Surface_surgery& surgery)
{
  const IS::Delta_complex& mesh = surgery.mesh();
  for(auto i = m_vertices; i < mesh.number_of_vertices(); ++i) {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(i));
    m_sources.emplace_back();
    if(surgery.original_vertex(v).is_valid()) {
      m_sources.back().push_back(surgery.original_vertex(v));
      continue;
    }
    IS::for_each_outgoing_halfedge(v, mesh, [&](IS::Halfedge_index h) {
      const Mesh::Vertex_index u = surgery.original_vertex(mesh.target(h));
      if(u.is_valid() || mesh.target(h) < v)
        m_sources.back().push_back(u.is_valid() ? u : mesh.target(h));
    });
  }
}

Mesh::Face_index Fine_level::input_face(Mesh::Face_index f) const
{
  if(f.idx() >= m_faces)
    return Mesh::Face_index();
  return m_split ? m_split->input_location(m_split->mesh().halfedge(f)).first : f;
}

Mesh::Edge_index Fine_level::input_edge(Mesh::Edge_index e) const
{
  if(e.idx() >= m_edges || (m_split && !m_split->coordinates().is_shared(e)))
    return Mesh::Edge_index();
  return m_split ? Mesh::Edge_index(m_split->input_outgoing_before(m_split->mesh().halfedge(e)))
                 : e;
}

Placement::Weights Fine_level::weights(std::size_t i) const
{
  if(i >= m_vertices)
    return weights(m_sources[i - m_vertices].front());
  const IT::Vertex_index v(static_cast<Mesh::size_type>(i));
  if(m_split && m_split->is_inserted(v))
    return IT::vertex_weights(m_split->inserted_vertex(v), m_split->input_mesh());
  return {1, {v}, {1}};
}

std::vector<Point> Fine_level::points() const
{
  std::vector<Kernel::Vector_3> vectors;
  for(const Point& p : m_input->points())
    vectors.push_back(p - CGAL::ORIGIN);
  extend(vectors, Kernel::Vector_3(CGAL::NULL_VECTOR));
  std::vector<Point> result;
  for(const Kernel::Vector_3& p : vectors)
    result.push_back(CGAL::ORIGIN + p);
  return result;
}

Triangle_data Fine_level::data(const Input_mesh& input, const Polygons& triangles) const
{
  if(input.data.empty() || is_input())
    return input.data;
  const Placement placement{m_vertices + m_sources.size(),
                            [this](std::size_t i) { return weights(i); },
                            [this](std::size_t i, std::size_t) {
                              return input_face(Mesh::Face_index(static_cast<Mesh::size_type>(i)));
                            }};
  Triangle_data result{data_at(input, triangles, placement), triangles};
  for(Point_function& f : result.functions) {
    f.values.resize(m_vertices);
    extend(f.values, 0.);
  }
  return result;
}
