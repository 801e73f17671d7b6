// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_FRONT_H
#define INTRINSIC_MAP_FRONT_H

#include "reading/Input_mesh.h"
#include "writing/Output_mesh.h"

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Input_part.h>

#include <Eigen/SparseCore>

#include <string>
#include <vector>

// The common subdivision of the three triangulations of a map, as far as it belongs to the input,
// with the points of the input. Map, input and this must be there as long as attributes from here.
class Map_front : public CGAL::Discrete_conformal_maps::Input_part
{
public:
  typedef CGAL::Discrete_conformal_maps::Edge_index Edge_index;
  typedef CGAL::Discrete_conformal_maps::Face_index Face_index;
  typedef CGAL::Discrete_conformal_maps::Halfedge_index Halfedge_index;
  typedef CGAL::Discrete_conformal_maps::Vertex_index Vertex_index;

  Map_front(const CGAL::Discrete_conformal_maps::Discrete_conformal_map& map, const ::Mesh& input)
    : Input_part(map), m_input(input)
  {}

  const ::Mesh& input() const { return m_input; }

  // The places of the corners of a face among the vertices.
  std::vector<Polygons::Index> polygon(Face_index f) const;

  // ---- The place in the input ----

  Point input_point(Vertex_index v) const;

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
  const ::Mesh& m_input;
};

// Adds the data of the input, interpolated as they are there.
void add_input_data(const Input_mesh& input, const Map_front& front, Output_mesh& mesh);

#endif // INTRINSIC_MAP_FRONT_H
