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

// Represents the part of the common subdivision of the three triangulations of a map that belongs
// to the input, and its position on the input. The map belongs to the whole input or to a
// component, whose elements are then counted. A copy is cheap. The map, the input and the component
// must outlive it.
class Map_part
{
public:
  typedef CGAL::Discrete_conformal_maps::Input_part Input_part;
  typedef CGAL::Discrete_conformal_maps::Layer Layer;
  typedef CGAL::Discrete_conformal_maps::Edge_index Edge_index;
  typedef CGAL::Discrete_conformal_maps::Face_index Face_index;
  typedef CGAL::Discrete_conformal_maps::Halfedge_index Halfedge_index;
  typedef CGAL::Discrete_conformal_maps::Vertex_index Vertex_index;

  // `component` is null if the map belongs to the whole input.
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

  // Returns the mesh that is mapped.
  const Mesh& mapped_mesh() const { return m_component ? m_component->mesh : *m_input; }

  // ---- The place in the input ----

  // Returns a vertex as a convex combination of vertices of the input.
  Placement::Weights weights(Vertex_index v) const;

  Point input_point(Vertex_index v) const;

  // Returns the points of its vertices on the input.
  std::vector<Point> input_points() const;

  // Returns the value at a vertex of a function on the vertices of the mapped mesh, linear on its
  // faces.
  template <class Function>
  double interpolated(Vertex_index v, const Function& function) const
  {
    const auto w = m_part->input_weights(v);
    double result = 0;
    for(std::size_t c = 0; c < w.size; ++c)
      result += w.weight[c] * function(w.vertex[c]);
    return result;
  }

  // Returns the interpolated values at all vertices, from values at the vertices of the mapped
  // mesh.
  std::vector<double> interpolated(const std::vector<double>& values) const;

  // Returns the matrix of weights of the vertices of the input (columns) for these vertices (rows).
  Eigen::SparseMatrix<double> interpolation_matrix() const;

  // ---- A mesh of it ----

  // Adds edges and polygons, and the elements of the triangulations that contain each element. A
  // vertex has a vertex of the input. An edge or a face has an edge or a face of all three
  // triangulations, and `last` is the name of the last one.
  void add_elements(const char* last, Output_mesh& result) const;

private:
  std::shared_ptr<const Input_part> m_part;
  const Mesh* m_input;
  const Component_mesh* m_component;
};

#endif // INTRINSIC_MAP_PART_H
