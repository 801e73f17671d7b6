// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Map_front.h"

#include <CGAL/boost/graph/iterator.h>

#include <utility>

using CGAL::Discrete_conformal_maps::Layer;

Map_front::Map_front(const Any_map& map, const Mesh& input)
  : m_map(map), m_input(input), m_number(mesh().number_of_vertices(), Polygons::none)
{
  choose_elements();
}

void Map_front::choose_elements()
{
  std::vector<char> is_used(mesh().number_of_vertices(), 0);
  for(const Halfedge_index h : mesh().halfedges())
    is_used[mesh().target(h).idx()] |= has(h);
  for(const Vertex_index v : mesh().vertices())
    if(is_used[v.idx()] || is_of_input(v)) {
      m_number[v.idx()] = static_cast<Polygons::Index>(m_vertices.size());
      m_vertices.push_back(v);
    }
  for(const Edge_index e : mesh().edges())
    if(has(mesh().halfedge(e)) || has(mesh().opposite(mesh().halfedge(e))))
      m_edges.push_back(e);
  for(const Face_index f : mesh().faces())
    if(has(mesh().halfedge(f)))
      m_faces.push_back(f);
}

Point Map_front::input_point(Vertex_index v) const
{
  if(is_of_input(v))
    return m_input.point(Mesh::Vertex_index(v.idx()));
  Kernel::Vector_3 result = CGAL::NULL_VECTOR;
  for_each_corner(
    v, [&](Mesh::Vertex_index x, double w) { result += w * (m_input.point(x) - CGAL::ORIGIN); });
  return CGAL::ORIGIN + result;
}

std::vector<Polygons::Index> Map_front::polygon(Face_index f) const
{
  std::vector<Polygons::Index> result;
  for(const Halfedge_index h : CGAL::halfedges_around_face(mesh().halfedge(f), mesh()))
    result.push_back(m_number[mesh().target(h).idx()]);
  return result;
}

CGAL::Intrinsic_triangulations::Vertex_weights<double>
Map_front::input_weights(Vertex_index v) const
{
  if(is_of_input(v))
    return {1, {v}, {1}};
  auto result = CGAL::Intrinsic_triangulations::vertex_weights(subdivision().place(Layer::A, v),
                                                               m_map.Delaunay().input_mesh());
  for(std::size_t c = 0; c < result.size; ++c)
    result.vertex[c] = m_map.input_vertex(result.vertex[c]);
  return result;
}

std::vector<Point> Map_front::input_points() const
{
  std::vector<Point> result;
  result.reserve(m_vertices.size());
  for(const Vertex_index v : m_vertices)
    result.push_back(input_point(v));
  return result;
}

std::vector<double> Map_front::interpolated(const std::vector<double>& values) const
{
  std::vector<double> result;
  result.reserve(m_vertices.size());
  for(const Vertex_index v : m_vertices) {
    double value = 0;
    if(is_of_input(v))
      value = values[v.idx()];
    else
      for_each_corner(v, [&](Mesh::Vertex_index x, double w) { value += w * values[x]; });
    result.push_back(value);
  }
  return result;
}

Eigen::SparseMatrix<double> Map_front::interpolation_matrix() const
{
  std::vector<Eigen::Triplet<double>> entries;
  for(std::size_t row = 0; row < m_vertices.size(); ++row) {
    const auto add = [&](Mesh::Vertex_index v, double weight) {
      if(weight != 0)
        entries.emplace_back(int(row), int(v.idx()), weight);
    };
    const Vertex_index v = m_vertices[row];
    if(is_of_input(v))
      add(Mesh::Vertex_index(v.idx()), 1);
    else
      for_each_corner(v, add);
  }
  Eigen::SparseMatrix<double> result(Eigen::Index(m_vertices.size()),
                                     Eigen::Index(m_input.number_of_vertices()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

void Map_front::add_parents(const std::string& last, Output_mesh& result) const
{
  result.edges.reserve(m_edges.size());
  for(const Edge_index e : m_edges)
    result.edges.push_back(
      {m_number[mesh().vertex(e, 0).idx()], m_number[mesh().vertex(e, 1).idx()]});
  result.point_data.push_back(
    attribute_on_demand("input_vertex", m_vertices,
                        [this](Vertex_index v) { return is_of_input(v) ? number_of(v) : -1; }));
  const std::pair<Layer, std::string> layers[] = {
    {Layer::A, "input"}, {Layer::B, "intrinsic"}, {Layer::C, last}};
  for(const auto& [parent, name] : layers) {
    result.edge_data.push_back(
      attribute_on_demand(name + "_edge", m_edges, [this, layer = parent](Edge_index e) {
        return number_of(subdivision().parent_edge(layer, e));
      }));
    result.polygon_data.push_back(
      attribute_on_demand(name + "_face", m_faces, [this, layer = parent](Face_index f) {
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
    return input.triangle(Face_index(front.subdivision().parent_face(Layer::A, front.faces()[i])));
  };
  add_data(mesh, carried(input.data, {front.vertices().size(), mesh.polygons, weights, triangle}));
}
