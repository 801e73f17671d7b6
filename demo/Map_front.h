// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_FRONT_H
#define INTRINSIC_MAP_FRONT_H

#include "Input_mesh.h"
#include "Output_mesh.h"

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <string>
#include <vector>

// The common subdivision of the three triangulations of a map, as far as it belongs to the input.
// The vertices of the input come first. Map, input and this must be there as long as attributes
// from here.
class Map_front
{
public:
  typedef CGAL::Discrete_conformal_maps::Discrete_conformal_map Any_map;
  typedef CGAL::Discrete_conformal_maps::Edge_index Edge_index;
  typedef CGAL::Discrete_conformal_maps::Face_index Face_index;
  typedef CGAL::Discrete_conformal_maps::Halfedge_index Halfedge_index;
  typedef CGAL::Discrete_conformal_maps::Vertex_index Vertex_index;

  Map_front(const Any_map& map, const Mesh& input);

  const Any_map::Subdivision& subdivision() const { return m_map.subdivision(); }
  const Any_map::Subdivision::Mesh& mesh() const { return m_map.subdivision().mesh(); }
  const Mesh& input() const { return m_input; }

  // ---- Its elements ----

  const std::vector<Vertex_index>& vertices() const { return m_vertices; }
  const std::vector<Edge_index>& edges() const { return m_edges; }
  const std::vector<Face_index>& faces() const { return m_faces; }

  bool has(Halfedge_index h) const { return m_map.is_front(h); }

  // The second copy of a vertex has a greater number.
  bool is_of_input(Vertex_index v) const { return v.idx() < m_input.number_of_vertices(); }

  // The places of the corners of a face among the vertices.
  std::vector<Polygons::Index> polygon(Face_index f) const;

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

  // The points of its vertices on the input.
  std::vector<Point> input_points() const;

  // Of values at the vertices of the input, linear on its faces, those at these vertices.
  std::vector<double> interpolated(const std::vector<double>& values) const;

  // The weights of the vertices of the input (columns) in those at these vertices (rows).
  Eigen::SparseMatrix<double> interpolation_matrix() const;

  // ---- A mesh of it ----

  // Adds edges, and of each element which ones of the triangulations it is a part of: of a vertex
  // that of the input, of an edge and a face those of all three, of which `last` is the name of the
  // last.
  void add_parents(const std::string& last, Output_mesh& result) const;

private:
  void choose_elements();

  const Any_map& m_map;
  const Mesh& m_input;
  std::vector<Polygons::Index> m_number; // among the vertices, of each one of the subdivision
  std::vector<Vertex_index> m_vertices;
  std::vector<Edge_index> m_edges;
  std::vector<Face_index> m_faces;
};

// Adds the data of the input, interpolated as they are there.
void add_input_data(const Input_mesh& input, const Map_front& front, Output_mesh& mesh);

#endif // INTRINSIC_MAP_FRONT_H
