// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#if defined(CGAL_USE_CORE) || defined(CGAL_USE_LEDA)
#define HAS_EXACT_SQUARE_ROOTS
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#endif

#include <ostream>

namespace Test_traits {

using namespace Test_surfaces;
using IT::Diamond;
using Double_traits = IT::Euclidean_geometry_traits<>;

// ---- Quadrangles i l j k in the plane with integer coordinates, k on the left of ij ----

struct Quadrangle
{
  Vector i, j, k, l;

  bool is_proper() const { return det(j - i, k - i) > 0 && det(i - j, l - j) > 0; }
  bool is_convex() const { return det(l - k, i - k) < 0 && det(l - k, j - k) > 0; }

  bool has_straight_side() const { return det(l - k, i - k) == 0 || det(l - k, j - k) == 0; }

  // Returns a positive number if l is inside the circle through i, j, k. Entries up to 2^14 do not
  // overflow.
  std::int64_t in_circle() const
  {
    const Vector a = i - l, b = j - l, c = k - l;
    return dot(a, a) * det(b, c) + dot(b, b) * det(c, a) + dot(c, c) * det(a, b);
  }

  template <typename FT>
  Diamond<FT> lengths() const
  {
    const auto distance = [](const Vector& p, const Vector& q) {
      return FT(CGAL::sqrt(FT(static_cast<double>(dot(p - q, p - q)))));
    };
    return {distance(i, j), distance(j, k), distance(k, i), distance(i, l), distance(l, j)};
  }

  friend std::ostream& operator<<(std::ostream& out, const Quadrangle& q)
  {
    for(const Vector& v : {q.i, q.j, q.k, q.l})
      out << '(' << v.x << ' ' << v.y << ") ";
    return out;
  }

  Quadrangle flipped() const { return {l, k, i, j}; }
};

std::vector<Quadrangle> random_quadrangles(std::size_t n, int size, unsigned int seed)
{
  CGAL::Random random(seed);
  const auto point = [&] { return Vector{random.get_int(0, size), random.get_int(0, size)}; };
  std::vector<Quadrangle> result;
  while(result.size() < n) {
    const Quadrangle q{point(), point(), point(), point()};
    if(q.is_proper())
      result.push_back(q);
  }
  return result;
}

// Returns four points with integer coordinates on a circle of radius 65, whose distances are not
// all rational.
std::vector<Quadrangle> cocircular_quadrangles()
{
  const std::vector<Vector> circle{{65, 0},  {63, 16},  {56, 33},  {39, 52}, {25, 60},
                                   {0, 65},  {-33, 56}, {-60, 25}, {-65, 0}, {-52, -39},
                                   {0, -65}, {16, -63}, {33, -56}, {60, -25}};
  std::vector<Quadrangle> result;
  for(std::size_t a = 0; a < circle.size(); ++a)
    for(std::size_t b = a + 1; b < circle.size(); ++b)
      for(std::size_t c = b + 1; c < circle.size(); ++c)
        for(std::size_t d = c + 1; d < circle.size(); ++d)
          result.push_back({circle[a], circle[c], circle[d], circle[b]});
  return result;
}

template <typename Traits>
struct Decisions
{
  Traits traits;

  bool is_locally_Delaunay(const Quadrangle& q) const
  {
    return traits.is_locally_Delaunay_object()(q.lengths<typename Traits::FT>());
  }
  bool is_certain(const Quadrangle& q) const
  {
    return traits.is_locally_Delaunay_object().is_certain(q.lengths<typename Traits::FT>());
  }
  bool is_convex(const Quadrangle& q) const
  {
    return traits.is_convex_object()(q.lengths<typename Traits::FT>());
  }
  typename Traits::FT flipped_length(const Quadrangle& q) const
  {
    return traits.compute_flipped_length_object()(q.lengths<typename Traits::FT>());
  }
};

void check_double(const Quadrangle& q)
{
  const Decisions<Double_traits> decide;
  EXPECT_EQ(decide.is_locally_Delaunay(q), q.in_circle() <= 0);
  EXPECT_FALSE(decide.is_certain(q) && q.in_circle() >= 0);
  EXPECT_TRUE(q.has_straight_side() || decide.is_convex(q) == q.is_convex());
  EXPECT_NEAR(decide.flipped_length(q) / length(q.k - q.l), 1, 1e-6);
}

// ---- A traits class that offers no more than is asked for ----

struct Traits_archetype
{
  using FT = double;
  using Integer = std::int64_t;
  using Geodesic_strip = IT::Euclidean_strip<double>;

  // Returns the angle of the corner opposite to a, by the law of cosines.
  static double angle(double a, double b, double c)
  {
    return std::acos(std::clamp((b * b + c * c - a * a) / (2 * b * c), -1., 1.));
  }

  struct Flipped_length
  {
    double operator()(const Diamond<double>& d) const
    {
      const double at_i = angle(d.jk, d.ij, d.ki) + angle(d.lj, d.ij, d.il);
      return std::sqrt(d.ki * d.ki + d.il * d.il - 2 * d.ki * d.il * std::cos(at_i));
    }
  };
  struct Distance
  {
    // Computes Equation 3.7 literally.
    double operator()(const std::array<double, 3>& side, const std::array<double, 3>& p,
                      const std::array<double, 3>& q) const
    {
      double square = 0;
      for(std::size_t s = 0; s < 3; ++s)
        square -= side[s] * side[s] * (q[s] - p[s]) * (q[(s + 1) % 3] - p[(s + 1) % 3]);
      return std::sqrt(std::max(square, 0.));
    }
  };
  struct Locally_Delaunay
  {
    bool operator()(const Diamond<double>& d) const
    {
      return angle(d.ij, d.jk, d.ki) + angle(d.ij, d.lj, d.il) < std::acos(-1.) + 1e-7;
    }
    bool is_certain(const Diamond<double>&) const { return false; }
  };
  struct Convex
  {
    bool operator()(const Diamond<double>& d) const
    {
      return angle(d.jk, d.ij, d.ki) + angle(d.lj, d.ij, d.il) < pi - 1e-7 &&
             angle(d.ki, d.ij, d.jk) + angle(d.il, d.ij, d.lj) < pi - 1e-7;
    }
  };
  struct Length
  {
    bool operator()(double length) const { return length > 0 && std::isfinite(length); }
  };
  struct Triangle
  {
    bool operator()(double a, double b, double c) const
    {
      return a < b + c + 1e-9 && b < c + a + 1e-9 && c < a + b + 1e-9;
    }
  };

  Flipped_length compute_flipped_length_object() const { return {}; }
  Distance compute_distance_object() const { return {}; }
  Locally_Delaunay is_locally_Delaunay_object() const { return {}; }
  Convex is_convex_object() const { return {}; }
  Length is_length_object() const { return {}; }
  Triangle is_triangle_object() const { return {}; }
};

template <typename Traits_1, typename Traits_2>
void expect_same_combinatorics(const IT::Intrinsic_triangulation<Traits_1>& a,
                               const IT::Intrinsic_triangulation<Traits_2>& b)
{
  for(Halfedge_index h : a.mesh().halfedges()) {
    const Edge_index e = a.mesh().edge(h);
    EXPECT_EQ(a.mesh().next(h), b.mesh().next(h));
    EXPECT_EQ(a.mesh().target(h), b.mesh().target(h));
    EXPECT_EQ(a.coordinates().normal_coordinate(e), b.coordinates().normal_coordinate(e));
    EXPECT_EQ(a.coordinates().roundabout(h), b.coordinates().roundabout(h));
    EXPECT_NEAR(CGAL::to_double(a.length(e)), CGAL::to_double(b.length(e)), 1e-9);
  }
}

struct Metric
{
  std::string name;
  Delta_complex mesh;
  std::vector<double> lengths;
};

// Returns surfaces with lengths of type `double`, and some edges to flip.
std::vector<Metric> small_metrics()
{
  std::vector<Metric> result;
  for(const Named_complex& c : complexes())
    if(c.mesh.number_of_edges() < 20)
      for(unsigned int seed = 0; seed < 10; ++seed)
        result.push_back({c.name, c.mesh, random_lengths(c.mesh, seed)});
  for(int twists : {1, 2}) {
    const Flat_surface s = flat_cylinder(1, twists);
    result.push_back({"sheared annulus", s.mesh, s.lengths()});
  }
  return result;
}

template <typename Traits, typename Check>
void for_each_small_triangulation(const Check& check)
{
  std::size_t flips = 0;
  for(const auto& [name, mesh, lengths] : traced(small_metrics())) {
    auto t = triangulation<Traits>(mesh, lengths);
    auto reference = triangulation(mesh, lengths);
    check(t, reference);
    flips += IT::make_Delaunay(reference);
    IT::make_Delaunay(t);
    EXPECT_TRUE(IT::is_Delaunay(t) && t.is_valid(true));
    expect_same_combinatorics(reference, t);
    flip_to_input(t);
    EXPECT_TRUE(t.is_valid(true));
  }
  EXPECT_GT(flips, 5u);
}

// ---- Areas ----

using Rational = CGAL::Exact_rational;

// Returns (4 A)^2, exactly.
Rational squared_quadrupled_area(double a, double b, double c)
{
  const Rational x(a), y(b), z(c);
  return (x + y + z) * (y + z - x) * (z + x - y) * (x + y - z);
}

// Returns the relative error, in units in the last place.
double error_of_area(double a, double b, double c)
{
  const Rational exact = squared_quadrupled_area(a, b, c);
  const Rational computed(IT::quadrupled_area(a, b, c));
  const double error = CGAL::to_double((computed * computed - exact) / exact) / 2;
  return std::abs(error) / std::numeric_limits<double>::epsilon();
}

TEST(Euclidean_geometry_traits, double_agrees_with_integer_predicates)
{
  for(int size : {20, 100, 10000})
    for(const Quadrangle& q : random_quadrangles(3000, size, 1))
      check_double(q);
}

TEST(Euclidean_geometry_traits, double_keeps_cocircular_ties)
{
  const Decisions<Double_traits> decide;
  for(const Quadrangle& q : cocircular_quadrangles()) {
    ASSERT_TRUE(q.is_proper() && q.in_circle() == 0);
    EXPECT_TRUE(decide.is_locally_Delaunay(q));
    EXPECT_TRUE(decide.is_locally_Delaunay(q.flipped()));
    EXPECT_FALSE(decide.is_certain(q) || decide.is_certain(q.flipped()));
    EXPECT_TRUE(decide.is_convex(q));
  }
}

TEST(Euclidean_geometry_traits, double_is_certain_of_most_edges)
{
  const Decisions<Double_traits> decide;
  for(const Quadrangle& q : random_quadrangles(20000, 12, 3))
    EXPECT_EQ(decide.is_certain(q), q.in_circle() < 0) << q;
}

TEST(Euclidean_geometry_traits, double_is_not_certain_that_straight_sides_are_convex)
{
  const Decisions<Double_traits> decide;
  for(const Quadrangle& q : random_quadrangles(20000, 12, 2))
    EXPECT_FALSE(q.has_straight_side() && decide.is_convex(q)) << q;
}

TEST(Euclidean_geometry_traits, an_edge_and_its_flip_are_not_both_refused)
{
  const Double_traits traits;
  for(unsigned int seed = 0; seed < 3; ++seed)
    for(const Quadrangle& q : random_quadrangles(3000, 1 << (4 * seed + 3), seed)) {
      const Diamond<double> d = q.lengths<double>();
      const double kl = traits.compute_flipped_length_object()(d);
      EXPECT_TRUE(traits.is_locally_Delaunay_object()(d) ||
                  traits.is_locally_Delaunay_object()({kl, d.ki, d.il, d.lj, d.jk}));
    }
}

TEST(Euclidean_geometry_traits, diamonds_of_no_area)
{
  const Double_traits traits;
  const Diamond<double> cap{2, 1, 1, 1.5, 1.5};
  EXPECT_FALSE(traits.is_locally_Delaunay_object()(cap));
  EXPECT_TRUE(traits.is_convex_object()(cap));
  EXPECT_DOUBLE_EQ(traits.compute_flipped_length_object()(cap), std::sqrt(1.25));
  const Diamond<double> side_of_cap{1, 2, 1, 1, 1}; // the cap's apex is an end of the edge
  EXPECT_TRUE(traits.is_locally_Delaunay_object()(side_of_cap));
  EXPECT_FALSE(traits.is_convex_object()(side_of_cap));
  const Diamond<double> flat{2, 1, 1, 0.5, 1.5};
  EXPECT_FALSE(traits.is_locally_Delaunay_object()(flat));
  EXPECT_DOUBLE_EQ(traits.compute_flipped_length_object()(flat), 0.5);
}

TEST(Euclidean_geometry_traits, lengths_and_triangles)
{
  const Double_traits traits;
  const auto is_length = traits.is_length_object();
  for(double good : {1., 1e-30, 1e30})
    EXPECT_TRUE(is_length(good)) << good;
  for(double bad : {0., -1., 1e-80, 1e80, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(is_length(bad)) << bad;
  const auto is_triangle = traits.is_triangle_object();
  EXPECT_TRUE(is_triangle(3, 4, 5) && is_triangle(3, 4, 7) && is_triangle(7, 3, 4));
  EXPECT_TRUE(is_triangle(0.1, 0.2, 0.3) && is_triangle(0.1, 0.7, 0.8));
  EXPECT_FALSE(is_triangle(3, 4, 7.0000001) || is_triangle(7.0000001, 3, 4) ||
               is_triangle(1, 9, 2));
}

TEST(Euclidean_geometry_traits, area_of_needles_and_caps)
{
  CGAL::Random random(1);
  for(int i = 0; i < 5000; ++i) {
    const double a = random.get_double(0.5, 1), thin = std::pow(10., random.get_double(-14, 0));
    const double needle = a * (1 + thin * random.get_double(-0.9, 0.9));
    EXPECT_LT(error_of_area(a, needle, a * thin), 8);
    EXPECT_LT(error_of_area(a * thin, a, needle), 8);
    const double cap = random.get_double(0.1, 0.9) * a, rest = (a - cap) * (1 + thin);
    EXPECT_TRUE(squared_quadrupled_area(a, cap, rest) <= 0 || error_of_area(cap, a, rest) < 8);
  }
  EXPECT_EQ(IT::quadrupled_area(1., 2., 3.), 0);
  EXPECT_EQ(IT::quadrupled_area(0.1, 0.2, 0.1 + 0.2 + 1e-16), 0);
  EXPECT_DOUBLE_EQ(IT::quadrupled_area(3., 4., 5.), 24);
}

// All five lengths are exact in `double`, and k and l are on the line through i and j.
TEST(Euclidean_geometry_traits, a_short_edge_between_long_ones_keeps_its_digits)
{
  const Double_traits::Compute_flipped_length flipped_length;
  for(int digits : {10, 20, 26}) {
    const double unit = std::ldexp(1, -digits);
    EXPECT_EQ(flipped_length({1, 1 - 3 * unit, 3 * unit, 5 * unit, 1 - 5 * unit}), 2 * unit);
    EXPECT_EQ(flipped_length({unit, 1 - unit, 1, 1, 1 - unit}), 0);
    EXPECT_EQ(flipped_length({unit, 1 - unit, 1, 2, 2 - unit}), 1);
  }
}

TEST(Euclidean_geometry_traits, whole_triangulations_in_long_double)
{
  for_each_small_triangulation<IT::Euclidean_geometry_traits<long double>>(
    [](const auto& t, const auto& reference) {
      for(Halfedge_index h : t.mesh().halfedges())
        EXPECT_EQ(t.is_flippable(h), reference.is_flippable(h));
    });
}

TEST(Intrinsic_geometry_traits, archetype)
{
  for_each_small_triangulation<Traits_archetype>([](const auto& t, const auto& reference) {
    for(Halfedge_index h : t.mesh().halfedges())
      EXPECT_EQ(t.is_flippable(h), reference.is_flippable(h));
  });
  const Mesh mesh = octahedron();
  IT::Intrinsic_triangulation<Traits_archetype> t(
    mesh, CGAL::parameters::geom_traits(Traits_archetype()));
  EXPECT_EQ(IT::make_Delaunay(t), 0u);
}

#ifdef HAS_EXACT_SQUARE_ROOTS

using Exact = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;
using Exact_traits = IT::Euclidean_geometry_traits<Exact>;

TEST(Exact_geometry_traits, agrees_with_integer_predicates)
{
  const Decisions<Exact_traits> decide;
  for(const Quadrangle& q : random_quadrangles(40, 50, 5)) {
    EXPECT_EQ(decide.is_locally_Delaunay(q), q.in_circle() <= 0);
    EXPECT_EQ(decide.is_certain(q), q.in_circle() < 0);
    EXPECT_EQ(decide.is_convex(q), q.is_convex());
    EXPECT_NEAR(CGAL::to_double(decide.flipped_length(q)), length(q.k - q.l), 1e-9);
  }
}

TEST(Exact_geometry_traits, knows_ties_exactly)
{
  const Exact_traits traits;
  const auto is_Delaunay = traits.is_locally_Delaunay_object();
  for(int scale : {1, 7, 1000}) {
    const Exact a(3 * scale), b(4 * scale), c(5 * scale), tiny(1e-30);
    EXPECT_TRUE(is_Delaunay({c, a, b, a, b}));
    EXPECT_TRUE(is_Delaunay({c - tiny, a, b, a, b}));
    EXPECT_FALSE(is_Delaunay({c + tiny, a, b, a, b}));
    EXPECT_EQ(traits.compute_flipped_length_object()({c, a, b, a, b}), c);
  }
}

// Sides 52, 25, 39, 60 are on a circle, with diagonals 63 and 56.
TEST(Exact_geometry_traits, knows_a_cocircular_quadrangle_with_rational_sides)
{
  const Exact_traits traits;
  const auto is_Delaunay = traits.is_locally_Delaunay_object();
  EXPECT_TRUE(is_Delaunay({63, 52, 25, 39, 60}));
  EXPECT_TRUE(is_Delaunay({56, 25, 39, 60, 52}));
  EXPECT_FALSE(is_Delaunay({63 + Exact(1e-30), 52, 25, 39, 60}));
  EXPECT_EQ(traits.compute_flipped_length_object()({63, 52, 25, 39, 60}), 56);
}

TEST(Exact_geometry_traits, flat_triangles_and_straight_sides)
{
  const Exact_traits traits;
  const Exact tiny(1e-30);
  EXPECT_TRUE(traits.is_triangle_object()(3, 4, 7));
  EXPECT_FALSE(traits.is_triangle_object()(3, 4, 7 + tiny));
  EXPECT_FALSE(traits.is_length_object()(0));
  EXPECT_TRUE(traits.is_length_object()(tiny));
  // Two right triangles at i form a straight side.
  EXPECT_FALSE(traits.is_convex_object()({4, 5, 3, 3, 5}));
  EXPECT_TRUE(traits.is_convex_object()({4, 5 - tiny, 3, 3, 5}));
}

TEST(Exact_geometry_traits, whole_triangulations_as_with_double)
{
  for_each_small_triangulation<Exact_traits>([](const auto& t, const auto& reference) {
    for(Halfedge_index h : t.mesh().halfedges())
      EXPECT_EQ(t.is_flippable(h), reference.is_flippable(h));
  });
}

TEST(Exact_geometry_traits, from_positions)
{
  for(unsigned int seed : seeds(5)) {
    const std::vector<Vector> points = random_points(8, 1000, seed);
    IT::Intrinsic_triangulation<Exact_traits> exact(planar_mesh(points));
    IT::Intrinsic_triangulation<> approximate(planar_mesh(points));
    EXPECT_EQ(IT::make_Delaunay(exact), IT::make_Delaunay(approximate));
    expect_same_combinatorics(exact, approximate);
    EXPECT_TRUE(exact.is_valid(true));
  }
}

TEST(Exact_geometry_traits, ties_need_no_flip)
{
  const auto place = [](double x, double y) { return Point(3 * x, 4 * y, 0); };
  IT::Intrinsic_triangulation<Exact_traits> t(grid(3, 3, place));
  EXPECT_EQ(IT::make_Delaunay(t), 0u);
}

#else

TEST(Exact_geometry_traits, all)
{
  GTEST_SKIP() << "CGAL has no number type with exact square roots: it was built without CORE and "
                  "LEDA";
}

#endif

TEST(Traits, lengths_of_positions_in_single_precision_are_not_rounded_to_it)
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3> mesh;
  CGAL::copy_face_graph(perturbed(embedded_torus(9, 7), 1e-3, 5), mesh);
  const IT::Intrinsic_triangulation<> t(mesh);
  for(Edge_index e : mesh.edges()) {
    const auto &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
    const long double x = p.x() - (long double)(q.x()), y = p.y() - (long double)(q.y()),
                      z = p.z() - (long double)(q.z());
    EXPECT_NEAR(double(t.length(e) / std::sqrt(x * x + y * y + z * z)), 1, 1e-15);
  }
}

} // namespace Test_traits
