// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map_mesh.h"

#include <CGAL/boost/graph/iterator.h>

#include <utility>

using CGAL::Discrete_conformal_maps::Layer;

Map_mesh_builder::Map_mesh_builder(const Any_map& map, const Mesh& input)
  : m_map(map), m_input(input), m_number(mesh().number_of_vertices(), Polygons::none)
{
  choose_elements();
}

bool Map_mesh_builder::is_front(Halfedge_index h) const { return m_map.is_front(h); }

void Map_mesh_builder::choose_elements()
{
  std::vector<char> is_used(mesh().number_of_vertices(), 0);
  for(const Halfedge_index h : mesh().halfedges())
    is_used[mesh().target(h).idx()] |= is_front(h);
  for(const Vertex_index v : mesh().vertices())
    if(is_used[v.idx()] || is_of_input(v)) {
      m_number[v.idx()] = static_cast<Polygons::Index>(m_vertices.size());
      m_vertices.push_back(v);
    }
  for(const Edge_index e : mesh().edges())
    if(is_front(mesh().halfedge(e)) || is_front(mesh().opposite(mesh().halfedge(e))))
      m_edges.push_back(e);
  for(const Face_index f : mesh().faces())
    if(is_front(mesh().halfedge(f)))
      m_faces.push_back(f);
}

Point Map_mesh_builder::input_point(Vertex_index v) const
{
  if(is_of_input(v))
    return m_input.point(Mesh::Vertex_index(v.idx()));
  Kernel::Vector_3 result = CGAL::NULL_VECTOR;
  for_each_corner(
    v, [&](Mesh::Vertex_index x, double w) { result += w * (m_input.point(x) - CGAL::ORIGIN); });
  return CGAL::ORIGIN + result;
}

std::vector<Polygons::Index> Map_mesh_builder::polygon(Face_index f) const
{
  std::vector<Polygons::Index> result;
  for(const Halfedge_index h : CGAL::halfedges_around_face(mesh().halfedge(f), mesh()))
    result.push_back(m_number[mesh().target(h).idx()]);
  return result;
}

void Map_mesh_builder::add_edges()
{
  for(const Edge_index e : m_edges)
    m_result.edges.push_back(
      {m_number[mesh().vertex(e, 0).idx()], m_number[mesh().vertex(e, 1).idx()]});
}

void Map_mesh_builder::add_input_vertices()
{
  m_result.point_data.push_back(attribute("input_vertex", m_vertices, [&](Vertex_index v) {
    return is_of_input(v) ? number_of(v) : -1;
  }));
}

void Map_mesh_builder::add_parent_edges(const std::string& name)
{
  const std::pair<std::string, Layer> parents[] = {
    {"input_edge", Layer::A}, {"intrinsic_edge", Layer::B}, {name, Layer::C}};
  for(const auto& [attribute_name, layer] : parents)
    m_result.edge_data.push_back(
      attribute(attribute_name.c_str(), m_edges, [&, layer = layer](Edge_index e) {
        return number_of(subdivision().parent_edge(layer, e));
      }));
}

void Map_mesh_builder::add_parent_faces(const std::string& name)
{
  const std::pair<std::string, Layer> parents[] = {
    {"input_face", Layer::A}, {"intrinsic_face", Layer::B}, {name, Layer::C}};
  for(const auto& [attribute_name, layer] : parents)
    m_result.polygon_data.push_back(
      attribute(attribute_name.c_str(), m_faces, [&, layer = layer](Face_index f) {
        return number_of(subdivision().parent_face(layer, f));
      }));
}

// The second copies of vertices and edges are taken to the first.
CGAL::Intrinsic_triangulations::Vertex_weights<double>
Map_mesh_builder::input_weights(Vertex_index v) const
{
  if(is_of_input(v))
    return {1, {v}, {1}};
  auto result = CGAL::Intrinsic_triangulations::vertex_weights(subdivision().place(Layer::A, v),
                                                               m_map.Delaunay().input_mesh());
  for(std::size_t c = 0; c < result.size; ++c)
    result.vertex[c] = m_map.input_vertex(result.vertex[c]);
  return result;
}

namespace {

class Interpolation : Map_mesh_builder
{
public:
  Interpolation(const Any_map& map, const Mesh& input) : Map_mesh_builder(map, input) {}

  std::vector<Point> points() const
  {
    std::vector<Point> result;
    for(const Vertex_index v : vertices())
      result.push_back(input_point(v));
    return result;
  }

  std::vector<double> operator()(const std::vector<double>& values) const
  {
    std::vector<double> result;
    for(const Vertex_index v : vertices()) {
      double value = 0;
      if(is_of_input(v))
        value = values[v.idx()];
      else
        for_each_corner(v, [&](Mesh::Vertex_index x, double w) { value += w * values[x]; });
      result.push_back(value);
    }
    return result;
  }

  Mesh_data operator()(const Input_mesh& input, const Polygons& polygons) const
  {
    return carried(input.data,
                   {vertices().size(), polygons,
                    [&](std::size_t i) { return input.weights(input_weights(vertices()[i])); },
                    [&](std::size_t i, std::size_t) {
                      return input.triangle(
                        Face_index(subdivision().parent_face(Layer::A, faces()[i])));
                    }});
  }
};

} // namespace

std::vector<double> interpolated(const CGAL::Discrete_conformal_maps::Discrete_conformal_map& map,
                                 const Mesh& input, const std::vector<double>& values)
{
  return Interpolation(map, input)(values);
}

std::vector<Point> input_points(const CGAL::Discrete_conformal_maps::Discrete_conformal_map& map,
                                const Mesh& input)
{
  return Interpolation(map, input).points();
}

void add_input_data(const Input_mesh& input,
                    const CGAL::Discrete_conformal_maps::Discrete_conformal_map& map,
                    Output_mesh& mesh)
{
  if(!input.data.empty())
    add_data(mesh, Interpolation(map, input.mesh)(input, mesh.polygons));
}
