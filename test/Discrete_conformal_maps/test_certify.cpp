// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/data_meshes.h"
#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/certify.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/certify_ideal_Delaunay.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace Test_certify {

using namespace Test_surfaces;
using Rational = CGAL::Exact_rational;
using Ideal_traits = IT::Ideal_geometry_traits<>;
using Exact_ideal_traits = IT::Ideal_geometry_traits<Rational>;
using Ideal_triangulation = IT::Intrinsic_triangulation<Ideal_traits>;
using Ideal_correspondence = IT::Correspondence<Ideal_traits>;
using Flips = std::vector<Halfedge_index>;

std::vector<double> random_factors(std::size_t n, double range, unsigned int seed)
{
  std::vector<double> result = random_values(n, range, seed);
  for(double& x : result)
    x = std::exp(x);
  return result;
}

template <typename Traits>
void flip(IT::Intrinsic_triangulation<Traits>& t, const Flips& flips)
{
  for(Halfedge_index h : flips)
    t.flip(h);
}

// ---- The ideal Delaunay condition ----

// Returns the sign of Equation 4.5 without quotients, at lengths computed by flips in rational
// numbers.
CGAL::Sign ideal_Delaunay_sign(const IT::Diamond<Rational>& d)
{
  return CGAL::compare((d.jk * d.il + d.ki * d.lj) * (d.jk * d.lj + d.ki * d.il),
                       d.ij * d.ij * (d.il * d.lj + d.jk * d.ki));
}

struct Expected_certificate
{
  std::vector<Edge_index> ties, non_Delaunay_edges;
  std::size_t edges = 0;
};

template <typename Length>
Expected_certificate expected_certificate(const Delta_complex& mesh, const Length& length,
                                          const std::vector<double>& factor)
{
  const auto scaled = boost::make_function_property_map<Edge_index>([&](Edge_index e) {
    return Rational(length(e) * Rational(factor[mesh.vertex(e, 0)]) *
                    Rational(factor[mesh.vertex(e, 1)]));
  });
  Expected_certificate result;
  for(Edge_index e : mesh.edges()) {
    if(mesh.is_border(e))
      continue;
    ++result.edges;
    const CGAL::Sign sign = ideal_Delaunay_sign(IT::diamond(scaled, mesh.halfedge(e), mesh));
    if(sign == CGAL::ZERO)
      result.ties.push_back(e);
    if(sign == CGAL::NEGATIVE)
      result.non_Delaunay_edges.push_back(e);
  }
  return result;
}

std::vector<Edge_index> sorted(std::vector<Edge_index> edges)
{
  std::sort(edges.begin(), edges.end());
  return edges;
}

void expect_equal(const IT::Ideal_Delaunay_certificate& c, const Expected_certificate& expected)
{
  EXPECT_EQ(sorted(c.ties), expected.ties);
  EXPECT_EQ(sorted(c.non_Delaunay_edges), expected.non_Delaunay_edges);
  EXPECT_EQ(c.decided_in_floating_point + c.decided_exactly, expected.edges);
  EXPECT_EQ(c.is_Delaunay(), expected.non_Delaunay_edges.empty());
  EXPECT_EQ(c.greatest_excess > 0, !expected.non_Delaunay_edges.empty());
}

struct Flip_recorder : IT::Default_flip_visitor
{
  void after_flip(Halfedge_index h) { flips.push_back(h); }
  Flips flips;
};

template <typename Traits>
Flips flips_to_Delaunay(IT::Intrinsic_triangulation<Traits> t)
{
  Flip_recorder recorder;
  IT::make_Delaunay(t, CGAL::parameters::visitor(std::ref(recorder)));
  return recorder.flips;
}

void check_against_exact_flips(const Delta_complex& mesh, const std::vector<double>& length,
                               const std::vector<double>& factor, const Flips& flips)
{
  auto rounded = triangulation<Ideal_traits>(mesh, length);
  auto exact = triangulation<Exact_ideal_traits>(mesh, length);
  flip(rounded, flips);
  flip(exact, flips);
  expect_equal(IT::certify_ideal_Delaunay(rounded, factor),
               expected_certificate(
                 exact.mesh(), [&](Edge_index e) { return exact.length(e); }, factor));
}

TEST(Certify_ideal_Delaunay, agrees_with_exact_flips)
{
  for(const auto& [name, mesh] : complexes()) {
    if(mesh.number_of_edges() > 100)
      continue;
    for(unsigned int seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      const auto length = random_factors(mesh.number_of_edges(), 1 + seed, seed);
      const auto t = triangulation<Ideal_traits>(mesh, length);
      const auto ones = std::vector<double>(mesh.number_of_vertices(), 1.);
      auto copy = t;
      const auto factor = random_factors(mesh.number_of_vertices(), 1, seed + 1);
      for(const Flips& flips :
          {Flips(), random_flips(copy, 2 * mesh.number_of_edges(), seed), flips_to_Delaunay(t)})
        for(const auto& f : {ones, factor})
          check_against_exact_flips(mesh, length, f, flips);
    }
  }
}

TEST(Certify_ideal_Delaunay, what_exact_flips_make_passes)
{
  for(const auto& [name, mesh] : complexes()) {
    if(mesh.number_of_edges() > 100)
      continue;
    SCOPED_TRACE(name);
    const auto length = random_factors(mesh.number_of_edges(), 2, 3);
    auto t = triangulation<Ideal_traits>(mesh, length);
    flip(t, flips_to_Delaunay(triangulation<Exact_ideal_traits>(mesh, length)));
    EXPECT_TRUE(IT::certify_ideal_Delaunay(t).is_Delaunay());
    EXPECT_EQ(IT::certify_ideal_Delaunay(t).greatest_excess, 0);
  }
}

// The ties are rectangles with sides 3 and 4, and quadrangles on a circle with sides 52, 25, 39,
// 60.
TEST(Certify_ideal_Delaunay, knows_ties)
{
  const Delta_complex torus = glue({{1, 2, 3}, {-1, -2, -3}});
  for(double scale : {1., 1e-100, 1e100, 0x1p-40})
    for(double factor : {1., 0.1, 1e20}) {
      auto t = triangulation<Ideal_traits>(torus, {3 * scale, 4 * scale, 5 * scale});
      for(int flips = 0; flips < 2; ++flips) {
        const auto c = IT::certify_ideal_Delaunay(t, {factor});
        if(scale == 1) {
          EXPECT_EQ(c.ties, std::vector<Edge_index>{Edge_index(2)});
          EXPECT_TRUE(c.is_Delaunay());
        }
        EXPECT_EQ(c.decided_exactly, 1u);
        t.flip(Halfedge_index(4));
      }
    }
  const Delta_complex quadrangle = glue({{1, 2, 3}, {-1, 4, 5}});
  auto t = triangulation<Ideal_traits>(quadrangle, {63, 52, 25, 39, 60});
  EXPECT_EQ(IT::certify_ideal_Delaunay(t).ties.size(), 1u);
  t.flip(Halfedge_index(0));
  EXPECT_EQ(t.length(Edge_index(0)), 56);
  EXPECT_EQ(IT::certify_ideal_Delaunay(t).ties.size(), 1u);
}

TEST(Certify_ideal_Delaunay, one_unit_in_the_last_place_decides)
{
  const Delta_complex quadrangle = glue({{1, 2, 3}, {-1, 4, 5}});
  const auto longer =
    triangulation<Ideal_traits>(quadrangle, {std::nextafter(63., 64.), 52, 25, 39, 60});
  EXPECT_TRUE(IT::is_Delaunay(longer)); // with the tolerance
  const auto c = IT::certify_ideal_Delaunay(longer);
  EXPECT_EQ(c.non_Delaunay_edges, std::vector<Edge_index>{Edge_index(0)});
  EXPECT_NEAR(c.greatest_excess, 2 * (std::nextafter(63., 64.) - 63) / 63, 1e-20);
  EXPECT_TRUE(IT::certify_ideal_Delaunay(
                triangulation<Ideal_traits>(quadrangle, {std::nextafter(63., 0.), 52, 25, 39, 60}))
                .ties.empty());
}

TEST(Certify_ideal_Delaunay, of_the_empty_surface)
{
  EXPECT_TRUE(IT::certify_ideal_Delaunay(Ideal_triangulation()).is_Delaunay());
}

// ---- The order of ends ----

// With many digits, an edge that is not a tie is distinguished from one.
using Real_100 = boost::multiprecision::cpp_bin_float_100;
using Ideal_traits_100 = IT::Ideal_geometry_traits<Real_100>;

// Computes the positions of edges of T_1 on edges of T_2, from the lengths of T_1. These are
// flipped to the lengths of T_2, whose faces the edges of T_1 cross straight.
class Traced_places
{
  using Vector_100 = std::array<Real_100, 2>;

public:
  // `length` contains the lengths of the edges of T_1.
  Traced_places(const std::vector<Real_100>& length, const Flips& flips, const Correspondence& ab)
    : m_ab(ab), m_mesh(ab.mesh(Side::input)), m_length(length), m_place(ab.number_of_crossings())
  {
    for(Halfedge_index h : flips)
      flip(h);
    for(Edge_index e : ab.mesh(Side::input).edges())
      trace(IT::first_halfedge(e));
  }

  // Returns the position on the first halfedge of the edge of T_2.
  const Real_100& operator[](std::size_t crossing) const { return m_place[crossing]; }
  Delta_complex::size_type size() const { return m_ab.number_of_crossings(); }

private:
  static Vector_100 between(const Vector_100& v, const Vector_100& w, const Real_100& s)
  {
    return {v[0] + s * (w[0] - v[0]), v[1] + s * (w[1] - v[1])};
  }
  static Real_100 det(const Vector_100& v, const Vector_100& w)
  {
    return v[0] * w[1] - v[1] * w[0];
  }

  const Real_100& length(Halfedge_index h) const { return m_length[m_mesh.edge(h)]; }

  // Returns the third corner of the face of `h`, whose source is at `s` and whose target is at `t`.
  Vector_100 apex(Halfedge_index h, const Vector_100& s, const Vector_100& t) const
  {
    const Real_100 &c = length(h), &a = length(m_mesh.next(h)), &b = length(m_mesh.prev(h));
    const Real_100 x = (b * b + c * c - a * a) / (2 * c), y = sqrt(b * b - x * x);
    const Vector_100 foot = between(s, t, x / c);
    return {foot[0] - y / c * (t[1] - s[1]), foot[1] + y / c * (t[0] - s[0])};
  }

  void flip(Halfedge_index h)
  {
    const Halfedge_index o = m_mesh.opposite(h);
    const Vector_100 s{Real_100(0), Real_100(0)}, t{length(h), Real_100(0)};
    const Vector_100 k = apex(h, s, t), l = apex(o, t, s);
    m_length[m_mesh.edge(h)] = sqrt((k[0] - l[0]) * (k[0] - l[0]) + (k[1] - l[1]) * (k[1] - l[1]));
    IT::flip_edge(h, m_mesh);
  }

  void trace(Halfedge_index a)
  {
    std::vector<Halfedge_index> exits;
    std::vector<std::array<Vector_100, 2>> ends;
    for(unsigned int m = 0; m < m_ab.number_of_crossings(Side::input, Edge_index(a)); ++m)
      exits.push_back(m_mesh.opposite(m_ab.crossing(Side::input, a, m).across.halfedge));
    if(exits.empty())
      return;
    Vector_100 s{Real_100(0), Real_100(0)}, t{length(exits[0]), Real_100(0)};
    const Vector_100 start = apex(exits[0], s, t);
    for(std::size_t m = 0;; ++m) {
      ends.push_back({s, t});
      const Halfedge_index o = m_mesh.opposite(exits[m]);
      const Vector_100 beyond = apex(o, t, s);
      if(m + 1 == exits.size()) {
        set_places(a, start, beyond, ends);
        return;
      }
      (exits[m + 1] == m_mesh.next(o) ? t : s) = beyond;
    }
  }

  void set_places(Halfedge_index a, const Vector_100& p, const Vector_100& q,
                  const std::vector<std::array<Vector_100, 2>>& ends)
  {
    for(unsigned int m = 0; m < ends.size(); ++m) {
      const auto c = m_ab.crossing(Side::input, a, m);
      const auto& [s, t] = ends[m];
      const Vector_100 line{q[0] - p[0], q[1] - p[1]};
      const Real_100 to_s = det(line, {s[0] - p[0], s[1] - p[1]}),
                     to_t = det(line, {t[0] - p[0], t[1] - p[1]});
      const Real_100 on_exit = to_s / (to_s - to_t);
      m_place[c.id] =
        IT::is_first_halfedge(m_mesh.opposite(c.across.halfedge)) ? on_exit : 1 - on_exit;
    }
  }

  const Correspondence& m_ab;
  Delta_complex m_mesh;
  std::vector<Real_100> m_length, m_place;
};

// Returns the vertices of the subdivision along a halfedge of T_2.
std::vector<Vertex_index> vertices_along(Halfedge_index h, const DCM::Triple_subdivision<>& s)
{
  std::map<Vertex_index, Vertex_index> next;
  Vertex_index v;
  for(Edge_index e : s.mesh().edges())
    for(Halfedge_index x : {s.mesh().halfedge(e), s.mesh().opposite(s.mesh().halfedge(e))})
      if(s.parent_halfedge(Layer::B, x) == h) {
        next[s.mesh().source(x)] = s.mesh().target(x);
        if(s.is_vertex(Layer::B, s.mesh().source(x)))
          v = s.mesh().source(x);
      }
  std::vector<Vertex_index> result;
  while(next.size() > 1) {
    const Vertex_index from = v;
    result.push_back(v = next[from]);
    next.erase(from);
  }
  return result;
}

using Pairs = std::vector<std::pair<Vertex_index, Vertex_index>>;

struct Expected_order
{
  Pairs ties, exchanged;
  std::size_t pairs = 0;
};

Expected_order expected_order(const DCM::Triple_subdivision<>& s, const Traced_places& of_A,
                              const IT::Correspondence<Ideal_traits_100>& bc)
{
  Expected_order result;
  const auto& mesh = bc.mesh(Side::input);
  const auto end_of_A = mesh.num_vertices() + of_A.size();
  for(Edge_index e : mesh.edges()) {
    const auto vertices = vertices_along(IT::first_halfedge(e), s);
    const auto is_A = [&](Vertex_index v) { return v.idx() < end_of_A; };
    const auto place = [&](Vertex_index v) {
      return is_A(v) ? of_A[v.idx() - mesh.num_vertices()]
                     : bc.crossing(v.idx() - end_of_A).on_input.t;
    };
    for(std::size_t i = 1; i < vertices.size(); ++i) {
      const Vertex_index v = vertices[i - 1], w = vertices[i];
      if(is_A(v) == is_A(w))
        continue;
      ++result.pairs;
      const Real_100 difference = place(w) - place(v);
      if(abs(difference) < 1e-80)
        result.ties.emplace_back(v, w);
      else if(difference < 0)
        result.exchanged.emplace_back(v, w);
    }
  }
  return result;
}

Pairs vertices_of(const std::vector<DCM::Pair_of_ends>& pairs)
{
  Pairs result;
  for(const DCM::Pair_of_ends& p : pairs)
    result.emplace_back(p.first, p.second);
  std::sort(result.begin(), result.end());
  return result;
}

std::size_t number_of_pairs(const DCM::Order_certificate& c)
{
  return c.decided_in_floating_point + c.decided_in_multiprecision + c.decided_exactly;
}

void expect_equal(const DCM::Order_certificate& c, Expected_order expected)
{
  std::sort(expected.ties.begin(), expected.ties.end());
  std::sort(expected.exchanged.begin(), expected.exchanged.end());
  EXPECT_EQ(vertices_of(c.ties), expected.ties);
  EXPECT_EQ(vertices_of(c.exchanged), expected.exchanged);
  EXPECT_EQ(number_of_pairs(c), expected.pairs);
  EXPECT_TRUE(c.undecided.empty());
}

Ideal_triangulation with_lengths_times(const Triangulation& b, const std::vector<double>& factor)
{
  std::vector<double> lengths;
  for(Edge_index e : b.mesh().edges())
    lengths.push_back(b.length(e) * factor[e]);
  return triangulation<Ideal_traits>(b.mesh(), lengths);
}

std::vector<Real_100> distances(const Mesh& mesh)
{
  std::vector<Real_100> result;
  for(Edge_index e : mesh.edges()) {
    const Point &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
    Real_100 square = 0;
    for(int i = 0; i < 3; ++i)
      square += (Real_100(p[i]) - Real_100(q[i])) * (Real_100(p[i]) - Real_100(q[i]));
    result.push_back(sqrt(square));
  }
  return result;
}

struct Tested
{
  std::size_t pairs = 0, exchanged = 0, ties = 0;
};

// Checks subdivisions with correct positions, and with positions of T_3 on another surface.
void check_order(const Triangulation& start, const std::vector<Real_100>& length, double range,
                 unsigned int seed, Tested& tested)
{
  Triangulation ab = start;
  Flips flips_ab;
  const std::size_t edges = ab.mesh().number_of_edges();
  flip_at_random(ab, edges / 2, seed, [&](Halfedge_index h) { flips_ab.push_back(h); });
  Ideal_triangulation bc = with_lengths_times(ab, std::vector<double>(edges, 1.));
  Ideal_triangulation other = with_lengths_times(ab, random_factors(edges, range, seed));
  const Flips flips_bc = random_flips(bc, edges / 2, seed + 1);
  auto bc_100 = triangulation<Ideal_traits_100>(ab.mesh(), lengths_of(ab));
  flip(bc_100, flips_bc);
  flip(other, flips_bc);
  const Correspondence c_ab(ab);
  const Ideal_correspondence c_bc(bc);
  const Traced_places places(length, flips_ab, c_ab);
  const IT::Correspondence<Ideal_traits_100> c_bc_100(bc_100);
  for(const Ideal_triangulation* t : {&bc, &other}) {
    const DCM::Triple_subdivision<> s(c_ab, Ideal_correspondence(*t));
    const DCM::Order_certificate c = DCM::certify_order_of_ends(s, c_ab, c_bc);
    expect_equal(c, expected_order(s, places, c_bc_100));
    tested.pairs += number_of_pairs(c);
    tested.exchanged += c.exchanged.size();
    tested.ties += c.ties.size();
  }
}

TEST(Certify_order, agrees_with_exact_places)
{
  Tested tested;
  for(const Named_mesh& m : meshes()) {
    if(m.mesh.number_of_edges() > 100)
      continue;
    for(unsigned int seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(m.name + ", seed " + std::to_string(seed));
      const Triangulation from_points(m.mesh);
      check_order(from_points, distances(m.mesh), 0.5, seed, tested);
      const auto length = lengths_of(from_points);
      check_order(triangulation(from_points.mesh(), length),
                  std::vector<Real_100>(length.begin(), length.end()), 0.5, seed, tested);
    }
  }
  EXPECT_GT(tested.pairs, 200u);
  EXPECT_GT(tested.exchanged, 20u);
  EXPECT_GT(tested.ties, 0u); // on symmetric surfaces
}

// ---- Maps ----

Mesh read_data_mesh(const std::string& name)
{
  for(const std::string& file : data_meshes(10000000))
    if(std::filesystem::path(file).filename() == name)
      return read_repaired_mesh(file);
  return Mesh();
}

// Checks that all edges and pairs are counted, except for the end of a second copy, whose elements
// are mirror images of others. Failures are rounding errors.
void check_map(const DCM::Discrete_conformal_map& map, const DCM::Map_certificate& c)
{
  std::size_t edges = 0;
  for(Edge_index e : mesh_A(map).edges())
    edges += !mesh_A(map).is_border(e);
  for(const auto* on : {&c.on_B, &c.on_C}) {
    EXPECT_EQ(on->decided_in_floating_point + on->decided_exactly, edges);
    EXPECT_LT(on->greatest_excess, 1e-13);
  }
  EXPECT_TRUE(c.order.undecided.empty());
  EXPECT_EQ(c.is_certified(), c.on_B.non_Delaunay_edges.empty() &&
                                c.on_C.non_Delaunay_edges.empty() && c.order.exchanged.empty());
}

TEST(Certify, maps_of_data_meshes)
{
  std::size_t pairs = 0;
  for(const char* name : {"cow.off", "bull.off", "eight.off"}) {
    const Mesh mesh = read_data_mesh(name);
    if(mesh.is_empty())
      GTEST_SKIP() << "CGAL's data files are not here";
    SCOPED_TRACE(name);
    const auto check = [&](const DCM::Discrete_conformal_map& map) {
      const DCM::Map_certificate c = DCM::certify(map);
      check_map(map, c);
      EXPECT_TRUE(c.is_certified());
      EXPECT_TRUE(IT::certify_Delaunay(map.Delaunay()).is_Delaunay());
      pairs += c.order.decided_in_floating_point;
    };
    check(DCM::flatten(mesh));
    if(std::string(name) == "eight.off")
      check(DCM::uniformize_hyperbolic(mesh));
    else
      check(DCM::map_to_sphere(mesh));
  }
  EXPECT_GT(pairs, 100u);
}

// These meshes have many right angles, whose ties are rounded.
TEST(Certify, maps_with_ties)
{
  for(const Named_mesh& m : traced(meshes())) {
    const Planar_conformal_map map = DCM::flatten(m.mesh);
    check_map(map, DCM::certify(map));
  }
}

// The lengths of T_3 are computed again by the flips that led to it.
TEST(Certify, agrees_with_exact_flips_of_maps)
{
  for(const Named_mesh& m : traced(meshes())) {
    const Planar_conformal_map map = DCM::flatten(m.mesh);
    std::vector<double> u, factor;
    for(Vertex_index v : mesh_C(map).vertices()) {
      u.push_back(map.log_scale(v));
      factor.push_back(std::exp(u.back() / 2));
    }
    DCM::Penner_surface<double> surface(map.ideal().input_mesh(), map.ideal().input_length_map());
    surface.scale(u);
    DCM::internal::Ptolemy_surface<Rational> exact(map.ideal().input_mesh(),
                                                   map.ideal().input_length_map());
    const auto length = [&](Edge_index e) { return exact.length(e); };
    expect_equal(DCM::certify(map).on_B,
                 expected_certificate(exact.mesh(), length, std::vector<double>(u.size(), 1.)));
    exact.replay(surface.flips());
    expect_equal(DCM::certify(map).on_C, expected_certificate(exact.mesh(), length, factor));
  }
}

// ---- Exact surfaces ----

// Represents a surface with lengths in a hundred digits, which is flipped by the law of cosines.
struct Surface_100
{
  Delta_complex mesh;
  std::vector<Real_100> length;

  Real_100 of(Halfedge_index h) const { return length[mesh.edge(h)]; }

  // Returns the position of the third corner of the face of `h`, seen from the source of `h`, on
  // its left.
  std::array<Real_100, 2> apex(Halfedge_index h) const
  {
    const Real_100 c = of(h), a = of(mesh.next(h)), b = of(mesh.prev(h)),
                   x = (b * b + c * c - a * a) / (2 * c);
    return {x, sqrt(b * b - x * x)};
  }

  // Returns the angle at the source of `h` in its face.
  Real_100 angle(Halfedge_index h) const
  {
    const auto [x, y] = apex(h);
    return atan2(y, x);
  }

  void make_Delaunay()
  {
    for(bool has_changed = true; has_changed;) {
      has_changed = false;
      for(Edge_index e : mesh.edges()) {
        const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
        if(mesh.is_border(e) ||
           angle(mesh.prev(h)) + angle(mesh.prev(o)) <= boost::math::constants::pi<Real_100>())
          continue;
        const auto p = apex(h), q = apex(o);
        const Real_100 x = of(h) - q[0] - p[0], y = p[1] + q[1];
        length[e] = sqrt(x * x + y * y);
        IT::flip_edge(h, mesh);
        has_changed = true;
      }
    }
  }
};

// Returns the greatest error of the curvature at a vertex that is not a cone, if the scale factors
// of a map are applied to the intrinsic Delaunay triangulation of the exact mesh.
double true_curvature_error(const Mesh& mesh, const Planar_conformal_map& map)
{
  const Triangulation t(mesh);
  Surface_100 flat{t.mesh(), distances(mesh)};
  flat.make_Delaunay();
  std::vector<Real_100> u;
  for(Vertex_index v : flat.mesh.vertices())
    u.emplace_back(map.log_scale(v));
  DCM::Penner_surface<Real_100> scaled(
    flat.mesh, boost::make_function_property_map<Edge_index>(
                 [&](Edge_index e) -> const Real_100& { return flat.length[e]; }));
  scaled.scale(u);
  flat.mesh = scaled.mesh();
  for(Edge_index e : flat.mesh.edges())
    flat.length[e] = scaled.scaled_length(e);
  std::vector<Real_100> defect(u.size(), 2 * boost::math::constants::pi<Real_100>());
  for(Halfedge_index h : flat.mesh.halfedges())
    defect[flat.mesh.source(h)] -= flat.angle(h);
  for(Vertex_index v : map.cones())
    defect[v] = 0;
  Real_100 result = 0;
  for(const Real_100& d : defect)
    result = (std::max)(result, Real_100(abs(d)));
  return static_cast<double>(result);
}

// Returns a torus with vertices at a distance of `height` from the midpoints of edges.
Mesh torus_with_needles(double height, unsigned int seed)
{
  Mesh mesh = perturbed(embedded_torus(6, 5), 0.2, seed);
  const std::vector<Edge_index> edges(mesh.edges().begin(), mesh.edges().end());
  for(std::size_t i = 0; i < edges.size(); i += 7) {
    const Halfedge_index h = mesh.halfedge(edges[i]);
    const Point p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h)),
                r = mesh.point(mesh.target(mesh.next(h)));
    const Halfedge_index center = CGAL::Euler::add_center_vertex(h, mesh);
    mesh.point(mesh.target(center)) = p + 0.5 * (q - p) + height * (r - p);
  }
  return mesh;
}

// The errors of a map with exact decisions are true on the exact surface. Its faces are so thin
// that rounded lengths belong to another surface. With the default, the errors are not true.
TEST(Certify, errors_of_exact_maps_are_those_on_the_exact_surface)
{
  for(const double height : traced({1e-4, 1e-7, 1e-9}))
    for(unsigned int seed = 0; seed < 2; ++seed) {
      const Mesh mesh = torus_with_needles(height, seed);
      const Planar_conformal_map map = DCM::flatten(mesh, DCM::parameters::exact_decisions(true));
      const double truth = true_curvature_error(mesh, map);
      EXPECT_NEAR(map.max_curvature_error(), truth, 1e-13 + 1e-6 * truth);
      EXPECT_LT(truth, 1e-15 / height);
      EXPECT_TRUE(IT::certify_Delaunay(map.Delaunay()).is_Delaunay());
      EXPECT_TRUE(DCM::certify(map).on_C.is_Delaunay());
      for(Edge_index e : map.ideal().input_mesh().edges())
        EXPECT_NEAR(map.ideal().input_length(e) / map.Delaunay().length(e), 1, 1e-11);
    }
}

TEST(Certify, finds_what_is_not_delaunay)
{
  const Mesh mesh = perturbed(embedded_torus(6, 5), 0.4, 3);
  const auto fixed = DCM::flatten(mesh, DCM::parameters::flipping(DCM::Flipping::none));
  const DCM::Map_certificate c = DCM::certify(fixed);
  EXPECT_FALSE(c.is_certified());
  EXPECT_FALSE(c.on_B.is_Delaunay());
  EXPECT_GT(c.on_B.greatest_excess, 0.01);
  EXPECT_TRUE(c.order.is_exact()); // nothing crosses

  const Planar_conformal_map map = DCM::flatten(mesh);
  EXPECT_TRUE(DCM::certify(map).is_certified());
  std::vector<double> factor;
  for(Vertex_index v : mesh_C(map).vertices())
    factor.push_back(std::exp(map.log_scale(v) / 2));
  factor[7] *= 3;
  EXPECT_FALSE(IT::certify_ideal_Delaunay(map.ideal(), factor).is_Delaunay());
}

} // namespace Test_certify
