// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Fine_level.h"

Fine_level::Fine_level(const Mesh& input, const Triangulation* split)
  : m_input(&input),
    m_split(split),
    m_vertices(input.number_of_vertices(), split),
    m_edges(split ? split->mesh().number_of_edges() : input.number_of_edges()),
    m_faces(split ? split->mesh().number_of_faces() : input.number_of_faces())
{}

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

Triangle_data Fine_level::data(const Input_mesh& input, const Polygons& triangles) const
{
  if(input.data.empty() || is_input())
    return input.data;
  const Placement placement{m_vertices.size(),
                            [this](std::size_t i) { return m_vertices.weights(i); },
                            [this](std::size_t i, std::size_t) {
                              return input_face(Mesh::Face_index(static_cast<Mesh::size_type>(i)));
                            }};
  Triangle_data result{data_at(input, triangles, placement), triangles};
  for(Point_function& f : result.functions) {
    f.values.resize(m_vertices.number_before_surgery());
    extend(f.values, 0.);
  }
  return result;
}
