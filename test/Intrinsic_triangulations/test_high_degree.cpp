// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/trace_edge.h>

namespace Test_high_degree {

using namespace Test_surfaces;
using Subdivision = IT::Common_subdivision<>;

// No face of T1 may meet itself.
void check_subdivision(const Correspondence& c, double tolerance)
{
  const Triangulation& t = c.triangulation();
  const Subdivision s(c);
  EXPECT_TRUE(s.mesh().is_valid());
  EXPECT_EQ(s.mesh().number_of_vertices(), t.mesh().number_of_vertices() + c.number_of_crossings());
  EXPECT_EQ(Euler_characteristic(s.mesh()), Euler_characteristic(t.input_mesh()));
  const auto [area, wrong] = relative_areas(Side::input, s, t);
  EXPECT_NEAR(area, 1, 1e-9);
  EXPECT_GT(wrong, -tolerance);
}

// The pieces of every edge add up to its length.
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

void expect_Delaunay(const Triangulation& t)
{
  EXPECT_TRUE(IT::is_Delaunay(t));
  EXPECT_TRUE(t.is_valid(true));
}

// Delaunay, and a subdivision of the right area. Returns the number of flips.
std::size_t check(const Mesh& mesh, double tolerance = 1e-9)
{
  Triangulation t(mesh);
  const std::size_t flips = IT::make_Delaunay(t);
  expect_Delaunay(t);
  check_subdivision(Correspondence(t), tolerance);
  EXPECT_EQ(flip_to_input(t) > 0, flips > 0);
  for(Edge_index e : t.mesh().edges())
    EXPECT_EQ(t.coordinates().normal_coordinate(e), -1);
  EXPECT_TRUE(t.is_valid(true));
  return flips;
}

// ---- Surfaces ----

// A ring of n points at random heights and distances between two apexes.
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

Point in_plane(double x, double y) { return {x, y, 0}; }

// A fan of triangles around the first corner of a convex polygon in the plane.
Mesh fan(std::size_t corners, double flatness)
{
  std::vector<Point> points;
  Triangles triangles;
  for(std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::acos(-1.) * static_cast<double>(i) / static_cast<double>(corners);
    points.push_back(in_plane(std::cos(angle), flatness * std::sin(angle)));
    if(i > 1)
      triangles.push_back({0, i - 1, i});
  }
  return make_mesh(points, triangles);
}

// Pairs of needles and of caps, as thin as `width`, between fat triangles.
Mesh thin_faces(double width)
{
  const std::vector<Point> points{in_plane(0, 0),           in_plane(width, 0), in_plane(0.4, 1),
                                  in_plane(0.5, -1),        in_plane(-1, 0.1),  in_plane(1, 0.2),
                                  in_plane(0.45, 1 + width)};
  return make_mesh(
    points,
    {{0, 1, 2}, {0, 3, 1}, {4, 0, 2}, {1, 5, 2}, {4, 3, 0}, {1, 3, 5}, {4, 2, 6}, {2, 5, 6}});
}

// A cap over the side of length 2 of a triangle, of height `height`.
Mesh cap(double height)
{
  return make_mesh(
    {in_plane(0, 0), in_plane(2, 0), in_plane(1, -height), in_plane(1.1, 1.7), in_plane(0.9, -1.6)},
    {{0, 2, 1}, {0, 1, 3}, {0, 4, 2}, {2, 4, 1}});
}

Mesh stretched(Mesh mesh, double factor)
{
  for(Vertex_index v : mesh.vertices())
    mesh.point(v) = Point(factor * mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
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
    check_subdivision(c, 1e-9);
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
  check_subdivision(c, 1e-9);
  EXPECT_GT(flip_to_input(t), 0u);
  EXPECT_TRUE(t.is_valid(true));
}

TEST(High_degree, ten_thousand_slivers)
{
  const std::vector<Vector> points = random_points(5050, 1 << 18, 1);
  const Mesh mesh = planar_mesh(points);
  EXPECT_GT(mesh.number_of_faces(), 10000u);
  EXPECT_GT(check(mesh), 10000u);
}

// 6 million crossings. The edges across are a thousand times as long as the cylinder is high: their
// rounding leaves only five digits of the exact lengths, however exact the flips.
TEST(High_degree, cylinder_of_a_thousand_twists)
{
  const int n = 39, twists = 1000;
  Flat_triangulation flat(flat_cylinder(n, twists, 40000));
  EXPECT_GT(flat.make_Delaunay(), 1000000u);
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

TEST(Near_degenerate, thin_faces)
{
  for(double width : traced({1e-1, 1e-3, 1e-6, 1e-9, 1e-12})) {
    check(thin_faces(width));
    EXPECT_GT(check(cap(width)), 0u);
  }
}

TEST(Near_degenerate, fans)
{
  for(double flatness : traced({1., 1e-2, 1e-5}))
    for(std::size_t corners : traced({5u, 50u, 500u}))
      check(fan(corners, flatness));
}

TEST(Near_degenerate, stretched)
{
  for(double factor : traced({1e-5, 1e-3, 1e3, 1e5}))
    for(const Named_mesh& m : traced(meshes()))
      check(stretched(perturbed(m.mesh, 0.02, 1), factor));
}

TEST(Near_degenerate, near_coincident_vertices)
{
  for(double distance : {1e-3, 1e-6, 1e-9, 1e-12})
    for(const Named_mesh& m : meshes()) {
      SCOPED_TRACE(m.name + ", " + std::to_string(-std::log10(distance)) + " digits");
      check(with_near_coincident_vertices(m.mesh, distance, 1));
    }
}

} // namespace Test_high_degree
