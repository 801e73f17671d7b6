// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/generators.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Ideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Lazy_exact_nt.h>

namespace Test_ideal_geometry {

using namespace Test_surfaces;
using IT::Diamond;
using Rational = CGAL::Exact_rational;
using Double_traits = IT::Ideal_geometry_traits<>;
using Exact_traits = IT::Ideal_geometry_traits<Rational>;

// ---- The light cone ----

// Represents the light-like vector w^2 (1 - p^2, 2p, 1 + p^2). Every ray of the light cone but one
// has a p, in this order, and -<q,r>/2 is a square. So Penner lengths are rational.
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

// Returns n points in order around the light cone.
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

// Returns the diamond of points i, l, j, k in this order.
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

// Returns a positive sign if the polyhedron with faces ijk and jil is strictly convex along ij.
// Then the corner l is on the side of the plane ijk away from the origin.
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

// Stores points around the light cone, and a strip of triangles of them from the first to another
// one.
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

  // Returns the ends of the inner edges.
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

// All terms are positive, so all numbers keep their digits, whatever the decoration is.
TEST(Ideal_geometry, rounded_strip_keeps_its_digits)
{
  CGAL::Random random(4);
  IT::Ideal_strip<Rational> exact;
  IT::Ideal_strip<double> rounded;
  const auto expect_close = [](const Rational& x, double y, std::size_t n) {
    // Each triangle contributes four rounding errors of half a unit in the last place, and the end
    // contributes ten.
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

// ---- Circles ----

// Returns |sin(alpha - beta)|, a chord of a circle of diameter 1, from the tangents of the halves
// of both angles.
Rational chord(const Rational& a, const Rational& b)
{
  const Rational sine = (2 * a * (1 - b * b) - 2 * b * (1 - a * a)) / ((1 + a * a) * (1 + b * b));
  return CGAL::abs(sine);
}

// By Ptolemy's theorem the flip equals the flip in the plane, and both diagonals are Delaunay.
TEST(Ideal_geometry, flip_in_a_circle_is_euclidean)
{
  CGAL::Random random(5);
  for(int n = 0; n < 200; ++n) {
    std::array<Rational, 4> a{random_positive(random), Rational(0), Rational(0), Rational(0)};
    for(std::size_t m = 1; m < 4; ++m)
      a[m] = a[m - 1] + random_positive(random);
    const Diamond<Rational> d{chord(a[0], a[2]), chord(a[2], a[3]), chord(a[3], a[0]),
                              chord(a[0], a[1]), chord(a[1], a[2])};
    const Rational kl = chord(a[1], a[3]);
    EXPECT_EQ(Exact_traits::Compute_flipped_length()(d), kl);
    const Diamond<Rational> flipped{kl, d.lj, d.jk, d.ki, d.il};
    for(const Diamond<Rational>& tie : {d, flipped}) {
      EXPECT_TRUE(Exact_traits::Is_locally_Delaunay()(tie));
      EXPECT_TRUE(Double_traits::Is_locally_Delaunay()(to_double(tie)));
    }
  }
}

// In floating point the new edge is Delaunay, however close the decision is.
TEST(Ideal_geometry, flipped_edge_is_delaunay)
{
  CGAL::Random random(6);
  const Double_traits::Is_locally_Delaunay is_Delaunay;
  std::size_t flips = 0;
  for(int n = 0; n < 20000; ++n) {
    const auto length = [&] { return std::exp(random.get_double(-9, 9)); };
    Diamond<double> d{1, length(), length(), length(), length()};
    const double k = d.jk * d.ki, l = d.il * d.lj;
    const double tie = std::sqrt(
      ((d.jk * d.jk + d.ki * d.ki) / k + (d.il * d.il + d.lj * d.lj) / l) / (1 / k + 1 / l));
    d.ij = tie * (1 + random.get_int(-10, 400) * std::numeric_limits<double>::epsilon());
    if(is_Delaunay(d))
      continue;
    ++flips;
    EXPECT_TRUE(is_Delaunay({Double_traits::Compute_flipped_length()(d), d.lj, d.jk, d.ki, d.il}));
  }
  EXPECT_GT(flips, 1000u);
}

TEST(Ideal_geometry, lengths_have_a_range)
{
  const Double_traits::Is_length is_length;
  for(double length : {1., 1e-150, 1e150, 1e-30, 1e30})
    EXPECT_TRUE(is_length(length));
  for(double length : {0., -1., 1e-160, 1e160, std::numeric_limits<double>::infinity(),
                       std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(is_length(length));
  // Decisions are correct at the ends of the range.
  const Double_traits::Is_locally_Delaunay is_Delaunay;
  EXPECT_FALSE(is_Delaunay({1e150, 1e-150, 1e-150, 1e-150, 1e-150}));
  EXPECT_FALSE(is_Delaunay({1e150, 1e-150, 1e149, 1e149, 1e-150}));
  EXPECT_TRUE(is_Delaunay({1e-150, 1e-150, 1e150, 1e150, 1e-150}));
  EXPECT_TRUE(is_Delaunay({1e-150, 1e150, 1e150, 1e150, 1e150}));
}

// ---- Surfaces ----

using Exact_triangulation = IT::Intrinsic_triangulation<Exact_traits>;
using Double_triangulation = IT::Intrinsic_triangulation<Double_traits>;
using Exact_correspondence = IT::Correspondence<Exact_traits>;
using IT::Side;

constexpr std::array<Side, 2> both_sides{Side::input, Side::intrinsic};

Side other(Side side) { return side == Side::input ? Side::intrinsic : Side::input; }

// Returns numbers without regard to the triangle inequality.
std::vector<double> positive_numbers(std::size_t n, double range, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<double> result(n);
  for(double& x : result)
    x = std::exp(random.get_double(-range, range));
  return result;
}

bool is_closed(const Delta_complex& mesh)
{
  for(Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h))
      return false;
  return true;
}

std::vector<Named_complex> small_complexes()
{
  std::vector<Named_complex> result;
  for(Named_complex& c : complexes())
    if(c.mesh.number_of_edges() < 60)
      result.push_back(c);
  return result;
}

template <typename Traits>
void flip_to_Delaunay_at_random(IT::Intrinsic_triangulation<Traits>& t, unsigned int seed)
{
  CGAL::Random random(seed);
  for(;;) {
    std::vector<Edge_index> wrong;
    for(Edge_index e : t.mesh().edges())
      if(!t.is_Delaunay(e))
        wrong.push_back(e);
    if(wrong.empty())
      return;
    const auto i = random.get_int(0, static_cast<int>(wrong.size()));
    t.flip(t.mesh().halfedge(wrong[static_cast<std::size_t>(i)]));
  }
}

// Returns the edges of T2, each by its crossings with T1, in order: they determine T2 up to its
// numbering.
template <typename Traits>
std::vector<std::vector<Halfedge_index>> passages(const IT::Intrinsic_triangulation<Traits>& t)
{
  std::vector<std::vector<Halfedge_index>> result;
  for(Edge_index e : t.mesh().edges()) {
    const Halfedge_index h = t.mesh().halfedge(e);
    std::vector<std::vector<Halfedge_index>> both;
    for(Halfedge_index x : {h, t.mesh().opposite(h)}) {
      both.emplace_back();
      for(const auto& p : IT::trace_intrinsic_edge(t, x))
        both.back().push_back(p.on_input.halfedge);
      both.back().pop_back();
    }
    result.push_back((std::min)(both[0], both[1]));
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Ideal_geometry, every_order_of_flips_gives_the_same_delaunay_triangulation)
{
  std::size_t flips = 0;
  for(const auto& [name, mesh] : traced(small_complexes()))
    for(unsigned int seed = 0; seed < 3; ++seed) {
      const auto start =
        triangulation<Exact_traits>(mesh, positive_numbers(mesh.number_of_edges(), 2, seed));
      Exact_triangulation a = start, b = start, c = start;
      flips += IT::make_Delaunay(a);
      flip_to_Delaunay_at_random(b, seed);
      random_flips(c, 2 * mesh.number_of_edges(), seed);
      flip_to_Delaunay_at_random(c, seed + 1);
      EXPECT_TRUE(a.is_valid(true) && b.is_valid(true) && c.is_valid(true));
      EXPECT_EQ(passages(a), passages(b));
      EXPECT_EQ(passages(a), passages(c));
    }
  EXPECT_GT(flips, 300u);
}

// A filter of intervals before rational numbers changes no decision and no length.
TEST(Ideal_geometry, filtered_numbers_are_exact)
{
  using Filtered_traits = IT::Ideal_geometry_traits<CGAL::Lazy_exact_nt<Rational>>;
  for(const auto& [name, mesh] : traced(small_complexes())) {
    const auto length = positive_numbers(mesh.number_of_edges(), 2, 4);
    auto exact = triangulation<Exact_traits>(mesh, length);
    auto filtered = triangulation<Filtered_traits>(mesh, length);
    EXPECT_EQ(IT::make_Delaunay(exact), IT::make_Delaunay(filtered));
    EXPECT_EQ(passages(exact), passages(filtered));
    EXPECT_TRUE(IT::is_Delaunay(filtered));
    for(Edge_index e : mesh.edges())
      EXPECT_EQ(exact.length(e), filtered.length(e).exact());
  }
}

TEST(Ideal_geometry, exact_ties_keep_the_edge)
{
  const Delta_complex torus = glue({{1, 2, 3}, {-1, -2, -3}});
  const auto check = [](auto t) {
    for(int flips = 0; flips < 2; ++flips) {
      auto unchanged = t;
      EXPECT_EQ(IT::make_Delaunay(unchanged), 0u);
      t.flip(Halfedge_index(4)); // the other diagonal of a rectangle
      EXPECT_EQ(t.length(Edge_index(2)), 5);
    }
  };
  check(triangulation<Exact_traits>(torus, {3, 4, 5}));
  check(triangulation<IT::Ideal_geometry_traits<CGAL::Lazy_exact_nt<Rational>>>(torus, {3, 4, 5}));
  const double longer = std::nextafter(5., 6.);
  auto t = triangulation<Exact_traits>(torus, {3, 4, longer});
  EXPECT_EQ(IT::make_Delaunay(t), 1u);
}

// Flips in any order, back to where they started: every length is the same number again.
TEST(Ideal_geometry, flips_back_to_the_input_are_exact)
{
  for(const auto& [name, mesh] : traced(small_complexes())) {
    const auto start =
      triangulation<Exact_traits>(mesh, positive_numbers(mesh.number_of_edges(), 2, 1));
    Exact_triangulation t = start;
    std::vector<Halfedge_index> flipped = random_flips(t, 2 * mesh.number_of_edges(), 7);
    Exact_triangulation u = t;
    u.recompute_lengths(); // along T1, without the flips in between
    for(Edge_index e : mesh.edges())
      EXPECT_EQ(t.length(e), u.length(e));
    // An edge that is shared again has its length from T1, so t itself is not used.
    std::vector<Rational> length;
    for(Edge_index e : mesh.edges())
      length.push_back(t.length(e));
    while(!flipped.empty()) {
      const Halfedge_index h = flipped.back();
      length[mesh.edge(h).idx()] = Exact_traits::Compute_flipped_length()(
        IT::diamond(boost::make_function_property_map<Edge_index>(
                      [&](Edge_index e) { return length[e.idx()]; }),
                    h, t.mesh()));
      t.flip(h);
      flipped.pop_back();
    }
    for(Edge_index e : mesh.edges())
      EXPECT_EQ(length[e.idx()], start.length(e));
  }
}

// Returns the greatest violation of the triangle inequality, relative to the longest side.
template <typename Traits>
typename Traits::FT triangle_defect(const IT::Intrinsic_triangulation<Traits>& t)
{
  typedef typename Traits::FT FT;
  const Delta_complex& mesh = t.mesh();
  FT result(-1);
  for(Halfedge_index h : mesh.halfedges()) {
    const FT &a = t.length(mesh.edge(h)), &b = t.length(mesh.edge(mesh.next(h)));
    const FT& c = t.length(mesh.edge(mesh.prev(h)));
    result = (std::max)(result, FT((a - b - c) / a));
  }
  return result;
}

TEST(Ideal_geometry, delaunay_triangulation_satisfies_the_triangle_inequality)
{
  for(const auto& [name, mesh] : complexes())
    if(is_closed(mesh) && mesh.number_of_edges() < 20)
      for(double range : {1., 5., 10.}) {
        SCOPED_TRACE(name);
        auto t =
          triangulation<Exact_traits>(mesh, positive_numbers(mesh.number_of_edges(), range, 8));
        IT::make_Delaunay(t);
        EXPECT_TRUE(triangle_defect(t) < 0);
      }
}

TEST(Ideal_geometry, wild_lengths_become_delaunay)
{
  for(const auto& [name, mesh] : complexes())
    for(double range : {10., 30., 69.}) // up to 1e30, down to 1e-30
      for(unsigned int seed = 0; seed < 5; ++seed) {
        SCOPED_TRACE(name);
        auto t =
          triangulation<Double_traits>(mesh, positive_numbers(mesh.number_of_edges(), range, seed));
        IT::make_Delaunay(t);
        EXPECT_TRUE(IT::is_Delaunay(t));
        EXPECT_TRUE(t.is_valid(true));
        if(is_closed(mesh)) { // strict up to rounding
          EXPECT_LT(triangle_defect(t), 1e-13);
        }
      }
}

// ---- Correspondence ----

// Returns small surfaces, both Delaunay and after random flips.
std::vector<std::pair<std::string, Exact_triangulation>> exact_triangulations()
{
  std::vector<std::pair<std::string, Exact_triangulation>> result;
  for(const auto& [name, mesh] : small_complexes()) {
    auto t = triangulation<Exact_traits>(mesh, positive_numbers(mesh.number_of_edges(), 2, 9));
    IT::make_Delaunay(t);
    result.emplace_back(name + ", Delaunay", t);
    random_flips(t, mesh.number_of_edges(), 10);
    result.emplace_back(name + ", flipped", t);
  }
  return result;
}

template <typename Traits>
std::vector<IT::Face_location<typename Traits::FT>> sample(const Delta_complex& mesh, std::size_t n,
                                                           unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<IT::Face_location<typename Traits::FT>> result;
  for(std::size_t i = 0; i < n; ++i) {
    typedef typename Traits::FT FT;
    const auto f = random_index<Face_index>(mesh.number_of_faces(), random);
    const FT u(random.get_int(0, 100)), v(random.get_int(1, 100)), w(random.get_int(1, 100));
    result.push_back(
      {f, {v / (u + v + w), FT(1 - v / (u + v + w) - w / (u + v + w)), w / (u + v + w)}});
  }
  return result;
}

TEST(Ideal_geometry, crossings_are_those_of_the_integer_coordinates)
{
  for(const auto& [name, t] : traced(exact_triangulations())) {
    const Exact_correspondence c(t);
    std::size_t on_intrinsic = 0, on_input = 0;
    for(Edge_index e : t.mesh().edges()) {
      const auto n = c.number_of_crossings(Side::intrinsic, e);
      EXPECT_EQ(n, IT::crossings(t.coordinates().normal_coordinate(e)));
      on_intrinsic += n;
    }
    for(Edge_index e : t.input_mesh().edges())
      on_input += c.number_of_crossings(Side::input, e);
    EXPECT_EQ(on_input, on_intrinsic);
    EXPECT_EQ(on_input, c.number_of_crossings());
    for(Side side : both_sides)
      for(Halfedge_index h : c.mesh(side).halfedges()) {
        Rational last(0);
        for(Delta_complex::size_type p = 0; p < c.number_of_crossings(side, Edge_index(h)); ++p) {
          const Rational place = c.crossing(side, h, p).here.t;
          EXPECT_TRUE(last < place && place < 1);
          last = place;
        }
      }
  }
}

TEST(Ideal_geometry, scales_are_positive)
{
  for(const auto& [name, t] : traced(exact_triangulations())) {
    const Exact_correspondence c(t);
    for(Delta_complex::size_type id = 0; id < c.number_of_crossings(); ++id)
      EXPECT_TRUE(c.scale(id) > 0);
  }
}

// The correspondence lays out edges of T1 on T2. Without it, edges of T2 are laid out on T1, too.
TEST(Ideal_geometry, points_go_there_and_back_exactly)
{
  for(const auto& [name, t] : traced(exact_triangulations())) {
    const Exact_correspondence c(t);
    for(Side side : both_sides)
      for(const auto& p : sample<Exact_traits>(c.mesh(side), 12, 11)) {
        const auto q = IT::point_across(c, side, p);
        EXPECT_EQ(q, IT::point_across(t, side, p));
        const auto back = IT::point_across(c, other(side), q);
        EXPECT_EQ(back, IT::point_across(t, other(side), q));
        if(p.second[1] != 0) { // otherwise it may be seen from the other side of its edge
          EXPECT_EQ(back, p);
        }
      }
  }
}

// ---- Points across by central projection ----

// Represents a triangle of T1 laid out in the light cone; h is its first side. Any basis of space
// is possible, for instance the corners of the first triangle.
struct Lifted_triangle
{
  Halfedge_index h;
  std::array<Vector_3, 3> q; // the source of h, its target, and the apex
};

Vector_3 combination(const std::array<Vector_3, 3>& q, const std::array<Rational, 3>& w)
{
  Vector_3 result;
  for(std::size_t x = 0; x < 3; ++x)
    result[x] = w[0] * q[0][x] + w[1] * q[1][x] + w[2] * q[2][x];
  return result;
}

class Light_cone
{
public:
  explicit Light_cone(const Exact_triangulation& t) : m_t(t), m_mesh(t.input_mesh()) {}

  Lifted_triangle first(Halfedge_index h) const
  {
    return {h, {Vector_3{1, 0, 0}, Vector_3{0, 1, 0}, Vector_3{0, 0, 1}}};
  }

  Lifted_triangle next(const Lifted_triangle& a) const
  {
    return {m_mesh.next(a.h), {a.q[1], a.q[2], a.q[0]}};
  }

  // Returns the triangle, turned so that it begins with this side.
  Lifted_triangle turned(Lifted_triangle a, Halfedge_index h) const
  {
    while(a.h != h)
      a = next(a);
    return a;
  }

  // Returns the triangle beyond the side h, whose apex follows from the relation of four light-like
  // vectors.
  Lifted_triangle beyond(const Lifted_triangle& a) const
  {
    const Halfedge_index o = m_mesh.opposite(a.h);
    const Rational ij = length(a.h), jk = length(m_mesh.next(a.h)), ki = length(m_mesh.prev(a.h));
    const Rational il = length(m_mesh.next(o)), lj = length(m_mesh.prev(o));
    const Rational kl = (ki * lj + jk * il) / ij;
    const Rational of_l = ij * jk * ki, of_k = ij * il * lj, of_i = jk * kl * lj,
                   of_j = ki * kl * il;
    return {o,
            {a.q[1], a.q[0],
             combination({a.q[0], a.q[1], a.q[2]}, {of_i / of_l, of_j / of_l, -of_k / of_l})}};
  }

  Lifted_triangle counterclockwise(const Lifted_triangle& a) const
  {
    return beyond(turned(a, m_mesh.prev(a.h)));
  }

  // Returns the end of a halfedge of T2 that starts at the source of the outgoing halfedge `a` of
  // T1.
  Vector_3 end_of(Halfedge_index h, Lifted_triangle a) const
  {
    const auto trace = IT::trace_intrinsic_edge(m_t, h);
    for(std::size_t m = 1; m + 1 < trace.size(); ++m)
      a = beyond(turned(a, trace[m].on_input.halfedge));
    return trace.size() == 2 ? a.q[1] : a.q[2];
  }

  // Returns the point of T1 on the ray of the point `p` of a face of T2.
  std::pair<Halfedge_index, std::array<Rational, 3>>
  project(const IT::Face_location<Rational>& p) const
  {
    const Halfedge_index x = m_t.mesh().halfedge(p.first),
                         z = m_t.mesh().opposite(m_t.mesh().prev(x));
    const Lifted_triangle start = first(m_t.input_outgoing_before(x));
    const Vector_3 &X = start.q[0], Y = end_of(x, start);
    Lifted_triangle a = start;
    Vector_3 Z = Y;
    for(bool is_first = true; !(determinant(X, Y, Z) > 0); is_first = false) {
      if(!is_first)
        a = counterclockwise(a);
      while(a.h != m_t.input_outgoing_before(z))
        a = counterclockwise(a);
      Z = end_of(z, a);
    }
    return walk(start, combination({X, Y, Z}, p.second));
  }

private:
  const Rational& length(Halfedge_index h) const { return m_t.input_length(m_mesh.edge(h)); }

  static std::array<Rational, 3> coordinates(const Lifted_triangle& a, const Vector_3& p)
  {
    std::array<Rational, 3> w{determinant(p, a.q[1], a.q[2]), determinant(a.q[0], p, a.q[2]),
                              determinant(a.q[0], a.q[1], p)};
    const Rational sum = w[0] + w[1] + w[2];
    for(Rational& x : w)
      x /= sum;
    return w;
  }

  static bool contains(const Lifted_triangle& a, const Vector_3& p)
  {
    return determinant(p, a.q[1], a.q[2]) >= 0 && determinant(a.q[0], p, a.q[2]) >= 0 &&
           determinant(a.q[0], a.q[1], p) >= 0;
  }

  // Walks straight from the source of the outgoing halfedge `a` to `p`.
  std::pair<Halfedge_index, std::array<Rational, 3>> walk(Lifted_triangle a,
                                                          const Vector_3& p) const
  {
    const Vector_3 start = a.q[0];
    while(!(determinant(start, a.q[1], p) >= 0 && determinant(start, p, a.q[2]) >= 0))
      a = counterclockwise(a);
    if(!contains(a, p)) {
      a = beyond(next(a));
      while(!contains(a, p))
        a = beyond(determinant(start, p, a.q[2]) > 0 ? next(a) : next(next(a)));
    }
    return {a.h, coordinates(a, p)};
  }

  const Exact_triangulation& m_t;
  const Delta_complex& m_mesh;
};

TEST(Ideal_geometry, points_across_are_central_projections)
{
  std::size_t surfaces = 0;
  for(const auto& [name, t] : exact_triangulations()) {
    if(!is_closed(t.mesh()))
      continue;
    SCOPED_TRACE(name);
    ++surfaces;
    const Light_cone cone(t);
    const Exact_correspondence c(t);
    for(const auto& p : sample<Exact_traits>(t.mesh(), 20, 12)) {
      if(p.second[1] == 0)
        continue;
      const auto q = IT::point_across(c, Side::intrinsic, p);
      const auto [h, w] = cone.project(p);
      ASSERT_EQ(q.first, t.input_mesh().face(h));
      EXPECT_EQ(IT::coordinates_from(h, q, t.input_mesh()), w);
    }
  }
  EXPECT_GT(surfaces, 15u);
}

// ---- No inserted vertices ----

TEST(Ideal_geometry, inserted_vertices_are_refused)
{
  const auto t = triangulation<Double_traits>(glue({{1, 2, 3}}), {1, 1, 1});
  EXPECT_NO_THROW(Double_triangulation(t.input_mesh(), t.mesh()));
  const IT::Face_location<double> center(Face_index(0), {0.25, 0.25, 0.5});
  EXPECT_THROW(Double_triangulation(t.input_mesh(), t.mesh(), {center}), IT::Invalid_input);
}

// ---- Floating point ----

Delta_complex connectivity(const Mesh& mesh) { return IT::Intrinsic_triangulation<>(mesh).mesh(); }

// Returns the lengths of a mesh, scaled at its vertices.
std::vector<double> scaled_lengths(const Mesh& mesh, double range, unsigned int seed)
{
  const auto u = positive_numbers(mesh.number_of_vertices(), range / 2, seed); // exp(u / 2)
  std::vector<double> result;
  for(Edge_index e : mesh.edges()) {
    const Vertex_index i = mesh.vertex(e, 0), j = mesh.vertex(e, 1);
    result.push_back(std::sqrt(CGAL::squared_distance(mesh.point(i), mesh.point(j))) * u[i.idx()] *
                     u[j.idx()]);
  }
  return result;
}

TEST(Ideal_geometry, scaled_meshes_become_delaunay)
{
  for(const auto& [name, mesh] : traced(meshes()))
    for(double range : {0.5, 5., 15.}) {
      auto t = triangulation<Double_traits>(connectivity(mesh), scaled_lengths(mesh, range, 13));
      IT::make_Delaunay(t);
      EXPECT_TRUE(IT::is_Delaunay(t));
      EXPECT_TRUE(t.is_valid(true));
      const IT::Correspondence<Double_traits> c(t);
      const IT::Common_subdivision<Double_traits> s(c);
      EXPECT_TRUE(s.mesh().is_valid());
      EXPECT_EQ(Euler_characteristic(s.mesh()), Euler_characteristic(t.input_mesh()));
      Double_triangulation back = t;
      flip_to_input(back);
      for(Edge_index e : back.mesh().edges())
        EXPECT_TRUE(back.coordinates().is_shared(e));
    }
}

// Exact numbers yield the truth.
TEST(Ideal_geometry, rounded_crossings_keep_their_digits)
{
  // Every edge results from a few flips, each with three rounding errors, and every strip is a few
  // triangles long.
  const double digits = 1e-13;
  std::size_t crossings = 0;
  for(const auto& [name, regular] : traced(meshes()))
    for(double range : {1., 4.}) {
      const Mesh mesh = perturbed(regular, 0.05, 16); // no ties
      const auto lengths = scaled_lengths(mesh, range, 14);
      auto rounded = triangulation<Double_traits>(connectivity(mesh), lengths);
      auto exact = triangulation<Exact_traits>(connectivity(mesh), lengths);
      IT::make_Delaunay(rounded);
      IT::make_Delaunay(exact);
      ASSERT_EQ(passages(rounded), passages(exact));
      const IT::Correspondence<Double_traits> c(rounded);
      const Exact_correspondence d(exact);
      ASSERT_EQ(c.number_of_crossings(), d.number_of_crossings());
      for(Delta_complex::size_type id = 0; id < c.number_of_crossings(); ++id, ++crossings) {
        const auto p = c.crossing(id);
        const auto q = d.crossing(id);
        EXPECT_EQ(p.on_input.halfedge, q.on_input.halfedge);
        EXPECT_NEAR(p.on_input.t, CGAL::to_double(q.on_input.t), digits);
        EXPECT_NEAR(p.on_intrinsic.t, CGAL::to_double(q.on_intrinsic.t), digits);
        EXPECT_NEAR(c.scale(id) / CGAL::to_double(d.scale(id)), 1, digits);
      }
    }
  EXPECT_GT(crossings, 100u);
}

} // namespace Test_ideal_geometry
