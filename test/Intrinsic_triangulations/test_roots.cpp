// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "accordions.h"
#include "exact_flips.h"

#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Root_tower.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

// These tests check sums of square roots, and decisions about surfaces that involve many of them.
namespace Test_roots {

using namespace Test_surfaces;
using CGAL::Exact_rational;
using IT::Exact_ring;

// A number that is not zero is decided by 6000 bits. Zeros are known.
using Long_real = boost::multiprecision::number<
  boost::multiprecision::cpp_bin_float<6000, boost::multiprecision::digit_base_2>,
  boost::multiprecision::et_off>;

CGAL::Sign sign_unless_tiny(const Long_real& x)
{
  const Long_real bound = boost::multiprecision::ldexp(Long_real(1), -5500);
  return x > bound ? CGAL::POSITIVE : x < -bound ? CGAL::NEGATIVE : CGAL::ZERO;
}

// ---- Characters ----

TEST(Roots, characters_are_those_of_primes)
{
  for(std::size_t i = 0; i < 64; ++i) {
    const std::uint64_t p = IT::internal::character_prime(i);
    EXPECT_TRUE(i == 0 || p < IT::internal::character_prime(i - 1));
    for(std::uint64_t d = 2; d * d <= p; ++d)
      ASSERT_NE(p % d, 0u) << p;
  }
}

TEST(Roots, characters_of_products_are_added)
{
  Portable_random random(1);
  for(int trial = 0; trial < 300; ++trial) {
    const auto number = [&] {
      Exact_ring x(std::ldexp(std::floor(random.get_double(1, 1e15)), random.get_int(-900, 900)));
      for(int factor = trial % 4; factor > 0; --factor)
        x = x * Exact_ring(random.get_int(1, 1000000)) + Exact_ring(1);
      return x;
    };
    const Exact_ring x = number(), y = number();
    const auto a = IT::internal::quadratic_characters(x), b = IT::internal::quadratic_characters(y);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(IT::internal::quadratic_characters(Exact_ring(x * y)), *a ^ *b);
    EXPECT_EQ(IT::internal::quadratic_characters(Exact_ring(x * x)), std::uint64_t(0));
  }
}

// ---- Towers ----

// Represents the product of some primes, and the rank of several of them over two elements.
struct Square
{
  unsigned int primes; // one bit for each
  double value;
};

constexpr std::array<int, 12> first_primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};

Square random_square(int number_of_primes, Portable_random& random)
{
  Square result{0, 1};
  for(int factor = random.get_int(1, 4); factor > 0; --factor) {
    const int i = random.get_int(0, number_of_primes);
    result.primes ^= 1u << i;
    result.value *= first_primes[std::size_t(i)];
  }
  const int whole = random.get_int(1, 50);
  result.value *= whole * whole;
  return result;
}

std::size_t rank(std::vector<Square> squares)
{
  std::size_t result = 0;
  for(unsigned int bit = 1; bit < 1u << first_primes.size(); bit *= 2) {
    const auto has_bit = [&](const Square& s) { return (s.primes & bit) != 0; };
    const auto pivot = std::find_if(squares.begin(), squares.end(), has_bit);
    if(pivot == squares.end())
      continue;
    const unsigned int row = pivot->primes;
    squares.erase(pivot);
    for(Square& s : squares)
      if(has_bit(s))
        s.primes ^= row;
    ++result;
  }
  return result;
}

// Stores a tower with the elements that are roots of whole numbers, and their values.
template <typename K>
struct Roots
{
  using Tower = IT::internal::Root_tower<K>;
  using Complex = IT::internal::Root_complex<K>;

  Tower tower{12};
  std::vector<Complex> root;
  std::vector<Long_real> value;

  Complex number(const K& x) { return {&tower, {x}, {K(0)}}; }

  // Adds a number, multiplied by the factor of the tower.
  void add(const K& square, const Long_real& value_of_square)
  {
    const auto multiple = tower.root(square);
    ASSERT_TRUE(multiple);
    root.push_back({&tower, multiple->root, {K(0)}});
    value.push_back(sqrt(value_of_square) * Long_real(CGAL::to_double(multiple->factor)));
  }

  static CGAL::Sign sign(const Complex& x) { return CGAL::get_certain(sign_of_real(x)); }
};

template <typename K>
std::size_t size_of_tower(const std::vector<Square>& squares, const K& factor)
{
  IT::internal::Root_tower<K> tower(12);
  std::size_t size = 1;
  for(const Square& s : squares)
    size = (std::max)(size, tower.root(K(s.value) * factor * factor).value().root.size());
  return size;
}

// A root that is a product of others adds nothing, for whole numbers and fractions of any size.
TEST(Roots, towers_have_the_rank_of_the_roots)
{
  for(unsigned int seed : seeds(60)) {
    Portable_random random(seed);
    std::vector<Square> squares;
    for(int i = random.get_int(3, 16); i > 0; --i)
      squares.push_back(random_square(2 + int(seed) % 7, random));
    const std::size_t expected = std::size_t(1) << rank(squares);
    EXPECT_EQ(size_of_tower(squares, Exact_ring(1)), expected);
    EXPECT_EQ(size_of_tower(squares, Exact_ring(0x1p900) + Exact_ring(3)), expected);
    EXPECT_EQ(size_of_tower<Exact_rational>(squares, Exact_rational(5) / Exact_rational(7)),
              expected);
  }
}

// Checks polynomials in dependent and independent roots, and products that cancel.
template <typename K>
void check_random_signs(unsigned int seed, int number_of_primes)
{
  Portable_random random(seed);
  Roots<K> roots;
  for(int i = 0; i < number_of_primes + 2; ++i) {
    const Square s = random_square(number_of_primes, random);
    roots.add(K(s.value), Long_real(s.value));
  }
  using Complex = typename Roots<K>::Complex;
  const auto random_sum = [&] {
    std::pair<Complex, Long_real> sum{roots.number(K(0)), 0};
    for(std::size_t i = 0; i < roots.root.size(); ++i) {
      const double c = random.get_int(-99, 100);
      sum.first = sum.first + roots.root[i] * K(c);
      sum.second += Long_real(c) * roots.value[i];
    }
    return sum;
  };
  const auto [a, value_a] = random_sum();
  const auto [b, value_b] = random_sum();
  const auto [c, value_c] = random_sum();
  const auto sign = [](const Complex& x) { return Roots<K>::sign(x); };
  EXPECT_EQ(sign(a * b - c), sign_unless_tiny(value_a * value_b - value_c));
  EXPECT_EQ(sign(a * b * c - a - b),
            sign_unless_tiny(value_a * value_b * value_c - value_a - value_b));
  const Complex zero = (a + b) * (a + b) - a * a - b * b - a * b * K(2);
  EXPECT_EQ(sign(zero), CGAL::ZERO);
  EXPECT_EQ(sign((a - b) * (a + b) * c - a * c * a + b * c * b), CGAL::ZERO);
  const K tiny(0x1p-1000);
  EXPECT_EQ(sign(zero + roots.number(tiny * tiny)), CGAL::POSITIVE);
  EXPECT_EQ(sign(zero - roots.root[0] * (tiny * tiny)), CGAL::NEGATIVE);
}

TEST(Roots, signs_of_random_polynomials)
{
  for(unsigned int seed : seeds(24))
    check_random_signs<Exact_ring>(seed, 2 + int(seed) % 8);
  for(unsigned int seed = 0; seed < 6; ++seed)
    check_random_signs<Exact_rational>(seed, 2 + int(seed) % 4);
}

// Powers of units, such as of sqrt(2) - 1, are sums with large terms that almost vanish.
TEST(Roots, signs_of_powers_of_units)
{
  for(int power : traced({20, 100, 300})) {
    Roots<Exact_ring> roots;
    auto product = roots.number(Exact_ring(1));
    for(int n : {1, 2, 6}) { // of 2, 5 and 37
      roots.add(Exact_ring(n * n + 1), Long_real(n * n + 1));
      for(int i = 0; i < power; ++i)
        product = product * (roots.root.back() - roots.number(Exact_ring(n)));
    }
    EXPECT_EQ(product.x.size(), 8u);
    EXPECT_EQ(Roots<Exact_ring>::sign(product), CGAL::POSITIVE);
    EXPECT_EQ(Roots<Exact_ring>::sign(-product), CGAL::NEGATIVE);
    EXPECT_EQ(Roots<Exact_ring>::sign(product * product - product), CGAL::NEGATIVE);
  }
}

// ---- Accordions ----

// Represents the unfolded strip in a plane, where the circles of all edges are tested.
struct Unfolded
{
  std::vector<std::array<Long_real, 2>> point;

  Unfolded(const Accordion& accordion, const Mesh& mesh)
  {
    std::size_t column = 0;
    Long_real x = 0;
    for(Vertex_index v : mesh.vertices()) {
      const Point& p = mesh.point(v);
      if(v.idx() > 0 && p.y() == accordion.left.front()) {
        const Panel& panel = accordion.panels[column++];
        x += sqrt(Long_real(panel.x * panel.x + panel.z * panel.z));
      }
      point.push_back({x, Long_real(p.y())});
    }
  }

  // Returns POSITIVE if the edge is Delaunay, and ZERO if it is a tie.
  CGAL::Sign Delaunay_sign(Halfedge_index h, const Delta_complex& mesh) const
  {
    const auto& i = point[mesh.source(h)];
    const auto from_i = [&](Vertex_index v) {
      return std::array<Long_real, 2>{point[v][0] - i[0], point[v][1] - i[1]};
    };
    const auto j = from_i(mesh.target(h)), k = from_i(mesh.target(mesh.next(h))),
               l = from_i(mesh.target(mesh.next(mesh.opposite(h))));
    const auto square = [](const auto& v) { return Long_real(v[0] * v[0] + v[1] * v[1]); };
    const auto cross = [](const auto& v, const auto& w) {
      return Long_real(v[0] * w[1] - v[1] * w[0]);
    };
    return sign_unless_tiny(square(j) * cross(k, l) - square(k) * cross(j, l) +
                            square(l) * cross(j, k));
  }
};

void check_accordion(const Accordion& accordion, std::size_t expected_ties)
{
  const Mesh mesh = accordion.mesh();
  const Unfolded unfolded(accordion, mesh);
  Triangulation t(mesh);
  IT::make_Delaunay(t, IT::parameters::exact_decisions(true));
  const IT::Delaunay_certificate certificate = IT::certify_Delaunay(t);
  EXPECT_TRUE(certificate.is_Delaunay());
  EXPECT_EQ(certificate.undecided(), 0u);
  std::vector<Edge_index> ties;
  for(Edge_index e : t.mesh().edges())
    if(!t.mesh().is_border(e)) {
      const CGAL::Sign sign = unfolded.Delaunay_sign(t.mesh().halfedge(e), t.mesh());
      EXPECT_NE(sign, CGAL::NEGATIVE) << e;
      if(sign == CGAL::ZERO)
        ties.push_back(e);
    }
  EXPECT_EQ(certificate.ties, ties);
  EXPECT_EQ(ties.size(), expected_ties);
}

// The squared widths are products of 2, 5, 13 and 17.
const std::vector<Panel> dependent_panels{{1, 1},  {2, 1},  {3, -2}, {4, 1},  {3, -1},
                                          {5, 1},  {5, -3}, {8, 1},  {9, -2}, {11, 3},
                                          {13, 1}, {14, 5}, {21, -1}};
// The squared widths are primes.
const std::vector<Panel> independent_panels{{1, 1},  {2, 1},  {3, -2}, {4, 1},  {5, -2},
                                            {6, 1},  {5, -4}, {7, 2},  {6, -5}, {8, 3},
                                            {8, -5}, {9, 4},  {10, -1}};

std::vector<Panel> some_panels(const std::vector<Panel>& panels, std::size_t count,
                               Portable_random& random)
{
  std::vector<Panel> result;
  for(std::size_t i = 0; i < count; ++i) {
    const int factor = random.get_int(1, 3);
    const Panel& panel = panels[(i + std::size_t(random.get_int(0, 2))) % panels.size()];
    result.push_back({factor * panel.x, factor * panel.z});
  }
  return result;
}

TEST(Roots, rectangles_over_many_folds_are_ties)
{
  for(unsigned int seed : seeds(24)) {
    Portable_random random(seed);
    const bool are_independent = seed % 3 == 0;
    Accordion a{some_panels(are_independent ? independent_panels : dependent_panels,
                            3 + std::size_t(random.get_int(0, are_independent ? 7 : 20)), random),
                {-999, 0, 57, 999},
                {-999, 0, 57, 999}};
    if(seed % 2 == 0)
      a.left[1] = a.right[1] = random.get_double(-1, 1);
    check_accordion(a, 1);
    a.left[1] += std::ldexp(1., -random.get_int(40, 1000)); // next to a tie
    check_accordion(a, a.left[1] == a.right[1] ? 1 : 0);
    a.left[1] = 2 * a.right[1] - a.left[1];
    check_accordion(a, a.left[1] == a.right[1] ? 1 : 0);
  }
}

// The fan has 28 vertices and eleven roots of rank 8.
TEST(Roots, roots_of_products_are_not_counted)
{
  check_accordion({{{10, -10},
                    {5, 11},
                    {11, -10},
                    {3, 1},
                    {8, -9},
                    {6, 1},
                    {7, -11},
                    {4, 10},
                    {2, -4},
                    {8, 10},
                    {9, -7}},
                   {-469, 0, 57, 469},
                   {-469, 0, 57, 469}},
                  1);
}

// A decision that is not affordable is not a tie and not certified, and exact traits reject it.
TEST(Roots, too_many_independent_roots_are_undecided)
{
  const Accordion a{independent_panels, {-999, 0, 57, 999}, {-999, 0, 57, 999}};
  const Mesh mesh = a.mesh();
  Triangulation t(mesh);
  IT::make_Delaunay(t, IT::parameters::exact_decisions(true));
  const IT::Delaunay_certificate certificate = IT::certify_Delaunay(t);
  EXPECT_FALSE(certificate.is_Delaunay());
  EXPECT_TRUE(certificate.is_geodesic());
  EXPECT_EQ(certificate.possibly_non_Delaunay_edges.size(), 1u);
  EXPECT_EQ(certificate.undecided(), 1u);
  EXPECT_TRUE(certificate.ties.empty());
  const Unfolded unfolded(a, mesh);
  EXPECT_EQ(
    unfolded.Delaunay_sign(t.mesh().halfedge(certificate.possibly_non_Delaunay_edges[0]), t.mesh()),
    CGAL::ZERO);
  Exact_triangulation exact(mesh);
  EXPECT_THROW(IT::make_Delaunay(exact), IT::Numerical_error);
  EXPECT_TRUE(exact.is_valid(true));
  Accordion near = a;
  near.left[1] = 0x1p-900; // far enough from a tie for floating point
  Triangulation other(near.mesh());
  IT::make_Delaunay(other, IT::parameters::exact_decisions(true));
  EXPECT_TRUE(IT::certify_Delaunay(other).is_Delaunay());
}

// ---- Traits derived from the default ones ----

struct Named_traits : IT::Euclidean_geometry_traits<>
{
  std::string name = "of one's own";
};

struct Thrifty_traits : IT::Euclidean_geometry_traits<>
{
  struct Is_locally_Delaunay : IT::Euclidean_geometry_traits<>::Is_locally_Delaunay
  {};
};

static_assert(IT::internal::has_metric<Named_traits>());
static_assert(IT::internal::has_exact_decisions<Named_traits>());
static_assert(IT::internal::has_metric<Thrifty_traits>());
static_assert(!IT::internal::has_exact_decisions<Thrifty_traits>());
static_assert(!IT::internal::has_metric<IT::Euclidean_geometry_traits<Long_real>>());
static_assert(IT::internal::has_exact_decisions<Exact_triangulation::Traits>());

TEST(Roots, derived_traits_keep_exact_decisions)
{
  const Accordion a{{{1, 1}, {2, 1}, {3, -2}}, {-999, 0x1p-900, 57, 999}, {-999, 0, 57, 999}};
  const Mesh mesh = a.mesh();
  IT::Intrinsic_triangulation<Named_traits> t(mesh);
  Triangulation expected(mesh);
  const auto exactly = IT::parameters::exact_decisions(true);
  EXPECT_EQ(IT::make_Delaunay(t, exactly), IT::make_Delaunay(expected, exactly));
  EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
  for(Edge_index e : t.mesh().edges())
    EXPECT_EQ(t.length(e), expected.length(e));
  // The metric of a user-defined condition can still be certified.
  EXPECT_FALSE(
    IT::certify_Delaunay(IT::Intrinsic_triangulation<Thrifty_traits>(mesh)).is_Delaunay());
}

} // namespace Test_roots
