// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "equality.h"
#include "flat_pair.h"

#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <boost/multiprecision/cpp_int.hpp>

namespace Test_integer_coordinates {

using namespace Test_surfaces;
using boost::multiprecision::cpp_int;

// ---- Tracing ----

using Crossing = Integer_coordinates<std::int64_t>::Crossing;

struct Trace
{
  std::vector<Crossing> crossings;
  Halfedge_index outgoing_at_end; // of T1
};

// Returns the curves of T1 by their first halfedges. Curves along an edge of T2 have no crossings.
template <typename Pair>
std::map<Halfedge_index, Trace> trace_all(const Pair& pair)
{
  const auto& c = pair.coordinates;
  std::map<Halfedge_index, Trace> result;
  for(Halfedge_index h : pair.mesh.halfedges()) {
    if(c.is_shared(pair.mesh.edge(h)))
      result[c.shared_halfedge(h, pair.mesh, pair.outgoing_halfedges)].outgoing_at_end =
        c.shared_halfedge(pair.mesh.opposite(h), pair.mesh, pair.outgoing_halfedges);
    if(pair.mesh.is_border(h))
      continue;
    for(std::int64_t k = 0; k < c.curves_leaving(pair.mesh.next(h), pair.mesh); ++k) {
      Trace& trace = result[c.outgoing_in_corner(h, k, pair.mesh, pair.outgoing_halfedges)];
      Crossing crossing = c.first_crossing(h, k, pair.mesh);
      do
        trace.crossings.push_back(crossing);
      while(c.advance(crossing, pair.mesh) != Integer_coordinates<std::int64_t>::Turn::ends);
      trace.outgoing_at_end = c.outgoing_at_end(crossing, pair.mesh, pair.outgoing_halfedges);
    }
  }
  return result;
}

// Checks that one curve hits each number of each edge, once in each direction.
template <typename Pair>
void check_hits(const Pair& pair, const std::map<Halfedge_index, Trace>& traces)
{
  std::map<std::pair<Edge_index, std::int64_t>, int> hits;
  for(const auto& [start, trace] : traces)
    for(const Crossing& c : trace.crossings) {
      const std::int64_t n = pair.coordinates.crossings(c.halfedge);
      ASSERT_TRUE(c.number >= 0 && c.number < n);
      ++hits[{pair.mesh.edge(c.halfedge), c.halfedge.idx() % 2 == 0 ? c.number : n - 1 - c.number}];
    }
  std::size_t crossings = 0;
  for(Edge_index e : pair.mesh.edges())
    crossings += static_cast<std::size_t>(pair.coordinates.crossings(pair.mesh.halfedge(e)));
  EXPECT_EQ(hits.size(), crossings);
  for(const auto& [place, count] : hits)
    EXPECT_EQ(count, 2);
}

template <typename Pair>
void check_directions(const Pair& pair, const std::map<Halfedge_index, Trace>& traces)
{
  for(const auto& [start, trace] : traces) {
    ASSERT_EQ(trace.outgoing_at_end, pair.mesh.opposite(start));
    const std::vector<Crossing>& back = traces.at(trace.outgoing_at_end).crossings;
    ASSERT_EQ(trace.crossings.size(), back.size());
    for(std::size_t i = 0; i < back.size(); ++i) {
      const Crossing &c = trace.crossings[i], &d = back[back.size() - 1 - i];
      EXPECT_EQ(c.halfedge, pair.mesh.opposite(d.halfedge));
      EXPECT_EQ(c.number, pair.coordinates.crossings(c.halfedge) - 1 - d.number);
    }
  }
}

// Checks that the number of crossings of every edge of T1 with every edge of T2 equals the number
// by brute force.
void check_pairs(const Flat_pair<>& pair, const std::map<Halfedge_index, Trace>& traces)
{
  for(const auto& [start, trace] : traces) {
    std::map<Edge_index, std::int64_t> count;
    for(const Crossing& c : trace.crossings)
      ++count[pair.mesh.edge(c.halfedge)];
    for(Edge_index e : pair.mesh.edges())
      ASSERT_EQ(count[e], count_crossings(pair.segment1(start),
                                          pair.segment2(pair.mesh.halfedge(e)), pair.t1));
  }
}

template <typename Pair>
std::map<Halfedge_index, Trace> check_traces(const Pair& pair)
{
  std::map<Halfedge_index, Trace> traces = trace_all(pair);
  EXPECT_EQ(traces.size(), pair.mesh.number_of_halfedges());
  check_hits(pair, traces);
  check_directions(pair, traces);
  return traces;
}

std::size_t check_random_flips(Flat_surface surface, int tries, unsigned int seed)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  Flat_pair<> pair(std::move(surface));
  pair.check_all();
  const std::size_t flips = random_flips(pair, tries, seed);
  pair.check_all();
  check_pairs(pair, check_traces(pair));
  return flips;
}

// ---- Surfaces with curvature ----

using Triangulation = IT::Intrinsic_triangulation<>;

// Stores the data for trace_all().
struct Curved_pair
{
  const Delta_complex& mesh;
  const Triangulation::Coordinates& coordinates;
  const Outgoing_halfedges& outgoing_halfedges;

  explicit Curved_pair(const Triangulation& t)
    : mesh(t.mesh()), coordinates(t.coordinates()), outgoing_halfedges(t.outgoing_halfedges())
  {}
};

template <typename Traits>
bool same_combinatorics(const IT::Intrinsic_triangulation<Traits>& a,
                        const IT::Intrinsic_triangulation<Traits>& b)
{
  for(Halfedge_index h : a.mesh().halfedges()) {
    const Edge_index e = a.mesh().edge(h);
    if(a.mesh().next(h) != b.mesh().next(h) || a.mesh().face(h) != b.mesh().face(h) ||
       a.mesh().target(h) != b.mesh().target(h) ||
       a.coordinates().roundabout(h) != b.coordinates().roundabout(h) ||
       a.coordinates().normal_coordinate(e) != b.coordinates().normal_coordinate(e))
      return false;
  }
  return true;
}

// Returns the relative difference of the lengths.
template <typename Traits>
double length_difference(const IT::Intrinsic_triangulation<Traits>& a,
                         const IT::Intrinsic_triangulation<Traits>& b)
{
  double result = 0;
  for(Edge_index e : a.mesh().edges())
    result = (std::max)(result, std::abs(a.length(e) / b.length(e) - 1));
  return result;
}

// Calls `check` for all meshes and Delta-complexes, with lengths, after random flips.
template <typename Check>
void for_each_flipped(const Check& check)
{
  for(const auto& [c, seed] : traced(complexes(), 4)) {
    const Triangulation before = triangulation(c.mesh, random_lengths(c.mesh, seed));
    Triangulation after(before);
    const std::vector<Halfedge_index> flipped = random_flips(after, 300, seed);
    EXPECT_TRUE(after.is_valid(true));
    check(before, after, flipped);
  }
}

// ---- Large numbers ----

// Returns each edge in turn, always in the same order, which lengthens the edges like the Fibonacci
// numbers.
Halfedge_index nth_edge_in_turn(int n)
{
  return Halfedge_index(static_cast<Delta_complex::size_type>(2 * (n % 3)));
}

// Flips until the type is too narrow; returns the number of flips.
template <typename Integer>
int flips_before_overflow()
{
  const Flat_surface surface = flat_torus(1, 1, 0);
  using Traits = IT::Euclidean_geometry_traits<double, Integer>;
  auto t = triangulation<Traits>(surface);
  for(int i = 0;; ++i) {
    const IT::Intrinsic_triangulation<Traits> before(t);
    try {
      t.flip(nth_edge_in_turn(i));
    } catch(const IT::Overflow_error&) {
      EXPECT_TRUE(same_combinatorics(before, t));
      EXPECT_EQ(length_difference(before, t), 0);
      EXPECT_TRUE(t.coordinates().is_valid(t.mesh(), t.outgoing_halfedges()));
      return i;
    }
  }
}

// Returns all data of T2.
template <typename Integer>
std::vector<Integer> numbers(const Delta_complex& mesh, const Integer_coordinates<Integer>& c)
{
  std::vector<Integer> result;
  for(Halfedge_index h : mesh.halfedges())
    for(auto number : {c.roundabout(h), mesh.next(h).idx(), mesh.target(h).idx()})
      result.push_back(static_cast<Integer>(number));
  for(Edge_index e : mesh.edges())
    result.push_back(c.normal_coordinate(e));
  return result;
}

// Returns the number of flips by coordinates alone, which continue when lengths of type `double`
// cannot.
template <typename Integer>
int flips_before_overflow_without_lengths()
{
  Delta_complex mesh = flat_torus(1, 1, 0).mesh;
  Integer_coordinates<Integer> coordinates(mesh);
  const Outgoing_halfedges outgoing_halfedges(mesh, coordinates.roundabout_map());
  for(int i = 0;; ++i) {
    const std::vector<Integer> before = numbers(mesh, coordinates);
    try {
      coordinates.flip(nth_edge_in_turn(i), mesh, outgoing_halfedges);
    } catch(const IT::Overflow_error&) {
      EXPECT_EQ(before, numbers(mesh, coordinates));
      EXPECT_TRUE(coordinates.is_valid(mesh, outgoing_halfedges));
      return i;
    }
  }
}

using Wide_vector = std::array<cpp_int, 2>;

// Returns the number of crossings of a primitive vector with the three edges (1,0), (1,1), (0,1) of
// a lattice torus.
cpp_int closed_form(const Wide_vector& v)
{
  const cpp_int x = abs(v[0]), y = abs(v[1]), z = abs(v[0] - v[1]);
  return x == 0 || y == 0 || z == 0 ? cpp_int(-1) : x + y + z - 3;
}

TEST(Integer_coordinates, convex_polygons_against_brute_force)
{
  std::size_t flips = 0;
  for(unsigned int seed = 0; seed < 8; ++seed)
    flips += check_random_flips(flat_polygon(random_points(8 + 6 * seed, 5000, seed)), 4000, seed);
  EXPECT_GT(flips, 8000u);
}

TEST(Integer_coordinates, tori_against_brute_force)
{
  std::size_t flips = 0;
  for(unsigned int seed = 0; seed < 4; ++seed)
    for(const auto& [m, n] :
        std::vector<std::pair<int, int>>{{1, 1}, {2, 1}, {1, 2}, {5, 1}, {3, 3}}) {
      SCOPED_TRACE(std::to_string(m) + " x " + std::to_string(n));
      flips += check_random_flips(flat_torus(m, n, seed), 3000, seed);
    }
  EXPECT_GT(flips, 5000u);
}

TEST(Integer_coordinates, cylinders_against_brute_force)
{
  std::size_t flips = 0;
  for(int n = 1; n < 5; ++n)
    for(int twists = 0; twists < 3; ++twists)
      flips += check_random_flips(flat_cylinder(n, twists), 500, static_cast<unsigned int>(n));
  EXPECT_GT(flips, 500u);
}

TEST(Integer_coordinates, torus_with_one_vertex_in_closed_form)
{
  Flat_pair<> pair(flat_torus(1, 1, 7));
  CGAL::Random random(7);
  const std::int64_t determinant = det(pair.t1.a, pair.t1.b);
  for(int i = 0; i < 2000; ++i) {
    const Halfedge_index h = random_halfedge(pair.mesh, random);
    if(!pair.can_flip(h))
      continue;
    pair.flip(h);
    const Vector v = pair.vector[h];
    const std::int64_t x = det(v, pair.t1.b) / determinant, y = det(pair.t1.a, v) / determinant;
    ASSERT_EQ(pair.coordinates.normal_coordinate(pair.mesh.edge(h)), closed_form({x, y}));
  }
}

TEST(Integer_coordinates, outgoing_halfedges_are_numbered_counterclockwise)
{
  for(const Flat_surface& s : {flat_polygon(random_points(30, 5000, 1)), flat_torus(3, 2, 1)}) {
    std::vector<Outgoing_halfedges::size_type> number(s.mesh.number_of_halfedges());
    const Outgoing_halfedges outgoing_halfedges(
      s.mesh, boost::make_iterator_property_map(number.begin(), boost::identity_property_map()));
    for(Vertex_index v : s.mesh.vertices()) {
      const Vector first = s.vector[outgoing_halfedges.halfedge(v, 0)];
      EXPECT_TRUE(!s.mesh.is_border(v) ||
                  s.mesh.is_border(s.mesh.opposite(outgoing_halfedges.halfedge(v, 0))));
      for(Outgoing_halfedges::size_type k = 0; k < outgoing_halfedges.degree(v); ++k) {
        const Halfedge_index h = outgoing_halfedges.halfedge(v, k);
        EXPECT_EQ(s.mesh.source(h), v);
        EXPECT_EQ(outgoing_halfedges.number(v, h), k);
        EXPECT_EQ(number[h], k);
        EXPECT_TRUE(k < 2 ||
                    is_before(first, s.vector[outgoing_halfedges.halfedge(v, k - 1)], s.vector[h]));
      }
    }
  }
}

TEST(Integer_coordinates, traces_on_curved_surfaces)
{
  for_each_flipped([](const Triangulation&, const Triangulation& after, const auto&) {
    check_traces(Curved_pair(after));
  });
}

TEST(Integer_coordinates, flips_there_and_back)
{
  std::size_t flips = 0;
  for_each_flipped([&](const Triangulation& before, Triangulation after, const auto& flipped) {
    flips += flipped.size();
    for(auto h = flipped.rbegin(); h != flipped.rend(); ++h)
      for(int turn = 0; turn < 3; ++turn)
        after.flip(*h);
    EXPECT_TRUE(same_combinatorics(before, after));
    EXPECT_EQ(length_difference(before, after), 0);
  });
  EXPECT_GT(flips, 5000u);
}

TEST(Integer_coordinates, flip_to_input)
{
  for_each_flipped([](const Triangulation&, Triangulation after, const auto&) {
    const auto edges = after.mesh().edges();
    const bool is_input = std::all_of(
      edges.begin(), edges.end(), [&](Edge_index e) { return after.coordinates().is_shared(e); });
    EXPECT_EQ(flip_to_input(after) == 0, is_input);
    EXPECT_TRUE(after.is_valid(true));
    expect_equal_to_input(after);
    EXPECT_EQ(flip_to_input(after), 0u);
  });
}

TEST(Integer_coordinates, damage_is_found)
{
  Flat_pair<> good(flat_torus(3, 2, 5));
  random_flips(good, 60, 5);
  ASSERT_TRUE(good.coordinates.is_valid(good.mesh, good.outgoing_halfedges));
  const auto is_good = [&] {
    return good.coordinates.is_valid(good.mesh, good.outgoing_halfedges) &&
           IT::internal::curve_defect(good.coordinates, good.mesh, good.t1.mesh,
                                      good.outgoing_halfedges)
             .empty();
  };
  for(Edge_index e : good.mesh.edges()) {
    const std::int64_t n = good.coordinates.normal_coordinate(e);
    for(std::int64_t wrong : {n - 1, n + 1, n + 2, std::int64_t(-2)}) {
      good.coordinates.set(e, wrong);
      EXPECT_FALSE(is_good()) << e << ": " << wrong << " in place of " << n;
    }
    good.coordinates.set(e, n);
  }
  for(Halfedge_index h : good.mesh.halfedges()) {
    const auto r = good.coordinates.roundabout(h),
               degree = good.outgoing_halfedges.degree(good.mesh.source(h));
    for(auto wrong : {(r + 1) % degree, (r + degree - 1) % degree, degree}) {
      good.coordinates.set(h, wrong);
      EXPECT_FALSE(is_good()) << h << ": " << wrong << " in place of " << r;
    }
    good.coordinates.set(h, r);
  }
  EXPECT_TRUE(is_good());
}

TEST(Integer_coordinates, overflow_changes_nothing)
{
  const int narrow = flips_before_overflow<std::int16_t>();
  const int medium = flips_before_overflow<std::int32_t>();
  const int wide = flips_before_overflow_without_lengths<std::int64_t>();
  EXPECT_EQ(narrow, flips_before_overflow_without_lengths<std::int16_t>());
  EXPECT_EQ(medium, flips_before_overflow_without_lengths<std::int32_t>());
  EXPECT_GT(narrow, 5);
  EXPECT_GT(medium, narrow + 20);
  EXPECT_GT(wide, medium + 40);
}

TEST(Integer_coordinates, lengths_that_double_cannot_hold_are_named_and_change_nothing)
{
  const Flat_surface surface = flat_torus(1, 1, 0);
  Triangulation t = triangulation(surface);
  int flips = 0;
  for(bool goes_on = true; goes_on && flips < 1000; flips += goes_on) {
    const Triangulation before(t);
    try {
      t.flip(nth_edge_in_turn(flips));
    } catch(const IT::Numerical_error& error) {
      goes_on = false;
      EXPECT_NE(std::string(error.what()).find("flipping edge"), std::string::npos);
      EXPECT_TRUE(same_combinatorics(before, t));
      EXPECT_EQ(length_difference(before, t), 0);
    }
  }
  EXPECT_LT(flips, 1000);
}

TEST(Integer_coordinates, overflow_while_flipping_to_Delaunay_leaves_it_valid)
{
  using Traits = IT::Euclidean_geometry_traits<double, std::int16_t>;
  const Flat_surface surface = flat_cylinder(6, 300);
  auto t = triangulation<Traits>(surface);
  EXPECT_THROW(IT::make_Delaunay(t), IT::Overflow_error);
  EXPECT_TRUE(t.is_valid(true));
  flip_to_input(t);
  EXPECT_TRUE(t.is_valid(true));
}

TEST(Integer_coordinates, arbitrary_precision_goes_beyond)
{
  Delta_complex mesh = flat_torus(1, 1, 0).mesh;
  Integer_coordinates<cpp_int> coordinates(mesh);
  const Outgoing_halfedges outgoing_halfedges(mesh, coordinates.roundabout_map());
  std::vector<Wide_vector> vector{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}};
  for(int i = 0; i < 300; ++i) {
    const Halfedge_index h = nth_edge_in_turn(i), o = mesh.opposite(h);
    const Wide_vector il = vector[mesh.next(o)], ki = vector[mesh.prev(h)];
    coordinates.flip(h, mesh, outgoing_halfedges);
    vector[h] = {cpp_int(-il[0] - ki[0]), cpp_int(-il[1] - ki[1])};
    vector[o] = {cpp_int(il[0] + ki[0]), cpp_int(il[1] + ki[1])};
    ASSERT_EQ(coordinates.normal_coordinate(mesh.edge(h)), closed_form(vector[h]));
    ASSERT_TRUE(coordinates.is_valid(mesh, outgoing_halfedges));
  }
  EXPECT_GT(coordinates.normal_coordinate(Edge_index(0)),
            (std::numeric_limits<std::int64_t>::max)());
}

TEST(Integer_coordinates, arbitrary_precision_agrees_with_64_bits)
{
  for(const Flat_surface& surface : {flat_cylinder(4, 30), flat_torus(4, 3, 2)}) {
    auto narrow = triangulation(surface);
    auto wide = triangulation<IT::Euclidean_geometry_traits<double, cpp_int>>(surface);
    EXPECT_EQ(IT::make_Delaunay(narrow), IT::make_Delaunay(wide));
    EXPECT_TRUE(wide.is_valid(true));
    for(Edge_index e : narrow.mesh().edges())
      EXPECT_EQ(wide.coordinates().normal_coordinate(e), narrow.coordinates().normal_coordinate(e));
    for(Halfedge_index h : narrow.mesh().halfedges())
      EXPECT_EQ(wide.coordinates().roundabout(h), narrow.coordinates().roundabout(h));
    EXPECT_EQ(flip_to_input(wide), flip_to_input(narrow));
  }
}

} // namespace Test_integer_coordinates
