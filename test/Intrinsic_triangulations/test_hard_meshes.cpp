// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tied_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/diagnose.h>

namespace Test_hard_meshes {

using namespace Test_surfaces;
using Rational = CGAL::Exact_rational;

// Returns the squared length by exact arithmetic on the positions.
Rational squared_length(Halfedge_index h, const Mesh& mesh)
{
  const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h));
  Rational sum(0);
  for(int k = 0; k < 3; ++k) {
    const Rational d = Rational(q[k]) - Rational(p[k]);
    sum += d * d;
  }
  return sum;
}

// Stores the sign and the square of the cotangent of the angle opposite to `h`, in a face with
// area.
struct Squared_cotangent
{
  CGAL::Sign sign;
  Rational square;

  Squared_cotangent(Halfedge_index h, const Mesh& mesh)
  {
    const Rational a = squared_length(h, mesh), b = squared_length(mesh.next(h), mesh),
                   c = squared_length(mesh.prev(h), mesh);
    const Rational product = b + c - a;
    sign = CGAL::sign(product);
    square = product * product / (4 * b * c - product * product);
  }
};

// Returns the sign of the sum of the cotangents opposite to an edge: positive if it is Delaunay,
// zero at a tie.
CGAL::Sign local_Delaunay_sign(Edge_index e, const Mesh& mesh)
{
  const Squared_cotangent k(mesh.halfedge(e), mesh), l(mesh.halfedge(e, 1), mesh);
  if(k.sign != -l.sign)
    return k.sign == CGAL::ZERO ? l.sign : k.sign;
  return k.sign * CGAL::compare(k.square, l.square);
}

double shortest_to_longest_edge(const Mesh& mesh)
{
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for(Edge_index e : mesh.edges()) {
    const double square =
      CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
    least = (std::min)(least, square);
    greatest = (std::max)(greatest, square);
  }
  return std::sqrt(least / greatest);
}

TEST(Hard_meshes, are_valid_and_of_every_kind)
{
  std::set<std::pair<bool, std::int64_t>> kinds;
  for(std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto [name, mesh] = hard_mesh(seed);
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    EXPECT_GE(mesh.number_of_faces(), 20u);
    EXPECT_LE(mesh.number_of_faces(), 3000u);
    EXPECT_TRUE(all_are_apart(mesh));
    EXPECT_TRUE(IT::diagnose(mesh).is_valid());
    EXPECT_NO_THROW(Triangulation{mesh});
    kinds.emplace(CGAL::is_closed(mesh), Euler_characteristic(mesh));
  }
  for(std::int64_t genus = 0; genus <= 2; ++genus) {
    EXPECT_TRUE(kinds.count({true, 2 - 2 * genus})) << genus;
    EXPECT_TRUE(kinds.count({false, 1 - 2 * genus})) << genus;
  }
}

TEST(Hard_meshes, are_as_bad_as_promised)
{
  std::set<std::string> names_with_short_edges, names_without_area;
  for(std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto [name, mesh] = hard_mesh(seed);
    if(shortest_to_longest_edge(mesh) < 1e-14)
      names_with_short_edges.insert(name);
    if(IT::diagnose(mesh).count(IT::Defect_kind::DEGENERATE_FACE) > 0)
      names_without_area.insert(name);
  }
  EXPECT_GE(names_with_short_edges.size(), 8u);
  EXPECT_TRUE(names_without_area.count("flat faces"));
  EXPECT_TRUE(names_without_area.count("sliced polygons"));
}

TEST(Hard_meshes, depend_on_the_seed_alone)
{
  EXPECT_EQ(Portable_random(7).get_int(0, 1 << 30), Portable_random(7).get_int(0, 1 << 30));
  Portable_random random(5489); // the first number of a std::mt19937_64 with this seed is known
  EXPECT_EQ(random.get_double(0, 1), std::ldexp(double(14514284786278117030u >> 11), -53));
  for(std::uint64_t seed : {0u, 500u, 999u}) {
    const Mesh a = hard_mesh(seed).mesh, b = hard_mesh(seed).mesh;
    EXPECT_TRUE(
      std::equal(a.points().begin(), a.points().end(), b.points().begin(), b.points().end()));
  }
}

TEST(Tied_meshes, are_Delaunay_with_the_ties_constructed)
{
  for(std::uint64_t seed = 0; seed < 210; ++seed) {
    const auto [name, mesh, ties] = tied_mesh(seed);
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    std::size_t count = 0;
    for(Edge_index e : mesh.edges())
      if(!mesh.is_border(e)) {
        const CGAL::Sign sign = local_Delaunay_sign(e, mesh);
        EXPECT_NE(sign, CGAL::NEGATIVE) << e;
        count += sign == CGAL::ZERO;
      }
    EXPECT_EQ(count, ties);
  }
}

TEST(Tied_meshes, integer_axes_are_perpendicular_and_equally_long)
{
  Portable_random random(1);
  for(int i = 0; i < 1000; ++i) {
    const auto axes = random_axes(100, random);
    EXPECT_EQ(dot(axes[0], axes[1]), 0);
    EXPECT_EQ(dot(axes[1], axes[2]), 0);
    EXPECT_EQ(dot(axes[2], axes[0]), 0);
    EXPECT_EQ(dot(axes[0], axes[0]), dot(axes[1], axes[1]));
    EXPECT_EQ(dot(axes[0], axes[0]), dot(axes[2], axes[2]));
  }
}

TEST(Tied_meshes, circle_has_all_its_points)
{
  EXPECT_EQ(points_on_circle(5).size(), 12u);
  EXPECT_EQ(points_on_circle(1105).size(), 108u);
}

// Rectangles are ties, but the rounded squares of some of their sides contradict this.
TEST(Tied_meshes, rectangles_have_thirty_bits)
{
  Portable_random random(2);
  double greatest = 0;
  int misleading = 0;
  for(int i = 0; i < 300; ++i) {
    const Mesh mesh = exact_rectangle(random).mesh;
    const auto square = [&](int p, int q) {
      return CGAL::squared_distance(mesh.point(Vertex_index(static_cast<unsigned>(p))),
                                    mesh.point(Vertex_index(static_cast<unsigned>(q))));
    };
    misleading += square(0, 1) + square(1, 2) != square(0, 2);
    for(const Point& p : mesh.points())
      for(int k = 0; k < 3; ++k)
        greatest = (std::max)(greatest, std::abs(p[k]));
  }
  EXPECT_GT(greatest, std::ldexp(1., 26));
  EXPECT_LT(greatest, std::ldexp(1., 30));
  EXPECT_GT(misleading, 0);
}

} // namespace Test_hard_meshes
