// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVED_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVED_VERTICES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Precise_lengths.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Metric_surface.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Errors of curvatures are bounded by this value, because a face of nearly zero area could make
// them infinite.
constexpr double greatest_curvature_error() { return 1e-6; }

// Returns the greatest change of the angles of a face by rounding of lengths or positions, as
// `curvature_errors()` describes it.
template <typename Surface>
double rounded_angle_error(Face_index f, const Surface& surface, double coordinate)
{
  const Face_metric<double> metric(f, surface);
  const double longest = (std::max)({metric.length(0), metric.length(1), metric.length(2)}),
               height = metric.doubled_area() / longest;
  return rounding_unit<double>() * (std::max)(longest, coordinate) / height;
}

// Returns for each vertex the greatest change of its curvature by rounding of lengths or positions
// of `surface`. Lengths have relative errors of one rounding. Positions have errors of one rounding
// of `coordinate`, the largest coordinate, which turn the sides of faces.
template <typename Surface>
std::vector<double> curvature_errors(const Surface& surface, double coordinate)
{
  const auto& mesh = surface.mesh();
  std::vector<double> result(mesh.num_vertices(), 0.);
  for(Face_index f : mesh.faces()) {
    const double error = rounded_angle_error(f, surface, coordinate);
    for(Halfedge_index h : sides(f, mesh))
      result[mesh.source(h).idx()] += error;
  }
  for(double& error : result)
    error = (std::min)(error, greatest_curvature_error());
  return result;
}

// Returns the greatest absolute value of a coordinate of the input, zero without positions.
template <typename Traits>
double largest_coordinate(const Intrinsic_triangulation<Traits>& tri)
{
  double result = 0;
  for(const auto& p : tri.input_metric().points)
    for(double x : p)
      result = (std::max)(result, std::abs(x));
  return result;
}

// Returns the unit normal of each face of a surface with positions.
template <typename Traits>
std::vector<std::array<double, 3>> unit_normals(const Intrinsic_triangulation<Traits>& tri)
{
  const Delta_complex& mesh = tri.input_mesh();
  const auto& points = tri.input_metric().points;
  std::vector<std::array<double, 3>> result(mesh.num_faces());
  for(Face_index f : mesh.faces()) {
    const auto [h, next, last] = sides(f, mesh);
    const auto& p = points[mesh.source(h)];
    auto n = cross(vector_between<double>(p, points[mesh.source(next)]),
                   vector_between<double>(p, points[mesh.source(last)]));
    const double norm = std::sqrt(dot(n, n));
    for(double& x : n)
      x /= norm;
    result[f.idx()] = n;
  }
  return result;
}

// Returns for each vertex the greatest change of its curvature by rounding of the positions of T1,
// to second order. If the target of an edge at the vertex moves, the curvature changes by the
// difference of the normals beside the edge, over its length. So it hardly changes on a surface
// that is almost plane, where only products of two angle errors remain.
// \pre the input has positions
template <typename Traits>
std::vector<double> curvature_errors_of_positions(const Intrinsic_triangulation<Traits>& tri)
{
  const Delta_complex& mesh = tri.input_mesh();
  const auto& points = tri.input_metric().points;
  const auto normal = unit_normals(tri);
  const double coordinate = largest_coordinate(tri);
  std::vector<double> result(mesh.num_vertices(), 0.);
  for(Halfedge_index h : mesh.halfedges()) {
    const auto along = vector_between<double>(points[mesh.source(h)], points[mesh.target(h)]),
               turn = vector_between<double>(normal[mesh.face(h).idx()],
                                             normal[mesh.face(mesh.opposite(h)).idx()]);
    const double angle_error = rounded_angle_error(mesh.face(h), tri.input(), coordinate);
    // The vertex itself moves too, which changes the curvature by at most as much.
    result[mesh.source(h).idx()] +=
      2 * rounding_unit<double>() * coordinate * std::sqrt(dot(turn, turn) / dot(along, along)) +
      angle_error * angle_error;
  }
  return result;
}

// Returns for each vertex the least known bound of the change of its curvature by rounding.
template <typename Traits>
std::vector<double> least_curvature_errors(const Intrinsic_triangulation<Traits>& tri)
{
  std::vector<double> result = curvature_errors(tri.intrinsic(), largest_coordinate(tri));
  if(!tri.input_metric().points.empty()) {
    const std::vector<double> of_positions = curvature_errors_of_positions(tri);
    for(Vertex_index v : tri.input_mesh().vertices())
      if(of_positions[v.idx()] < result[v.idx()]) // false for degenerate faces
        result[v.idx()] = of_positions[v.idx()];
  }
  return result;
}

// Returns T2 with the lengths that its edges have on the exact surface of T1.
template <typename Traits>
Metric_surface precise_surface(const Intrinsic_triangulation<Traits>& tri)
{
  Delta_complex mesh = without_maps(tri.mesh());
  auto length = stored_length_map<Double_double>(mesh);
  Precise_lengths<Traits> precise(tri);
  for(Edge_index e : mesh.edges())
    length[e] = precise(mesh.halfedge(e));
  return Metric_surface(mesh);
}

// Stores the surface without its flat vertices, which rest in faces.
struct Curved_vertices
{
  Metric_surface surface;
  std::vector<Vertex_index> vertices, flat_vertices; // the remaining and the removed vertices
  std::size_t number_of_unknown = 0; // curvatures that are smaller than rounding of the input
};

// Returns the end of the message of a failure.
inline std::string reason_of_failure(std::size_t number_of_unknown)
{
  return number_of_unknown == 0 ? ""
                                : "; rounding of the input exceeds the curvature of vertices: " +
                                    std::to_string(number_of_unknown);
}

inline void check_sphere(const Delta_complex& mesh)
{
  for(Vertex_index v : mesh.vertices())
    if(mesh.is_isolated(v))
      throw Invalid_input("vertex " + std::to_string(v.idx()) + " has no face");
  const Topological_type type = topological_type(mesh);
  if(type.components != 1 || type.genus != 0 || type.boundary_loops != 0)
    throw Invalid_input("only a sphere is the surface of a convex polyhedron, not " +
                        description(type));
}

// Returns the vertices of `surface` whose curvatures are at most their errors.
inline std::vector<Vertex_index> flat_vertices(const Metric_surface& surface,
                                               const std::vector<double>& error)
{
  const std::vector<double> curvature = surface.curvatures();
  std::vector<Vertex_index> result;
  for(Vertex_index v : surface.mesh().vertices())
    if(curvature[v.idx()] <= error[v.idx()])
      result.push_back(v);
  return result;
}

// Removes the flat vertices, whose curvatures are at most their errors, until all curvatures are
// greater. A removed vertex leaves its curvature, which may be negative, to three neighbors.
inline void remove_flat_vertices(Curved_vertices& curved, const std::vector<double>& error)
{
  for(auto flat = flat_vertices(curved.surface, error); !flat.empty();
      flat = flat_vertices(curved.surface, error))
    for(Vertex_index v : flat) {
      if(!curved.surface.remove_flat_vertex(v))
        throw Numerical_error("vertex " + std::to_string(v.idx()) +
                              " is flat and cannot be removed from the triangulation" +
                              reason_of_failure(curved.number_of_unknown));
      curved.flat_vertices.push_back(v);
    }
  std::sort(curved.flat_vertices.begin(), curved.flat_vertices.end());
}

// Determines the flat vertices, whose curvatures are at most `error`. A negative curvature counts
// as zero up to `tolerance`, or else up to the rounding errors in T1, whose lengths or positions
// are given.
template <typename Traits>
Curved_vertices curved_vertices(const Intrinsic_triangulation<Traits>& tri,
                                const std::vector<double>& error, std::optional<double> tolerance)
{
  Curved_vertices result{precise_surface(tri), {}, {}, 0};
  const std::vector<double> curvature = result.surface.curvatures(),
                            in_T1 = curvature_errors(tri.input(), largest_coordinate(tri));
  std::vector<std::size_t> negative;
  for(Vertex_index v : tri.mesh().vertices()) {
    if(curvature[v.idx()] < -tolerance.value_or((std::max)(in_T1[v.idx()], error[v.idx()])))
      negative.push_back(v.idx());
    result.number_of_unknown += std::abs(curvature[v.idx()]) <= in_T1[v.idx()];
  }
  if(!negative.empty())
    throw Negative_curvature(negative, curvature[negative.front()]);
  remove_flat_vertices(result, error);
  result.vertices = result.surface.collect_garbage();
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVED_VERTICES_H
