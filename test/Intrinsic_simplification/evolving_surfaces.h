// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SIMPLIFICATION_TEST_EVOLVING_SURFACES_H
#define INTRINSIC_SIMPLIFICATION_TEST_EVOLVING_SURFACES_H

#include "../Intrinsic_triangulations/generators.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>

namespace Test_surfaces {

namespace IS = CGAL::Intrinsic_simplification;
using IS::Evolving_surface;
using IS::Flattened_star;
using IS::Removal_status;

inline auto lengths_of(const Evolving_surface& s)
{
  return [&s](Edge_index e) { return s.surface().length(e); };
}

inline bool is_on_border(Vertex_index v, const Delta_complex& mesh)
{
  return !mesh.is_isolated(v) && mesh.is_border(mesh.halfedge(v));
}

// Returns the differences between 2 pi (or pi) and the sum of angles at each vertex.
inline std::vector<double> curvatures(const Evolving_surface& s)
{
  std::vector<double> result = angle_sums(s.mesh(), lengths_of(s));
  for(Vertex_index v : s.mesh().vertices())
    result[v] = (is_on_border(v, s.mesh()) ? 1 : 2) * pi - result[v];
  return result;
}

inline double area_of(const Evolving_surface& s) { return area_of(s.mesh(), lengths_of(s)); }

// ---- Checking ----

// Angles from acos are exact to about 1e-8 if they are small, and hundreds of them are added.
constexpr double angle_tolerance = 1e-6;

inline void expect_Delaunay(const Evolving_surface& s)
{
  for(Edge_index e : s.mesh().edges()) {
    const Halfedge_index h = s.mesh().halfedge(e), o = s.mesh().opposite(h);
    if(s.mesh().is_border(h) || s.mesh().is_border(o) || s.surface().is_constrained(e))
      continue;
    const double sum = angle_at(s.mesh().prev(h), s.mesh(), lengths_of(s)) +
                       angle_at(s.mesh().prev(o), s.mesh(), lengths_of(s));
    EXPECT_LE(sum, pi + angle_tolerance) << "edge " << e;
  }
}

inline void expect_triangles(const Evolving_surface& s)
{
  for(Halfedge_index h : s.mesh().halfedges())
    if(!s.mesh().is_border(h)) {
      const double a = s.surface().length(h);
      EXPECT_LE(a, (s.surface().length(s.mesh().next(h)) + s.surface().length(s.mesh().prev(h))) *
                     (1 + 1e-12))
        << "halfedge " << h;
    }
}

// Checks that the surface is a valid Delaunay triangulation with that Euler characteristic.
inline void expect_valid(const Evolving_surface& s, int characteristic)
{
  ASSERT_TRUE(IT::is_valid_Delta_complex(s.mesh(), true));
  EXPECT_EQ(Euler_characteristic(s.mesh()), characteristic);
  expect_triangles(s);
  expect_Delaunay(s);
  const std::vector<double> curvature = curvatures(s);
  double total = 0;
  for(Vertex_index v : s.mesh().vertices())
    total += s.mesh().is_isolated(v) ? 2 * pi : curvature[v];
  EXPECT_NEAR(total, 2 * pi * characteristic, angle_tolerance);
}

// Returns the whole visible state of a surface.
inline auto state_of(const Evolving_surface& s)
{
  std::vector<std::tuple<Halfedge_index, Face_index, Vertex_index, std::complex<double>>> halfedges;
  std::vector<double> lengths;
  std::vector<Halfedge_index> bases;
  for(Halfedge_index h : s.mesh().halfedges())
    halfedges.emplace_back(s.mesh().next(h), s.mesh().face(h), s.mesh().target(h),
                           s.surface().direction(h));
  for(Edge_index e : s.mesh().edges())
    lengths.push_back(s.surface().length(e));
  for(Face_index f : s.mesh().faces())
    bases.push_back(s.mesh().halfedge(f));
  for(Vertex_index v : s.mesh().vertices())
    bases.push_back(s.mesh().halfedge(v));
  return std::make_tuple(halfedges, lengths, bases, s.history().size());
}

// ---- Surfaces ----

inline Evolving_surface evolving(const Delta_complex& mesh, unsigned int seed)
{
  return Evolving_surface(triangulation(mesh, random_lengths(mesh, seed)));
}

// Returns the mesh with every edge halved.
inline Mesh subdivided(const Mesh& mesh, int times)
{
  if(times == 0)
    return mesh;
  std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  for(Edge_index e : mesh.edges())
    points.push_back(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  const auto middle = [&](Halfedge_index h) {
    return mesh.number_of_vertices() + mesh.edge(h).idx();
  };
  Triangles triangles;
  for(Face_index f : mesh.faces()) {
    const Halfedge_index a = mesh.halfedge(f), b = mesh.next(a), c = mesh.prev(a);
    for(Halfedge_index h : {a, b, c})
      triangles.push_back({mesh.target(h).idx(), middle(mesh.next(h)), middle(h)});
    triangles.push_back({middle(a), middle(b), middle(c)});
  }
  return subdivided(make_mesh(points, triangles), times - 1);
}

} // namespace Test_surfaces

#endif // INTRINSIC_SIMPLIFICATION_TEST_EVOLVING_SURFACES_H
