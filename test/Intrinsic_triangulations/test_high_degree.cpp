// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "equality.h"
#include "subdivision_checks.h"

#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/trace_edge.h>

namespace Test_high_degree {

using namespace Test_surfaces;

// Checks that the lengths of the pieces of every edge add up.
void check_trace_lengths(const Correspondence& c, double tolerance)
{
  const Triangulation& t = c.triangulation();
  for(Side side : both_sides)
    for(Edge_index e : c.mesh(side).edges()) {
      const Halfedge_index h = c.mesh(side).halfedge(e);
      Real sum = 0;
      for(Real piece : lengths_of_pieces(side, IT::trace_edge(side, h, c), t))
        sum += piece;
      EXPECT_NEAR(double(sum / Flat_faces(side, t).length(h)), 1, tolerance)
        << (side == Side::input ? "input " : "intrinsic ") << e;
    }
}

// ---- Surfaces ----

// Returns a ring of n points at random heights and distances between two apexes.
Mesh rough_bipyramid(std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  const Mesh smooth = bipyramid(n, 1);
  Mesh mesh = smooth;
  for(std::size_t i = 0; i < n; ++i) {
    const Vertex_index v(static_cast<Mesh::size_type>(i));
    const Point p = smooth.point(v);
    const double r = random.get_double(0.8, 1.2);
    mesh.point(v) = Point(r * p.x(), r * p.y(), random.get_double(-0.2, 0.2));
  }
  return mesh;
}

TEST(High_degree, hub_of_four_thousand)
{
  for(unsigned int seed : seeds(2)) {
    const Mesh mesh = rough_bipyramid(4000, seed);
    Triangulation t(mesh);
    EXPECT_EQ(t.outgoing_halfedges().degree(Vertex_index(4000)), 4000u);
    EXPECT_GT(IT::make_Delaunay(t), 1000u);
    expect_Delaunay(t);
    const Correspondence c(t);
    EXPECT_GT(c.number_of_crossings(), 1000u);
    check_areas(Subdivision(c), c, 1e-9);
    check_trace_lengths(c, 1e-9);
    EXPECT_GT(flip_to_input(t), 1000u);
    EXPECT_TRUE(t.is_valid(true));
  }
}

TEST(High_degree, random_flips_at_a_hub_and_back)
{
  Triangulation t(rough_bipyramid(4000, 3));
  flip_at_random(t, 100000, 1);
  EXPECT_TRUE(t.is_valid(true));
  const Correspondence c(t);
  EXPECT_GT(c.number_of_crossings(), 4000u);
  check_areas(Subdivision(c), c, 1e-9);
  EXPECT_GT(flip_to_input(t), 0u);
  EXPECT_TRUE(t.is_valid(true));
}

TEST(High_degree, ten_thousand_slivers)
{
  Triangulation t(planar_mesh(random_points(5050, 1 << 18, 1)));
  EXPECT_GT(t.mesh().number_of_faces(), 10000u);
  EXPECT_GT(IT::make_Delaunay(t), 10000u);
  expect_Delaunay(t);
  const Correspondence c(t);
  check_areas(Subdivision(c), c, 1e-9);
  EXPECT_GT(flip_to_input(t), 10000u);
  expect_equal_to_input(t);
}

// The edges have 6 million crossings. The edges across are a thousand times as long as the cylinder
// is high. Their rounding leaves only five digits of the exact lengths, however exact the flips
// are.
TEST(High_degree, cylinder_of_a_thousand_twists)
{
  const int n = 39, twists = 1000;
  Flat_triangulation flat(flat_cylinder(n, twists, 40000));
  EXPECT_GT(flat.make_Delaunay(), 500000u);
  expect_Delaunay(*flat);
  const Correspondence c(*flat);
  EXPECT_GT(c.number_of_crossings(), 6000000u);
  for(Edge_index e : flat->mesh().edges()) {
    const double exact = length(flat.vector(flat->mesh().halfedge(e)));
    EXPECT_NEAR(flat->length(e) / exact, 1, 1e-5);
  }
  check_trace_lengths(c, 1e-9);
  Triangulation back(*flat);
  EXPECT_GT(flip_to_input(back), 0u);
  for(Edge_index e : back.mesh().edges())
    EXPECT_EQ(back.coordinates().normal_coordinate(e), -1);
  EXPECT_TRUE(back.is_valid(true));
}

} // namespace Test_high_degree
