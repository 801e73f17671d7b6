// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "equality.h"
#include "near_degenerate_meshes.h"
#include "refinement_checks.h"
#include "subdivision_checks.h"

#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

namespace Test_near_degenerate {

using namespace Test_surfaces;

constexpr unsigned int number_of_meshes = 1200;

// Returns the greatest change of the area of a triangle with its lengths, if these are certain up
// to `u` of their sum.
Real uncertainty_of_area(std::array<Real, 3> l, Real u)
{
  const auto squared_area = [&](Real error) {
    const Real sum = l[0] + l[1] + l[2];
    Real product = sum / 16;
    for(Real side : l)
      product *= (std::max)(sum - 2 * side + error * sum, Real(0));
    return product;
  };
  return std::sqrt(squared_area(u)) - std::sqrt(squared_area(-u));
}

Real uncertainty_of_area(const Flat_faces& faces, Real u)
{
  Real sum = 0;
  for(Face_index f : faces.mesh().faces()) {
    std::array<Real, 3> l;
    for(std::size_t s = 0; s < 3; ++s)
      l[s] = faces.length(faces.sides(f)[s]);
    sum += uncertainty_of_area(l, u);
  }
  return sum;
}

// Checks that the surface keeps its area. For a cap as low as 1e-8 of its side, the lengths have
// lost half of the digits.
void check_area(const Triangulation& t)
{
  const Flat_faces input(Side::input, t), intrinsic(Side::intrinsic, t);
  const Real u = IT::rounding_unit<double>();
  const Real tolerance = uncertainty_of_area(input, u) + uncertainty_of_area(intrinsic, u);
  EXPECT_NEAR(double(intrinsic.area() / input.area()), 1, double(tolerance / input.area()));
}

void check_subdivision(const Triangulation& t)
{
  const Correspondence c(t);
  const Subdivision s(c);
  check_areas(s, c, 1e-9);
  check_pieces(s, c);
}

// Checks that short edges of T2 across long needles keep all their digits. The lengths of T1 are
// equal numbers in both precisions, but every rounding error is 2000 times smaller in the longer
// one.
void check_recomputed_lengths(const Mesh& mesh)
{
  Triangulation t(mesh);
  IT::make_Delaunay(t);
  t.recompute_lengths();
  const IT::internal::Edge_courses courses(t, IT::Concurrency());
  Delta_complex input(t.input_mesh());
  const auto length = input.add_property_map<Edge_index, Real>("e:long_length").first;
  for(Edge_index e : input.edges())
    length[e] = t.input_length(e);
  IT::Euclidean_strip<Real> strip;
  for(Edge_index e : t.mesh().edges()) {
    const IT::Edge_course course = courses(IT::first_halfedge(e));
    if(course.empty())
      continue;
    IT::internal::lay_out_strip(strip, IT::Surface_view(input, length), course);
    EXPECT_NEAR(double(t.length(e) / strip.length()), 1, 4e-15 * double(course.size() + 1));
  }
}

void check_Delaunay(const Mesh& mesh)
{
  Triangulation t(mesh);
  std::size_t flips = IT::make_Delaunay(t);
  expect_Delaunay(t);
  flips += IT::make_Delaunay(t, IT::parameters::exact_decisions(true));
  EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
  ASSERT_TRUE(t.is_valid(true));
  check_area(t);
  check_subdivision(t);
  EXPECT_EQ(flip_to_input(t) > 0, flips > 0);
  expect_equal_to_input(t);
}

// Checks that a remaining face without an excuse has no area, as far as its lengths determine it: a
// vertex lies on the boundary by rounding.
void check_remaining(const Triangulation& t, const IT::Refinement_result& result)
{
  for(const IT::Remaining_face& r : result.remaining)
    if(r.reason == IT::Remaining_reason::no_room) {
      const Halfedge_index h = t.mesh().halfedge(r.face);
      const auto length = [&](Halfedge_index x) { return t.length(t.mesh().edge(x)); };
      const double a = length(h), b = length(t.mesh().next(h)), c = length(t.mesh().prev(h));
      EXPECT_LT(IT::quadrupled_area(a, b, c), 1e-7 * (a * a + b * b + c * c));
    }
}

// Checks a refinement with limited insertions, because thin tubes need more faces than a test has
// time for. Angles follow from rounded lengths. In needles, only a certificate can decide which
// edges are Delaunay.
IT::Refinement_status check_refinement(const Mesh& mesh)
{
  Triangulation t(mesh);
  const auto result =
    IT::refine(t, IT::parameters::maximum_number_of_insertions(std::size_t(1000)));
  EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
  EXPECT_TRUE(t.is_valid(true));
  check_angles(t, 25, result);
  check_remaining(t, result);
  const Correspondence c(t);
  const Subdivision s(c);
  EXPECT_TRUE(s.mesh().is_valid());
  EXPECT_EQ(Euler_characteristic(s.mesh()), Euler_characteristic(t.input_mesh()));
  return result.status;
}

template <typename Check>
void for_each_mesh(const Check& check, unsigned int number = number_of_meshes)
{
  for(const auto& [m, seed] : traced(number, near_degenerate_mesh))
    EXPECT_NO_THROW(check(m.mesh));
}

// The meshes have the properties that the generator promises.
TEST(Near_degenerate_meshes, are_valid_and_of_every_kind)
{
  std::set<std::pair<bool, std::int64_t>> kinds;
  for_each_mesh([&](const Mesh& mesh) {
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    EXPECT_TRUE(IT::is_valid_Delta_complex(mesh, true));
    EXPECT_GE(mesh.number_of_faces(), 30u);
    EXPECT_LE(mesh.number_of_faces(), 900u);
    const std::set<Point> places(mesh.points().begin(), mesh.points().end());
    EXPECT_EQ(places.size(), mesh.number_of_vertices());
    kinds.emplace(CGAL::is_closed(mesh), Euler_characteristic(mesh));
  });
  for(std::int64_t genus = 0; genus <= 6; ++genus)
    EXPECT_TRUE(kinds.count({true, 2 - 2 * genus})) << genus;
  for(std::int64_t genus = 0; genus <= 3; ++genus)
    EXPECT_TRUE(kinds.count({false, 1 - 2 * genus})) << genus;
}

TEST(Near_degenerate_meshes, recomputed_lengths_of_needles)
{
  for(unsigned int seed = 0; seed < number_of_meshes; ++seed)
    if(const Named_mesh m = near_degenerate_mesh(seed); m.name == "needles") {
      SCOPED_TRACE(seed);
      check_recomputed_lengths(m.mesh);
    }
}

TEST(Near_degenerate_meshes, Delaunay_with_subdivision) { for_each_mesh(check_Delaunay); }

// Every face has 25 degrees, is excused by a small-angle vertex, or the limit was reached. The
// counts were measured: refinement of such meshes need not end.
TEST(Near_degenerate_meshes, refined_with_subdivision)
{
  std::map<IT::Refinement_status, unsigned int> count;
  for_each_mesh([&](const Mesh& mesh) { ++count[check_refinement(mesh)]; }, 480);
  for(const auto& [status, n] : count)
    std::cout << n << ' ' << to_string(status) << '\n';
  EXPECT_GE(count[IT::Refinement_status::bounds_met], 185u);
  EXPECT_GE(count[IT::Refinement_status::bounds_met_but_excused], 26u);
  EXPECT_LE(count[IT::Refinement_status::no_room], 2u);
}

} // namespace Test_near_degenerate
