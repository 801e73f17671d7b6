// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "exact_flips.h"
#include "tied_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Sqrt_extension.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace Test_exact_Delaunay {

using namespace Test_surfaces;
using CGAL::Exact_rational;
using IT::Delaunay_certificate;
using Q_of_root_2 = CGAL::Sqrt_extension<Exact_rational, Exact_rational>;

// ---- Numbers ----

using IT::Double_double;

Exact_rational exact_number(double x) { return Exact_rational(x); }
Exact_rational exact_number(Double_double x)
{
  return Exact_rational(x.high()) + Exact_rational(x.low());
}

using Tower = IT::internal::Root_tower<Exact_rational>;
using Exact_complex = IT::internal::Root_complex<Exact_rational>; // used without roots

template <typename N>
bool contains(const IT::internal::Ball<N>& ball, const Exact_complex& z)
{
  const Exact_rational dx = z.x.front() - exact_number(ball.x),
                       dy = z.y.front() - exact_number(ball.y);
  const Exact_rational radius(ball.radius);
  return dx * dx + dy * dy <= radius * radius;
}

template <typename N>
void expect_that_balls_contain_the_exact_number()
{
  using Ball = IT::internal::Ball<N>;
  Portable_random random(1);
  const Tower tower(0);
  const auto exactly = [&](const Ball& ball) {
    return Exact_complex{&tower, {exact_number(ball.x)}, {exact_number(ball.y)}};
  };
  const auto number = [&] { return std::ldexp(random.get_double(-1, 1), random.get_int(-30, 30)); };
  for(int trial = 0; trial < 300; ++trial) {
    Ball ball{number(), number(), 0};
    Exact_complex exact = exactly(ball);
    for(int step = 0; step < 20; ++step) {
      const Ball other{number(), number(), 0};
      const Exact_complex exact_other = exactly(other);
      switch(random.get_int(0, 3)) {
        case 0: ball = ball + other, exact = exact + exact_other; break;
        case 1: ball = ball - other, exact = exact - exact_other; break;
        default: ball = ball * other, exact = exact * exact_other;
      }
      ASSERT_TRUE(contains(ball, exact));
    }
    EXPECT_LE(ball.radius, 1000 * IT::internal::Rounding<N>::unit() * ball.norm() * 1e6);
  }
}

TEST(Exact_Delaunay, balls_contain_the_exact_number)
{
  expect_that_balls_contain_the_exact_number<double>();
  expect_that_balls_contain_the_exact_number<Double_double>();
}

TEST(Exact_Delaunay, balls_of_products_are_small)
{
  Portable_random random(2);
  IT::internal::Ball<double> ball{1, 0, 0};
  for(int step = 0; step < 100; ++step) {
    ball = ball * IT::internal::Ball<double>{random.get_double(-1, 1), random.get_double(-1, 1), 0};
    EXPECT_LE(ball.radius, (step + 1) * 1e-15 * ball.norm());
  }
}

// ---- Positions ----

using IT::internal::Position;

// Returns points with few digits, which have ties; or with many, or far from the origin, or near
// the ends of the range.
std::array<Position, 4> random_diamond(Portable_random& random)
{
  const int kind = random.get_int(0, 4);
  const double scale = std::ldexp(kind == 0 ? 1 : 0.1, random.get_int(-1, 2) * 500 * (kind == 1));
  const double offset = kind == 2 ? 1e9 : 0;
  std::array<Position, 4> p;
  for(Position& q : p)
    for(double& x : q)
      x = offset + scale * (kind == 3 ? random.get_double(-2, 2) : random.get_int(-1, 2));
  return p;
}

TEST(Exact_Delaunay, positions_decide_as_squared_lengths_do)
{
  Portable_random random(2);
  std::array<int, 3> signs{};
  for(int trial = 0; trial < 5000; ++trial) {
    const auto [i, j, k, l] = random_diamond(random);
    const auto square = [](const Position& p, const Position& q) {
      return IT::internal::squared_distance<Exact_rational>(p, q);
    };
    const IT::Diamond<Exact_rational> squares{square(i, j), square(j, k), square(k, i),
                                              square(i, l), square(l, j)};
    const CGAL::Sign expected = IT::internal::compare_opposite_angles(squares);
    ASSERT_EQ(IT::internal::compare_opposite_angles(i, j, k, l), expected) << trial;
    ++signs[std::size_t(expected + 1)];
  }
  EXPECT_GT(*std::min_element(signs.begin(), signs.end()), 200);
}

TEST(Exact_Delaunay, planes_are_found_exactly)
{
  Portable_random random(3);
  int flat = 0;
  for(int trial = 0; trial < 5000; ++trial) {
    std::array<Position, 4> p = random_diamond(random);
    if(random.get_int(0, 2) == 0)
      p[0][1] = p[1][1] = p[2][1] = p[3][1];
    const auto vector = [&](std::size_t n) {
      return IT::internal::vector_between<Exact_rational>(p[0], p[n]);
    };
    const IT::internal::Hinge<Exact_rational> hinge(vector(1), vector(2), vector(3));
    const bool expected = hinge.volume == 0 && hinge.cosine > 0;
    ASSERT_EQ(IT::internal::is_flat_in_space(p[0], p[1], p[2], p[3]), expected) << trial;
    flat += expected;
  }
  EXPECT_GT(flat, 500);
}

TEST(Exact_Delaunay, scaled_differences_are_exact)
{
  Portable_random random(4);
  for(int trial = 0; trial < 5000; ++trial) {
    const auto number = [&] {
      return std::ldexp(random.get_double(-1, 1), random.get_int(-1, 2) * random.get_int(0, 1000));
    };
    const double x = number(), y = trial % 3 == 0 ? x * (1 + random.get_double(0, 1)) : number(),
                 unit = std::ldexp(1., random.get_int(-1000, 1000));
    ASSERT_EQ(IT::internal::scaled_difference<Exact_rational>(x, y, unit),
              (Exact_rational(x) - Exact_rational(y)) * Exact_rational(unit))
      << x << ' ' << y << ' ' << unit;
  }
}

// ---- Roots ----

using IT::Exact_ring;

template <typename K>
void check_signs_of_sums_of_roots()
{
  using Tower = IT::internal::Root_tower<K>;
  using Complex = IT::internal::Root_complex<K>;
  Tower tower(10);
  const auto number = [&](double x) { return Complex{&tower, {K(x)}, {K(0)}}; };
  const auto multiple = [&](double square) { return tower.root(K(square)).value(); };
  const auto root = [&](double square) {
    const auto result = multiple(square);
    EXPECT_EQ(result.factor, K(1));
    return Complex{&tower, result.root, {K(0)}};
  };
  const auto sign = [](const Complex& a) { return CGAL::get_certain(sign_of_real(a)); };
  const Complex sum = root(2) + root(3), square = sum * sum;
  const auto product = multiple(6); // of both roots
  const Complex same =
    number(5) * product.factor + number(2) * Complex{&tower, product.root, {K(0)}};
  const Complex difference = square * product.factor - same;
  EXPECT_EQ(sign(difference), CGAL::ZERO);
  EXPECT_EQ(sign(difference - number(0x1p-30)), CGAL::NEGATIVE);
  EXPECT_EQ(sign(difference + number(0x1p-30)), CGAL::POSITIVE);
  EXPECT_EQ(
    sign_of_imaginary(conj(Complex{&tower, {K(2)}, {K(1)}}), Complex{&tower, {K(4)}, {K(2)}}),
    CGAL::ZERO);
  const auto known = multiple(50); // no new root
  EXPECT_EQ(known.root.size(), root(2).x.size());
  EXPECT_EQ(sign(Complex{&tower, known.root, {K(0)}} - number(5) * root(2) * known.factor),
            CGAL::ZERO);
  EXPECT_EQ(sign(root(49)), CGAL::POSITIVE);
  EXPECT_EQ(root(49).x.front(), K(7));
}

TEST(Exact_Delaunay, signs_of_sums_of_roots)
{
  check_signs_of_sums_of_roots<Exact_rational>();
  check_signs_of_sums_of_roots<Exact_ring>();
}

// A root of 7 is used as a different root from the root of 28 / 4.
TEST(Exact_Delaunay, signs_of_sums_of_dependent_roots)
{
  using Ring_tower = IT::internal::Root_tower<Q_of_root_2>;
  using Complex = IT::internal::Root_complex<Q_of_root_2>;
  Ring_tower tower(10);
  const auto root = [&](int square) {
    return Complex{&tower, tower.root(Q_of_root_2(square)).value().root, {Q_of_root_2(0)}};
  };
  const auto number = [&](int x) { return Complex{&tower, {Q_of_root_2(x)}, {Q_of_root_2(0)}}; };
  const Complex a = number(2) * root(7), b = root(28);
  EXPECT_GT(b.x.size(), root(7).x.size());
  EXPECT_EQ(sign_of_real(a - b), CGAL::ZERO);
  EXPECT_EQ(sign_of_real(a - b + number(1)), CGAL::POSITIVE);
  EXPECT_EQ(sign_of_real(a * b - number(28)), CGAL::ZERO);
  EXPECT_EQ(sign_of_real(a * b - number(29)), CGAL::NEGATIVE);
}

TEST(Exact_Delaunay, too_many_roots_are_refused)
{
  Tower tower(2);
  for(int square : {2, 3, 8, 27, 12})
    EXPECT_TRUE(tower.root(Exact_rational(square)));
  EXPECT_FALSE(tower.root(Exact_rational(5)));
}

TEST(Exact_Delaunay, whole_roots_are_found)
{
  Portable_random random(5);
  for(int trial = 0; trial < 1000; ++trial) {
    Exact_ring x(1);
    for(int factor = trial % 9; factor >= 0; --factor)
      x = x * Exact_ring(std::floor(std::ldexp(random.get_double(0, 1), random.get_int(1, 53)))) +
          Exact_ring(1);
    const Exact_ring square = x * x;
    ASSERT_TRUE(IT::internal::whole_root(square));
    EXPECT_EQ(IT::internal::whole_root(square).value(), x);
    EXPECT_FALSE(IT::internal::whole_root(Exact_ring(square + Exact_ring(1))));
    if(!(x == Exact_ring(1))) {
      EXPECT_FALSE(IT::internal::whole_root(Exact_ring(square - Exact_ring(1))));
    }
  }
  Exact_ring huge(0x1p1000); // beyond the range of `double`
  for(int step = 0; step < 4; ++step) {
    huge = huge * huge + Exact_ring(7);
    const Exact_ring square = huge * huge;
    ASSERT_TRUE(IT::internal::whole_root(square));
    EXPECT_EQ(IT::internal::whole_root(square).value(), huge);
    EXPECT_FALSE(IT::internal::whole_root(Exact_ring(square + Exact_ring(1))));
  }
}

// ---- Flat surfaces ----

void check_flat_surface(const Flat_surface& surface, std::uint64_t seed)
{
  Portable_random random(seed);
  Exact_triangulation t = with_squared_lengths(surface);
  Vector_keeper vectors(t.mesh(), surface.vector);
  shuffle(t, 4 * t.mesh().number_of_edges(), random,
          [&](Halfedge_index h) { vectors.after_flip(h); });
  IT::make_Delaunay(t, IT::parameters::visitor(std::ref(vectors)));
  const Delaunay_certificate certificate = IT::certify_Delaunay(t);
  EXPECT_TRUE(certificate.is_Delaunay());
  std::size_t ties = 0;
  for(Edge_index e : t.mesh().edges()) {
    const Vector v = vectors.vector[t.mesh().halfedge(e)];
    EXPECT_NEAR(t.length(e), length(v), 1e-11 * length(v));
    if(t.mesh().is_border(e))
      continue;
    const int side = vectors.side_of_circle(t.mesh().halfedge(e));
    EXPECT_LE(side, 0) << "edge " << e.idx();
    ties += side == 0;
  }
  EXPECT_EQ(certificate.ties.size(), ties);
}

TEST(Exact_Delaunay, flat_tori)
{
  for(unsigned int seed : seeds(20))
    check_flat_surface(
      flat_torus(static_cast<int>(1 + seed % 5), static_cast<int>(1 + seed / 5), seed), seed);
}

TEST(Exact_Delaunay, flat_cylinders)
{
  for(int n = 1; n < 9; ++n) {
    SCOPED_TRACE(n);
    check_flat_surface(flat_cylinder(n, n % 4), static_cast<std::uint64_t>(n));
  }
}

TEST(Exact_Delaunay, flat_polygons)
{
  for(unsigned int seed : seeds(20)) {
    const int n = 8 + 4 * static_cast<int>(seed);
    // A narrow range of coordinates has many cocircular points.
    const int range = seed % 2 == 0 ? n : 1000;
    check_flat_surface(flat_polygon(random_points(static_cast<std::size_t>(n), range, seed)), seed);
  }
}

// ---- Ties ----

// All ties are found, whatever the initial triangulation is.
TEST(Exact_Delaunay, finds_all_ties)
{
  for(const auto& [tied, seed] : traced(105, tied_mesh)) {
    Exact_triangulation t(tied.mesh);
    EXPECT_EQ(IT::make_Delaunay(t), 0u); // ties keep the edge
    EXPECT_EQ(IT::certify_Delaunay(t).ties.size(), tied.ties);
    Portable_random random(seed);
    shuffle(t, 100 + 3 * t.mesh().number_of_edges(), random);
    IT::make_Delaunay(t);
    const Delaunay_certificate certificate = IT::certify_Delaunay(t);
    EXPECT_TRUE(certificate.is_Delaunay());
    EXPECT_EQ(certificate.ties.size(), tied.ties);
    EXPECT_TRUE(t.is_valid(true));
  }
}

TEST(Exact_Delaunay, rectangles_are_ties)
{
  Portable_random random(7);
  for(int trial = 0; trial < 300; ++trial) {
    Exact_triangulation t(exact_rectangle(random).mesh);
    EXPECT_TRUE(IT::is_Delaunay(t));
    EXPECT_EQ(IT::certify_Delaunay(t).ties.size(), 1u);
  }
}

// ---- Kernels ----

template <typename Kernel>
void check_kernel(const Tied_mesh& tied)
{
  using Other_mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  Other_mesh mesh;
  CGAL::copy_face_graph(tied.mesh, mesh);
  // A third of the size is not a number of type `double`.
  for(auto v : mesh.vertices()) {
    const auto p = mesh.point(v);
    mesh.point(v) = typename Kernel::Point_3(p.x() / 3, p.y() / 3, p.z() / 3);
  }
  Exact_triangulation t(mesh);
  IT::make_Delaunay(t);
  const Delaunay_certificate certificate = IT::certify_Delaunay(t);
  EXPECT_TRUE(certificate.is_Delaunay());
  EXPECT_EQ(certificate.ties.size(), tied.ties);
}

TEST(Exact_Delaunay, positions_in_exact_kernels)
{
  for(const auto& [tied, seed] : traced(14, tied_mesh)) {
    check_kernel<CGAL::Simple_cartesian<Exact_rational>>(tied);
    check_kernel<CGAL::Exact_predicates_exact_constructions_kernel>(tied);
  }
}

// ---- A translation surface ----

// A regular octagon with sides glued is cut into a fan, and its squared lengths are in Q(sqrt 2).
// All corners are cocircular, so it has one cell with eight corners, and five ties.
TEST(Exact_Delaunay, octagon_with_lengths_in_an_extension)
{
  Delta_complex mesh = double_torus();
  auto square = mesh.add_property_map<Edge_index, Q_of_root_2>("e:square", Q_of_root_2(1)).first;
  const std::array<std::pair<int, int>, 5> diagonals{{{2, 1}, {3, 2}, {4, 2}, {3, 2}, {2, 1}}};
  for(unsigned int d = 0; d < 5; ++d)
    square[Edge_index(4 + d)] = Q_of_root_2(diagonals[d].first, diagonals[d].second, 2);
  IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<Q_of_root_2>> t(
    mesh, IT::parameters::squared_edge_length_map(square));
  EXPECT_EQ(IT::make_Delaunay(t), 0u);
  EXPECT_EQ(IT::certify_Delaunay(t).ties.size(), 5u);
  for(std::uint64_t seed = 0; seed < 20; ++seed) {
    Portable_random random(seed);
    shuffle(t, 8, random);
    IT::make_Delaunay(t);
    const Delaunay_certificate certificate = IT::certify_Delaunay(t);
    EXPECT_TRUE(certificate.is_Delaunay());
    EXPECT_EQ(certificate.ties.size(), 5u);
    int sides = 0;
    for(Edge_index e : t.mesh().edges())
      sides += std::abs(t.length(e) - 1) < 1e-12;
    EXPECT_EQ(sides, 4);
  }
}

// ---- Hard meshes ----

TEST(Exact_Delaunay, certified_on_hard_meshes)
{
  for(const auto& [hard, seed] : traced(240, hard_mesh)) {
    Exact_triangulation t(hard.mesh);
    IT::make_Delaunay(t);
    EXPECT_TRUE(IT::is_Delaunay(t));
    EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
  }
}

const auto exactly = IT::parameters::exact_decisions(true);

// Checks that with exact decisions the result is certified, and agrees with the stored lengths.
// Without them, flips end, with edges that are wrong by rounding.
void expect_certified_in_double(const Mesh& mesh)
{
  Triangulation by_lengths(mesh), t(mesh);
  EXPECT_NO_THROW(IT::make_Delaunay(by_lengths));
  EXPECT_NO_THROW(IT::make_Delaunay(t, exactly));
  EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
  EXPECT_TRUE(IT::is_Delaunay(t));
  EXPECT_TRUE(t.is_valid(true));
  EXPECT_EQ(IT::make_Delaunay(t), 0u);
}

TEST(Exact_Delaunay, double_is_certified_on_hard_meshes)
{
  for(const auto& [hard, seed] : traced(240, hard_mesh))
    expect_certified_in_double(hard.mesh);
}

std::array<Exact_rational, 3> exact_sides(Face_index f, const Triangulation& t)
{
  const auto side = IT::sides(f, t.input_mesh());
  const auto length = [&](std::size_t s) {
    return Exact_rational(t.input_length(t.input_mesh().edge(side[s])));
  };
  return {length(0), length(1), length(2)};
}

// Lengths that count as exact are lengths of triangles: some are shortened by their rounding
// errors.
TEST(Exact_Delaunay, rounded_lengths_are_those_of_triangles)
{
  std::size_t shortened = 0;
  for(const auto& [hard, seed] : traced(120, hard_mesh)) {
    const Triangulation by_points(hard.mesh);
    Triangulation t(hard.mesh, IT::parameters::edge_length_map(by_points.length_map()));
    for(Edge_index e : t.input_mesh().edges()) {
      const double before = by_points.length(e), after = t.input_length(e);
      EXPECT_LE(after, before);
      EXPECT_GE(after, before * (1 - 32 * std::numeric_limits<double>::epsilon()));
      shortened += after < before;
    }
    for(Face_index f : t.input_mesh().faces()) {
      const auto [a, b, c] = exact_sides(f, t);
      EXPECT_TRUE(a <= b + c && b <= c + a && c <= a + b);
    }
    Triangulation exact(t);
    try {
      IT::make_Delaunay(t);
      IT::make_Delaunay(exact, exactly);
      EXPECT_TRUE(IT::certify_Delaunay(exact).is_Delaunay());
    } catch(const IT::Numerical_error& error) { // vertices in one place
      EXPECT_NE(std::string(error.what()).find("has no positive finite length"), std::string::npos);
    }
  }
  EXPECT_GT(shortened, 100u);
}

// Squared lengths that violate the triangle inequality by rounding do not count as exact.
TEST(Exact_Delaunay, rounded_squared_lengths_of_flat_triangles)
{
  const Mesh mesh = grid(2, 1, [](double x, double y) { return Point(x, y, 0); });
  for(double excess : {0., 1e-15}) {
    const auto square = boost::make_function_property_map<Edge_index>([&](Edge_index e) {
      const Halfedge_index h = mesh.halfedge(e);
      const double x = mesh.point(mesh.target(h)).x() - mesh.point(mesh.source(h)).x();
      const double y = mesh.point(mesh.target(h)).y() - mesh.point(mesh.source(h)).y();
      return std::pow(std::abs(x) + std::abs(y), 2) * (x != 0 && y != 0 ? 1 + excess : 1);
    });
    const Triangulation t(mesh, IT::parameters::squared_edge_length_map(square));
    EXPECT_EQ(t.input_metric().squared_lengths.empty(), excess > 0);
    for(Face_index f : t.input_mesh().faces()) {
      const auto [a, b, c] = exact_sides(f, t);
      EXPECT_TRUE(a <= b + c && b <= c + a && c <= a + b);
    }
  }
}

TEST(Exact_Delaunay, double_is_certified_on_ties)
{
  for(const auto& [tied, seed] : traced(105, tied_mesh)) {
    expect_certified_in_double(tied.mesh);
    Triangulation t(tied.mesh);
    EXPECT_EQ(IT::make_Delaunay(t, exactly), 0u); // ties keep the edge
    Portable_random random(seed);
    shuffle(t, 100 + 3 * t.mesh().number_of_edges(), random);
    IT::make_Delaunay(t, exactly);
    const Delaunay_certificate certificate = IT::certify_Delaunay(t);
    EXPECT_TRUE(certificate.is_Delaunay());
    EXPECT_EQ(certificate.ties.size(), tied.ties);
  }
}

// Meaningless lengths, and bent edges, are found at the beginning.
TEST(Exact_Delaunay, double_is_certified_whatever_it_starts_from)
{
  for(std::uint64_t seed = 0; seed < 60; ++seed) {
    Portable_random random(seed);
    Triangulation t(seed % 2 == 0 ? hard_mesh(seed).mesh : hard_base(random));
    const int edges = static_cast<int>(t.mesh().number_of_edges());
    for(int flip = 0; flip < edges; ++flip) {
      const Halfedge_index h =
        t.mesh().halfedge(Edge_index(static_cast<unsigned>(random.get_int(0, edges))));
      if(IT::flip_status(h, t.mesh()) == IT::Operation_status::possible &&
         (flip % 5 == 0 || t.is_flippable(h)))
        try {
          t.flip(h); // not always straight
        } catch(const IT::Numerical_error&) {
        }
    }
    SCOPED_TRACE(seed);
    IT::make_Delaunay(t, exactly);
    EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
    EXPECT_TRUE(t.is_valid(true));
  }
}

// Returns a flat torus with the shortest distances 1000, |(300, 700)| and |(700, 700)|. Two sides
// of each face wind around it.
Triangulation wound_torus(std::size_t m, std::size_t n, int twists)
{
  const Mesh mesh = embedded_torus(m, n);
  const auto steps = [](std::size_t from, std::size_t to, std::size_t size) {
    const auto steps = static_cast<double>((to + size - from) % size);
    return steps > 1 ? steps - static_cast<double>(size) : steps;
  };
  std::vector<double> length;
  for(Edge_index e : mesh.edges()) {
    const std::size_t v = mesh.vertex(e, 0).idx(), w = mesh.vertex(e, 1).idx();
    const double row = steps(v % n, w % n, n);
    length.push_back(
      std::hypot(1000 * steps(v / n, w / n, m) + (1000. * twists + 300) * row, 700 * row));
  }
  return triangulation(Triangulation(mesh).mesh(), length);
}

// The strip of a short edge has thousands of triangles of the first triangulation.
TEST(Exact_Delaunay, unwinds_tori)
{
  const std::array<double, 3> expected{std::hypot(300, 700), std::hypot(700, 700), 1000};
  for(int twists : traced({100, 2000, 10000})) {
    Triangulation t = wound_torus(6, 5, twists);
    IT::make_Delaunay(t, exactly);
    EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
    for(Face_index f : t.mesh().faces()) {
      auto lengths = IT::internal::side_lengths(t.mesh().halfedge(f), t);
      std::sort(lengths.begin(), lengths.end());
      for(std::size_t s = 0; s < 3; ++s)
        EXPECT_NEAR(lengths[s], expected[s], 1); // lengths of T1 are rounded
    }
  }
}

// ---- Error bounds ----

typedef boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>> Long_real;

// Returns a random diamond, thin by up to `digits` decimals. Its apices need not lie above the
// base. It is convex, or its other diagonal crosses the base near its end.
std::array<std::array<double, 2>, 4> random_diamond(Portable_random& random, double digits,
                                                    bool is_convex)
{
  const auto thin = [&] { return std::pow(10, -digits * random.get_double(0, 1)); };
  const double base = thin(), above = thin(), below = thin(),
               cut = base * (is_convex ? random.get_double(0, 1)
                                       : 1 + random.get_double(-1, 1) * thin() * thin()),
               slope = random.get_double(-1, 1) / thin();
  return {{{0, 0}, {base, 0}, {cut + slope * above, above}, {cut - slope * below, -below}}};
}

// The lengths have errors of up to `error`, all in the worst direction or at random.
TEST(Exact_Delaunay, bounds_of_flipped_lengths_hold)
{
  Portable_random random(8);
  std::size_t good = 0, convex = 0, concave = 0;
  for(int trial = 0; trial < 20000; ++trial) {
    const auto p = random_diamond(random, trial % 8, trial % 4 > 0);
    const double common = std::ldexp(1., -random.get_int(30, 52));
    const auto error = [&] {
      return trial % 3 == 0 ? 0 : trial % 3 == 1 ? common : std::ldexp(1., -random.get_int(30, 52));
    };
    const IT::Diamond<double> errors{error(), error(), error(), error(), error()};
    const auto exact = [&](std::size_t a, std::size_t b) {
      const Long_real x = Long_real(p[a][0]) - p[b][0], y = Long_real(p[a][1]) - p[b][1];
      return Long_real(sqrt(x * x + y * y));
    };
    const auto stored = [&](std::size_t a, std::size_t b, double greatest_error) {
      const double change =
        random.get_int(0, 2) == 0 ? random.get_double(-1, 1) : double(2 * random.get_int(0, 2) - 1);
      return static_cast<double>(exact(a, b) * (1 + Long_real(change) * greatest_error));
    };
    const IT::internal::Flipped_diagonal diagonal(
      {stored(0, 1, errors.ij), stored(1, 2, errors.jk), stored(2, 0, errors.ki),
       stored(0, 3, errors.il), stored(3, 1, errors.lj)},
      {errors.ij + 0x1p-53, errors.jk + 0x1p-53, errors.ki + 0x1p-53, errors.il + 0x1p-53,
       errors.lj + 0x1p-53});
    const IT::internal::Bounded_length flipped = diagonal();
    const Long_real kl = exact(2, 3);
    ASSERT_LE(abs(flipped.length - kl), kl * Long_real(flipped.error)) << trial;
    good += flipped.is_good();
    const auto from_j = [&](std::size_t a, std::size_t c) { return Long_real(p[a][c]) - p[1][c]; };
    const bool is_convex = from_j(2, 0) * from_j(3, 1) > from_j(2, 1) * from_j(3, 0);
    if(const auto decided = diagonal.is_convex_at_target(); CGAL::is_certain(decided)) {
      ASSERT_EQ(CGAL::get_certain(decided), is_convex) << trial;
      ++(is_convex ? convex : concave);
    }
  }
  EXPECT_GT(good, 5000u);
  EXPECT_GT(convex, 5000u);
  EXPECT_GT(concave, 500u);
}

TEST(Exact_Delaunay, certified_on_data_meshes)
{
  for_each_data_mesh(2000000, [](const Mesh& mesh) {
    expect_certified_in_double(mesh);
    Exact_triangulation t(mesh);
    IT::make_Delaunay(t);
    EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
    EXPECT_TRUE(t.is_valid(true));
  });
}

// Filters and multiprecision decide alike, also for edges that are not Delaunay or bent.
TEST(Exact_Delaunay, certificate_agrees_with_the_signs_of_all_edges)
{
  for(std::uint64_t seed : traced({5u, 23u, 112u, 155u, 167u, 187u, 196u, 199u})) {
    Triangulation t(hard_mesh(seed).mesh);
    IT::make_Delaunay(t);
    auto decisions = IT::internal::exact_decisions(t);
    std::vector<Edge_index> ties, non_Delaunay;
    for(Edge_index e : t.mesh().edges())
      if(!t.mesh().is_border(e))
        switch(decisions.Delaunay_sign(t.mesh().halfedge(e))) {
          case CGAL::POSITIVE: break;
          case CGAL::ZERO: ties.push_back(e); break;
          case CGAL::NEGATIVE: non_Delaunay.push_back(e); break;
        }
    const Delaunay_certificate certificate = IT::certify_Delaunay(t);
    EXPECT_EQ(certificate.ties, ties);
    EXPECT_EQ(certificate.non_Delaunay_edges, non_Delaunay);
  }
}

// ---- Planes ----

// Returns the triangulation of a mesh by its exact squared lengths. Without positions triangles are
// laid out one by one, over rational numbers.
Exact_triangulation by_squares(const Exact_triangulation& t, const Mesh& mesh)
{
  Delta_complex copy = t.input_mesh();
  auto square = copy.add_property_map<Edge_index, Exact_rational>("e:square").first;
  for(Edge_index e : copy.edges()) {
    const auto position = [&](IT::Vertex_index v) {
      const Point& p = mesh.point(Mesh::Vertex_index(v.idx()));
      return Position{p.x(), p.y(), p.z()};
    };
    const Halfedge_index h = copy.halfedge(e);
    square[e] = IT::internal::squared_distance<Exact_rational>(position(copy.source(h)),
                                                               position(copy.target(h)));
  }
  return Exact_triangulation(copy, IT::parameters::squared_edge_length_map(square));
}

// Edges of a shuffled triangulation cross many planes, each with many faces.
TEST(Exact_Delaunay, planes_decide_as_triangles_do)
{
  std::array<int, 3> signs{};
  for(std::uint64_t seed : seeds(70)) {
    const Tied_mesh tied = tied_mesh(seed);
    Exact_triangulation t(tied.mesh), other = by_squares(t, tied.mesh);
    Portable_random random(seed);
    shuffle(t, 2 * t.mesh().number_of_edges(), random, [&](Halfedge_index h) { other.flip(h); });
    auto by_planes = IT::internal::exact_decisions(t),
         by_triangles = IT::internal::exact_decisions(other);
    for(Edge_index e : t.mesh().edges())
      if(const Halfedge_index h = t.mesh().halfedge(e); !t.mesh().is_border(e)) {
        const CGAL::Sign sign = by_planes.Delaunay_sign(h);
        ASSERT_EQ(sign, by_triangles.Delaunay_sign(h)) << e;
        ASSERT_EQ(by_planes.convexity_at_source(h), by_triangles.convexity_at_source(h)) << e;
        ASSERT_EQ(by_planes.is_straight(h), by_triangles.is_straight(h)) << e;
        ++signs[std::size_t(sign + 1)];
      }
  }
  EXPECT_GT(*std::min_element(signs.begin(), signs.end()), 200);
}

// ---- Certificates that fail ----

TEST(Exact_Delaunay, certificate_names_edges_that_are_not_Delaunay)
{
  for(unsigned int seed = 0; seed < 10; ++seed) {
    const Flat_surface surface = flat_polygon(random_points(60, 200, seed));
    const Exact_triangulation t = with_squared_lengths(surface);
    const Vector_keeper vectors(t.mesh(), surface.vector);
    const Delaunay_certificate certificate = IT::certify_Delaunay(t);
    std::set<Edge_index> expected;
    for(Edge_index e : t.mesh().edges())
      if(!t.mesh().is_border(e) && vectors.side_of_circle(t.mesh().halfedge(e)) > 0)
        expected.insert(e);
    EXPECT_EQ(std::set<Edge_index>(certificate.non_Delaunay_edges.begin(),
                                   certificate.non_Delaunay_edges.end()),
              expected);
    EXPECT_TRUE(certificate.is_geodesic());
  }
}

// A flip across a corner of 180 degrees or more gives an edge that is not straight.
TEST(Exact_Delaunay, certificate_names_bent_edges)
{
  const Flat_surface surface = flat_polygon(random_points(60, 200, 3));
  std::size_t bent = 0;
  for(Edge_index e : surface.mesh.edges()) {
    Exact_triangulation t = with_squared_lengths(surface);
    const Halfedge_index h = t.mesh().halfedge(e);
    if(IT::flip_status(h, t.mesh()) != IT::Operation_status::possible || t.is_flippable(h))
      continue;
    t.flip(h);
    EXPECT_EQ(IT::certify_Delaunay(t).non_straight_edges, std::vector<Edge_index>{e});
    ++bent;
  }
  EXPECT_GT(bent, 10u);
}

} // namespace Test_exact_Delaunay
