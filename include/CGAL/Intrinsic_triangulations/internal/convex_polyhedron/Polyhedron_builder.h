// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_POLYHEDRON_BUILDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_POLYHEDRON_BUILDER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Convex_positions.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Curvature_path.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Curved_vertices.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/lay_out_pyramids.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds the positions of the vertices of a convex polyhedron with the surface of a triangulation.
// It makes the edges of T2 straight lines on it.
template <typename Traits>
class Polyhedron_builder
{
public:
  typedef Polyhedron_kernel::Point_3 Point;

  Polyhedron_builder(Intrinsic_triangulation<Traits>& tri, std::optional<double> tolerance)
    : m_tri(tri)
  {
    check_sphere(tri.input_mesh());
    make_Delaunay(tri);
    Curved_vertices curved = curved_vertices(tri, tolerance);
    m_flat_vertices = std::move(curved.flat_vertices);
    Curvature_path path(curved.surface);
    path.follow_to(t_at_end);
    if(!(path.t() <= greatest_t_at_end))
      throw Numerical_error("the curvature inside of the polyhedron stays at " +
                            std::to_string(path.t()) + " of its first value");
    m_last_t = path.t();
    m_newton_steps = path.newton_steps();
    build(path, curved.vertices, is_flat(path.surface(), path.radii(), m_last_t));
    if(!m_is_flat && !is_accurate())
      try_polygon(path, curved.vertices);
  }

  const std::vector<Point>& points() const { return m_points; }
  const std::vector<Vertex_index>& flat_vertices() const { return m_flat_vertices; }
  const Polyhedron_certificate& certificate() const { return m_certificate; }
  double last_curvature() const { return m_last_t; }
  std::size_t newton_steps() const { return m_newton_steps; }

  // Returns the greatest relative difference of distances in space and lengths.
  double max_edge_error() const
  {
    double result = 0;
    for(Edge_index e : m_tri.mesh().edges()) {
      const Point &p = m_points[m_tri.mesh().vertex(e, 0).idx()],
                  &q = m_points[m_tri.mesh().vertex(e, 1).idx()];
      const double length = m_tri.length(e);
      result = (std::max)(result, std::abs(distance<double>(p, q) - length) / length);
    }
    return result;
  }

private:
  // The end of the path, and the greatest t of an acceptable result.
  static constexpr double t_at_end = 1e-14, greatest_t_at_end = 1e-6;
  // A polyhedron is flat if its pyramids are no higher, relative to its size and to t.
  static constexpr double flat_height = 1e3;
  // The greatest error of an edge. Greater errors show that heights are lost in rounding.
  static constexpr double greatest_edge_error = 1e-9;

  void build(const Curvature_path& path, const std::vector<Vertex_index>& vertices, bool is_flat)
  {
    m_is_flat = is_flat;
    Metric_surface surface = path.surface();
    place(surface, path.radii(), vertices);
    triangulate();
    certify(surface);
  }

  bool is_accurate() const
  {
    return m_certificate.is_convex() && max_edge_error() <= greatest_edge_error;
  }

  // Lengths determine heights to half of the digits only. So a polygon with two sides can have
  // heights of rounding errors. Builds the polygon, unless it has other edge lengths.
  void try_polygon(const Curvature_path& path, const std::vector<Vertex_index>& vertices)
  {
    try {
      build(path, vertices, true);
      if(is_accurate())
        return;
    } catch(const Numerical_error&) { // the polyhedron is no polygon
    }
    build(path, vertices, false);
  }

  // Places the vertices, the flat ones in the faces in which they rest.
  void place(Metric_surface& surface, const Radii& radii, const std::vector<Vertex_index>& vertices)
  {
    std::vector<Precise_vector> positions = Pyramid_layout(surface, radii).positions();
    center(positions);
    m_corners.clear();
    for(const Precise_vector& p : positions)
      m_corners.emplace_back(p.x.high(), p.y.high(), m_is_flat ? 0. : p.z.high());
    if(!m_is_flat)
      flip_concave_edges(
        surface.mesh(), m_corners, [&](Halfedge_index h) { return surface.is_flippable(h); },
        [&](Halfedge_index h) { surface.flip(h); });
    m_points.resize(m_tri.mesh().num_vertices());
    for(std::size_t i = 0; i < vertices.size(); ++i)
      m_points[vertices[i].idx()] = m_corners[i];
    const Delta_complex& mesh = surface.mesh();
    for(Face_index f : mesh.faces()) {
      const auto corner = corners_in_space(mesh.halfedge(f), mesh, m_corners);
      for(const Resting_points::Point& p : surface.points().in_face(f))
        m_points[p.number] = CGAL::barycenter(corner[0], p.coordinates[0], corner[1],
                                              p.coordinates[1], corner[2], p.coordinates[2]);
    }
  }

  static void center(std::vector<Precise_vector>& positions)
  {
    Precise_vector sum{0, 0, 0};
    for(const Precise_vector& p : positions)
      sum = sum + p;
    const Precise_vector shift = Double_double(-1 / static_cast<double>(positions.size())) * sum;
    for(Precise_vector& p : positions)
      p = p + shift;
  }

  // The heights of the pyramids over a polygon with two sides shrink as the curvature does.
  static bool is_flat(const Metric_surface& surface, const Radii& radii, double t)
  {
    double height = 0, size = 0;
    for(Face_index f : surface.mesh().faces())
      height = (std::max)(height, pyramid(f, surface, radii).height().high());
    for(Edge_index e : surface.mesh().edges())
      size = (std::max)(size, surface.length_map()[e].high());
    return height <= flat_height * t * size;
  }

  // Flips T2 such that its edges are edges of the polyhedron, or lie in its faces.
  void triangulate()
  {
    const auto weight = boost::make_function_property_map<Vertex_index>([this](Vertex_index v) {
      return CGAL::squared_distance(m_points[v.idx()], Point(CGAL::ORIGIN));
    });
    make_weighted_Delaunay(m_tri, weight);
    if(!m_is_flat)
      flip_concave_edges_of_T2();
    m_tri.recompute_lengths();
  }

  // Does so at edges whose faces have no flat vertices: rounding moves these out of faces.
  void flip_concave_edges_of_T2()
  {
    const Delta_complex& mesh = m_tri.mesh();
    std::vector<bool> is_flat(mesh.num_vertices(), false);
    for(Vertex_index v : m_flat_vertices)
      is_flat[v.idx()] = true;
    const auto has_flat_corner = [&](Halfedge_index h) {
      const Halfedge_index o = opposite(h);
      return is_flat[mesh.source(h).idx()] || is_flat[mesh.target(h).idx()] ||
             is_flat[mesh.target(mesh.next(h)).idx()] || is_flat[mesh.target(mesh.next(o)).idx()];
    };
    flip_concave_edges(
      mesh, m_points,
      [&](Halfedge_index h) { return !has_flat_corner(h) && m_tri.is_flippable(h); },
      [&](Halfedge_index h) { m_tri.flip(h); });
  }

  void certify(const Metric_surface& surface)
  {
    const bool has_flat_vertices = !m_flat_vertices.empty();
    const Delta_complex& mesh = has_flat_vertices ? surface.mesh() : m_tri.mesh();
    const Polyhedron_points& points = has_flat_vertices ? m_corners : m_points;
    m_certificate = m_is_flat ? certified_polygon(mesh, points)
                              : certified_polyhedron(mesh, points, CGAL::ORIGIN);
  }

  Intrinsic_triangulation<Traits>& m_tri;
  Polyhedron_points m_corners, m_points; // the vertices with curvature, and all
  std::vector<Vertex_index> m_flat_vertices;
  Polyhedron_certificate m_certificate;
  bool m_is_flat = false;
  double m_last_t = 1;
  std::size_t m_newton_steps = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_POLYHEDRON_BUILDER_H
