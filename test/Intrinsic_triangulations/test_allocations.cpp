// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Elementary operations allocate nothing.

#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

std::size_t number_of_allocations(); // counted_new.cpp

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

// a wavy square of n x n cells, with every diagonal the same way
Mesh wavy_square(unsigned n)
{
  Mesh mesh;
  for(unsigned i = 0; i <= n; ++i)
    for(unsigned j = 0; j <= n; ++j)
      mesh.add_vertex(Point(i, 3. * j, 2 * std::sin(1.7 * i) * std::cos(0.9 * j)));
  const auto vertex = [&](unsigned i, unsigned j) { return Mesh::Vertex_index(i * (n + 1) + j); };
  for(unsigned i = 0; i < n; ++i)
    for(unsigned j = 0; j < n; ++j) {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

TEST(Allocations, AFlipAllocatesNothing)
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

// Only the stack allocates: the marks of its edges once, and the edges as often as it doubles.
TEST(Allocations, MakeDelaunayAllocatesItsStackOnly)
{
  IT::Intrinsic_triangulation<> tri(wavy_square(60));
  const std::size_t before = number_of_allocations();
  const std::size_t flips = IT::make_Delaunay(tri);
  EXPECT_LT(number_of_allocations() - before, 20u);
  EXPECT_GT(flips, 1000u);
}

} // namespace
