// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the growth of costs for extreme degrees or crossings: bipyramids over ever more points,
// and thin cylinders sheared by ever more twists. Constant time per flip and linear time per
// crossing yield constant columns.

#include "../Table.h"
#include "measure.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <random>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Mesh::Vertex_index Vertex;

// Returns two hubs of degree `n` over a ring of `n` points at random heights.
Mesh bipyramid(unsigned n)
{
  std::mt19937 random(n);
  std::uniform_real_distribution<double> height(-0.5, 0.5);
  Mesh mesh;
  const Vertex top = mesh.add_vertex(Point(0, 0, 0.6)), bottom = mesh.add_vertex(Point(0, 0, -0.6));
  std::vector<Vertex> ring;
  for(unsigned i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n;
    ring.push_back(mesh.add_vertex(Point(std::cos(angle), std::sin(angle), height(random))));
  }
  for(unsigned i = 0; i < n; ++i) {
    const Vertex a = ring[i], b = ring[(i + 1) % n];
    mesh.add_face(top, a, b);
    mesh.add_face(bottom, b, a);
  }
  return mesh;
}

// Stores the lengths of a strip of `n` quadrangles around a cylinder of circumference 1 and the
// given height, whose diagonals lead `twists` times around it.
struct Sheared_cylinder
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, double> length;

  Sheared_cylinder(unsigned n, unsigned twists, double height)
    : length(mesh.add_property_map<Mesh::Edge_index, double>("e:sheared_length", 0).first)
  {
    std::vector<Vertex> low, high;
    for(unsigned i = 0; i < n; ++i)
      low.push_back(mesh.add_vertex(Point())), high.push_back(mesh.add_vertex(Point()));
    for(unsigned i = 0; i < n; ++i) {
      const unsigned j = (i + 1) % n;
      mesh.add_face(low[i], low[j], high[j]);
      mesh.add_face(low[i], high[j], high[i]);
    }
    for(Mesh::Edge_index e : mesh.edges()) {
      const unsigned a = mesh.vertex(e, 0), b = mesh.vertex(e, 1);
      const bool across = a % 2 != b % 2;
      const double forward = across && a / 2 != b / 2 ? 1. / n : 0;
      length[e] = across ? std::hypot(twists + forward, height) : 1. / n;
    }
  }
};

template <typename Input, typename NamedParameters>
void benchmark(const Table& table, const char* name, unsigned size, const Input& input,
               const NamedParameters& np)
{
  Samples flip, trace, subdivide;
  IT::Intrinsic_triangulation<> tri(input, np);
  const std::size_t flips = flip.time([&] { return IT::make_Delaunay(tri); });
  const IT::Correspondence<> correspondence = trace.time([&] { return IT::Correspondence<>(tri); });
  const auto faces = subdivide.time(
    [&] { return IT::Common_subdivision<>(correspondence).mesh().number_of_faces(); });
  table.row(name, size, flips, 1e6 * flip.median() / double(flips),
            correspondence.number_of_crossings(),
            1e6 * trace.median() / double(correspondence.number_of_crossings()), faces,
            1e6 * subdivide.median() / faces);
}

int main()
{
  keep_memory();
  const Table table({"surface", "degree or twists", "flips", "each (ns)", "crossings", "each (ns)",
                     "faces", "each (ns)"});
  for(unsigned n : {500, 1000, 2000, 4000, 8000, 16000})
    benchmark(table, "bipyramid", n, bipyramid(n), CGAL::parameters::default_values());
  for(unsigned twists : {125, 250, 500, 1000}) {
    const Sheared_cylinder cylinder(40, twists, 2.);
    benchmark(table, "sheared cylinder", twists, cylinder.mesh,
              IT::parameters::edge_length_map(cylinder.length));
  }
}
