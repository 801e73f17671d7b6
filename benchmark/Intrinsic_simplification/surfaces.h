// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SIMPLIFICATION_BENCHMARK_SURFACES_H
#define INTRINSIC_SIMPLIFICATION_BENCHMARK_SURFACES_H

// This file provides surfaces to be simplified: generated ones, and surfaces in files.

#include "../Table.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Mesh::Vertex_index Vertex;

// Returns an m by n grid, cut into triangles; `place(i, j)` is a point.
template <typename Place>
Mesh grid(unsigned m, unsigned n, const Place& place)
{
  Mesh mesh;
  for(unsigned j = 0; j <= n; ++j)
    for(unsigned i = 0; i <= m; ++i)
      mesh.add_vertex(place(i, j));
  for(unsigned j = 0; j < n; ++j)
    for(unsigned i = 0; i < m; ++i) {
      const Vertex a((m + 1) * j + i), b(a + 1), c(a + m + 1), d(c + 1);
      mesh.add_face(a, b, d);
      mesh.add_face(a, d, c);
    }
  return mesh;
}

// Returns a nearly flat square with low hills.
inline Mesh hills(unsigned n)
{
  return grid(n, n, [n](unsigned i, unsigned j) {
    const double x = double(i) / n, y = double(j) / n;
    return Point(x, y, 0.02 * std::sin(9 * x + 2 * y) * std::cos(7 * y - x));
  });
}

// Returns a torus with bumps as `n` by `3 n` quadrangles, each of them cut in two.
inline Mesh bumpy_torus(unsigned n)
{
  const unsigned m = 3 * n;
  Mesh mesh;
  for(unsigned j = 0; j < m; ++j)
    for(unsigned i = 0; i < n; ++i) {
      const double a = 2 * CGAL_PI * i / n, b = 2 * CGAL_PI * j / m;
      const double tube = 1 + 0.1 * std::sin(5 * a) * std::sin(15 * b);
      const double radius = 3 + tube * std::cos(a);
      mesh.add_vertex(Point(radius * std::cos(b), radius * std::sin(b), tube * std::sin(a)));
    }
  for(unsigned j = 0; j < m; ++j)
    for(unsigned i = 0; i < n; ++i) {
      const unsigned right = (i + 1) % n, above = (j + 1) % m * n;
      mesh.add_face(Vertex(n * j + i), Vertex(above + i), Vertex(above + right));
      mesh.add_face(Vertex(n * j + i), Vertex(above + right), Vertex(n * j + right));
    }
  return mesh;
}

// Returns a cylinder of radius one and length four along the third axis, with half a sphere at each
// end and `n` vertices around it.
inline Mesh capsule(unsigned n)
{
  const unsigned cap = n / 4, wall = 2 * n / 3, rings = 2 * cap + wall - 1;
  Mesh mesh;
  for(unsigned k = 1; k <= rings; ++k) {
    const bool is_low = k <= cap, is_high = k >= cap + wall;
    const double angle = is_low    ? CGAL_PI / 2 * k / cap
                         : is_high ? CGAL_PI / 2 * (rings + 1 - k) / cap
                                   : CGAL_PI / 2;
    const double z = is_low    ? -2 - std::cos(angle)
                     : is_high ? 2 + std::cos(angle)
                               : 4. * (k - cap) / wall - 2;
    for(unsigned i = 0; i < n; ++i) {
      const double turn = 2 * CGAL_PI * (i + 0.5 * (k % 2)) / n;
      mesh.add_vertex(Point(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), z));
    }
  }
  const Vertex bottom = mesh.add_vertex(Point(0, 0, -3)), top = mesh.add_vertex(Point(0, 0, 3));
  for(unsigned i = 0; i < n; ++i) {
    const unsigned next = (i + 1) % n, last = n * (rings - 1);
    mesh.add_face(bottom, Vertex(next), Vertex(i));
    mesh.add_face(top, Vertex(last + i), Vertex(last + next));
    for(unsigned k = 0; k + 1 < rings; ++k) {
      const Vertex a(n * k + i), b(n * k + next), c(n * (k + 1) + i), d(n * (k + 1) + next);
      mesh.add_face(a, b, d);
      mesh.add_face(a, d, c);
    }
  }
  return mesh;
}

// Returns the mesh with every edge halved.
inline Mesh subdivided(const Mesh& mesh)
{
  Mesh result;
  for(Vertex v : mesh.vertices())
    result.add_vertex(mesh.point(v));
  for(Mesh::Edge_index e : mesh.edges())
    result.add_vertex(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  const auto middle = [&](Mesh::Halfedge_index h) {
    return Vertex(mesh.number_of_vertices() + mesh.edge(h));
  };
  for(Mesh::Face_index f : mesh.faces()) {
    const auto a = mesh.halfedge(f), b = mesh.next(a), c = mesh.next(b);
    for(const auto h : {a, b, c})
      result.add_face(mesh.target(h), middle(mesh.next(h)), middle(h));
    result.add_face(middle(a), middle(b), middle(c));
  }
  return result;
}

// Reads triangles, and omits vertices without faces. Returns an empty mesh if the file has no face.
inline Mesh read_surface(const std::string& path)
{
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(path, mesh) ||
     !CGAL::is_triangle_mesh(mesh))
    return Mesh();
  for(Vertex v : mesh.vertices())
    if(mesh.is_isolated(v))
      mesh.remove_vertex(v);
  mesh.collect_garbage();
  return mesh;
}

// Calls `benchmark(name, mesh)`.
template <typename Benchmark>
void benchmark_file(const std::string& path, const Benchmark& benchmark)
{
  const Mesh mesh = read_surface(path);
  if(mesh.number_of_vertices() == 0)
    std::fprintf(stderr, "%s is no triangle mesh\n", path.c_str());
  else
    benchmark(name_of(path), mesh);
}

#endif // INTRINSIC_SIMPLIFICATION_BENCHMARK_SURFACES_H
