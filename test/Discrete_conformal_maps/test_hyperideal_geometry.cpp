// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/generators.h"

#include <CGAL/Intrinsic_triangulations/Hyperideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace Test_hyperideal_geometry {

using namespace Test_surfaces;
using Real_50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                              boost::multiprecision::et_off>;
template <typename FT>
using Edge = IT::Decorated_length<FT>;
template <typename FT>
using Traits = IT::Hyperideal_geometry_traits<FT>;
template <typename FT>
using Diamond = IT::Diamond<Edge<FT>>;

// ---- Vectors of R^{2,1} ----

// Represents the vector s (cos a, sin a, cos b), which is orthogonal to a geodesic of the
// hyperbolic plane with the ends a - b and a + b. For b = 0 it is light-like.
struct Circle
{
  Real_50 s, a, b;

  Real_50 radius() const { return s * sin(b); }
  std::array<Real_50, 3> vector() const { return {s * cos(a), s * sin(a), s * cos(b)}; }
};

template <typename FT>
Edge<FT> edge(const Circle& v, const Circle& w)
{
  const Real_50 square = 2 * v.s * w.s * (cos(v.b + w.b) - cos(v.a - w.a));
  return {FT(sqrt(square > 0 ? square : Real_50(0))), FT(v.radius()), FT(w.radius())};
}

Real_50 determinant(const Circle& x, const Circle& y, const Circle& z)
{
  const auto [a, b, c] = std::array{x.vector(), y.vector(), z.vector()};
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Returns `n` circles in counterclockwise order that do not meet. Some have radius zero.
std::vector<Circle> random_circles(std::size_t n, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> gap(2 * n);
  double sum = 0;
  for(double& g : gap)
    sum += g = unit(random) + 1e-3;
  std::vector<Circle> result;
  double at = 0;
  for(std::size_t i = 0; i < n; ++i) {
    const double width = unit(random) < 0.3 ? 0 : gap[2 * i];
    const Real_50 turn = 2 * boost::math::constants::pi<Real_50>() / sum;
    result.push_back(
      {Real_50(std::exp(4 * unit(random) - 2)), turn * (at + width / 2), turn * width / 2});
    at += gap[2 * i] + gap[2 * i + 1];
  }
  return result;
}

// Returns the diamond, in which i and j are opposite to each other.
template <typename FT>
Diamond<FT> diamond(const Circle& i, const Circle& l, const Circle& j, const Circle& k)
{
  return {edge<FT>(i, j), edge<FT>(j, k), edge<FT>(k, i), edge<FT>(i, l), edge<FT>(l, j)};
}

template <typename FT>
double relative_error(const FT& x, const Real_50& truth)
{
  return static_cast<double>(abs(Real_50(x) / truth - 1));
}

template <typename FT>
FT flipped(const Diamond<FT>& d)
{
  return Traits<FT>().compute_flipped_length_object()(d);
}

TEST(Hyperideal_geometry, a_flip_keeps_the_vectors_of_four_circles)
{
  std::mt19937 random(1);
  for(int trial = 0; trial < 500; ++trial) {
    const auto v = random_circles(4, random);
    const Real_50 truth = edge<Real_50>(v[3], v[1]).tangent;
    const auto d = diamond<double>(v[0], v[1], v[2], v[3]);
    EXPECT_LT(relative_error(flipped(diamond<Real_50>(v[0], v[1], v[2], v[3])), truth), 1e-40);
    EXPECT_LT(relative_error(flipped(d), truth), 3e-14) << trial;
  }
}

TEST(Hyperideal_geometry, the_condition_is_the_convexity_of_the_polyhedron)
{
  // In the span of four vectors, the affine hulls of ijk and jil meet along ij. The polyhedron is
  // convex if the origin and the other apex are on different sides, which four determinants decide.
  std::mt19937 random(2);
  const Traits<double> traits;
  for(int trial = 0; trial < 500; ++trial) {
    const auto v = random_circles(4, random);
    const Circle &i = v[0], &l = v[1], &j = v[2], &k = v[3];
    const Real_50 above = determinant(i, l, j) + determinant(i, j, k),
                  below = determinant(l, j, k) + determinant(l, k, i);
    if(abs(above / below - 1) < 1e-9)
      continue;
    EXPECT_EQ(traits.is_locally_Delaunay_object()(diamond<double>(i, l, j, k)), above < below)
      << trial;
  }
}

TEST(Hyperideal_geometry, an_edge_that_was_flipped_is_not_flipped_back)
{
  std::mt19937 random(3);
  const Traits<double> traits;
  for(int trial = 0; trial < 50; ++trial) {
    const auto v = random_circles(4, random);
    auto d = diamond<double>(v[0], v[1], v[2], v[3]);
    // Close to a tie, the apex moves along its ray.
    auto at = [&](double factor) {
      auto moved = v;
      moved[3].s *= factor;
      return diamond<double>(moved[0], moved[1], moved[2], moved[3]);
    };
    double low = 1e-6, high = 1e6;
    if(traits.is_locally_Delaunay_object()(at(low)) ==
       traits.is_locally_Delaunay_object()(at(high)))
      continue;
    const bool at_low = traits.is_locally_Delaunay_object()(at(low));
    for(int step = 0; step < 60; ++step) {
      const double middle = std::sqrt(low * high);
      (traits.is_locally_Delaunay_object()(at(middle)) == at_low ? low : high) = middle;
    }
    d = at(at_low ? high : low);
    ASSERT_FALSE(traits.is_locally_Delaunay_object()(d));
    const Edge<double> kl{flipped(d), d.ki.source_radius, d.lj.source_radius};
    EXPECT_TRUE(traits.is_locally_Delaunay_object()({kl, d.lj, d.jk, d.ki, d.il})) << trial;
    EXPECT_NEAR(flipped<double>({kl, d.lj, d.jk, d.ki, d.il}) / d.ij.tangent, 1, 1e-10);
  }
}

TEST(Hyperideal_geometry, flips_commute_with_scaling)
{
  std::mt19937 random(4);
  for(int trial = 0; trial < 300; ++trial) {
    const auto v = random_circles(4, random);
    auto scaled = v;
    for(Circle& c : scaled)
      c.s *= std::exp(std::uniform_real_distribution<double>(-3, 3)(random));
    const auto d = diamond<double>(v[0], v[1], v[2], v[3]),
               e = diamond<double>(scaled[0], scaled[1], scaled[2], scaled[3]);
    const double factor =
      static_cast<double>(sqrt(Real_50(scaled[1].s * scaled[3].s / (v[1].s * v[3].s))));
    EXPECT_NEAR(flipped(e) / (factor * flipped(d)), 1, 1e-13) << trial;
  }
}

TEST(Hyperideal_geometry, without_radii_a_flip_is_Ptolemys_relation)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> length(0.1, 10);
  const Traits<double> traits;
  const IT::Ideal_geometry_traits<> ideal;
  for(int trial = 0; trial < 500; ++trial) {
    const IT::Diamond<double> d{length(random), length(random), length(random), length(random),
                                length(random)};
    const Diamond<double> e{{d.ij, 0, 0}, {d.jk, 0, 0}, {d.ki, 0, 0}, {d.il, 0, 0}, {d.lj, 0, 0}};
    EXPECT_NEAR(flipped(e) / ideal.compute_flipped_length_object()(d), 1, 1e-14);
    EXPECT_EQ(traits.compute_flipped_length_object()(d), ideal.compute_flipped_length_object()(d));
    EXPECT_EQ(traits.is_locally_Delaunay_object()(e), ideal.is_locally_Delaunay_object()(d));
  }
}

TEST(Hyperideal_geometry, circles_that_touch_keep_their_edge)
{
  const Traits<double> traits;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> positive(1e-3, 10);
  for(int trial = 0; trial < 300; ++trial) {
    const double i = positive(random), j = positive(random), k = positive(random),
                 l = positive(random);
    const Diamond<double> d{{0, i, j},
                            {positive(random), j, k},
                            {positive(random), k, i},
                            {positive(random), i, l},
                            {positive(random), l, j}};
    EXPECT_TRUE(traits.is_locally_Delaunay_object()(d));
    EXPECT_FALSE(traits.is_convex_object()(d));
  }
}

// ---- Strips ----

// Represents a strip from circle 0 to the middle one, through the polygon whose corners are all
// circles.
struct Polygon_strip
{
  std::vector<Circle> v;
  std::size_t b = v.size() / 2;
  std::vector<std::array<std::size_t, 2>> exits; // the source is on the right, the target left

  template <typename Strip>
  void lay_out(Strip& strip, std::mt19937& random)
  {
    const auto length = [&](std::size_t x, std::size_t y) { return edge<double>(v[x], v[y]); };
    std::size_t i = 1, j = v.size() - 1;
    exits = {{i, j}};
    strip.start(length(0, i), length(i, j), length(j, 0));
    while(i + 1 < b || j > b + 1) {
      const bool around_source = i + 1 == b || (j > b + 1 && random() % 2 == 0);
      const std::size_t l = around_source ? j - 1 : i + 1;
      if(around_source)
        strip.turn_around_source(length(j, i), length(l, j), length(i, l));
      else
        strip.turn_around_target(length(j, i), length(l, j), length(i, l));
      (around_source ? j : i) = l;
      exits.push_back({i, j});
    }
    strip.finish(length(j, i), length(b, j), length(i, b));
  }
};

TEST(Hyperideal_geometry, crossings_in_strips_are_those_of_the_vectors)
{
  std::mt19937 random(7);
  IT::Hyperideal_strip<double> strip;
  for(int trial = 0; trial < 300; ++trial) {
    Polygon_strip polygon{random_circles(4 + random() % 12, random), {}, {}};
    polygon.b = polygon.v.size() / 2;
    polygon.lay_out(strip, random);
    const Circle &a = polygon.v[0], &b = polygon.v[polygon.b];
    EXPECT_LT(relative_error(strip.length(), edge<Real_50>(a, b).tangent), 1e-11);
    ASSERT_EQ(strip.size(), polygon.exits.size());
    for(std::size_t m = 0; m < strip.size(); ++m) {
      const Circle &i = polygon.v[polygon.exits[m][0]], &j = polygon.v[polygon.exits[m][1]];
      const Real_50 at_a = abs(determinant(b, i, j)), at_b = abs(determinant(a, i, j)),
                    at_i = abs(determinant(a, b, j)), at_j = abs(determinant(a, b, i));
      const auto crossing = strip.crossing(m);
      EXPECT_LT(relative_error(crossing.along_line, at_b / (at_a + at_b)), 1e-11);
      EXPECT_LT(relative_error(crossing.along_edge, at_j / (at_i + at_j)), 1e-11);
      EXPECT_LT(relative_error(crossing.scale, (at_i + at_j) / (at_a + at_b)), 1e-11);
    }
  }
}

// ---- Triangulations ----

TEST(Hyperideal_geometry, a_surface_has_one_Delaunay_triangulation_from_all_flips)
{
  using Triangulation = IT::Intrinsic_triangulation<Traits<double>>;
  for(unsigned int seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(0.2, 2), radius(0.1, 1);
    const Mesh mesh = embedded_torus(4, 5);
    std::vector<double> tangent, radii;
    for(std::size_t e = 0; e < mesh.num_edges(); ++e)
      tangent.push_back(number(random));
    for(std::size_t v = 0; v < mesh.num_vertices(); ++v)
      radii.push_back(v % 3 == 0 ? 0 : radius(random));
    Triangulation tri(
      mesh, IT::parameters::edge_length_map(boost::make_function_property_map<Mesh::Edge_index>(
                                              [&](Mesh::Edge_index e) { return tangent[e.idx()]; }))
              .geom_traits(Traits<double>(radii)));
    IT::make_Delaunay(tri);
    ASSERT_TRUE(IT::is_Delaunay(tri));
    EXPECT_TRUE(tri.is_valid());
    std::vector<double> before, after;
    for(IT::Edge_index e : tri.mesh().edges())
      before.push_back(tri.length(e));
    for(int flip = 0; flip < 60; ++flip) {
      const IT::Halfedge_index h(
        static_cast<IT::Delta_complex::size_type>(random() % tri.mesh().num_halfedges()));
      if(tri.is_flippable(h))
        tri.flip(h);
    }
    IT::make_Delaunay(tri);
    for(IT::Edge_index e : tri.mesh().edges())
      after.push_back(tri.length(e));
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    for(std::size_t e = 0; e < before.size(); ++e)
      EXPECT_NEAR(after[e] / before[e], 1, 1e-10) << seed;
  }
}

} // namespace Test_hyperideal_geometry
