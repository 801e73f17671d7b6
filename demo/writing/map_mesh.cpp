// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/map_mesh.h"

#include "writing/subdivision_elements.h"

#include <CGAL/Discrete_conformal_maps/hyperbolic_texture_points.h>
#include <CGAL/Discrete_conformal_maps/sphere_points.h>
#include <CGAL/Discrete_conformal_maps/texture_points.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

using DCM::Edge_index;
using DCM::Face_index;
using DCM::Halfedge_index;
using DCM::Vertex_index;

template <class Map>
Corner_data texture(const Map& map, const Map_part& part, bool is_homogeneous)
{
  const DCM::Texture_corners corners(map, part.part());
  Corner_data result;
  result.dimension = is_homogeneous ? 3 : 2;
  for(const Face_index f : part.faces()) {
    for(const Halfedge_index h :
        CGAL::halfedges_around_face(part.side_to_first_corner(f), part.mesh()))
      result.polygons.add_corner(corners.index(h));
    result.polygons.close();
  }
  if(is_homogeneous)
    result.coordinates = DCM::homogeneous_texture_points(map, part.part(), corners).points;
  else
    for(const auto& p : DCM::texture_points(map, part.part(), corners).points)
      result.coordinates.push_back({p[0], p[1], 1});
  return result;
}

template <class Map>
Output_mesh with_texture(const Map& map, const Map_part& part, const Cones& cones,
                         bool is_homogeneous)
{
  Output_mesh result;
  result.points = part.input_points();
  part.add_elements("flat", result);
  result.texture = texture(map, part, is_homogeneous);
  std::vector<std::int64_t> is_cone(part.vertices().size(), 0);
  for(const Mesh::Vertex_index v : cones)
    is_cone[v] = 1;
  result.point_data.push_back({"is_cone", std::move(is_cone)});
  add_attribute(result.point_data, "log_scale", part, &Map_part::vertices, [=, &map](auto v) {
    return part.interpolated(v, [&](Vertex_index u) { return map.log_scale(u); });
  });
  add_attribute(result.edge_data, "is_seam", part, &Map_part::edges, [=, &map](Edge_index e) {
    return std::int64_t(DCM::is_seam(map, part.part(), e));
  });
  return result;
}

} // namespace

Output_mesh flat_mesh(const Planar_map& map, const Map_part& part, const Cones& cones,
                      bool is_homogeneous)
{
  return with_texture(map, part, cones, is_homogeneous);
}

Output_mesh flat_mesh(const Hyperbolic_map& map, const Map_part& part, const Cones& cones,
                      bool is_homogeneous)
{
  return with_texture(map, part, cones, is_homogeneous);
}

Output_mesh sphere_mesh(const Spherical_map& map, const Map_part& part)
{
  const auto homogeneous = std::make_shared<const std::vector<std::array<double, 4>>>(
    DCM::homogeneous_coordinates(map, part.part()));
  const auto points = DCM::sphere_points(map, part.part(), *homogeneous).points;
  Output_mesh result;
  for(const auto& p : points)
    result.points.emplace_back(p[0], p[1], p[2]);
  part.add_elements("sphere", result);
  if(map.is_disk()) {
    result.texture.dimension = 2;
    for(const auto& p : DCM::disk_points(part.part(), points).points)
      result.texture.coordinates.push_back({p[0], p[1], 1});
    result.texture.polygons = result.polygons;
  }
  const auto add = [&](const std::string& name, const auto& value) {
    add_attribute(result.point_data, name, part, &Map_part::vertices, value);
  };
  add("log_scale",
      [=, &map](Vertex_index v) { return part.part().is_of_input(v) ? map.log_scale(v) : 0; });
  for(int c = 0; c < 3; ++c)
    add(std::string("input_") + "xyz"[c], [=](Vertex_index v) { return part.input_point(v)[c]; });
  for(std::size_t c = 0; c < 4; ++c)
    add(std::string("homogeneous_") + "xyzw"[c],
        [=](Vertex_index v) { return (*homogeneous)[part.number(v)][c]; });
  return result;
}
