// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "known_surfaces.h"
#include "tied_meshes.h"

#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/path_on_input.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>

namespace Test_edge_paths {

using namespace Test_surfaces;
using Paths = IT::Edge_paths<Triangulation::Traits>;
using Halfedges = std::vector<Halfedge_index>;
using Status = IT::Shortening_status;
using Surface_path = IT::Surface_path<double>;

double length(const Halfedges& path, const Triangulation& t)
{
  double sum = 0;
  for(Halfedge_index h : path)
    sum += t.length(t.mesh().edge(h));
  return sum;
}

// ---- Geodesics ----

// Returns the angle on the left of a joint, infinite on the boundary, computed independently.
Real angle(Halfedge_index in, Halfedge_index out, const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  Real sum = 0;
  for(Halfedge_index h = out;;) {
    if(mesh.is_border(h))
      return std::numeric_limits<Real>::infinity();
    sum += faces.angle(h);
    h = mesh.opposite(mesh.prev(h));
    if(h == mesh.opposite(in))
      return sum;
  }
}

// Checks that a path can cut no corner, and gain more than rounding errors.
void expect_geodesic(const Halfedges& path, bool is_loop, const Triangulation& t)
{
  const Flat_faces faces(Side::intrinsic, t);
  const Delta_complex& mesh = t.mesh();
  for(std::size_t k = 0; k + (is_loop ? 0 : 1) < path.size(); ++k) {
    const Halfedge_index in = path[k], out = path[(k + 1) % path.size()];
    ASSERT_EQ(mesh.target(in), mesh.source(out));
    ASSERT_NE(out, mesh.opposite(in));
    const Real a = faces.length(in), b = faces.length(out);
    const Real least =
      (std::min)(angle(in, out, faces), angle(mesh.opposite(out), mesh.opposite(in), faces));
    const Real gain = least < pi - 1e-6 ? (std::min)(a, b) * (pi - least) * (pi - least) : 0;
    EXPECT_LT(static_cast<double>(gain), 1e-13 * length(path, t))
      << least << " between " << a << " and " << b;
  }
}

std::pair<Vertex_index, Vertex_index> random_vertices(const Delta_complex& mesh,
                                                      CGAL::Random& random)
{
  const Vertex_index v = random_vertex(mesh, random);
  return {v, random_vertex(mesh, random)};
}

// Checks random paths along edges. Their geodesics are not shorter than the shortest path, and not
// longer than before.
void check_random_paths(Triangulation t, int n, unsigned int seed)
{
  const Flat_faces faces(Side::input, t);
  CGAL::Random random(seed);
  for(int i = 0; i < n; ++i) {
    const auto [v, w] = random_vertices(t.mesh(), random);
    if(t.mesh().is_isolated(v) || t.mesh().is_isolated(w))
      continue;
    const Halfedges start = IT::shortest_edge_path(t.intrinsic(), v, w);
    const double before = length(start, t);
    Paths paths(t);
    paths.add_path(start);
    EXPECT_EQ(paths.shorten(), Status::geodesic);
    const Halfedges path = paths.halfedges(0);
    EXPECT_LE(paths.length(0), before * (1 + 1e-14));
    expect_geodesic(path, false, t);
    if(path.empty())
      continue;
    EXPECT_EQ(t.mesh().source(path.front()), v);
    EXPECT_EQ(t.mesh().target(path.back()), w);
    if(i % 10 == 0) {
      IT::Shortest_paths shortest(t.input());
      shortest.add_source(v);
      shortest.run();
      // The search uses rounded lengths of flat triangles.
      EXPECT_GE(paths.length(0), shortest.distance(w) * (1 - 1e-9));
      EXPECT_NEAR(IT::path_on_input(t, path).length, paths.length(0), 1e-12 * before);
    }
  }
  EXPECT_TRUE(t.is_valid(true));
}

TEST(Edge_paths, random_paths)
{
  for(const Named_mesh& m : traced(meshes()))
    check_random_paths(Triangulation(m.mesh), 50, 1);
}

TEST(Edge_paths, random_paths_after_flips)
{
  for(const Named_triangulation& t : traced(triangulations()))
    check_random_paths(t.triangulation, 10, 2);
}

TEST(Edge_paths, random_paths_on_near_degenerate_meshes)
{
  for(const auto& [m, seed] : traced(40, near_degenerate_mesh))
    check_random_paths(Triangulation(m.mesh), 10, seed);
}

TEST(Edge_paths, random_paths_on_data_meshes)
{
  for_data_meshes({"elephant.off", "pig.off", "anchor.off", "fandisk.off"},
                  [](const Mesh& mesh) { check_random_paths(Triangulation(mesh), 100, 3); });
}

// ---- Flat surfaces ----

// Returns the vector along a path in the plane.
Vector displacement(const Halfedges& path, const Flat_triangulation& flat)
{
  Vector sum{0, 0};
  for(Halfedge_index h : path)
    sum = sum + flat.input_vector(h);
  return sum;
}

// Returns a random walk along edges of T1. A loop continues until it is at its start.
Halfedges random_walk(const Delta_complex& mesh, int n, bool is_loop, CGAL::Random& random)
{
  Halfedges result;
  Vertex_index v(0);
  while(n-- > 0 || (is_loop && v != Vertex_index(0))) {
    Halfedges outgoing_halfedges;
    IT::for_each_outgoing_halfedge(v, mesh,
                                   [&](Halfedge_index h) { outgoing_halfedges.push_back(h); });
    result.push_back(outgoing_halfedges[static_cast<std::size_t>(
      random.get_int(0, static_cast<int>(outgoing_halfedges.size())))]);
    v = mesh.target(result.back());
  }
  return result;
}

// Checks a walk of a single class: all its geodesics are straight lines of one length.
void check_flat(const Flat_surface& surface, bool is_loop, unsigned int seed)
{
  CGAL::Random random(seed);
  for(int i = 0; i < 20; ++i) {
    Flat_triangulation flat(surface);
    Triangulation t = *flat;
    const Halfedges walk = random_walk(t.mesh(), 12, is_loop, random);
    Paths paths(t);
    is_loop ? paths.add_loop(walk) : paths.add_path(walk);
    if(paths.shorten() == Status::blocked) // it crosses itself
      continue;
    EXPECT_NEAR(paths.length(0), length(displacement(walk, flat)), 1e-8);
    expect_geodesic(paths.halfedges(0), is_loop, t);
  }
}

TEST(Edge_paths, on_flat_tori_and_cylinders)
{
  for(unsigned int seed = 0; seed < 5; ++seed) {
    check_flat(flat_torus(5, 4, seed), false, seed);
    check_flat(flat_torus(5, 4, seed), true, seed);
    check_flat(flat_torus(2, 1, seed), true, seed);
    check_flat(flat_cylinder(5, static_cast<int>(seed)), false, seed);
    check_flat(flat_cylinder(5, static_cast<int>(seed)), true, seed);
  }
}

// With exact decisions, a certificate shows that no angle is below pi.
TEST(Edge_paths, exact)
{
  using Traits = IT::Exact_Euclidean_geometry_traits<>;
  for(const Named_mesh& m : traced(meshes())) {
    IT::Intrinsic_triangulation<Traits> t(m.mesh);
    Triangulation rounded(m.mesh);
    CGAL::Random random(5);
    for(int i = 0; i < 5; ++i) {
      const auto [v, w] = random_vertices(t.mesh(), random);
      const Halfedges start = IT::shortest_edge_path(rounded.input(), v, w);
      t.reset_to_input();
      rounded.reset_to_input();
      IT::Edge_paths<Traits> exact(t);
      Paths paths(rounded);
      exact.add_path(start);
      paths.add_path(start);
      EXPECT_EQ(exact.shorten(), Status::geodesic);
      EXPECT_EQ(paths.shorten(), Status::geodesic);
      EXPECT_TRUE(exact.is_geodesic());
      EXPECT_NEAR(exact.length(0), paths.length(0), 1e-9 * (1 + paths.length(0)));
    }
  }
}

// The surface has many equal angles, and angles of exactly pi.
TEST(Edge_paths, exact_with_ties)
{
  for(std::uint64_t seed : seeds(20)) {
    IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>> t(tied_mesh(seed).mesh);
    CGAL::Random random(static_cast<unsigned int>(seed));
    for(int i = 0; i < 3; ++i) {
      const auto [v, w] = random_vertices(t.mesh(), random);
      IT::Edge_paths paths(t);
      paths.add_path(IT::shortest_edge_path(t.intrinsic(), v, w));
      EXPECT_EQ(paths.shorten(), Status::geodesic);
    }
  }
}

// Paths run side by side: at a vertex with a small angle sum, they move to either side.
TEST(Edge_paths, doubled_paths)
{
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t(m.mesh);
    CGAL::Random random(6);
    for(int i = 0; i < 10; ++i) {
      const auto [v, w] = random_vertices(t.mesh(), random);
      const Halfedges start = IT::shortest_edge_path(t.intrinsic(), v, w);
      const double before = length(start, t);
      Paths paths(t);
      for(int copy = 0; copy < 3; ++copy)
        paths.add_path(start);
      EXPECT_EQ(paths.shorten(), Status::geodesic);
      for(std::size_t copy = 0; copy < 3; ++copy) {
        expect_geodesic(paths.halfedges(copy), false, t);
        EXPECT_LE(paths.length(copy), before * (1 + 1e-14));
      }
    }
  }
}

TEST(Edge_paths, contracts_to_a_point)
{
  Triangulation t(random_sphere(40, 1));
  const Halfedge_index h = t.mesh().halfedge(Face_index(3));
  Paths paths(t);
  paths.add_loop({h, t.mesh().next(h), t.mesh().prev(h)});
  EXPECT_EQ(paths.shorten(), Status::geodesic);
  EXPECT_TRUE(paths.halfedges(0).empty());
  EXPECT_EQ(paths.length(0), 0);
}

// The path leads across a corner of a square, whose diagonal at the corner is flipped, unless it is
// constrained or another path runs along it.
TEST(Edge_paths, blocked_by_paths_and_constraints)
{
  const Mesh mesh = grid(2, 2, [](double x, double y) { return Point(x, y, 0); });
  const Triangulation square(mesh);
  const Vertex_index middle(4);
  Halfedge_index diagonal;
  IT::for_each_outgoing_halfedge(middle, square.mesh(), [&](Halfedge_index h) {
    if(square.length(square.mesh().edge(h)) > 1.2)
      diagonal = h;
  });
  const Halfedges corner{IT::opposite(IT::previous_around_source(diagonal, square.mesh())),
                         IT::next_around_source(diagonal, square.mesh())};
  for(int obstacle = 0; obstacle < 3; ++obstacle) {
    const auto is_constrained = boost::make_function_property_map<Edge_index>(
      [&](Edge_index e) { return obstacle == 2 && e == Edge_index(diagonal); });
    Triangulation t(mesh, CGAL::parameters::edge_is_constrained_map(is_constrained));
    Paths paths(t);
    paths.add_path(corner);
    if(obstacle == 1)
      paths.add_path({diagonal});
    EXPECT_EQ(paths.shorten(), obstacle > 0 ? Status::blocked : Status::geodesic);
    EXPECT_NEAR(paths.length(0), obstacle > 0 ? 2 : std::sqrt(2.), 1e-15);
  }
}

// Returns a walk on a grid with lines of 9 vertices. It leads along lines to the corner of a
// square, several times around it, and into it, with random excursions.
Halfedges spiral_with_excursions(const Delta_complex& mesh, std::size_t turns, CGAL::Random& random)
{
  Halfedges result;
  Vertex_index at(0);
  const auto halfedge_to = [&](Vertex_index v, Vertex_index w) {
    Halfedge_index result;
    IT::for_each_outgoing_halfedge(
      v, mesh, [&](Halfedge_index h) { result = mesh.target(h) == w ? h : result; });
    return result;
  };
  const auto step = [&](int by) {
    Halfedges excursion;
    Vertex_index v = at;
    for(int n = random.get_int(-6, 7); n > 0; --n) {
      Halfedges outgoing_halfedges;
      IT::for_each_outgoing_halfedge(v, mesh,
                                     [&](Halfedge_index h) { outgoing_halfedges.push_back(h); });
      excursion.push_back(outgoing_halfedges[static_cast<std::size_t>(
        random.get_int(0, static_cast<int>(outgoing_halfedges.size())))]);
      v = mesh.target(excursion.back());
    }
    result.insert(result.end(), excursion.begin(), excursion.end());
    for(auto h = excursion.rbegin(); h != excursion.rend(); ++h)
      result.push_back(mesh.opposite(*h));
    const Vertex_index next(static_cast<Delta_complex::size_type>(static_cast<int>(at.idx()) + by));
    result.push_back(halfedge_to(at, next));
    at = next;
  };
  for(int by : {1, 1, 9, 9})
    step(by);
  for(std::size_t i = 0; i < turns; ++i)
    for(int by : {1, 1, 1, 9, 9, 9, -1, -1, -1, -9, -9, -9})
      step(by);
  step(1);
  step(9);
  return result;
}

// A path that overlaps itself without crossings becomes straight.
TEST(Edge_paths, spirals_with_excursions)
{
  const Mesh mesh = grid(8, 8, [](double x, double y) { return Point(x, y, 0); });
  CGAL::Random random(7);
  for(int i = 0; i < 100; ++i) {
    Triangulation t(mesh);
    const Halfedges walk =
      spiral_with_excursions(t.mesh(), static_cast<std::size_t>(i % 4), random);
    const Point &p = mesh.point(t.mesh().source(walk.front())),
                &q = mesh.point(t.mesh().target(walk.back()));
    Paths paths(t);
    paths.add_path(walk);
    EXPECT_EQ(paths.shorten(), Status::geodesic) << i;
    EXPECT_NEAR(paths.length(0), std::sqrt(CGAL::squared_distance(p, q)), 1e-12) << i;
  }
}

// On the boundary the side of the surface counts.
TEST(Edge_paths, along_the_boundary)
{
  Triangulation t(punctured(grid(2, 2, [](double x, double y) { return Point(x, y, 0); }), {0, 1}));
  Paths paths(t);
  paths.add_path(IT::shortest_edge_path(t.intrinsic(), Vertex_index(1), Vertex_index(3)));
  EXPECT_EQ(paths.shorten(), Status::geodesic);
  EXPECT_EQ(paths.length(0), 2);
  const Surface_path path = IT::path_on_input(t, paths.halfedges(0));
  ASSERT_EQ(path.places.size(), 3u);
  EXPECT_EQ(t.input_mesh().source(IT::halfedge_of(path.places[1])), Vertex_index(4));
}

// The path leads around an annulus from one side to the other, and has the length of a straight
// line in the plane.
TEST(Edge_paths, around_a_cylinder)
{
  const Flat_surface surface = flat_cylinder(6, 0);
  for(int turns = -3; turns <= 3; ++turns) {
    Flat_triangulation flat(surface);
    Triangulation t = *flat;
    Halfedges walk;
    const auto step = [&](Vertex_index v, const Vector& d) {
      IT::for_each_outgoing_halfedge(v, t.mesh(), [&](Halfedge_index h) {
        if(flat.input_vector(h) == d)
          walk.push_back(h);
      });
      return t.mesh().target(walk.back());
    };
    Vertex_index v = t.mesh().source(halfedge_of(1));
    for(int i = 0; i < 6 * std::abs(turns); ++i)
      v = step(v, {turns > 0 ? 1000 : -1000, 0});
    step(v, {300, 700});
    Paths paths(t);
    paths.add_path(walk);
    EXPECT_EQ(paths.shorten(), Status::geodesic);
    EXPECT_NEAR(paths.length(0), std::hypot(6000. * turns + 300, 700), 1e-9);
    EXPECT_NEAR(IT::path_on_input(t, paths.halfedges(0)).length, paths.length(0), 1e-9);
  }
}

} // namespace Test_edge_paths
