// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests check the greedy simplification.

#include "../Intrinsic_triangulations/data_meshes.h"
#include "../Intrinsic_triangulations/hard_meshes.h"
#include "evolving_surfaces.h"

#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>

namespace Test_simplify {

using namespace Test_surfaces;
using IS::Simplification_result;
using IS::simplify;
using IS::Transport_cost;
using IS::parameters::maximum_cost;
using IS::parameters::number_of_vertices;

std::set<std::size_t> vertices_of(const Evolving_surface& s)
{
  std::set<std::size_t> result;
  for(Vertex_index v : s.mesh().vertices())
    result.insert(v);
  return result;
}

std::set<std::size_t> first(std::size_t n)
{
  std::set<std::size_t> result;
  for(std::size_t v = 0; v < n; ++v)
    result.insert(v);
  return result;
}

// ---- Developable surfaces ----

// Removes what can be removed without moving curvature.
Simplification_result simplify_for_free(Evolving_surface& s, double rounding)
{
  Transport_cost cost(s);
  cost.add_curvature(s);
  return simplify(s, cost, maximum_cost(rounding));
}

// Checks that only the vertices 0, ..., corners - 1 are left.
void expect_only_corners_left(const Mesh& mesh, std::size_t corners, double rounding)
{
  Evolving_surface s(mesh);
  const double area = area_of(s);
  const Simplification_result result = simplify_for_free(s, rounding);
  EXPECT_EQ(vertices_of(s), first(corners));
  EXPECT_LE(result.greatest_cost, rounding);
  EXPECT_EQ(result.removed + corners, mesh.number_of_vertices());
  EXPECT_NEAR(area_of(s) / area, 1, 1e-10);
}

TEST(Simplification, polyhedra_to_their_corners)
{
  for(int times = 1; times <= 3; ++times) {
    expect_only_corners_left(subdivided(cube(), times), 8, 1e-12);
    expect_only_corners_left(subdivided(tetrahedron(), times), 4, 1e-12);
    expect_only_corners_left(subdivided(octahedron(), times), 6, 1e-12);
    expect_only_corners_left(subdivided(square(), times + 1), 4, 1e-12);
  }
}

// Positions are rounded, and so are the curvatures.
TEST(Simplification, rotated_polyhedra_to_their_corners)
{
  Mesh mesh = subdivided(cube(), 3);
  for(Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    mesh.point(v) = Point(0.6 * p.x() - 0.8 * p.y() + p.z() / 3, 0.8 * p.x() + 0.6 * p.y() + 0.1,
                          p.z() + p.x() / 7);
  }
  expect_only_corners_left(mesh, 8, 1e-10);
}

// The walls of a box without lid and bottom are an annulus whose boundary is straight everywhere.
TEST(Simplification, tube_to_its_ends)
{
  Evolving_surface s(subdivided(punctured(cube(), {0, 1, 2, 3}), 3));
  simplify_for_free(s, 1e-12);
  EXPECT_LE(s.mesh().number_of_vertices(), 6u);
  EXPECT_NEAR(area_of(s), 4, 1e-10);
  EXPECT_EQ(Euler_characteristic(s.mesh()), 0);
}

// A piece of a cone consists of the sides of a regular pyramid.
TEST(Simplification, pyramid_to_its_corners)
{
  std::vector<Point> points{{0, 0, 1}};
  Triangles triangles;
  for(std::size_t i = 0; i < 5; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / 5;
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
    triangles.push_back({0, i + 1, (i + 1) % 5 + 1});
  }
  expect_only_corners_left(subdivided(make_mesh(points, triangles), 3), 6, 1e-10);
}

// ---- Stopping ----

TEST(Simplification, goes_on)
{
  Evolving_surface s(random_sphere(200, 1));
  Transport_cost cost(s);
  cost.add_curvature(s);
  double last = 0;
  std::size_t before = 200;
  for(const std::size_t n : {200u, 180u, 120u, 60u, 20u, 10u}) {
    EXPECT_EQ(simplify(s, cost, number_of_vertices(n)).removed, before - n);
    before = n;
    EXPECT_EQ(s.mesh().number_of_vertices(), n);
    EXPECT_EQ(cost.total() > last, n < 200);
    last = cost.total();
    expect_valid(s, 2);
  }
}

// None of the remaining vertices can be removed, each for a reason.
TEST(Simplification, ends_where_nothing_can_be_removed)
{
  for(const auto& [c, seed] : traced(complexes(), 5)) {
    Evolving_surface s = evolving(c.mesh, seed);
    const int characteristic = Euler_characteristic(c.mesh);
    const Simplification_result result = simplify(s, number_of_vertices(std::size_t(0)));
    expect_valid(s, characteristic);
    std::array<std::size_t, IS::number_of_removal_statuses> skipped{};
    Flattened_star star;
    for(Vertex_index v : s.mesh().vertices()) {
      Removal_status status = s.flatten(v, star);
      if(status == Removal_status::possible)
        status = s.remove(star);
      ASSERT_NE(status, Removal_status::possible);
      ++skipped[static_cast<std::size_t>(status)];
    }
    EXPECT_EQ(result.skipped, skipped);
  }
}

// The surface follows the flips of the triangulation, and the history contains them.
TEST(Simplification, starts_from_an_exactly_Delaunay_triangulation)
{
  for(std::uint64_t seed : traced({0u, 1u, 2u, 3u, 5u, 9u, 13u, 25u, 26u})) {
    IT::Intrinsic_triangulation<> tri(hard_mesh(seed).mesh), alone = tri;
    Evolving_surface s(tri);
    s.make_exactly_Delaunay(tri);
    EXPECT_EQ(s.history().size(), IT::make_Delaunay(alone, IT::parameters::exact_decisions(true)));
    EXPECT_TRUE(IT::certify_Delaunay(tri).is_Delaunay());
    for(Halfedge_index h : tri.mesh().halfedges()) {
      EXPECT_EQ(s.mesh().target(h), tri.mesh().target(h));
      EXPECT_EQ(s.mesh().next(h), tri.mesh().next(h));
      EXPECT_EQ(s.surface().length(h), alone.length(tri.mesh().edge(h)));
    }
  }
}

// Rounding hides angles of these surfaces, at some vertices all of them.
TEST(Simplification, of_hard_meshes)
{
  for(std::uint64_t seed = 0; seed < 10 * hard_families.size(); ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = hard_mesh(seed).mesh;
    Evolving_surface surface(mesh);
    ASSERT_NO_THROW(
      IS::simplify(surface, IS::parameters::number_of_vertices(2 * mesh.number_of_vertices() / 5)));
    ASSERT_TRUE(IT::is_valid_Delta_complex(surface.mesh(), true));
    EXPECT_EQ(Euler_characteristic(surface.mesh()), Euler_characteristic(mesh));
    expect_triangles(surface);
    for(Edge_index e : surface.mesh().edges())
      EXPECT_GT(surface.surface().length(e), 0);
  }
}

// Interior and boundary vertices of flat strips are ties: they lie on diagonals of thin faces.
TEST(Simplification, keeps_the_corners_of_thin_strips)
{
  for(const std::size_t columns : {2u, 3u, 5u, 8u})
    for(const double height : {0.05, 0.02, 0.01, 0.005, 0.002, 0.001}) {
      const Mesh mesh = grid(columns, 2, [&, n = double(columns)](double x, double y) {
        return Point(x / n, height * y / 2, 0);
      });
      SCOPED_TRACE(std::to_string(columns) + " columns of height " + std::to_string(height));
      Evolving_surface surface(mesh);
      simplify(surface, number_of_vertices(std::size_t(4)));
      std::set<Point> corners;
      for(Vertex_index v : surface.mesh().vertices())
        corners.insert(mesh.point(v));
      EXPECT_EQ(corners, (std::set<Point>{{0, 0, 0}, {1, 0, 0}, {0, height, 0}, {1, height, 0}}));
      EXPECT_NEAR(area_of(surface), height, 1e-9 * height);
    }
}

TEST(Simplification, protected_vertices_stay)
{
  Evolving_surface s(random_sphere(100, 2));
  for(unsigned int v = 0; v < 100; v += 10)
    s.protect(Vertex_index(v));
  const Simplification_result result = simplify(s, number_of_vertices(std::size_t(0)));
  for(unsigned int v = 0; v < 100; v += 10)
    EXPECT_FALSE(s.mesh().is_removed(Vertex_index(v)));
  EXPECT_EQ(s.mesh().number_of_vertices(), 10u);
  EXPECT_EQ(result.skipped[static_cast<std::size_t>(Removal_status::protected_vertex)], 10u);
}

// ---- Order ----

// Checks that the surface is always valid.
struct Checking_visitor
{
  const Evolving_surface& surface;
  std::vector<Vertex_index> order = {};
  double cost = -1;

  void before_removal(const Flattened_star& star, double cost_of_star)
  {
    order.push_back(star.center());
    cost = cost_of_star;
  }
  void after_removal(Vertex_index v)
  {
    EXPECT_EQ(order.back(), v);
    EXPECT_TRUE(surface.mesh().is_removed(v));
    expect_valid(surface, 2);
  }
};

TEST(Simplification, keeps_the_surface_valid)
{
  Evolving_surface s(random_sphere(150, 4));
  Checking_visitor visitor{s};
  simplify(s, number_of_vertices(std::size_t(5)).visitor(std::ref(visitor)));
  EXPECT_EQ(visitor.order.size(), 145u);
}

TEST(Simplification, takes_parameters_in_any_order)
{
  const Mesh mesh = random_sphere(60, 4);
  const auto length = boost::make_function_property_map<Mesh::Edge_index>([](auto) { return 1.; });
  Evolving_surface s(mesh, IS::parameters::edge_length_map(length));
  EXPECT_EQ(s.surface().length(IT::Edge_index(0)), 1);
  Checking_visitor visitor{s};
  const auto visited = IS::parameters::visitor(std::ref(visitor));
  simplify(s, visited.number_of_vertices(std::size_t(5)).maximum_cost(-1.));
  EXPECT_TRUE(visitor.order.empty());
  simplify(s, visited.maximum_cost(-1.).number_of_vertices(std::size_t(5)).maximum_cost(1e9));
  EXPECT_EQ(visitor.order.size(), 55u);
}

// Represents a visitor with functions that are not constant, whose copies count together.
struct Counting_visitor : IS::Default_simplification_visitor
{
  void after_removal(Vertex_index) { ++own, ++*all; }

  std::size_t own = 0;
  std::shared_ptr<std::size_t> all = std::make_shared<std::size_t>(0);
};

TEST(Simplification, takes_visitors_and_references_to_them)
{
  Counting_visitor copied, referred;
  Evolving_surface s(random_sphere(60, 4)), t(random_sphere(60, 4));
  simplify(s, number_of_vertices(std::size_t(5)).visitor(copied));
  simplify(t, number_of_vertices(std::size_t(5)).visitor(std::ref(referred)));
  EXPECT_EQ(*copied.all, 55u);
  EXPECT_EQ(copied.own, 0u);
  EXPECT_EQ(referred.own, 55u);
}

// Represents a user-defined cost: the index of the vertex.
struct Last_number_first
{
  double operator()(const Flattened_star& star) const { return -double(star.center().idx()); }
  void after_removal(const Flattened_star&) {}
};

TEST(Simplification, takes_the_cheapest_first)
{
  Evolving_surface s(subdivided(octahedron(), 2));
  Last_number_first cost;
  Checking_visitor visitor{s};
  simplify(s, cost, number_of_vertices(std::size_t(10)).visitor(std::ref(visitor)));
  EXPECT_TRUE(std::is_sorted(visitor.order.rbegin(), visitor.order.rend()));
}

// Represents a function of the star alone, which removals nearby increase or decrease.
struct Distance_from_degree_six
{
  double operator()(const Flattened_star& star) const { return std::abs(double(star.size()) - 6); }
  void after_removal(const Flattened_star&) {}
};

// Returns the costs of all vertices that can be removed.
std::map<Vertex_index, double> costs(const Evolving_surface& s)
{
  std::map<Vertex_index, double> result;
  Flattened_star star;
  for(Vertex_index v : s.mesh().vertices())
    if(s.flatten(v, star) == IS::Removal_status::possible)
      result[v] = Distance_from_degree_six()(star);
  return result;
}

// Compares each removal with all other possible removals.
struct Comparing_visitor : IS::Default_simplification_visitor
{
  const Evolving_surface& surface;
  std::map<Vertex_index, double> before = {};
  int fallen = 0;

  explicit Comparing_visitor(const Evolving_surface& s) : surface(s) {}

  void before_removal(const Flattened_star& star, double cost)
  {
    const auto now = costs(surface);
    for(const auto& [v, other] : now) {
      EXPECT_LE(cost, other) << star.center() << ' ' << v;
      const auto old = before.find(v);
      fallen += old != before.end() && other < old->second;
    }
    before = now;
  }
};

TEST(Simplification, takes_the_cheapest_though_costs_fall)
{
  for(unsigned seed = 0; seed < 5; ++seed) {
    Evolving_surface s(random_sphere(80, seed));
    Distance_from_degree_six cost;
    Comparing_visitor visitor(s);
    simplify(s, cost, number_of_vertices(std::size_t(5)).visitor(std::ref(visitor)));
    EXPECT_GT(visitor.fallen, 10);
  }
}

TEST(Simplification, goes_on_while_a_cost_is_allowed)
{
  for(unsigned seed = 0; seed < 5; ++seed) {
    Evolving_surface s(random_sphere(80, seed));
    Distance_from_degree_six cost;
    simplify(s, cost, maximum_cost(0.));
    EXPECT_LT(s.mesh().number_of_vertices(), 80u);
    for(const auto& [v, left] : costs(s))
      EXPECT_GT(left, 0) << v;
  }
}

TEST(Simplification, is_reproducible)
{
  const Mesh mesh = random_sphere(300, 5);
  const auto state = [&] {
    Evolving_surface s(mesh);
    simplify(s, number_of_vertices(std::size_t(20)));
    return state_of(s);
  };
  EXPECT_TRUE(state() == state());
}

struct Impatient_visitor : IS::Default_simplification_visitor
{
  int left = 50;
  void after_removal(Vertex_index)
  {
    if(--left == 0)
      throw std::runtime_error("enough");
  }
};

TEST(Simplification, can_be_stopped_by_an_exception)
{
  Evolving_surface s(random_sphere(100, 6));
  Impatient_visitor visitor;
  EXPECT_THROW(simplify(s, number_of_vertices(std::size_t(0)).visitor(std::ref(visitor))),
               std::runtime_error);
  EXPECT_EQ(s.mesh().number_of_vertices(), 50u);
  expect_valid(s, 2);
  simplify(s, number_of_vertices(std::size_t(20)));
  EXPECT_EQ(s.mesh().number_of_vertices(), 20u);
}

// The apexes are vertices of high degree.
TEST(Simplification, bipyramid)
{
  Evolving_surface s(bipyramid(2000, 0.5));
  simplify(s, number_of_vertices(std::size_t(0)));
  expect_valid(s, 2);
  EXPECT_LE(s.mesh().number_of_vertices(), 6u);
}

// ---- Default cost ----

struct Cell_polygon
{
  std::string name;
  std::size_t corners;
  int width, height;
  std::function<bool(int, int)> has_cell;
};

std::vector<Cell_polygon> cell_polygons()
{
  return {{"square", 4, 4, 4, [](int, int) { return true; }},
          {"strip", 4, 40, 1, [](int, int) { return true; }},
          {"L", 6, 4, 4, [](int i, int j) { return i < 2 || j < 2; }},
          {"stairs", 14, 6, 6, [](int i, int j) { return i + j < 6; }},
          {"comb", 20, 9, 4, [](int i, int j) { return j < 1 || i % 2 == 0; }}};
}

// Divides each cell into 2 n^2 triangles.
Mesh mesh_of(const Cell_polygon& p, int n)
{
  Mesh mesh;
  std::map<std::pair<int, int>, Vertex_index> vertex;
  const auto at = [&](int i, int j) {
    const auto [place, is_new] = vertex.try_emplace({i, j});
    if(is_new)
      place->second = mesh.add_vertex(Point(i, j, 0));
    return place->second;
  };
  for(int i = 0; i < n * p.width; ++i)
    for(int j = 0; j < n * p.height; ++j)
      if(p.has_cell(i / n, j / n)) {
        mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  return mesh;
}

// Flat vertices can be removed without changing the surface, so the area shows whether others were
// removed.
TEST(Simplification, keeps_corners_of_flat_surfaces_by_default)
{
  for(const Cell_polygon& p : traced(cell_polygons()))
    for(const int n : traced({1, 2, 5}))
      for(const std::size_t more : traced({0, 1, 2, 5, 10})) {
        Evolving_surface s(mesh_of(p, n));
        const double area = area_of(s);
        simplify(s, number_of_vertices(p.corners + more));
        EXPECT_EQ(s.mesh().number_of_vertices(), p.corners + more);
        EXPECT_NEAR(area_of(s) / area, 1, 1e-12);
      }
}

// The part cut off a square of side two is half of a unit square, an eighth of the area.
TEST(Transport_cost, of_change_at_the_boundary)
{
  Evolving_surface s(mesh_of({"square", 4, 2, 2, [](int, int) { return true; }}, 1));
  s.make_Delaunay();
  Transport_cost cost(s);
  cost.add_boundary_change(s, 3);
  Flattened_star star;
  for(Vertex_index v : s.mesh().vertices()) {
    const std::size_t degree = s.mesh().degree(v);
    if(s.flatten(v, star) != Removal_status::possible)
      continue;
    const bool is_corner = star.is_border() && std::abs(star.scale_factor()) > 0.1;
    EXPECT_NEAR(cost(star), is_corner ? 3 * std::abs(star.area_change()) / 4 * 8 : 0, 1e-12)
      << v << " of degree " << degree;
    EXPECT_EQ(is_corner, cost(star) > 0.1);
  }
  EXPECT_EQ(cost.number_of_masses(), 0u);
}

// A surface is not removed completely by mistake.
TEST(Simplification, needs_a_target)
{
  Evolving_surface s(random_sphere(30, 6));
  Transport_cost cost = IS::default_cost(s);
  EXPECT_THROW(simplify(s), IT::Invalid_input);
  EXPECT_THROW(simplify(s, cost), IT::Invalid_input);
  EXPECT_THROW(simplify(s, IS::parameters::minimum_angle(3)), IT::Invalid_input);
  EXPECT_EQ(s.mesh().number_of_vertices(), 30u);
  EXPECT_EQ(simplify(s, maximum_cost(-1.)).removed, 0u);
}

// ---- Real meshes ----

TEST(Simplification, of_data_meshes_to_the_last_vertex)
{
  for_each_data_mesh(1000000, [](const Mesh& mesh) {
    Evolving_surface s(mesh);
    const int characteristic = Euler_characteristic(s.mesh());
    const double area = area_of(s);
    simplify(s, number_of_vertices(mesh.number_of_vertices() / 100));
    expect_valid(s, characteristic);
    const double ratio = area_of(s) / area;
    EXPECT_TRUE(ratio > 0 && std::isfinite(ratio));
    simplify(s, number_of_vertices(std::size_t(0)));
    expect_valid(s, characteristic);
  });
}

} // namespace Test_simplify
