// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_MESH_H
#define INTRINSIC_MAP_MESH_H

#include "Input_mesh.h"
#include "Output_mesh.h"

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>

#include <cstddef>
#include <string>
#include <vector>

// The common subdivision of the three triangulations of a map, as far as it belongs to the input.
// The vertices of the input come first. This is what the meshes of all kinds of maps have in
// common.
class Map_mesh_builder
{
protected:
  typedef CGAL::Discrete_conformal_maps::Discrete_conformal_map Any_map;
  typedef CGAL::Discrete_conformal_maps::Edge_index Edge_index;
  typedef CGAL::Discrete_conformal_maps::Face_index Face_index;
  typedef CGAL::Discrete_conformal_maps::Halfedge_index Halfedge_index;
  typedef CGAL::Discrete_conformal_maps::Vertex_index Vertex_index;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Map_mesh_builder(const Any_map& map, const Mesh& input);

  const Any_map::Subdivision& subdivision() const { return m_map.subdivision(); }
  const Any_map::Subdivision::Mesh& mesh() const { return m_map.subdivision().mesh(); }
  const Mesh& input() const { return m_input; }

  // ---- The part that belongs to the input ----

  const std::vector<Vertex_index>& vertices() const { return m_vertices; }
  const std::vector<Edge_index>& edges() const { return m_edges; }
  const std::vector<Face_index>& faces() const { return m_faces; }

  bool is_front(Halfedge_index h) const;

  // The second copy of a vertex has a greater number.
  bool is_of_input(Vertex_index v) const { return v.idx() < m_input.number_of_vertices(); }

  // ---- The place in the input ----

  // Calls `function` with the vertices of the face of the input in which `v` is, and their weights.
  template <class Function>
  void for_each_corner(Vertex_index v, const Function& function) const
  {
    using CGAL::Discrete_conformal_maps::Layer;
    const auto [face, weight] = subdivision().place(Layer::A, v).location;
    const auto& a = m_map.Delaunay().input_mesh();
    Halfedge_index h = a.halfedge(face);
    for(const double w : weight) {
      const Vertex_index corner = m_map.input_vertex(a.source(h));
      function(Mesh::Vertex_index(corner.idx()), w);
      h = a.next(h);
    }
  }

  Point input_point(Vertex_index v) const;
  CGAL::Intrinsic_triangulations::Vertex_weights<double> input_weights(Vertex_index v) const;

  // ---- The result ----

  std::vector<Polygons::Index> polygon(Face_index f) const;
  void add_edges();
  void add_input_vertices();
  // `name` is that of the last triangulation
  void add_parent_edges(const std::string& name);
  void add_parent_faces(const std::string& name);

  Output_mesh m_result;

private:
  void choose_elements();

  const Any_map& m_map;
  const Mesh& m_input;
  std::vector<Polygons::Index> m_number; // in the result, of each vertex
  std::vector<Vertex_index> m_vertices;
  std::vector<Edge_index> m_edges;
  std::vector<Face_index> m_faces;
};

// Where the vertices of the mesh of a map are in the input.
std::vector<Point> input_points(const CGAL::Discrete_conformal_maps::Discrete_conformal_map& map,
                                const Mesh& input);

// The values at the vertices of the mesh of a map of a function that is linear on the faces of the
// input.
std::vector<double> interpolated(const CGAL::Discrete_conformal_maps::Discrete_conformal_map& map,
                                 const Mesh& input, const std::vector<double>& values);

// Adds the data of the input to the mesh of a map.
void add_input_data(const Input_mesh& input,
                    const CGAL::Discrete_conformal_maps::Discrete_conformal_map& map,
                    Output_mesh& mesh);

#endif // INTRINSIC_MAP_MESH_H
