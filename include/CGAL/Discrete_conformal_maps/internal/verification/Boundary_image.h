// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_BOUNDARY_IMAGE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_BOUNDARY_IMAGE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Boundary_loop.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <complex>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents the image in the plane of the boundary of a surface, and measures its distance from a
// shape.
class Boundary_image
{
public:
  typedef std::complex<double> Point;
  typedef std::vector<Vertex_index> Vertices;

  explicit Boundary_image(const Planar_conformal_map& map)
    : m_position(map.Delaunay().input_mesh().num_vertices()),
      m_crossing(map.Delaunay().input_mesh().num_edges())
  {
    const auto& subdivision = map.subdivision();
    const auto& mesh = subdivision.mesh();
    for(Halfedge_index h : mesh.halfedges()) {
      if(!map.is_original(h) || map.is_original(Intrinsic_triangulations::opposite(h)))
        continue;
      const Point p = map.image(mesh.prev(h));
      if(const Vertex_index v = subdivision.parent_vertex(Layer::A, mesh.source(h)); v.is_valid())
        m_position[v.idx()] = p;
      else
        m_crossing[subdivision.parent_edge(Layer::A, mesh.edge(h)).idx()].push_back(p);
    }
  }

  // Returns the greatest relative difference of the distances of some vertices from the center of
  // the circle that fits them best.
  double radius_error(const Vertices& vertices) const
  {
    const Point center = center_of(vertices);
    double least = std::abs(position(vertices.front()) - center), greatest = least;
    for(Vertex_index v : vertices) {
      const double radius = std::abs(position(v) - center);
      least = greater_error(least, radius) == radius ? least : radius;
      greatest = greater_error(greatest, radius);
    }
    return (greatest - least) / least;
  }

  // Returns the greatest distance of a point of the boundary from the straight line between the
  // ends of a side. The distance is relative to the length of the line. `side` contains the border
  // halfedges.
  double straightness_error(const Boundary_loop& side, const Delta_complex& mesh) const
  {
    const Point start = position(mesh.source(side.front())),
                line = position(mesh.target(side.back())) - start;
    double result = 0;
    const auto add = [&](const Point& p) {
      result = greater_error(result, std::abs(((p - start) / line).imag()));
    };
    for(Halfedge_index h : side) {
      add(position(mesh.source(h)));
      for(const Point& p : m_crossing[mesh.edge(h).idx()])
        add(p);
    }
    return result;
  }

  // Returns the cosine of the angle at `b`.
  double cosine(Vertex_index a, Vertex_index b, Vertex_index c) const
  {
    const Point p = position(a) - position(b), q = position(c) - position(b);
    return std::abs((p * std::conj(q)).real()) / (std::abs(p) * std::abs(q));
  }

private:
  const Point& position(Vertex_index v) const { return m_position[v.idx()]; }

  // Returns the center of the circle that fits vertices best. Points z = x + iy of a circle satisfy
  // |z|^2 = a x + b y + c. Coordinates are relative to the mean of the points.
  Point center_of(const Vertices& vertices) const
  {
    Point mean = 0;
    for(Vertex_index v : vertices)
      mean += position(v) / double(vertices.size());
    double size = 0;
    for(Vertex_index v : vertices)
      size = greater_error(size, std::abs(position(v) - mean));
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right_side = Eigen::Vector3d::Zero();
    for(Vertex_index v : vertices) {
      const Point z = (position(v) - mean) / size;
      const Eigen::Vector3d row(z.real(), z.imag(), 1);
      matrix += row * row.transpose();
      right_side += std::norm(z) * row;
    }
    const Eigen::Vector3d x = matrix.fullPivLu().solve(right_side);
    return mean + size * Point(x[0], x[1]) / 2.;
  }

  std::vector<Point> m_position;              // of the vertices on the boundary
  std::vector<std::vector<Point>> m_crossing; // crossings of edges of T_2 and T_3 with an edge
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_BOUNDARY_IMAGE_H
