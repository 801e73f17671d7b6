// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sphere_mesh.h"

#include <CGAL/boost/graph/iterator.h>

#include <limits>
#include <sstream>

namespace CM = CGAL::Discrete_conformal_maps;

namespace {

using CM::Edge_index;
using CM::Face_index;
using CM::Halfedge_index;
using CM::Layer;
using CM::Vertex_index;

class Sphere_mesh_builder
{
public:
  Sphere_mesh_builder(const CM::Spherical_conformal_map& map, const Mesh& input)
    : m_map(map),
      m_subdivision(map.subdivision()),
      m_mesh(m_subdivision.mesh()),
      m_input(input),
      m_number(m_mesh.number_of_vertices(), none),
      m_homogeneous(m_mesh.number_of_vertices())
  {
    if(map.is_disk())
      m_result.texture.dimension = 2;
  }

  Output_mesh build()
  {
    choose_elements();
    for(const Vertex_index v : m_vertices)
      add_point(v);
    for(const Face_index f : m_faces)
      add_polygon(f);
    for(const Edge_index e : m_edges)
      m_result.edges.push_back(
        {m_number[m_mesh.vertex(e, 0).idx()], m_number[m_mesh.vertex(e, 1).idx()]});
    add_point_data();
    add_parents();
    return std::move(m_result);
  }

private:
  typedef CM::Spherical_conformal_map Map;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  bool is_front(Halfedge_index h) const
  {
    return m_map.is_front(m_subdivision.parent_face(Layer::A, m_mesh.face(h)));
  }

  void choose_elements()
  {
    for(const Halfedge_index h : m_mesh.halfedges())
      if(is_front(h))
        m_homogeneous[m_mesh.target(h).idx()] =
          m_map.homogeneous_coordinates(m_subdivision.place_on_C(h));
    for(const Vertex_index v : m_mesh.vertices())
      if(m_homogeneous[v.idx()][3] > 0) {
        m_number[v.idx()] = m_vertices.size();
        m_vertices.push_back(v);
      }
    for(const Edge_index e : m_mesh.edges())
      if(is_front(m_mesh.halfedge(e)) || is_front(m_mesh.opposite(m_mesh.halfedge(e))))
        m_edges.push_back(e);
    for(const Face_index f : m_mesh.faces())
      if(is_front(m_mesh.halfedge(f)))
        m_faces.push_back(f);
  }

  bool is_of_input(Vertex_index v) const { return v.idx() < m_input.number_of_vertices(); }

  void add_point(Vertex_index v)
  {
    const auto p = is_of_input(v) ? m_map.position(v) : Map::project(m_homogeneous[v.idx()]);
    m_result.points.emplace_back(p[0], p[1], p[2]);
    if(m_map.is_disk()) {
      const auto z = Map::to_plane(p);
      m_result.texture.coordinates.push_back({z.real(), z.imag(), 1});
    }
  }

  void add_polygon(Face_index f)
  {
    m_result.polygons.emplace_back();
    for(const Halfedge_index h : CGAL::halfedges_around_face(m_mesh.halfedge(f), m_mesh))
      m_result.polygons.back().push_back(m_number[m_mesh.target(h).idx()]);
    if(m_map.is_disk())
      m_result.texture.polygons.push_back(m_result.polygons.back());
  }

  Point input_point(Vertex_index v) const
  {
    if(is_of_input(v))
      return m_input.point(Mesh::Vertex_index(v.idx()));
    const auto& [face, weight] = m_subdivision.place_on_A(v);
    const auto& a = m_map.Delaunay().input_mesh();
    Kernel::Vector_3 result = CGAL::NULL_VECTOR;
    Halfedge_index h = a.halfedge(face);
    for(const double w : weight) {
      const Mesh::Vertex_index corner(m_map.input_vertex(a.source(h)).idx());
      result += w * (m_input.point(corner) - CGAL::ORIGIN);
      h = a.next(h);
    }
    return CGAL::ORIGIN + result;
  }

  void add_point_data()
  {
    std::vector<Attribute>& data = m_result.point_data;
    data.push_back(attribute("input_vertex", m_vertices,
                             [&](Vertex_index v) { return is_of_input(v) ? number_of(v) : -1; }));
    data.push_back(attribute("log_scale", m_vertices, [&](Vertex_index v) {
      return is_of_input(v) ? m_map.log_scale(v) : 0;
    }));
    const char* const input_names[] = {"input_x", "input_y", "input_z"};
    for(int c = 0; c < 3; ++c)
      data.push_back(
        attribute(input_names[c], m_vertices, [&](Vertex_index v) { return input_point(v)[c]; }));
    const char* const names[] = {"homogeneous_x", "homogeneous_y", "homogeneous_z",
                                 "homogeneous_w"};
    for(std::size_t c = 0; c < 4; ++c)
      data.push_back(
        attribute(names[c], m_vertices, [&](Vertex_index v) { return m_homogeneous[v.idx()][c]; }));
  }

  void add_parents()
  {
    const auto number = [](auto parent) { return number_of(parent); };
    for(const auto& [name, layer] : {std::pair("input_edge", Layer::A),
                                     {"intrinsic_edge", Layer::B},
                                     {"sphere_edge", Layer::C}})
      m_result.edge_data.push_back(attribute(name, m_edges, [&, layer = layer](Edge_index e) {
        return number(m_subdivision.parent_edge(layer, e));
      }));
    for(const auto& [name, layer] : {std::pair("input_face", Layer::A),
                                     {"intrinsic_face", Layer::B},
                                     {"sphere_face", Layer::C}})
      m_result.polygon_data.push_back(attribute(name, m_faces, [&, layer = layer](Face_index f) {
        return number(m_subdivision.parent_face(layer, f));
      }));
  }

  const Map& m_map;
  const Map::Subdivision& m_subdivision;
  const Map::Subdivision::Mesh& m_mesh;
  const Mesh& m_input;
  std::vector<std::size_t> m_number;                // in the result, of each vertex
  std::vector<std::array<double, 4>> m_homogeneous; // of each vertex; zero if it is not wanted
  std::vector<Vertex_index> m_vertices;
  std::vector<Edge_index> m_edges;
  std::vector<Face_index> m_faces;
  Output_mesh m_result;
};

} // namespace

Output_mesh sphere_mesh(const CM::Spherical_conformal_map& map, const Mesh& input)
{
  return Sphere_mesh_builder(map, input).build();
}

std::string precise_positions(const CM::Spherical_conformal_map& map, const Mesh& input)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<CM::Spherical_conformal_map::Extended>::max_digits10);
  for(const Mesh::Vertex_index v : input.vertices()) {
    const auto p = map.precise_position(Vertex_index(v.idx()));
    text << v.idx() << ' ' << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  return text.str();
}
