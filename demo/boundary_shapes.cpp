// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "boundary_shapes.h"

#include "Program_error.h"

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace CM = CGAL::Discrete_conformal_maps;

namespace {

using Vector = Kernel::Vector_3;

double length(Mesh::Halfedge_index h, const Mesh& mesh)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

double angle(const Vector& a, const Vector& b)
{
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
}

// Pi less the angles of faces at a vertex of the boundary.
double exterior_angle(Mesh::Vertex_index v, const Mesh& mesh)
{
  double result = CGAL_PI;
  for(const Mesh::Halfedge_index h : mesh.halfedges_around_target(mesh.halfedge(v)))
    if(!mesh.is_border(h))
      result -= angle(mesh.point(mesh.source(h)) - mesh.point(v),
                      mesh.point(mesh.target(mesh.next(h))) - mesh.point(v));
  return result;
}

Boundary_loop loop_of(Mesh::Halfedge_index border, const Mesh& mesh)
{
  Boundary_loop result;
  for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(border, mesh))
    result.push_back(mesh.target(h));
  return result;
}

// Chooses corners among the vertices of a loop.
class Corner_choice
{
  using Corners = std::vector<std::size_t>; // places on the loop

public:
  Corner_choice(const Mesh& mesh, const Boundary_loop& loop) : m_order(loop.size())
  {
    double place = 0;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const Mesh::Vertex_index v = loop[i], next = loop[(i + 1) % loop.size()];
      m_angle.push_back(exterior_angle(v, mesh));
      m_place.push_back(place);
      place += length(mesh.halfedge(v, next), mesh);
    }
    m_length = place;
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](std::size_t i, std::size_t j) { return m_angle[i] > m_angle[j]; });
  }

  Corners corners() const
  {
    const Corners sharpest = sharpest_at_distance(0);
    const double least = total_angle(sharpest) - std::abs(total_angle(sharpest)) / 10;
    for(double distance = m_length / 4; distance > 1e-3 * m_length; distance *= 0.9)
      if(const Corners c = sharpest_at_distance(distance); c.size() == 4 && total_angle(c) >= least)
        return c;
    return sharpest;
  }

private:
  // Up to four, each as sharp as can be that far from those before.
  Corners sharpest_at_distance(double distance) const
  {
    Corners result;
    for(const std::size_t i : m_order) {
      const bool is_far = std::all_of(result.begin(), result.end(), [&](std::size_t j) {
        return this->distance(i, j) >= distance;
      });
      if(is_far && result.size() < 4)
        result.push_back(i);
    }
    return result;
  }

  double distance(std::size_t i, std::size_t j) const
  {
    const double d = std::abs(m_place[i] - m_place[j]);
    return (std::min)(d, m_length - d);
  }

  double total_angle(const Corners& corners) const
  {
    return std::accumulate(corners.begin(), corners.end(), 0.,
                           [&](double sum, std::size_t i) { return sum + m_angle[i]; });
  }

  double m_length = 0;
  std::vector<double> m_angle, m_place;
  std::vector<std::size_t> m_order; // the sharpest first
};

// The length in the plane of a halfedge of the subdivision, in its face.
double flat_length(CM::Halfedge_index h, const CM::Planar_conformal_map& map)
{
  const auto& subdivision = map.subdivision();
  const auto position = [&](CM::Halfedge_index x) {
    const auto z = map.homogeneous_coordinates(subdivision.location(CM::Layer::C, x));
    return std::complex<double>(z[0], z[1]) / z[2];
  };
  return std::abs(position(h) - position(subdivision.mesh().prev(h)));
}

} // namespace

std::vector<Boundary_loop> single_boundary_loops(const Mesh& mesh, const std::string& path)
{
  Mesh copy = mesh;
  const auto component = copy.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  std::vector<Boundary_loop> result(
    CGAL::Polygon_mesh_processing::connected_components(copy, component));
  std::vector<Mesh::Halfedge_index> borders;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
  const auto fail = [&](const std::string& what) {
    throw Program_error(path + ": a component " + what +
                        ", but this shape is for one boundary loop");
  };
  for(const Mesh::Halfedge_index h : borders) {
    Boundary_loop& loop = result[component[mesh.face(mesh.opposite(h))]];
    if(!loop.empty())
      fail("has several boundary loops");
    loop = loop_of(h, mesh);
  }
  for(const Boundary_loop& loop : result)
    if(loop.empty())
      fail("has no boundary");
  return result;
}

std::array<Mesh::Vertex_index, 4> rectangle_corners(const Mesh& mesh, const Boundary_loop& loop)
{
  std::array<Mesh::Vertex_index, 4> result;
  const std::vector<std::size_t> corners = Corner_choice(mesh, loop).corners();
  std::transform(corners.begin(), corners.end(), result.begin(),
                 [&](std::size_t i) { return loop[i]; });
  return result;
}

// Half the angle under which the centre sees an edge of length l, in a circle with the diameter 1 /
// x, is asin(l x); if the centre is outside, this is pi less that for the longest.
std::vector<double> circle_angles(const std::vector<double>& length)
{
  const std::size_t n = length.size();
  const auto longest =
    static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  const auto half_arcs = [&](double x, bool is_centre_outside) {
    std::vector<double> result(n);
    std::transform(length.begin(), length.end(), result.begin(),
                   [&](double l) { return std::asin((std::min)(l * x, 1.)); });
    if(is_centre_outside)
      result[longest] = CGAL_PI - result[longest];
    return result;
  };
  const auto excess = [&](const std::vector<double>& arcs) {
    return std::accumulate(arcs.begin(), arcs.end(), -CGAL_PI);
  };
  double low = 0, high = 1 / length[longest];
  const bool is_outside = excess(half_arcs(high, false)) < 0;
  for(double x; x = (low + high) / 2, low < x && x < high;)
    ((excess(half_arcs(x, is_outside)) > 0) != is_outside ? high : low) = x;
  const std::vector<double> arcs = half_arcs(high, is_outside);
  std::vector<double> result(n);
  for(std::size_t i = 0; i < n; ++i)
    result[i] = arcs[i] + arcs[(i + n - 1) % n];
  return result;
}

std::vector<double> boundary_lengths(const Mesh& mesh)
{
  std::vector<double> result(mesh.number_of_vertices(), 0);
  for(const Mesh::Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h))
      result[mesh.source(h)] = length(h, mesh);
  return result;
}

std::vector<double> boundary_lengths(const CM::Planar_conformal_map& map)
{
  const auto& subdivision = map.subdivision();
  const auto& input = map.Delaunay().input_mesh();
  std::vector<double> result(input.number_of_vertices(), 0);
  const auto is_front = [&](CM::Halfedge_index h) {
    return map.is_front(subdivision.parent_face(CM::Layer::A, subdivision.mesh().face(h)));
  };
  for(const CM::Halfedge_index h : subdivision.mesh().halfedges()) {
    if(!is_front(h) || is_front(subdivision.mesh().opposite(h)))
      continue;
    CM::Halfedge_index start =
      input.halfedge(subdivision.parent_edge(CM::Layer::A, subdivision.mesh().edge(h)));
    if(map.is_front(input.face(start)))
      start = input.opposite(start); // loops have the surface on their right
    result[input.source(start).idx()] += flat_length(h, map);
  }
  return result;
}
