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
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Metric_surface.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

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

// The greatest error of a curvature that counts: a face of nearly zero area could make it infinite.
constexpr double greatest_curvature_error() { return 1e-6; }

// Returns for each vertex the greatest change of its curvature by rounding of the input. Lengths
// have relative errors of one rounding. Positions have errors of one rounding of the largest
// coordinate, which turn the sides of faces.
template <typename Traits>
std::vector<double> curvature_errors(const Intrinsic_triangulation<Traits>& tri)
{
  const double unit = rounding_unit<double>();
  double coordinate = 0;
  for(const auto& p : tri.input_metric().points)
    for(double x : p)
      coordinate = (std::max)(coordinate, std::abs(x));
  const Delta_complex& mesh = tri.mesh();
  std::vector<double> result(mesh.num_vertices(), 0.);
  for(Face_index f : mesh.faces()) {
    const Face_metric<double> metric(f, tri.intrinsic());
    const double longest = (std::max)({metric.length(0), metric.length(1), metric.length(2)}),
                 height = metric.doubled_area() / longest;
    for(Halfedge_index h : sides(f, mesh))
      result[mesh.source(h).idx()] += unit * (std::max)(longest, coordinate) / height;
  }
  for(double& error : result)
    error = (std::min)(error, greatest_curvature_error());
  return result;
}

// Stores the surface without its flat vertices, which rest in faces.
struct Curved_vertices
{
  Metric_surface surface;
  std::vector<Vertex_index> vertices, flat_vertices; // the remaining and the removed vertices
};

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

// Determines the flat vertices, whose curvatures are at most `tolerance`, or else at most their
// rounding errors.
template <typename Traits>
Curved_vertices curved_vertices(const Intrinsic_triangulation<Traits>& tri,
                                std::optional<double> tolerance)
{
  Curved_vertices result{precise_surface(tri), {}, {}};
  const std::vector<double> curvature = result.surface.curvatures();
  const std::vector<double> error = curvature_errors(tri);
  std::vector<std::size_t> negative;
  for(Vertex_index v : tri.mesh().vertices())
    if(const double greatest = tolerance ? *tolerance : error[v.idx()];
       curvature[v.idx()] < -greatest)
      negative.push_back(v.idx());
    else if(curvature[v.idx()] <= greatest)
      result.flat_vertices.push_back(v);
  if(!negative.empty())
    throw Negative_curvature(negative, curvature[negative.front()]);
  for(Vertex_index v : result.flat_vertices)
    if(!result.surface.remove_flat_vertex(v))
      throw Numerical_error("vertex " + std::to_string(v.idx()) +
                            " is flat and cannot be removed from the triangulation");
  result.vertices = result.surface.collect_garbage();
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVED_VERTICES_H
