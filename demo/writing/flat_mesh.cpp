// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/flat_mesh.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

using DCM::Edge_index;
using DCM::Face_index;
using DCM::Halfedge_index;
using DCM::Layer;
using DCM::Vertex_index;

std::complex<double> position(const DCM::Planar_conformal_map&, const std::array<double, 3>& z)
{
  return {z[0] / z[2], z[1] / z[2]};
}

std::complex<double> position(const DCM::Hyperbolic_conformal_map& map,
                              const std::array<double, 3>& z)
{
  return map.to_disk(z);
}

template <class Map>
class Flat_mesh_builder
{
public:
  Flat_mesh_builder(const Map& map, const Map_front& front, bool is_homogeneous)
    : m_map(map), m_front(front)
  {
    m_result.texture.dimension = is_homogeneous ? 3 : 2;
  }

  Output_mesh build(const std::vector<Mesh::Vertex_index>& cones)
  {
    add_polygons();
    m_result.points = m_front.input_points();
    m_front.add_parents("flat", m_result);
    add_point_data(cones);
    m_result.edge_data.push_back(attribute_on_demand(
      "is_seam", m_front.edges(), [&map = m_map, &front = m_front](Edge_index e) {
        return std::int64_t(DCM::is_seam(map, front, e));
      }));
    return std::move(m_result);
  }

private:
  const Map_front::Mesh& mesh() const { return m_front.mesh(); }

  // ---- Points ----

  void add_point_data(const std::vector<Mesh::Vertex_index>& cones)
  {
    std::vector<char> is_cone(mesh().number_of_vertices(), 0);
    for(const Mesh::Vertex_index v : cones)
      is_cone[v] = 1;
    m_result.point_data.push_back(attribute("is_cone", m_front.vertices(), [&](Vertex_index v) {
      return std::int64_t(is_cone[v.idx()]);
    }));
    std::vector<double> scale;
    for(const Mesh::Vertex_index v : m_front.input().vertices())
      scale.push_back(m_map.log_scale(Vertex_index(v.idx())));
    m_result.point_data.push_back({"log_scale", m_front.interpolated(scale)});
  }

  // ---- Polygons ----

  void add_polygons()
  {
    const DCM::Texture_corners corners(m_map, m_front);
    Corner_data& texture = m_result.texture;
    for(const Face_index f : m_front.faces()) {
      m_result.polygons.push_back(m_front.polygon(f));
      for(const Halfedge_index h : CGAL::halfedges_around_face(mesh().halfedge(f), mesh()))
        texture.polygons.add_corner(corners.index(h));
      texture.polygons.close();
    }
    for(std::size_t n = 0; n < corners.size(); ++n)
      texture.coordinates.push_back(
        coordinates(m_front.subdivision().location(Layer::C, corners.halfedge(n))));
  }

  std::array<double, 3> coordinates(const DCM::Discrete_conformal_map::Face_location& on_C) const
  {
    const std::array<double, 3> z = m_map.homogeneous_coordinates(on_C);
    if(m_result.texture.dimension == 3)
      return z;
    const std::complex<double> p = position(m_map, z);
    return {p.real(), p.imag(), 1};
  }

  const Map& m_map;
  const Map_front& m_front;
  Output_mesh m_result;
};

// Whether the height of the triangle is more than rounding of the coordinates of its points.
bool has_area(const Point& p, const Point& q, const Point& r)
{
  const double longest = std::sqrt((std::max)(
    {CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)}));
  double greatest = 0;
  for(const Point& x : {p, q, r})
    for(int i = 0; i < 3; ++i)
      greatest = (std::max)(greatest, std::abs(x[i]));
  // each of three points may be wrong by some roundings
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * greatest;
  return 2 * std::sqrt(CGAL::squared_area(p, q, r)) > rounding * longest;
}

// Calls `visit` with each polygon, the orientation in the plane of each triangle into which it is
// cut, and whether the triangle has area in space beyond rounding.
template <class Visit>
void for_each_triangle(const Output_mesh& mesh, const Visit& visit)
{
  const auto place = [&](std::size_t c) {
    const std::array<double, 3>& z = mesh.texture.coordinates[c];
    return Kernel::Point_2(z[0] / z[2], z[1] / z[2]);
  };
  for(std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const Polygons::Polygon p = mesh.polygons[i], t = mesh.texture.polygons[i];
    for(std::size_t k = 2; k < p.size(); ++k)
      visit(i, CGAL::orientation(place(t[0]), place(t[k - 1]), place(t[k])),
            has_area(mesh.points[p[0]], mesh.points[p[k - 1]], mesh.points[p[k]]));
  }
}

} // namespace

Output_mesh flat_mesh(const DCM::Planar_conformal_map& map, const Map_front& front,
                      const std::vector<Mesh::Vertex_index>& cones, bool is_homogeneous)
{
  return Flat_mesh_builder(map, front, is_homogeneous).build(cones);
}

Output_mesh flat_mesh(const DCM::Hyperbolic_conformal_map& map, const Map_front& front,
                      const std::vector<Mesh::Vertex_index>& cones, bool is_homogeneous)
{
  return Flat_mesh_builder(map, front, is_homogeneous).build(cones);
}

std::vector<std::int64_t> flipped_polygons(const Output_mesh& mesh)
{
  std::vector<std::int64_t> result;
  for_each_triangle(mesh, [&](std::size_t i, CGAL::Orientation turn, bool has_area) {
    const auto polygon = static_cast<std::int64_t>(i);
    if(has_area && turn == CGAL::RIGHT_TURN && (result.empty() || result.back() != polygon))
      result.push_back(polygon);
  });
  return result;
}

void describe_triangles(Statistics& statistics, const Output_mesh& mesh)
{
  std::size_t flipped = 0, degenerate = 0, slivers = 0;
  for_each_triangle(mesh, [&](std::size_t, CGAL::Orientation turn, bool has_area) {
    flipped += has_area && turn == CGAL::RIGHT_TURN;
    degenerate += has_area && turn == CGAL::COLLINEAR;
    slivers += !has_area && turn != CGAL::LEFT_TURN;
  });
  statistics["flipped_triangles"] = flipped;
  statistics["degenerate_triangles"] = degenerate;
  statistics["flipped_slivers"] = slivers;
}
