// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sphere_mesh.h"

#include "map_mesh.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <limits>
#include <sstream>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

using DCM::Vertex_index;

class Sphere_mesh_builder : Map_mesh_builder
{
public:
  Sphere_mesh_builder(const DCM::Spherical_conformal_map& map, const Mesh& input)
    : Map_mesh_builder(map, input), m_map(map), m_homogeneous(mesh().number_of_vertices())
  {
    if(map.is_disk())
      m_result.texture.dimension = 2;
    for(const Halfedge_index h : mesh().halfedges())
      if(is_front(h))
        m_homogeneous[mesh().target(h).idx()] =
          map.homogeneous_coordinates(subdivision().location(DCM::Layer::C, h));
  }

  Output_mesh build()
  {
    for(const Vertex_index v : vertices())
      add_point(v);
    for(const Face_index f : faces())
      add_polygon(f);
    add_edges();
    add_point_data();
    add_parent_edges("sphere_edge");
    add_parent_faces("sphere_face");
    return std::move(m_result);
  }

private:
  typedef DCM::Spherical_conformal_map Map;

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
    m_result.polygons.push_back(polygon(f));
    if(m_map.is_disk())
      m_result.texture.polygons.push_back(polygon(f));
  }

  void add_point_data()
  {
    std::vector<Attribute>& data = m_result.point_data;
    add_input_vertices();
    data.push_back(attribute("log_scale", vertices(), [&](Vertex_index v) {
      return is_of_input(v) ? m_map.log_scale(v) : 0;
    }));
    const char* const input_names[] = {"input_x", "input_y", "input_z"};
    for(int c = 0; c < 3; ++c)
      data.push_back(
        attribute(input_names[c], vertices(), [&](Vertex_index v) { return input_point(v)[c]; }));
    const char* const names[] = {"homogeneous_x", "homogeneous_y", "homogeneous_z",
                                 "homogeneous_w"};
    for(std::size_t c = 0; c < 4; ++c)
      data.push_back(
        attribute(names[c], vertices(), [&](Vertex_index v) { return m_homogeneous[v.idx()][c]; }));
  }

  const Map& m_map;
  std::vector<std::array<double, 4>> m_homogeneous; // of each vertex
};

} // namespace

Output_mesh sphere_mesh(const DCM::Spherical_conformal_map& map, const Mesh& input)
{
  return Sphere_mesh_builder(map, input).build();
}

std::string precise_positions(const DCM::Spherical_conformal_map& map, const Mesh& input)
{
  typedef DCM::Spherical_conformal_map::Extended Extended;
  const auto decimal = [](const Extended& x) {
    return boost::multiprecision::cpp_bin_float_50(x.high()) + x.low();
  };
  std::ostringstream text;
  text.precision(std::numeric_limits<Extended>::max_digits10);
  for(const Mesh::Vertex_index v : input.vertices()) {
    const auto p = map.precise_position(Vertex_index(v.idx()));
    text << v.idx() << ' ' << decimal(p[0]) << ' ' << decimal(p[1]) << ' ' << decimal(p[2]) << '\n';
  }
  return text.str();
}
