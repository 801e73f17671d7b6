// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Map_front.h"

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <utility>

using CGAL::Discrete_conformal_maps::Layer;

Point Map_front::input_point(Vertex_index v) const
{
  const auto w = input_weights(v);
  if(w.size == 1)
    return m_input.point(Mesh::Vertex_index(v.idx()));
  Kernel::Vector_3 result = CGAL::NULL_VECTOR;
  for(std::size_t c = 0; c < w.size; ++c)
    result += w.weight[c] * (m_input.point(w.vertex[c]) - CGAL::ORIGIN);
  return CGAL::ORIGIN + result;
}

std::vector<Polygons::Index> Map_front::polygon(Face_index f) const
{
  std::vector<Polygons::Index> result;
  for(const Halfedge_index h : CGAL::halfedges_around_face(mesh().halfedge(f), mesh()))
    result.push_back(number(mesh().target(h)));
  return result;
}

std::vector<Point> Map_front::input_points() const
{
  std::vector<Point> result;
  result.reserve(vertices().size());
  for(const Vertex_index v : vertices())
    result.push_back(input_point(v));
  return result;
}

std::vector<double> Map_front::interpolated(const std::vector<double>& values) const
{
  std::vector<double> result;
  result.reserve(vertices().size());
  for(const Vertex_index v : vertices()) {
    const auto w = input_weights(v);
    double value = 0;
    for(std::size_t c = 0; c < w.size; ++c)
      value += w.weight[c] * values[w.vertex[c]];
    result.push_back(value);
  }
  return result;
}

Eigen::SparseMatrix<double> Map_front::interpolation_matrix() const
{
  std::vector<Eigen::Triplet<double>> entries;
  for(std::size_t row = 0; row < vertices().size(); ++row) {
    const auto w = input_weights(vertices()[row]);
    for(std::size_t c = 0; c < w.size; ++c)
      if(w.weight[c] != 0)
        entries.emplace_back(int(row), int(w.vertex[c].idx()), w.weight[c]);
  }
  Eigen::SparseMatrix<double> result(Eigen::Index(vertices().size()),
                                     Eigen::Index(m_input.number_of_vertices()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

void Map_front::add_parents(const std::string& last, Output_mesh& result) const
{
  result.edges.reserve(edges().size());
  for(const Edge_index e : edges())
    result.edges.push_back({number(mesh().vertex(e, 0)), number(mesh().vertex(e, 1))});
  result.point_data.push_back(
    attribute_on_demand("input_vertex", vertices(),
                        [this](Vertex_index v) { return is_of_input(v) ? number_of(v) : -1; }));
  const std::pair<Layer, std::string> layers[] = {
    {Layer::A, "input"}, {Layer::B, "intrinsic"}, {Layer::C, last}};
  for(const auto& [parent, name] : layers) {
    result.edge_data.push_back(
      attribute_on_demand(name + "_edge", edges(), [this, layer = parent](Edge_index e) {
        return number_of(subdivision().parent_edge(layer, e));
      }));
    result.polygon_data.push_back(
      attribute_on_demand(name + "_face", faces(), [this, layer = parent](Face_index f) {
        return number_of(subdivision().parent_face(layer, f));
      }));
  }
}

void add_input_data(const Input_mesh& input, const Map_front& front, Output_mesh& mesh)
{
  if(input.data.empty())
    return;
  const auto weights = [&](std::size_t i) {
    return input.weights(front.input_weights(front.vertices()[i]));
  };
  const auto triangle = [&](std::size_t i, std::size_t) {
    return input.triangle(
      Map_front::Face_index(front.subdivision().parent_face(Layer::A, front.faces()[i])));
  };
  add_data(mesh, carried(input.data, {front.vertices().size(), mesh.polygons, weights, triangle}));
}
