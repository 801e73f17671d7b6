// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests close boundary loops and cut handles.

#include "evolving_surfaces.h"

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>
#include <CGAL/Intrinsic_simplification/pinch_handles.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/Edge_paths.h>

namespace Test_surgery {

using namespace Test_surfaces;
using IS::Surface_surgery;
using Triangulation = IT::Intrinsic_triangulation<>;

constexpr double no_bound = std::numeric_limits<double>::infinity();

auto lengths_of(const Surface_surgery& s)
{
  return [&s](Edge_index e) { return get(s.length_map(), e); };
}

double area(const Surface_surgery& s) { return area_of(s.mesh(), lengths_of(s)); }

double total_curvature(const Surface_surgery& s)
{
  double total = 0;
  const std::vector<double> sums = angle_sums(s.mesh(), lengths_of(s));
  for(Vertex_index v : s.mesh().vertices())
    total += (s.mesh().is_isolated(v) || !s.mesh().is_border(v) ? 2 : 1) * pi - sums[v];
  return total;
}

void expect_valid(const Surface_surgery& s, double area_before, double tolerance = 1e-9)
{
  ASSERT_TRUE(IT::is_valid_Delta_complex(s.mesh(), true));
  EXPECT_NEAR(total_curvature(s), 2 * pi * Euler_characteristic(s.mesh()), 1e-6);
  EXPECT_NEAR(area(s), area_before + s.filled_area(), tolerance * area(s));
  EXPECT_TRUE(s.triangulation().is_valid(true));
}

// Checks that points are mapped back to themselves. Points in disks have no preimage.
void expect_map(const Surface_surgery& s, const Triangulation& input, double tolerance = 1e-9)
{
  CGAL::Random random(1);
  const auto random_point = [&](Face_index f) { return Location{f, random_coordinates(random)}; };
  for(Face_index f : input.mesh().faces()) {
    const Location p = random_point(f);
    const auto back = s.preimage(s.image(p));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->first, f);
    for(std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(back->second[c], p.second[c], tolerance);
  }
  double filled = 0;
  for(Face_index f : s.mesh().faces())
    filled += s.preimage(random_point(f)) ? 0 : area_of(f, s.mesh(), lengths_of(s));
  EXPECT_LE(filled, s.filled_area() * (1 + 1e-9));
  std::size_t apexes = 0;
  for(Vertex_index v : s.mesh().vertices())
    apexes += !s.original_vertex(v).is_valid();
  EXPECT_EQ(apexes, s.number_of_disks());
}

// Checks that original faces and edges are unchanged.
void expect_unchanged(const Surface_surgery& s, const Triangulation& input)
{
  for(Face_index f : input.mesh().faces())
    for(std::size_t c = 0; c < 3; ++c) {
      const Halfedge_index h = IT::sides(f, s.mesh())[c], g = IT::sides(f, input.mesh())[c];
      EXPECT_EQ(get(s.length_map(), Edge_index(h)), input.length(Edge_index(g)));
      EXPECT_EQ(s.original_vertex(s.mesh().source(h)), input.mesh().source(g));
    }
}

// ---- Boundary loops ----

TEST(Surface_surgery, closes_all_loops)
{
  for(unsigned seed = 0; seed < 5; ++seed)
    for(const Named_complex& c : traced(complexes())) {
      const Triangulation input = triangulation(c.mesh, random_lengths(c.mesh, seed));
      Surface_surgery s(input);
      const auto before = IT::topological_type(c.mesh);
      const double area_before = area(s);
      EXPECT_EQ(IS::close_boundary_loops(s, no_bound), before.boundary_loops);
      const auto after = IT::topological_type(s.mesh());
      EXPECT_EQ(after.boundary_loops, 0u);
      EXPECT_EQ(after.genus, before.genus);
      EXPECT_EQ(after.components, before.components);
      expect_valid(s, area_before);
      expect_map(s, input);
      expect_unchanged(s, input);
    }
}

TEST(Surface_surgery, closes_short_loops_only)
{
  const Mesh mesh = grid(4, 4, [](double x, double y) { return Point(x, y, 0); });
  const Triangulation input(mesh);
  Surface_surgery s(input);
  EXPECT_EQ(IS::close_boundary_loops(s, 15.999), 0u);
  EXPECT_EQ(IS::close_boundary_loops(s, 16), 1u);
}

// The disk of a regular polygon is flat.
TEST(Surface_surgery, disks_of_regular_polygons)
{
  for(std::size_t n : {3u, 4u, 5u, 8u, 30u, 1000u}) {
    std::vector<Point> points{Point(0, 0, 2)};
    Triangles triangles;
    for(std::size_t i = 0; i < n; ++i) {
      points.emplace_back(std::cos(2 * pi * double(i) / double(n)),
                          std::sin(2 * pi * double(i) / double(n)), 0);
      triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
    }
    const Triangulation input(make_mesh(points, triangles));
    Surface_surgery s(input);
    ASSERT_EQ(IS::close_boundary_loops(s, no_bound), 1u);
    const double side = 2 * std::sin(pi / double(n));
    EXPECT_NEAR(s.filled_area(), double(n) / 4 * side * side / std::tan(pi / double(n)), 1e-9);
    const Vertex_index apex(s.mesh().number_of_vertices() - 1);
    EXPECT_NEAR(angle_sums(s.mesh(), lengths_of(s))[apex], 2 * pi, 1e-6);
  }
}

// The boundaries are one edge, two edges, and one long edge among short ones.
TEST(Surface_surgery, disks_of_long_edges_are_cones)
{
  for(const std::vector<double>& sides :
      {std::vector<double>{1}, {1, 1}, {2, 1}, {1, 0.6, 0.6}, {1, 0.01, 0.01, 0.99}}) {
    const double radius = IS::internal::disk_radius(sides);
    EXPECT_DOUBLE_EQ(radius, sides[0] / std::sqrt(3.));
    EXPECT_LE(IS::internal::central_angle(sides, radius), 2 * pi * (1 + 1e-12));
  }
}

// ---- Handles ----

// A closed curve separates if and only if its signature is zero.
TEST(Loop_signatures, against_cutting)
{
  std::size_t separating = 0, others = 0;
  for(const Named_complex& c : traced(complexes())) {
    const IT::Loop_signatures signatures(c.mesh);
    CGAL::Random random(3);
    for(int i = 0; i < 60; ++i) {
      // The random walk ends at the first vertex that it meets again.
      std::vector<Halfedge_index> walk;
      Halfedge_index h(static_cast<unsigned>(random.get_int(0, int(c.mesh.num_halfedges()))));
      auto met = walk.end();
      for(int step = 0; step < 30 && met == walk.end(); ++step) {
        walk.push_back(h);
        met = std::find_if(walk.begin(), walk.end(),
                           [&](Halfedge_index x) { return c.mesh.source(x) == c.mesh.target(h); });
        if(met != walk.end())
          break;
        const int turns = random.get_int(1, 6);
        h = c.mesh.opposite(h);
        for(int t = 0; t < turns && !c.mesh.is_border(h); ++t)
          h = IT::next_around_source(h, c.mesh);
      }
      if(met == walk.end())
        continue;
      const std::vector<Halfedge_index> loop(met, walk.end());
      if((loop.size() == 2 && loop[0] == c.mesh.opposite(loop[1])) ||
         std::any_of(loop.begin(), loop.end(),
                     [&](Halfedge_index x) { return c.mesh.is_border(c.mesh.target(x)); }))
        continue;
      Surface_surgery s(triangulation(c.mesh, random_lengths(c.mesh, 1)));
      s.cut(loop);
      IS::close_boundary_loops(s, no_bound); // components stay apart
      ASSERT_TRUE(IT::is_valid_Delta_complex(s.mesh(), true));
      const bool separates =
        IT::topological_type(s.mesh()).components > IT::topological_type(c.mesh).components;
      EXPECT_EQ(signatures.of(loop) == 0, separates);
      ++(separates ? separating : others);
    }
  }
  EXPECT_GT(separating, 100u);
  EXPECT_GT(others, 100u);
}

// Returns the length of the shortest closed walk that does not separate and stays inside. It is a
// shortest path in the cover in which a walk around such a curve leads to another sheet.
double shortest_loop(const Surface_surgery& s)
{
  const Delta_complex& mesh = s.mesh();
  const IT::Loop_signatures signatures(mesh);
  typedef std::pair<Vertex_index, std::uint64_t> State;
  double result = no_bound;
  for(Vertex_index start : mesh.vertices()) {
    if(mesh.is_isolated(start) || mesh.is_border(start))
      continue;
    std::map<State, double> distance;
    std::set<std::pair<double, State>> queue{{0, {start, 0}}};
    while(!queue.empty()) {
      const auto [d, state] = *queue.begin();
      queue.erase(queue.begin());
      if(!distance.emplace(state, d).second)
        continue;
      if(state.first == start && state.second != 0) {
        result = (std::min)(result, d);
        break;
      }
      for(Halfedge_index h : mesh.halfedges())
        if(mesh.source(h) == state.first && !mesh.is_border(mesh.target(h)))
          queue.insert({d + get(s.length_map(), Edge_index(h)),
                        {mesh.target(h), state.second ^ signatures[Edge_index(h)]}});
    }
  }
  return result;
}

TEST(Short_loops, shortest_of_all)
{
  std::size_t found = 0;
  for(unsigned seed = 0; seed < 5; ++seed)
    for(const Named_complex& c : complexes()) {
      if(c.mesh.number_of_vertices() > 60 || IT::topological_type(c.mesh).genus > 3)
        continue;
      SCOPED_TRACE(c.name);
      const Surface_surgery s(triangulation(c.mesh, random_lengths(c.mesh, seed)));
      const double expected = shortest_loop(s);
      for(double bound : {no_bound, expected * (1 + 1e-9), expected * (1 - 1e-9)}) {
        const auto loops = IS::internal::Short_loops(s).disjoint_loops(bound);
        ASSERT_EQ(loops.empty(), !(expected < no_bound && expected <= bound));
        if(!loops.empty()) {
          EXPECT_NEAR(loops.front().length, expected, 1e-12 * expected);
          ++found;
        }
      }
    }
  EXPECT_GT(found, 30u);
}

// If no loop is found, searches reach each vertex several times, however far they extend.
TEST(Short_loops, searches_overlap_little)
{
  const std::size_t n = 30;
  const double around = 2 * double(n) * std::sin(pi / double(n)); // a circle of the tube
  for(std::size_t m : {100u, 400u}) {
    const Surface_surgery s{Triangulation(embedded_torus(m, n))};
    for(double part : {0.2, 0.5, 0.65, 0.8}) {
      IS::internal::Short_loops loops(s);
      EXPECT_TRUE(loops.disjoint_loops(part * around).empty());
      EXPECT_LT(loops.number_of_visits(), 10 * m * n);
    }
  }
}

std::size_t pinch_all(const Triangulation& input)
{
  Surface_surgery s(input);
  const auto before = IT::topological_type(s.mesh());
  const double area_before = area(s);
  const std::size_t pinched = IS::pinch_handles(s, no_bound);
  const auto after = IT::topological_type(s.mesh());
  EXPECT_EQ(after.genus + pinched, before.genus);
  EXPECT_EQ(after.components, before.components);
  EXPECT_EQ(after.boundary_loops, before.boundary_loops);
  EXPECT_EQ(s.number_of_disks(), 2 * pinched);
  expect_valid(s, area_before);
  expect_map(s, input);
  expect_unchanged(s, input);
  return after.genus;
}

TEST(Pinch_handles, all_handles)
{
  for(int genus : traced({0, 1, 2, 5, 9})) {
    EXPECT_EQ(pinch_all(Triangulation(plate_with_holes(genus))), 0u);
    EXPECT_EQ(pinch_all(Triangulation(straight_plate_with_holes(genus))), 0u);
  }
  EXPECT_EQ(pinch_all(Triangulation(punctured(embedded_torus(9, 8), {7}))), 0u);
  EXPECT_EQ(pinch_all(Triangulation(five_components())), 0u);
}

// Returns a sphere with tubes between pairs of removed triangles, far from each other.
Mesh sphere_with_handles(std::size_t n, std::size_t genus, unsigned seed)
{
  const Mesh sphere = random_sphere(n, seed);
  std::vector<Point> points;
  for(Vertex_index v : sphere.vertices())
    points.push_back(sphere.point(v));
  std::vector<std::array<std::size_t, 3>> free;
  Triangles triangles;
  std::vector<bool> is_used(n, false);
  for(Face_index f : sphere.faces()) {
    std::array<std::size_t, 3> t;
    Halfedge_index h = sphere.halfedge(f);
    for(std::size_t c = 0; c < 3; ++c, h = sphere.next(h))
      t[c] = sphere.source(h);
    if(free.size() == 2 * genus || is_used[t[0]] || is_used[t[1]] || is_used[t[2]]) {
      triangles.push_back({t[0], t[1], t[2]});
      continue;
    }
    for(std::size_t v : t)
      is_used[v] = true;
    free.push_back(t);
  }
  for(std::size_t i = 0; i < genus; ++i) {
    const auto &a = free[i], &b = free[i + genus];
    for(std::size_t c = 0; c < 3; ++c) { // the other one in its opposite direction
      const std::size_t d = (c + 1) % 3, p = b[(3 - c) % 3], q = b[(3 - d) % 3];
      triangles.push_back({a[c], a[d], p});
      triangles.push_back({a[d], q, p});
    }
  }
  return make_mesh(points, triangles);
}

// Rounds and searches do not grow with the genus, nor with the bound.
TEST(Pinch_handles, effort_at_high_genus)
{
  const std::size_t genus = 200;
  for(const Mesh& mesh : {plate_with_holes(int(genus)), sphere_with_handles(4000, genus, 6)}) {
    Surface_surgery s{Triangulation(mesh)};
    ASSERT_EQ(IT::topological_type(s.mesh()).genus, genus);
    ASSERT_EQ(IT::topological_type(s.mesh()).boundary_loops, 0u);
    IS::internal::Handle_pincher pincher(s, no_bound);
    EXPECT_EQ(pincher(), genus);
    EXPECT_EQ(IT::topological_type(s.mesh()).genus, 0u);
    EXPECT_LT(pincher.number_of_searches(), 40u);
    EXPECT_LT(pincher.number_of_visits(), 60 * mesh.number_of_vertices());
  }
}

// Some have a single vertex, or all vertices on the boundary.
TEST(Pinch_handles, all_complexes)
{
  for(unsigned seed = 0; seed < 5; ++seed)
    for(const Named_complex& c : traced(complexes())) {
      const std::size_t left = pinch_all(triangulation(c.mesh, random_lengths(c.mesh, seed)));
      EXPECT_TRUE(left == 0 || IT::topological_type(c.mesh).boundary_loops > 0);
    }
}

// The bound is compared with the shortest of all closed walks of edges.
TEST(Pinch_handles, flat_tori_of_known_length)
{
  for(unsigned seed : seeds(20)) {
    const Triangulation input = triangulation(flat_torus(4 + int(seed % 3), 5, seed));
    const double length = shortest_loop(Surface_surgery(input));
    for(double bound : {length * (1 - 1e-9), length * (1 + 1e-9)}) {
      Surface_surgery s(input);
      EXPECT_EQ(IS::pinch_handles(s, bound), bound > length ? 1u : 0u);
      expect_valid(s, area(Surface_surgery(input)));
      expect_map(s, input);
    }
  }
}

// Returns the relative distance of a length from the closest length of a vector of the lattice.
double deviation_from_lattice(double length, const Flat_surface& torus)
{
  double result = no_bound;
  for(int i = -5; i <= 5; ++i)
    for(int j = -5; j <= 5; ++j)
      result =
        (std::min)(result, std::abs(Test_surfaces::length(i * torus.a + j * torus.b) / length - 1));
  return result;
}

// Makes a closed geodesic in the class of the shortest edge loop a curve of edges, and returns it.
std::vector<Halfedge_index> make_geodesic(Surface_surgery& s)
{
  const auto loops = IS::internal::Short_loops(s).disjoint_loops(no_bound);
  Triangulation tri = s.triangulation();
  IT::Edge_paths<IS::Intrinsic_surface::Traits> paths(tri);
  paths.add_loop(loops.at(0).halfedges);
  paths.shorten();
  const std::vector<Halfedge_index> result = paths.halfedges(0);
  s.retriangulate(std::move(tri));
  return result;
}

// A closed geodesic of a flat torus is as long as a vector of its lattice.
TEST(Surface_surgery, cuts_along_geodesics)
{
  for(unsigned seed : seeds(20)) {
    const Flat_surface torus = flat_torus(4 + int(seed % 3), 5 + int(seed % 4), seed);
    const Triangulation input = triangulation(torus);
    Surface_surgery s(input);
    const double area_before = area(s);
    double length = 0;
    const std::vector<Halfedge_index> geodesic = make_geodesic(s);
    for(Halfedge_index h : geodesic)
      length += get(s.length_map(), Edge_index(h));
    EXPECT_LT(deviation_from_lattice(length, torus), 1e-9);
    const auto [left, right] = s.cut(geodesic);
    s.close(left);
    s.close(right);
    EXPECT_EQ(IT::topological_type(s.mesh()).genus, 0u);
    expect_valid(s, area_before);
    expect_map(s, input);
  }
}

// A tube of a torus consists of n-gons, and two of them are filled.
TEST(Pinch_handles, area_of_disks)
{
  const std::size_t n = 7;
  const Triangulation input(embedded_torus(30, n));
  const double side = 2 * std::sin(pi / double(n));
  Surface_surgery s(input);
  EXPECT_EQ(IS::pinch_handles(s, double(n) * side * (1 - 1e-9)), 0u);
  EXPECT_EQ(IS::pinch_handles(s, double(n) * side * (1 + 1e-9)), 1u);
  EXPECT_NEAR(s.filled_area(), 2 * double(n) / 4 * side * side / std::tan(pi / double(n)), 1e-9);
}

TEST(Pinch_handles, keeps_constraints)
{
  const Mesh mesh = embedded_torus(9, 8);
  const Triangulation input(mesh, CGAL::parameters::edge_is_constrained_map(
                                    CGAL::Constant_property_map<Edge_index, bool>(true)));
  Surface_surgery s(input);
  ASSERT_EQ(IS::pinch_handles(s, no_bound), 1u);
  const Triangulation result = s.triangulation();
  std::size_t constrained = 0;
  for(Edge_index e : result.mesh().edges())
    constrained += result.is_constrained(e);
  EXPECT_GT(constrained, mesh.number_of_edges());
}

TEST(Pinch_handles, then_simplifies)
{
  Surface_surgery s{Triangulation(plate_with_holes(5))};
  EXPECT_EQ(IS::pinch_handles(s, no_bound), 5u);
  IS::Evolving_surface surface(s.triangulation());
  IS::simplify(surface, IS::parameters::number_of_vertices(10u));
  EXPECT_LE(surface.mesh().number_of_vertices(), 10u);
}

} // namespace Test_surgery
