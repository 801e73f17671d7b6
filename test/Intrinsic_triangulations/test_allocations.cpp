// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Elementary operations allocate nothing, and objects use the memory given in the manual.

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

// These functions are defined in counted_new.cpp.
std::size_t number_of_allocations();
std::size_t bytes_in_use();

namespace Test_allocations {

using namespace Test_surfaces;

// Returns a wavy square of n x n cells, with parallel diagonals.
Mesh wavy_square(std::size_t n)
{
  return grid(n, n, [](double i, double j) {
    return Point(i, 3 * j, 2 * std::sin(1.7 * i) * std::cos(0.9 * j));
  });
}

// Returns a torus of n x n cells with a wavy radius.
Mesh wavy_torus(std::size_t n)
{
  Mesh mesh = embedded_torus(n, n);
  for(Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    const double axis = std::hypot(p.x(), p.y()), wave = 0.3 * std::sin(1.7 * double(v.idx() / n));
    const double s = (axis + 1 + (axis - 3) * wave) / axis;
    mesh.point(v) = Point(s * p.x(), s * p.y(), (1 + wave) * p.z());
  }
  return mesh;
}

TEST(Allocations, a_flip_allocates_nothing)
{
  IT::Intrinsic_triangulation<> tri(wavy_square(10));
  std::size_t flips = 0;
  const std::size_t before = number_of_allocations();
  for(IT::Edge_index e : tri.mesh().edges()) {
    const IT::Halfedge_index h = tri.mesh().halfedge(e);
    if(tri.is_flippable(h)) {
      tri.flip(h);
      ++flips;
    }
  }
  EXPECT_EQ(number_of_allocations(), before);
  EXPECT_GT(flips, 50u);
}

// Only the stack allocates: the marks of its edges once, and the edges whenever it doubles.
TEST(Allocations, make_Delaunay_allocates_its_stack_only)
{
  IT::Intrinsic_triangulation<> tri(wavy_square(60));
  const std::size_t before = number_of_allocations();
  const std::size_t flips = IT::make_Delaunay(tri);
  EXPECT_LT(number_of_allocations() - before, 20u);
  EXPECT_GT(flips, 1000u);
}

// Returns the bytes of the object that `make()` returns, for each of `edges` edges.
template <typename Make>
double bytes_per_edge(std::size_t edges, const Make& make)
{
  const std::size_t before = bytes_in_use();
  const auto object = make();
  return static_cast<double>(bytes_in_use() - before) / static_cast<double>(edges);
}

TEST(Allocations, bytes_on_a_closed_surface)
{
  const Mesh mesh = wavy_torus(100);
  const std::size_t edges = mesh.number_of_edges();
  EXPECT_NEAR(bytes_per_edge(edges, [&] { return IT::Intrinsic_triangulation<>(mesh); }), 124, 1);
  IT::Intrinsic_triangulation<> tri(mesh);
  EXPECT_NEAR(bytes_per_edge(edges, [&] { return IT::Vertex_inserter<>(tri); }), 4, 1);
  EXPECT_NEAR(bytes_per_edge(edges, [&] { return IT::Correspondence<>(tri); }), 40, 1);
  EXPECT_GT(IT::make_Delaunay(tri), edges / 10);
  IT::Correspondence<> with_crossings(tri);
  const double crossings = static_cast<double>(with_crossings.number_of_crossings());
  EXPECT_LT(bytes_per_edge(edges, [&] { return IT::Correspondence<>(tri); }),
            55 + 36 * crossings / static_cast<double>(edges));
}

} // namespace Test_allocations
