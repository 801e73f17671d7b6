// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_POLYHEDRON_BUILDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_POLYHEDRON_BUILDER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Polyhedron_certificate.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Convex_positions.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Curvature_path.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Curved_vertices.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Edge_fitting.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Polygon_layout.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/lay_out_pyramids.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds the positions of the vertices of a convex polyhedron with the surface of a triangulation.
// Makes the edges of T2 straight lines on this polyhedron.
template <typename Traits>
class Polyhedron_builder
{
public:
  typedef Polyhedron_kernel::Point_3 Point;

  Polyhedron_builder(Intrinsic_triangulation<Traits>& tri, std::optional<double> tolerance)
    : m_tri(tri), m_greatest_edge_error((std::max)(1e-9, tolerance.value_or(0)))
  {
    check_sphere(tri.input_mesh());
    make_Delaunay(tri);
    if(tolerance)
      build(curved_vertices(tri, std::vector<double>(tri.mesh().num_vertices(), *tolerance),
                            tolerance));
    else
      build_as_precisely_as_possible();
  }

  const std::vector<Point>& points() const { return m_points; }
  const std::vector<Vertex_index>& flat_vertices() const { return m_flat_vertices; }
  const Polyhedron_certificate& certificate() const { return m_certificate; }
  Polyhedron_kind kind() const { return m_kind; }
  double last_curvature() const { return m_last_t; }
  std::size_t newton_steps() const { return m_newton_steps; }

  // Returns the greatest relative difference of distances in space and lengths.
  double max_edge_error() const
  {
    double result = 0;
    for(Edge_index e : m_tri.mesh().edges())
      result = (std::max)(result, edge_error(e) / m_tri.length(e));
    return result;
  }

private:
  static constexpr double t_at_end = 1e-14; // of the path
  // Lengths determine heights to half of the digits only. If heights are less, relative to the
  // size, a polygon with two sides is tried first. Its edges then have errors of the square.
  static constexpr double flat_height = 1e-7;
  static constexpr double position_error = 0x1p-50;    // relative to the largest coordinate
  static constexpr double coarse_edge_error = 0x1p-34; // of wrong edges
  static constexpr int most_fittings = 20;

  // Keeps the vertices that are curved in spite of rounding of positions. If no such polyhedron is
  // found, curvatures up to the rounding errors of lengths count as flat.
  void build_as_precisely_as_possible()
  {
    try {
      build(curved_vertices(m_tri, least_curvature_errors(m_tri), std::nullopt));
    } catch(const Numerical_error&) {
      const std::vector<Vertex_index> flat = m_flat_vertices;
      make_Delaunay(m_tri);
      Curved_vertices curved = curved_vertices(
        m_tri, curvature_errors(m_tri.intrinsic(), largest_coordinate(m_tri)), std::nullopt);
      if(curved.flat_vertices == flat)
        throw;
      build(std::move(curved));
    }
  }

  void build(Curved_vertices curved)
  {
    m_flat_vertices = std::move(curved.flat_vertices);
    m_number_of_unknown = curved.number_of_unknown;
    if(failure_of_polygon(curved, flat_height * flat_height).empty()) {
      m_last_t = 0;
      return;
    }
    Curvature_path path(curved.surface);
    path.follow_to(t_at_end);
    m_last_t = path.t();
    m_newton_steps = path.newton_steps();
    find(path, curved);
  }

  // Takes a polyhedron or a polygon, whichever measurements confirm.
  void find(const Curvature_path& path, const Curved_vertices& curved)
  {
    const auto failure = [&](bool is_polygon) {
      return is_polygon ? failure_of_polygon(curved, m_greatest_edge_error)
                        : failure_of_polyhedron(path, curved.vertices);
    };
    const bool is_flat = has_no_heights(path.surface(), path.radii());
    const std::string first = failure(is_flat);
    const std::string second = first.empty() ? first : failure(!is_flat);
    if(second.empty())
      return;
    std::ostringstream text;
    text << "no convex polyhedron is found; " << (is_flat ? second : first)
         << "; the curvature inside of it is " << m_last_t << " of its first value"
         << reason_of_failure(m_number_of_unknown);
    throw Numerical_error(text.str());
  }

  // Builds a polyhedron. Returns the reason why the polyhedron is no result, or nothing.
  std::string failure_of_polyhedron(const Curvature_path& path,
                                    const std::vector<Vertex_index>& vertices)
  {
    return failure_of([&] { build_polyhedron(path, vertices); }, m_greatest_edge_error);
  }

  // Builds a polygon whose edges have at most this relative error, and does the same.
  std::string failure_of_polygon(const Curved_vertices& curved, double greatest_edge_error)
  {
    return failure_of([&] { build_polygon(curved); }, greatest_edge_error);
  }

  template <typename Build>
  std::string failure_of(const Build& build, double greatest_edge_error)
  {
    try {
      build();
    } catch(const Numerical_error& error) {
      return error.what();
    }
    if(m_kind != Polyhedron_kind::convex_before_rounding && !m_certificate.is_convex())
      return to_string(m_certificate);
    return are_edges_accurate(greatest_edge_error) ? ""
                                                   : "edges have other lengths than on the surface";
  }

  bool are_edges_accurate(double greatest_error) const
  {
    double size = 0;
    for(const Point& p : m_points)
      for(int i = 0; i < 3; ++i)
        size = (std::max)(size, std::abs(p[i]));
    const auto edges = m_tri.mesh().edges();
    return std::all_of(edges.begin(), edges.end(), [&](Edge_index e) {
      return edge_error(e) <= greatest_error * m_tri.length(e) + position_error * size;
    });
  }

  double edge_error(Edge_index e) const
  {
    const Point &p = m_points[m_tri.mesh().vertex(e, 0).idx()],
                &q = m_points[m_tri.mesh().vertex(e, 1).idx()];
    return std::abs(distance<double>(p, q) - m_tri.length(e));
  }

  void build_polygon(const Curved_vertices& curved)
  {
    const Polygon_layout polygon(curved.surface);
    if(!polygon.exists())
      throw Numerical_error("the surface is no polygon");
    m_kind = Polyhedron_kind::polygon;
    std::vector<Precise_vector> positions = polygon.positions();
    round(positions);
    finish(polygon.surface(), curved.vertices, positions);
  }

  // Makes the edges of the last pyramids straight lines in space.
  void build_polyhedron(const Curvature_path& path, const std::vector<Vertex_index>& vertices)
  {
    m_kind = Polyhedron_kind::convex;
    Metric_surface surface = path.surface();
    std::vector<Precise_vector> positions = Pyramid_layout(surface, path.radii()).positions();
    fit(surface, positions);
    round(positions);
    const bool is_convex =
      certified_polyhedron(surface.mesh(), positions, m_corners, Precise_orientation()).is_convex();
    flip_concave(surface, m_corners, Rounded_orientation());
    finish(surface, vertices, positions);
    if(!m_certificate.is_convex() && is_convex)
      m_kind = Polyhedron_kind::convex_before_rounding;
  }

  template <typename Orientation_of>
  static std::size_t flip_concave(Metric_surface& surface,
                                  const typename Orientation_of::Points& positions,
                                  const Orientation_of& orientation)
  {
    return flip_concave_edges(
      surface.mesh(), positions, orientation,
      [&](Halfedge_index h) { return surface.is_flippable(h); },
      [&](Halfedge_index h) { surface.flip(h); });
  }

  // Gives edges their lengths until none is concave.
  static void fit(Metric_surface& surface, std::vector<Precise_vector>& positions)
  {
    constexpr double error = 0x1p-80; // less is an effect of rounding in plane faces
    for(int i = 0; i < most_fittings; ++i) {
      Edge_fitting(surface, positions);
      if(flip_concave(surface, positions, Precise_orientation{error}) == 0)
        return;
    }
  }

  // Centers and rounds positions.
  void round(std::vector<Precise_vector>& positions)
  {
    center(positions);
    m_corners.clear();
    for(const Precise_vector& p : positions)
      m_corners.push_back(rounded(p));
  }

  // Places the vertices, the flat ones in the faces in which they rest. Flips T2 and decides
  // whether the result is convex.
  void finish(const Metric_surface& surface, const std::vector<Vertex_index>& vertices,
              const std::vector<Precise_vector>& positions)
  {
    std::vector<Precise_vector> all(m_tri.mesh().num_vertices());
    for(std::size_t i = 0; i < vertices.size(); ++i)
      all[vertices[i].idx()] = positions[i];
    const Delta_complex& mesh = surface.mesh();
    for(Face_index f : mesh.faces())
      for(const Resting_points::Point& p : surface.points().in_face(f))
        all[p.number] = position_in_face(f, mesh, p.coordinates, positions);
    m_points.clear();
    for(const Precise_vector& p : all)
      m_points.push_back(rounded(p));
    triangulate(all);
    certify(surface);
  }

  static Precise_vector position_in_face(Face_index f, const Delta_complex& mesh,
                                         const std::array<double, 3>& coordinates,
                                         const std::vector<Precise_vector>& positions)
  {
    Precise_vector sum{0, 0, 0};
    Double_double all = 0;
    for(std::size_t c = 0; c < 3; ++c) {
      sum = sum + Double_double(coordinates[c]) * positions[mesh.source(sides(f, mesh)[c]).idx()];
      all += coordinates[c];
    }
    return (1 / all) * sum;
  }

  static Point rounded(const Precise_vector& p) { return {p.x.high(), p.y.high(), p.z.high()}; }

  static void center(std::vector<Precise_vector>& positions)
  {
    Precise_vector sum{0, 0, 0};
    for(const Precise_vector& p : positions)
      sum = sum + p;
    const Precise_vector shift = Double_double(-1 / static_cast<double>(positions.size())) * sum;
    for(Precise_vector& p : positions)
      p = p + shift;
  }

  static bool has_no_heights(const Metric_surface& surface, const Radii& radii)
  {
    double height = 0, size = 0;
    for(Face_index f : surface.mesh().faces())
      height = (std::max)(height, pyramid(f, surface, radii).height().high());
    for(Edge_index e : surface.mesh().edges())
      size = (std::max)(size, surface.length_map()[e].high());
    return height <= flat_height * size;
  }

  // Flips T2 such that its edges are edges of the polyhedron, or lie in its faces. In thin
  // polyhedra, many digits of squared distances determine edges.
  void triangulate(const std::vector<Precise_vector>& positions)
  {
    const bool is_polygon = m_kind == Polyhedron_kind::polygon;
    flip_to_edges(positions, is_polygon);
    if(!is_polygon && !are_edges_accurate(coarse_edge_error))
      flip_to_edges(positions, true);
  }

  void flip_to_edges(const std::vector<Precise_vector>& positions, bool has_many_digits)
  {
    const bool is_polygon = m_kind == Polyhedron_kind::polygon;
    const double part = is_polygon ? 1 - Polygon_layout::less_weight : 1;
    const auto weight = boost::make_function_property_map<Vertex_index>([&](Vertex_index v) {
      return Double_double(part) * (positions[v.idx()] * positions[v.idx()]);
    });
    make_weighted_Delaunay(m_tri, weight, parameters::exact_decisions(has_many_digits));
    if(!is_polygon)
      flip_concave_edges_of_T2();
    m_tri.recompute_lengths();
  }

  // Flips such edges if their faces have no flat vertices, because rounding moves flat vertices out
  // of faces.
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
      mesh, m_points, Rounded_orientation(),
      [&](Halfedge_index h) { return !has_flat_corner(h) && m_tri.is_flippable(h); },
      [&](Halfedge_index h) { m_tri.flip(h); });
  }

  void certify(const Metric_surface& surface)
  {
    const bool has_flat_vertices = !m_flat_vertices.empty();
    const Delta_complex& mesh = has_flat_vertices ? surface.mesh() : m_tri.mesh();
    const Polyhedron_points& points = has_flat_vertices ? m_corners : m_points;
    m_certificate = m_kind == Polyhedron_kind::polygon
                      ? certified_polygon(mesh, points)
                      : certified_polyhedron(mesh, points, points, Rounded_orientation());
  }

  Intrinsic_triangulation<Traits>& m_tri;
  double m_greatest_edge_error;          // relative to the length
  Polyhedron_points m_corners, m_points; // the vertices with curvature, and all
  std::vector<Vertex_index> m_flat_vertices;
  std::size_t m_number_of_unknown = 0; // see `Curved_vertices`
  Polyhedron_certificate m_certificate;
  Polyhedron_kind m_kind = Polyhedron_kind::convex;
  double m_last_t = 1;
  std::size_t m_newton_steps = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_POLYHEDRON_BUILDER_H
