// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/generators.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/Ideal_geometry_traits.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace Test_surfaces;
using IT::Diamond;
using Rational = CGAL::Exact_rational;
using Double_traits = IT::Ideal_geometry_traits<>;
using Exact_traits = IT::Ideal_geometry_traits<Rational>;

// ---- The light cone ----

// The light-like vector w^2 (1 - p^2, 2p, 1 + p^2). Every ray of the light cone but one is that of a p, in
// this order, and -<q,r>/2 is a square: Penner lengths are rational.
struct Ideal_point
{
  Rational p, w;

  std::array<Rational, 3> vector() const
  {
    return {w * w * (1 - p * p), 2 * w * w * p, w * w * (1 + p * p)};
  }
  friend Rational length(const Ideal_point& a, const Ideal_point& b)
  {
    return a.w * b.w * (a.p < b.p ? Rational(b.p - a.p) : Rational(a.p - b.p));
  }
};

using Vector_3 = std::array<Rational, 3>;

Vector_3 between(const Ideal_point& a, const Ideal_point& b, const Rational& t)
{
  const Vector_3 v = a.vector(), w = b.vector();
  return {(1 - t) * v[0] + t * w[0], (1 - t) * v[1] + t * w[1], (1 - t) * v[2] + t * w[2]};
}

Vector_3 scaled(const Rational& s, const Vector_3& v) { return {s * v[0], s * v[1], s * v[2]}; }

Rational determinant(const Vector_3& a, const Vector_3& b, const Vector_3& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Vector_3 difference(const Vector_3& a, const Vector_3& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Rational random_positive(CGAL::Random& random)
{
  return Rational(random.get_int(1, 1000)) / random.get_int(1, 1000);
}

// n points in order around the light cone
std::vector<Ideal_point> random_polygon(std::size_t n, CGAL::Random& random)
{
  std::vector<Ideal_point> result;
  Rational p = -random_positive(random);
  for(std::size_t i = 0; i < n; ++i) {
    result.push_back({p, random_positive(random)});
    p += random_positive(random);
  }
  return result;
}

// i, l, j, k in this order
Diamond<Rational> diamond(const std::vector<Ideal_point>& p)
{
  return {length(p[0], p[2]), length(p[2], p[3]), length(p[3], p[0]), length(p[0], p[1]),
          length(p[1], p[2])};
}

// ---- Single edges ----

TEST(Ideal_geometry, flip_is_exact_there_and_back)
{
  const Exact_traits traits;
  CGAL::Random random(1);
  for(int n = 0; n < 200; ++n) {
    const auto p = random_polygon(4, random);
    const Diamond<Rational> d = diamond(p);
    const Rational kl = traits.compute_flipped_length_object()(d);
    EXPECT_EQ(kl, length(p[1], p[3]));
    EXPECT_EQ(traits.compute_flipped_length_object()({kl, d.lj, d.jk, d.ki, d.il}), d.ij);
  }
}

// positive if the polyhedron with faces ijk and jil is strictly convex along ij: then the corner l is on the
// side of the plane ijk away from the origin
CGAL::Sign convexity(const std::vector<Ideal_point>& p)
{
  const Vector_3 i = p[0].vector(), l = p[1].vector(), j = p[2].vector(), k = p[3].vector();
  const auto side = [&](const Vector_3& x) {
    return determinant(difference(j, i), difference(k, i), difference(x, i));
  };
  return CGAL::sign(side({0, 0, 0})) * CGAL::sign(side(l)) < 0   ? CGAL::POSITIVE
         : CGAL::sign(side({0, 0, 0})) * CGAL::sign(side(l)) > 0 ? CGAL::NEGATIVE
                                                                 : CGAL::ZERO;
}

Diamond<double> to_double(const Diamond<Rational>& d)
{
  return {CGAL::to_double(d.ij), CGAL::to_double(d.jk), CGAL::to_double(d.ki),
          CGAL::to_double(d.il), CGAL::to_double(d.lj)};
}

TEST(Ideal_geometry, delaunay_is_convexity_in_the_light_cone)
{
  CGAL::Random random(2);
  std::array<int, 3> seen{};
  for(int n = 0; n < 2000; ++n) {
    const auto p = random_polygon(4, random);
    const CGAL::Sign sign = convexity(p);
    ++seen[static_cast<std::size_t>(sign + 1)];
    EXPECT_EQ(Exact_traits::Is_locally_Delaunay()(diamond(p)), sign != CGAL::NEGATIVE);
    EXPECT_EQ(Double_traits::Is_locally_Delaunay()(to_double(diamond(p))), sign != CGAL::NEGATIVE);
  }
  EXPECT_GT(seen[0], 100);
  EXPECT_GT(seen[2], 100);
}

// ---- Strips ----

// Points around the light cone, and a strip of triangles of them from the first to another one.
struct Strip_in_cone
{
  std::vector<Ideal_point> points;
  std::vector<bool> turns; // around the source
  std::size_t b;           // the points before are sources of inner edges, the others are targets

  Strip_in_cone(std::size_t number_of_turns, CGAL::Random& random)
  {
    b = 2;
    for(std::size_t m = 0; m < number_of_turns; ++m) {
      turns.push_back(random.get_bool());
      b += turns.back() ? 0 : 1;
    }
    points = random_polygon(number_of_turns + 4, random);
  }

  const Ideal_point& end() const { return points[b]; }

  // the ends of the inner edges
  std::vector<std::array<Ideal_point, 2>> inner_edges() const
  {
    std::size_t i = 1, j = points.size() - 1;
    std::vector<std::array<Ideal_point, 2>> result{{points[i], points[j]}};
    for(bool around_source : turns) {
      around_source ? --j : ++i;
      result.push_back({points[i], points[j]});
    }
    return result;
  }

  template <typename FT, typename Number>
  void lay_out(IT::Ideal_strip<FT>& strip, const Number& number) const
  {
    const auto edges = inner_edges();
    const auto between = [&](const Ideal_point& x, const Ideal_point& y) {
      return FT(number(length(x, y)));
    };
    const auto& [i, j] = edges[0];
    strip.start(between(points[0], i), between(i, j), between(j, points[0]));
    for(std::size_t m = 0; m < turns.size(); ++m) {
      const auto& [s, t] = edges[m];
      const Ideal_point& l = edges[m + 1][turns[m] ? 1 : 0];
      if(turns[m])
        strip.turn_around_source(between(s, t), between(t, l), between(l, s));
      else
        strip.turn_around_target(between(s, t), between(t, l), between(l, s));
    }
    const auto& [s, t] = edges.back();
    strip.finish(between(s, t), between(t, end()), between(end(), s));
  }
};

TEST(Ideal_geometry, strip_is_that_in_the_light_cone)
{
  CGAL::Random random(3);
  IT::Ideal_strip<Rational> strip; // used again
  for(std::size_t n = 0; n < 60; ++n) {
    const Strip_in_cone cone(n % 20, random);
    cone.lay_out(strip, [](const Rational& x) { return x; });
    EXPECT_EQ(strip.length(), length(cone.points[0], cone.end()));
    const auto edges = cone.inner_edges();
    ASSERT_EQ(strip.size(), edges.size());
    for(std::size_t m = 0; m < edges.size(); ++m) {
      const auto c = strip.crossing(m);
      EXPECT_TRUE(c.along_line > 0 && c.along_line < 1 && c.along_edge > 0 && c.along_edge < 1);
      EXPECT_EQ(between(cone.points[0], cone.end(), c.along_line),
                scaled(c.scale, between(edges[m][0], edges[m][1], c.along_edge)));
      EXPECT_TRUE(m == 0 || strip.crossing(m - 1).along_line < c.along_line);
    }
  }
}

// Only positive terms: all numbers keep their digits, whatever the decoration.
TEST(Ideal_geometry, rounded_strip_keeps_its_digits)
{
  CGAL::Random random(4);
  IT::Ideal_strip<Rational> exact;
  IT::Ideal_strip<double> rounded;
  const auto expect_close = [](const Rational& x, double y, std::size_t n) {
    // in each triangle four roundings, half a unit in the last place each, and ten at the end
    EXPECT_NEAR(y / CGAL::to_double(x), 1, (10 + 4 * static_cast<double>(n)) * 2.3e-16);
  };
  for(std::size_t n = 0; n < 60; ++n) {
    Strip_in_cone cone(3 * n, random);
    for(Ideal_point& p : cone.points)
      p.w *= Rational(std::exp(random.get_double(-30, 30)));
    cone.lay_out(exact, [](const Rational& x) { return x; });
    cone.lay_out(rounded, [](const Rational& x) { return CGAL::to_double(x); });
    expect_close(exact.length(), rounded.length(), 3 * n);
    for(std::size_t m = 0; m < exact.size(); ++m) {
      expect_close(exact.crossing(m).along_line, rounded.crossing(m).along_line, 6 * n);
      expect_close(exact.crossing(m).along_edge, rounded.crossing(m).along_edge, 6 * n);
      expect_close(exact.crossing(m).scale, rounded.crossing(m).scale, 12 * n);
    }
  }
}

} // namespace
