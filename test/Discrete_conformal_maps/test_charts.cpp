// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The charts overlap in the plane, or do not.

#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/charts.h>
#include <CGAL/Discrete_conformal_maps/common_subdivision_mesh.h>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

namespace Test_charts {

using namespace Test_surfaces;
typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;
typedef CGAL::Polygon_2<Exact> Polygon;
typedef CGAL::Polygon_set_2<Exact> Polygon_set;
typedef std::array<double, 2> Point_in_plane;

// Returns the faces of the common subdivision in the plane, as triangles.
std::vector<Polygon> triangles(const Planar_conformal_map& map, const Mesh& input)
{
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_in_plane>("h:uv").first;
  DCM::common_subdivision(
    map, mesh, DCM::parameters::input_point_map(input.points()).texture_coordinates_map(uv));
  std::vector<Polygon> result;
  for(Face_index f : mesh.faces()) {
    std::vector<Exact::Point_2> corner;
    for(Halfedge_index h : halfedges_around_face(mesh.halfedge(f), mesh))
      corner.emplace_back(uv[h][0], uv[h][1]);
    for(std::size_t n = 2; n < corner.size(); ++n)
      if(CGAL::orientation(corner[0], corner[n - 1], corner[n]) == CGAL::LEFT_TURN) {
        const std::array<Exact::Point_2, 3> t{corner[0], corner[n - 1], corner[n]};
        result.emplace_back(t.begin(), t.end());
      }
  }
  return result;
}

double area(const Polygon_set& set)
{
  std::vector<CGAL::Polygon_with_holes_2<Exact>> parts;
  set.polygons_with_holes(std::back_inserter(parts));
  Exact::FT sum = 0;
  for(const auto& part : parts) {
    sum += part.outer_boundary().area();
    for(auto hole = part.holes_begin(); hole != part.holes_end(); ++hole)
      sum += hole->area();
  }
  return CGAL::to_double(sum);
}

// Returns the exact intersection of two convex polygons.
Polygon common_part(Polygon a, const Polygon& b)
{
  for(auto side = b.edges_begin(); side != b.edges_end() && !a.is_empty(); ++side) {
    const Exact::Line_2 line = side->supporting_line();
    Polygon clipped;
    for(std::size_t n = 0; n < a.size(); ++n) {
      const Exact::Point_2 &p = a[n], &q = a[(n + 1) % a.size()];
      const Exact::FT at_p = line.a() * p.x() + line.b() * p.y() + line.c(),
                      at_q = line.a() * q.x() + line.b() * q.y() + line.c();
      if(at_p >= 0)
        clipped.push_back(p);
      if(at_p * at_q < 0)
        clipped.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    a = clipped;
  }
  return a;
}

// Returns the exact area: the intersections of pairs of triangles are joined.
double multiply_covered_area(const std::vector<Polygon>& triangles)
{
  std::vector<Polygon> common;
  for(std::size_t i = 0; i < triangles.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(CGAL::do_overlap(triangles[i].bbox(), triangles[j].bbox()))
        if(const Polygon p = common_part(triangles[i], triangles[j]); p.size() > 2 && p.area() > 0)
          common.push_back(p);
  Polygon_set result;
  result.join(common.begin(), common.end());
  return area(result);
}

// Returns a strip of the plane along a spiral on a cone, with n steps of a turn by `angle` each.
// Flattened without scaling, it overlaps itself if it turns more than once.
Mesh winding_strip(std::size_t n, double angle)
{
  Mesh mesh;
  for(std::size_t i = 0; i <= n; ++i)
    for(const double r : {1., 1.5}) {
      const double s = angle * double(i);
      mesh.add_vertex(Point(r * std::cos(s), r * std::sin(s), 0.1 * double(i)));
    }
  for(std::size_t i = 0; i < n; ++i) {
    const auto v = [&](std::size_t k) { return Vertex_index(Mesh::size_type(2 * i + k)); };
    mesh.add_face(v(0), v(1), v(3));
    mesh.add_face(v(0), v(3), v(2));
  }
  return mesh;
}

std::vector<Mesh> surfaces()
{
  return {winding_strip(20, 0.2), winding_strip(30, 0.3),
          winding_strip(45, 0.3), punctured(random_sphere(60, 3), {0, 30, 50}),
          random_sphere(40, 8),   embedded_torus(7, 5)};
}

TEST(Charts, overlap_is_that_of_exact_Boolean_operations)
{
  bool has_overlap = false;
  for(const Mesh& mesh : surfaces()) {
    const Planar_conformal_map map = DCM::flatten(mesh, DCM::parameters::maximum_log_scale(1.));
    ASSERT_TRUE(map.is_laid_out());
    const DCM::Chart_overlap overlap = DCM::find_overlap(map);
    EXPECT_NEAR(overlap.area, multiply_covered_area(triangles(map, mesh)), 1e-7);
    EXPECT_EQ(overlap.area > 0, !overlap.charts.empty());
    has_overlap |= overlap.area > 0.01;
  }
  EXPECT_TRUE(has_overlap);
}

// Maps cannot be copied, so each is computed twice, with its unchanged layout, too.
TEST(Charts, are_cut_where_they_overlap)
{
  for(const Mesh& mesh : surfaces()) {
    Planar_conformal_map map = DCM::flatten(mesh, DCM::parameters::maximum_log_scale(1.));
    const DCM::Chart_overlap before = DCM::find_overlap(map);
    std::vector<double> length;
    const auto& complex = map.ideal().mesh();
    const auto side = [&](Halfedge_index h) {
      return std::abs(map.position(complex.next(h)) - map.position(h));
    };
    for(Halfedge_index h : complex.halfedges())
      length.push_back(map.is_laid_out(complex.face(h)) ? side(h) : 0);
    const std::size_t charts = DCM::cut_overlaps(map);
    const DCM::Chart_overlap after = DCM::find_overlap(map);
    EXPECT_EQ(after.area, 0);
    EXPECT_TRUE(after.charts.empty());
    EXPECT_EQ(after.number_of_charts, charts);
    EXPECT_EQ(charts > before.number_of_charts, before.area > 0);
    EXPECT_NEAR(multiply_covered_area(triangles(map, mesh)), 0, 1e-9);
    const std::vector<std::size_t> chart = DCM::charts_of_faces(map);
    for(Halfedge_index h : complex.halfedges())
      if(map.is_laid_out(complex.face(h))) {
        EXPECT_NEAR(side(h), length[h.idx()], 1e-9);
        if(!map.is_seam(complex.edge(h))) {
          EXPECT_EQ(chart[complex.face(h).idx()], chart[complex.face(complex.opposite(h)).idx()]);
          EXPECT_EQ(map.position(h), map.position(complex.next(complex.opposite(h))));
        }
      }
  }
}

TEST(Charts, fit_into_the_unit_square)
{
  for(const Mesh& mesh : surfaces()) {
    Planar_conformal_map map = DCM::flatten(mesh, DCM::parameters::maximum_log_scale(1.));
    const double overlap = DCM::find_overlap(map).area, factor = DCM::fit_into_unit_square(map);
    EXPECT_NEAR(DCM::find_overlap(map).area, overlap * factor * factor, 1e-9);
    double low = 1, high = 0;
    for(const Polygon& t : triangles(map, mesh))
      for(const Exact::Point_2& p : t.container())
        for(const double x : {CGAL::to_double(p.x()), CGAL::to_double(p.y())}) {
          low = (std::min)(low, x);
          high = (std::max)(high, x);
        }
    EXPECT_GE(low, 0);
    EXPECT_NEAR(low, 0, 1e-12);
    EXPECT_LE(high, 1);
    EXPECT_NEAR(high, 1, 1e-9);
  }
}

// Compares the area that at least two convex polygons cover with exact Boolean operations.
void compare_multiply_covered_area(const std::vector<std::vector<std::complex<double>>>& points)
{
  std::vector<DCM::internal::Convex_polygon> polygons;
  std::vector<Polygon> exact;
  for(const auto& some : points) {
    polygons.push_back(DCM::internal::convex_hull(some));
    exact.emplace_back();
    for(const auto& z : polygons.back())
      exact.back().push_back(Exact::Point_2(z.real(), z.imag()));
  }
  std::vector<DCM::internal::Multiply_covered_area::Pair> pairs;
  Polygon_set expected;
  for(std::size_t i = 0; i < polygons.size(); ++i)
    for(std::size_t j = i + 1; j < polygons.size(); ++j) {
      Polygon_set both(exact[i]);
      both.intersection(exact[j]);
      expected.join(both);
      pairs.emplace_back(i, j);
    }
  EXPECT_NEAR(DCM::internal::Multiply_covered_area(polygons, pairs)(), area(expected), 1e-12);
}

// Returns the corners of polygons whose coordinates are random multiples of 1/`steps`.
std::vector<std::vector<std::complex<double>>> random_corners(std::size_t polygons, int steps,
                                                              std::mt19937& random)
{
  std::uniform_int_distribution<int> coordinate(0, steps);
  const auto part = [&] { return double(coordinate(random)) / steps; };
  std::vector<std::vector<std::complex<double>>> result(polygons);
  for(auto& points : result)
    while(points.size() < 5 || DCM::internal::convex_hull(points).size() < 3)
      points.emplace_back(part(), part());
  return result;
}

TEST(Multiply_covered_area, is_that_of_exact_Boolean_operations)
{
  std::mt19937 random(5);
  for(std::size_t n = 1; n < 9; ++n)
    for(int trial = 0; trial < 5; ++trial)
      compare_multiply_covered_area(random_corners(n, 1 << 20, random));
}

// On a coarse grid, many corners and sides coincide, and whole polygons.
TEST(Multiply_covered_area, of_polygons_with_common_corners_and_sides)
{
  std::mt19937 random(6);
  for(int steps : {1, 2, 3, 4})
    for(std::size_t n = 1; n < 12; ++n) {
      auto points = random_corners(n, steps, random);
      points.push_back(points[0]);
      compare_multiply_covered_area(points);
    }
}

// Polygons that differ by rounding errors have sides that are almost parallel.
TEST(Multiply_covered_area, of_almost_equal_polygons)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> units(-2, 2);
  for(std::size_t n = 2; n < 7; ++n) {
    std::vector<std::vector<std::complex<double>>> points(n, random_corners(1, 1 << 20, random)[0]);
    for(auto& polygon : points)
      for(std::complex<double>& z : polygon)
        z += std::complex<double>(units(random), units(random)) * 0x1p-52;
    compare_multiply_covered_area(points);
  }
}

// Triangles with corners on the unit circle overlap each other. The lines through their sides touch
// a circle of radius 1/2. A side leaves the k-th next triangle at tan(k a) / 2 from its middle,
// where 2 a is the angle between corners. It leaves all but one between k = n - 2 and n - 1.
TEST(Multiply_covered_area, of_many_triangles)
{
  const std::size_t n = 400;
  std::vector<DCM::internal::Convex_polygon> polygons;
  std::vector<DCM::internal::Multiply_covered_area::Pair> pairs;
  const double a = pi / double(3 * n);
  for(std::size_t i = 0; i < n; ++i) {
    polygons.emplace_back();
    for(int k = 0; k < 3; ++k)
      polygons.back().push_back(std::polar(1., 2 * a * double(i) + 2 * pi * k / 3));
    for(std::size_t j = 0; j < i; ++j)
      pairs.emplace_back(j, i);
  }
  EXPECT_NEAR(DCM::internal::Multiply_covered_area(polygons, pairs)(),
              0.75 * double(n) * (std::tan(double(n - 1) * a) - std::tan(double(n - 2) * a)),
              1e-11);
}

} // namespace Test_charts
