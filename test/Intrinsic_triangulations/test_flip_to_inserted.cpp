// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips lead from one triangulation of a surface to another over a third, where both have inserted
// vertices.

#include "flat_pair.h"
#include "more_generators.h"

#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/rebase.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

namespace Test_flip_to_inserted {

using namespace Test_surfaces;
using Triangulation = IT::Intrinsic_triangulation<>;
using Plane_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

// Inserts vertices at random, every fourth on an edge that is in T1, too: on other edges of T2 it
// would be a matter of rounding on which side a vertex lies.
void random_insertions(Triangulation& t, int number, CGAL::Random& random)
{
  IT::Vertex_inserter<> inserter(t);
  for(int i = 0; i < number; ++i) {
    const Halfedge_index h = random_halfedge(t.mesh(), random);
    if(t.mesh().is_border(h))
      continue;
    const double x = random.get_double(0.2, 0.8), y = random.get_double(0.1, 0.9) * (1 - x);
    if(i % 4 == 0 && t.coordinates().is_shared(t.mesh().edge(h)) && inserter.can_be_split(h))
      inserter.split_edge(h, x);
    else
      inserter.insert({t.mesh().face(h), {x, y, 1 - x - y}});
  }
}

void random_removals(Triangulation& t, CGAL::Random& random)
{
  IT::Vertex_inserter<> inserter(t);
  for(auto v = t.mesh().num_vertices(); v-- > t.input_mesh().num_vertices();)
    if(random.get_int(0, 3) == 0)
      inserter.remove(Vertex_index(v));
  t.collect_garbage();
}

bool is_flat(Face_index f, const Triangulation& t)
{
  const auto [a, b, c] = IT::internal::side_lengths(t.mesh().halfedge(f), t);
  return IT::quadrupled_area(a, b, c) < 1e-6 * (a + b + c) * (a + b + c);
}

// Flips that leave no flat face: of a vertex inserted on an edge, rounding makes corners convex.
void random_good_flips(Triangulation& t, int tries, CGAL::Random& random)
{
  for(int i = 0; i < tries; ++i) {
    const Halfedge_index h = random_halfedge(t.mesh(), random);
    if(!t.is_flippable(h))
      continue;
    t.flip(h);
    if(is_flat(t.mesh().face(h), t) || is_flat(t.mesh().face(t.mesh().opposite(h)), t))
      t.flip(h);
  }
}

void change(Triangulation& t, int insertions, unsigned seed)
{
  CGAL::Random random(seed);
  random_good_flips(t, 40, random);
  random_insertions(t, insertions, random);
  random_good_flips(t, 40, random);
}

// Returns two triangulations over T1, which share inserted vertices for odd seeds.
std::pair<Triangulation, Triangulation> random_pair(const Triangulation& t1, unsigned seed)
{
  Triangulation t2(t1);
  if(seed % 2 == 1)
    change(t2, 1 + int(seed % 5), 7 * seed);
  Triangulation t3(t2);
  CGAL::Random random(seed);
  change(t2, int(seed % 4), 7 * seed + 1);
  if(seed % 3 == 0)
    random_removals(t2, random);
  change(t3, int(seed / 4 % 4), 7 * seed + 2);
  if(seed % 5 == 0)
    random_removals(t3, random);
  return {std::move(t2), std::move(t3)};
}

// ---- Brute force in the plane ----

typedef std::vector<Plane_point> Points;

Plane_point point(const IT::Face_location<double>& p, const Delta_complex& mesh,
                  const Points& points)
{
  const auto side = IT::sides(p.first, mesh);
  double x = 0, y = 0;
  for(std::size_t s = 0; s < 3; ++s) {
    x += p.second[s] * points[mesh.source(side[s])].x();
    y += p.second[s] * points[mesh.source(side[s])].y();
  }
  return {x, y};
}

Points with_inserted(Points points, const Triangulation& t)
{
  const Points input = points;
  for(Vertex_index v : t.mesh().vertices())
    if(t.is_inserted(v))
      points.push_back(
        point(IT::face_location(t.inserted_vertex(v), t.input_mesh()), t.input_mesh(), input));
  return points;
}

bool cross(const Plane_point& p, const Plane_point& q, const Plane_point& r, const Plane_point& s)
{
  return CGAL::orientation(p, q, r) * CGAL::orientation(p, q, s) < 0 &&
         CGAL::orientation(r, s, p) * CGAL::orientation(r, s, q) < 0;
}

// Returns whether the vertex `v` of `over` is on the edge `e` of its input.
bool is_on(Vertex_index v, Edge_index e, const Triangulation& over)
{
  if(over.is_inserted(v)) {
    const auto* p = IT::on_edge(over.inserted_vertex(v));
    return p && Edge_index(p->halfedge) == e;
  }
  return over.input_mesh().vertex(e, 0) == v || over.input_mesh().vertex(e, 1) == v;
}

// Returns the normal coordinate of the edge of `over`, over its input.
std::int64_t normal_coordinate(Edge_index edge, const Triangulation& over, const Points& points)
{
  const Vertex_index u = over.mesh().vertex(edge, 0), v = over.mesh().vertex(edge, 1);
  std::int64_t count = 0;
  for(Edge_index e : over.input_mesh().edges()) {
    const bool touches_u = is_on(u, e, over), touches_v = is_on(v, e, over);
    if(touches_u && touches_v)
      return -1;
    count += !touches_u && !touches_v &&
             cross(points[u], points[v], points[over.input_mesh().vertex(e, 0)],
                   points[over.input_mesh().vertex(e, 1)]);
  }
  return count;
}

typedef std::multiset<std::pair<long long, long long>> Edge_set; // by their midpoints

std::pair<long long, long long> midpoint(Edge_index e, const Triangulation& t, const Points& points)
{
  const Plane_point m =
    CGAL::midpoint(points[t.mesh().vertex(e, 0)], points[t.mesh().vertex(e, 1)]);
  return {std::llround(m.x() * 1e4), std::llround(m.y() * 1e4)};
}

// Returns how many edges of T3 are not in T3 with more vertices.
std::size_t number_of_missing_edges(const Triangulation& t3, const Points& points3,
                                    const Triangulation& over, const Points& points)
{
  Edge_set there;
  for(Edge_index e : over.mesh().edges())
    there.insert(midpoint(e, over, points));
  std::size_t missing = 0;
  for(Edge_index e : t3.mesh().edges()) {
    const auto [x, y] = midpoint(e, t3, points3);
    bool found = false;
    for(long long i : {-1, 0, 1})
      for(long long j : {-1, 0, 1})
        found = found || there.count({x + i, y + j}) > 0;
    missing += !found;
  }
  return missing;
}

void expect_brute_force(const Triangulation& over, const Points& points)
{
  ASSERT_TRUE(over.is_valid(true));
  for(Edge_index e : over.mesh().edges())
    ASSERT_EQ(over.coordinates().normal_coordinate(e), normal_coordinate(e, over, points)) << e;
  for(Edge_index e : over.mesh().edges()) {
    const double length = std::sqrt(
      CGAL::squared_distance(points[over.mesh().vertex(e, 0)], points[over.mesh().vertex(e, 1)]));
    EXPECT_NEAR(over.length(e) / length, 1, 1e-7);
  }
}

// Returns the number of vertices that only T3 has.
std::size_t check_polygon(unsigned seed)
{
  SCOPED_TRACE(seed);
  const Flat_surface surface = flat_polygon(random_points(6 + seed % 12, 5000, seed));
  const auto [t2, t3] = random_pair(triangulation(surface), seed);
  Points points;
  for(const Vector& p : surface.point)
    points.emplace_back(double(p.x), double(p.y));
  const Points points2 = with_inserted(points, t2), points3 = with_inserted(points, t3);
  const Triangulation over = IT::rebase(t2, t3);
  const Points all = with_inserted(points2, over);
  expect_brute_force(over, all);
  const Triangulation back = IT::rebase(t3, t2);
  EXPECT_EQ(over.mesh().number_of_vertices(), back.mesh().number_of_vertices());
  std::size_t split = 0; // edges of T1 are, where both have vertices on them
  for(Vertex_index v : back.mesh().vertices())
    split += back.is_inserted(v) && IT::on_edge(back.inserted_vertex(v)) != nullptr;
  EXPECT_LE(number_of_missing_edges(t3, points3, over, all), split);
  return over.number_of_inserted_vertices();
}

TEST(Flip_to_inserted, polygons_against_brute_force)
{
  std::size_t inserted = 0;
  for(unsigned seed = 0; seed < 1000 && !HasFatalFailure(); ++seed)
    inserted += check_polygon(seed);
  EXPECT_GT(inserted, 500u);
}

// ---- Surfaces with curvature, and ties ----

// Checks T3, to which vertices are added, over T2.
void expect_lengths(const Triangulation& t2, const Triangulation& t3)
{
  const Triangulation over = IT::rebase(t2, t3);
  ASSERT_TRUE(over.is_valid(true));
  const std::vector<double> found = sorted_lengths(over), expected = sorted_lengths(t3);
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i] / expected[i], 1, 1e-6);
}

TEST(Flip_to_inserted, all_complexes)
{
  for(const auto& [c, seed] : traced(complexes(), 8)) {
    Triangulation t2 = triangulation(c.mesh, random_lengths(c.mesh, seed));
    CGAL::Random random(seed);
    const int tries = static_cast<int>(std::min(2 * c.mesh.number_of_edges(), 60u));
    random_flips(t2, tries, seed);
    random_insertions(t2, 6, random);
    Triangulation t3(t2);
    random_flips(t2, tries, seed + 100);
    random_insertions(t3, 6, random);
    random_flips(t3, tries, seed + 200);
    expect_lengths(t2, t3);
    Triangulation t(t2);
    IT::flip_to(t, t3);
    EXPECT_EQ(sorted_lengths(t), sorted_lengths(t3));
  }
}

TEST(Flip_to_inserted, refined_surfaces)
{
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t2(m.mesh);
    IT::make_Delaunay(t2);
    IT::refine(t2, IT::parameters::minimum_angle(20));
    t2.collect_garbage();
    Triangulation t3(t2);
    IT::refine(t3, IT::parameters::minimum_angle(29));
    t3.collect_garbage();
    const Triangulation over = IT::rebase(t2, t3), back = IT::rebase(t3, t2);
    EXPECT_TRUE(over.is_valid(true));
    EXPECT_TRUE(back.is_valid(true));
    EXPECT_EQ(over.mesh().number_of_vertices(), back.mesh().number_of_vertices());
    Triangulation t(t2);
    IT::flip_to(t, t3);
    EXPECT_EQ(sorted_lengths(t), sorted_lengths(t3));
  }
}

// Centers of squares are inserted, and the rest of the grid has only ties.
TEST(Flip_to_inserted, ties)
{
  const Mesh mesh = grid(8, 8, [](double x, double y) { return Point(x, y, 0); });
  for(unsigned seed : seeds(20)) {
    Triangulation t2(mesh);
    IT::Vertex_inserter<> inserter(t2);
    for(Edge_index e : t2.input_mesh().edges())
      if((e.idx() + seed) % 7 == 0)
        inserter.split_edge(t2.mesh().halfedge(e), 0.5);
    Triangulation t3(t2);
    random_flips(t2, 200, seed);
    random_flips(t3, 200, seed + 100);
    expect_lengths(t2, t3);
    expect_lengths(t3, t2);
  }
}

std::size_t number_of_constraints(const Triangulation& t)
{
  const auto edges = t.mesh().edges();
  return static_cast<std::size_t>(
    std::count_if(edges.begin(), edges.end(), [&](Edge_index e) { return t.is_constrained(e); }));
}

// Constraints of edges that are not in the input are dropped.
TEST(Flip_to_inserted, keeps_constraints)
{
  Triangulation t2(tetrahedron());
  std::vector<char> all(t2.mesh().num_edges(), 1);
  Triangulation t3(tetrahedron(),
                   CGAL::parameters::edge_is_constrained_map(boost::make_iterator_property_map(
                     all.begin(), boost::typed_identity_property_map<Edge_index>())));
  IT::Vertex_inserter<>(t2).split_edge(t2.mesh().halfedge(Edge_index(0)), 0.25);
  IT::Vertex_inserter<>(t3).insert({Face_index(0), {0.25, 0.25, 0.5}});
  EXPECT_EQ(number_of_constraints(IT::rebase(t2, t3)), 7u); // one of six is split
  for(Edge_index e : t3.mesh().edges())
    t3.set_constrained(e, true);
  EXPECT_EQ(number_of_constraints(IT::rebase(t2, t3)), 7u);
}

} // namespace Test_flip_to_inserted
