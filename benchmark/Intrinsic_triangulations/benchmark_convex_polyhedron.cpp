// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes convex polyhedra from the lengths of their surfaces alone. They are hulls of random
// points on spheres that are flattened along an axis, triangulated by random flips. Errors are
// errors of the distances between the ends of edges of the hull. The time is also given as a
// multiple of the time of a Delaunay triangulation of the same surface.

#include "../../test/Intrinsic_triangulations/more_generators.h"
#include "../Table.h"
#include "measure.h"

#include <CGAL/Intrinsic_triangulations/convex_polyhedron.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

using namespace Test_surfaces;

Mesh flattened_hull(std::size_t n, double height)
{
  Mesh mesh = random_sphere(n, 1);
  for(Vertex_index v : mesh.vertices()) {
    Point& p = mesh.point(v);
    p = Point(p.x(), p.y(), height * p.z());
  }
  return mesh;
}

double greatest_error(const IT::Convex_polyhedron& p, const Mesh& hull)
{
  double result = 0;
  for(const auto e : hull.edges()) {
    const Vertex_index v = hull.vertex(e, 0), w = hull.vertex(e, 1);
    const double is = std::sqrt(CGAL::squared_distance(p.point(v), p.point(w))),
                 ought = std::sqrt(CGAL::squared_distance(hull.point(v), hull.point(w)));
    result = (std::max)(result, std::abs(is - ought) / ought);
  }
  return result;
}

int main()
{
  const Table table({"convex", "vertices", "height", "steps", "seconds",
                     "times a Delaunay triangulation", "error"});
  for(const double height : {1., 0.1, 0.01})
    for(const std::size_t n : {100, 500, 2000}) {
      const Mesh hull = flattened_hull(n, height);
      CGAL::Random random(1);
      const Triangulation t = with_random_flips(hull, random);
      const auto surface = IT::parameters::edge_length_map(t.length_map());
      Samples path, Delaunay;
      const auto p = path.time([&] { return IT::convex_polyhedron(t.mesh(), surface); });
      for(int i = 0; i < 5; ++i)
        Delaunay.time([&] {
          Triangulation copy(t.mesh(), surface);
          return IT::make_Delaunay(copy);
        });
      table.row(p.certificate().is_convex() ? "yes" : "no", n, height, p.newton_steps(),
                path.least() / 1000, path.least() / Delaunay.least(), greatest_error(p, hull));
    }
}
