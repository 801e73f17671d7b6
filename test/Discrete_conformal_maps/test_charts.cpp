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
    EXPECT_NEAR(low, 0, 1e-12);
    EXPECT_NEAR(high, 1, 1e-9);
  }
}

// Random convex polygons lie on top of each other.
TEST(Covered_area, is_that_of_exact_Boolean_operations)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, 1);
  for(std::size_t n = 1; n < 9; ++n)
    for(int trial = 0; trial < 5; ++trial) {
      std::vector<DCM::internal::Convex_polygon> polygons;
      Polygon_set expected;
      for(std::size_t i = 0; i < n; ++i) {
        std::vector<std::complex<double>> points;
        for(int k = 0; k < 5; ++k)
          points.emplace_back(coordinate(random), coordinate(random));
        polygons.push_back(DCM::internal::convex_hull(points));
        Polygon polygon;
        for(const auto& z : polygons.back())
          polygon.push_back(Exact::Point_2(z.real(), z.imag()));
        expected.join(polygon);
      }
      EXPECT_NEAR(DCM::internal::Covered_area(polygons)(), area(expected), 1e-12);
    }
}

} // namespace Test_charts
