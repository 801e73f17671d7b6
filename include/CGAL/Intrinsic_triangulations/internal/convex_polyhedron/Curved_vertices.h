// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVED_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_CURVED_VERTICES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Precise_lengths.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Metric_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/curvature_errors.h>
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
