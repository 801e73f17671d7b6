// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_PART_H
#define INTRINSIC_MAP_PART_H

#include "reading/component_meshes.h"
#include "writing/Output_mesh.h"

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Input_part.h>

#include <Eigen/SparseCore>

#include <cstdint>
#include <memory>
#include <vector>

// The common subdivision of the three triangulations of a map, as far as it belongs to the input,
// and where it is there. The map is of all of the input or of a component, then its elements are
// counted there. A copy is cheap; map, input and component must be there as long as it.
class Map_part
{
public:
  typedef CGAL::Discrete_conformal_maps::Input_part Input_part;
  typedef CGAL::Discrete_conformal_maps::Layer Layer;
  typedef CGAL::Discrete_conformal_maps::Edge_index Edge_index;
  typedef CGAL::Discrete_conformal_maps::Face_index Face_index;
  typedef CGAL::Discrete_conformal_maps::Halfedge_index Halfedge_index;
  typedef CGAL::Discrete_conformal_maps::Vertex_index Vertex_index;

  // `component` is null if the map is of all of the input.
  Map_part(const CGAL::Discrete_conformal_maps::Discrete_conformal_map& map, const Mesh& input,
           const Component_mesh* component = nullptr)
    : m_part(std::make_shared<const Input_part>(map)), m_input(&input), m_component(component)
  {}

  const Input_part& part() const { return *m_part; }
  const auto& map() const { return m_part->map(); }
  const auto& subdivision() const { return m_part->subdivision(); }
  const auto& mesh() const { return m_part->mesh(); }
  const auto& vertices() const { return m_part->vertices(); }
  const auto& edges() const { return m_part->edges(); }
  const auto& faces() const { return m_part->faces(); }
  Input_part::size_type number(Vertex_index v) const { return m_part->number(v); }
  Halfedge_index side_to_first_corner(Face_index f) const { return mesh().halfedge(f); }

  // The mesh that is mapped.
  const Mesh& mapped_mesh() const { return m_component ? m_component->mesh : *m_input; }

  // ---- The place in the input ----

  // A vertex as a convex combination of vertices of the input.
  Placement::Weights weights(Vertex_index v) const;

  Point input_point(Vertex_index v) const;

  // The points of its vertices on the input.
  std::vector<Point> input_points() const;

  // Of a function on the vertices of the mapped mesh, linear on its faces, the value at a vertex.
  template <class Function>
  double interpolated(Vertex_index v, const Function& function) const
  {
    const auto w = m_part->input_weights(v);
    double result = 0;
    for(std::size_t c = 0; c < w.size; ++c)
      result += w.weight[c] * function(w.vertex[c]);
    return result;
  }

  // As before, of values at these vertices, the values at all vertices.
  std::vector<double> interpolated(const std::vector<double>& values) const;

  // The weights of the vertices of the input (columns) in those at these vertices (rows).
  Eigen::SparseMatrix<double> interpolation_matrix() const;

  // ---- A mesh of it ----

  // Adds edges and polygons, and of each element which ones of the triangulations it is a part of:
  // of a vertex that of the input, of an edge and a face those of all three, of which `last` is the
  // name of the last.
  void add_elements(const char* last, Output_mesh& result) const;

private:
  std::shared_ptr<const Input_part> m_part;
  const Mesh* m_input;
  const Component_mesh* m_component;
};

#endif // INTRINSIC_MAP_PART_H
