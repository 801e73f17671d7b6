// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/sphere_mesh.h"

#include <CGAL/Discrete_conformal_maps/common_subdivision_mesh.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <limits>
#include <memory>
#include <sstream>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

using DCM::Vertex_index;

class Sphere_mesh_builder
{
  typedef DCM::Spherical_conformal_map Map;

public:
  Sphere_mesh_builder(const Map& map, const Map_front& front)
    : m_map(map),
      m_front(front),
      m_homogeneous(std::make_shared<const std::vector<std::array<double, 4>>>(
        DCM::homogeneous_coordinates(map, front)))
  {
    if(map.is_disk())
      m_result.texture.dimension = 2;
  }

  Output_mesh build()
  {
    m_result.points.reserve(m_front.vertices().size());
    for(const Vertex_index v : m_front.vertices())
      add_point(v);
    for(const Map_front::Face_index f : m_front.faces())
      add_polygon(f);
    m_front.add_parents("sphere", m_result);
    add_point_data();
    return std::move(m_result);
  }

private:
  void add_point(Vertex_index v)
  {
    const auto p =
      m_front.is_of_input(v) ? m_map.position(v) : m_map.image((*m_homogeneous)[m_front.number(v)]);
    m_result.points.emplace_back(p[0], p[1], p[2]);
    if(m_map.is_disk()) {
      const auto z = Map::to_plane(p);
      m_result.texture.coordinates.push_back({z.real(), z.imag(), 1});
    }
  }

  void add_polygon(Map_front::Face_index f)
  {
    m_result.polygons.push_back(m_front.polygon(f));
    if(m_map.is_disk())
      m_result.texture.polygons.push_back(m_front.polygon(f));
  }

  void add_point_data()
  {
    std::vector<Attribute>& data = m_result.point_data;
    const auto scale = [&map = m_map, &front = m_front](Vertex_index v) {
      return front.is_of_input(v) ? map.log_scale(v) : 0;
    };
    data.push_back(attribute_on_demand("log_scale", m_front.vertices(), scale));
    const char* const input_names[] = {"input_x", "input_y", "input_z"};
    for(int c = 0; c < 3; ++c)
      data.push_back(attribute_on_demand(
        input_names[c], m_front.vertices(),
        [&front = m_front, c](Vertex_index v) { return front.input_point(v)[c]; }));
    const char* const names[] = {"homogeneous_x", "homogeneous_y", "homogeneous_z",
                                 "homogeneous_w"};
    for(std::size_t c = 0; c < 4; ++c)
      data.push_back(
        attribute_on_demand(names[c], m_front.vertices(),
                            [homogeneous = m_homogeneous, &front = m_front, c](Vertex_index v) {
                              return (*homogeneous)[front.number(v)][c];
                            }));
  }

  const Map& m_map;
  const Map_front& m_front;
  std::shared_ptr<const std::vector<std::array<double, 4>>> m_homogeneous; // of each vertex
  Output_mesh m_result;
};

} // namespace

Output_mesh sphere_mesh(const DCM::Spherical_conformal_map& map, const Map_front& front)
{
  return Sphere_mesh_builder(map, front).build();
}

std::string precise_position(const DCM::Spherical_conformal_map& map, Mesh::Vertex_index v)
{
  // Digits that are computed are more than those that are written, all of which hold.
  typedef boost::multiprecision::cpp_bin_float_50 Number;
  std::ostringstream text;
  text.precision(std::numeric_limits<DCM::Spherical_conformal_map::Extended>::digits10);
  const auto p = map.position_in<Number>(Vertex_index(v.idx()));
  text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  return text.str();
}

std::string precise_positions(const DCM::Spherical_conformal_map& map, const Mesh& input)
{
  std::string result;
  for(const Mesh::Vertex_index v : input.vertices())
    result += std::to_string(v.idx()) + ' ' + precise_position(map, v);
  return result;
}
