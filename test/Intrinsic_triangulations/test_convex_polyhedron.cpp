// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "more_generators.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/convex_polyhedron.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/glue_boundary.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <map>
#include <queue>
#include <set>
#include <utility>
#include <vector>

using namespace Test_surfaces;

namespace {

typedef IT::Convex_polyhedron Polyhedron;

Polyhedron polyhedron_of_lengths(const Triangulation& t)
{
  return IT::convex_polyhedron(t.mesh(), IT::parameters::edge_length_map(t.length_map()));
}

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }
double distance(const Polyhedron& p, Vertex_index v, Vertex_index w)
{
  return std::sqrt(CGAL::squared_distance(p.point(v), p.point(w)));
}

// Checks that distances of all vertices are those of a convex mesh.
void expect_congruent(const Polyhedron& p, const Mesh& mesh, double tolerance)
{
  for(Vertex_index v : mesh.vertices())
    for(Vertex_index w : mesh.vertices())
      ASSERT_NEAR(distance(p, v, w), distance(mesh.point(v), mesh.point(w)), tolerance)
        << v << ' ' << w;
  EXPECT_TRUE(p.certificate().is_convex());
}

std::multiset<std::array<unsigned, 3>> faces_of(const Delta_complex& mesh)
{
  std::multiset<std::array<unsigned, 3>> result;
  for(Face_index f : mesh.faces()) {
    std::array<unsigned, 3> corner;
    for(std::size_t s = 0; s < 3; ++s)
      corner[s] = mesh.source(IT::sides(f, mesh)[s]).idx();
    std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    result.insert(corner);
  }
  return result;
}

Mesh stretched(Mesh mesh, double x, double y, double z)
{
  for(Vertex_index v : mesh.vertices()) {
    Point& p = mesh.point(v);
    p = Point(x * p.x(), y * p.y(), z * p.z());
  }
  return mesh;
}

// Rotates by an angle about a skew axis, so that coordinates are rounded.
Mesh rotated(Mesh mesh)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  for(Vertex_index v : mesh.vertices()) {
    Point& p = mesh.point(v);
    p = Point(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
    p = Point(p.x(), c * p.y() - s * p.z(), s * p.y() + c * p.z());
  }
  return mesh;
}

// Returns a box whose sides are grids of squares, each cut in two.
Mesh gridded_cube(int n)
{
  std::map<std::array<int, 3>, std::size_t> number;
  std::vector<Point> points;
  Triangles triangles;
  const auto corner = [&](std::array<int, 3> p) {
    const auto [it, is_new] = number.emplace(p, points.size());
    if(is_new)
      points.emplace_back(double(p[0]) / n, double(p[1]) / n, double(p[2]) / n);
    return it->second;
  };
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(int end : {0, n})
      for(int i = 0; i < n; ++i)
        for(int j = 0; j < n; ++j) {
          const auto at = [&](int u, int v) {
            std::array<int, 3> p{};
            p[axis] = end;
            p[(axis + 1) % 3] = u;
            p[(axis + 2) % 3] = v;
            return corner(p);
          };
          std::array<std::size_t, 4> q{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
          if(end == 0)
            std::reverse(q.begin(), q.end());
          triangles.push_back({q[0], q[1], q[2]});
          triangles.push_back({q[0], q[2], q[3]});
        }
  return make_mesh(points, triangles);
}

// Cuts each face into four at the midpoints of its sides.
Mesh subdivided(const Mesh& mesh)
{
  std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  for(auto e : mesh.edges())
    points.push_back(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  const auto middle = [&](auto h) { return mesh.number_of_vertices() + mesh.edge(h).idx(); };
  Triangles triangles;
  for(auto f : mesh.faces()) {
    std::array<std::size_t, 3> middles{};
    for(std::size_t s = 0; s < 3; ++s) {
      const auto h = IT::sides(f, mesh)[s];
      middles[s] = middle(h);
      triangles.push_back({mesh.source(h).idx(), middle(h), middle(mesh.prev(h))});
    }
    triangles.push_back(middles);
  }
  return make_mesh(points, triangles);
}

// Returns a polygon with two sides, each cut into triangles at a different corner.
Mesh double_polygon(const std::vector<Point>& corner, std::size_t lower_fan)
{
  Triangles triangles;
  const std::size_t n = corner.size();
  for(std::size_t i = 1; i + 1 < n; ++i) {
    triangles.push_back({0, i, i + 1});
    triangles.push_back({lower_fan, (lower_fan + i + 1) % n, (lower_fan + i) % n});
  }
  return make_mesh(corner, triangles);
}

} // namespace

TEST(Convex_polyhedron, recovers_hulls_from_their_metrics)
{
  CGAL::Random random(1);
  for(std::size_t n : {4, 5, 8, 20, 100})
    for(unsigned int seed = 0; seed < 4; ++seed)
      for(double z : {1., 0.1, 0.003}) {
        const Mesh mesh = stretched(random_sphere(n, seed), 1, 1, z);
        const Triangulation t = with_random_flips(mesh, random);
        const Polyhedron p = polyhedron_of_lengths(t);
        expect_congruent(p, mesh, 1e-9);
        EXPECT_LT(p.max_edge_error(), 1e-9);
        EXPECT_EQ(p.certificate().convex_edges, mesh.number_of_edges());
        EXPECT_EQ(faces_of(p.triangulation().mesh()), faces_of(Triangulation(mesh).mesh()));
        EXPECT_TRUE(p.triangulation().is_valid());
        EXPECT_FALSE(p.is_flat());
        EXPECT_TRUE(p.flat_vertices().empty());
      }
}

// Curvatures are near 2 pi at the ends, and 1e-9 between them. Squared distances of type `double`
// do not determine the edges of the second needle.
TEST(Convex_polyhedron, recovers_needles)
{
  const std::array<double, 2> widths[] = {{1e-3, 3e-7}, {1e-4, 1e-6}};
  for(const auto& [y, z] : widths)
    for(std::size_t n : {8, 12})
      for(unsigned int seed = 0; seed < 3; ++seed) {
        const Mesh mesh = stretched(random_sphere(n, seed), 1, y, z);
        const Triangulation t(mesh);
        const Polyhedron p = polyhedron_of_lengths(t);
        EXPECT_EQ(p.kind(), IT::Polyhedron_kind::convex);
        EXPECT_TRUE(p.certificate().is_convex());
        EXPECT_EQ(faces_of(p.triangulation().mesh()), faces_of(t.mesh()));
        for(Edge_index e : t.mesh().edges()) {
          const Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
          EXPECT_NEAR(distance(p, v, w) / distance(mesh.point(v), mesh.point(w)), 1, 1e-9);
        }
      }
}

// Heights are so small that rounded lengths make some vertices flat. Removing them makes others
// flat.
TEST(Convex_polyhedron, removes_vertices_that_become_flat)
{
  const Mesh mesh = stretched(random_sphere(16, 27), 1, 1, 1e-7);
  CGAL::Random random(27);
  const Polyhedron p = polyhedron_of_lengths(with_random_flips(mesh, random));
  expect_congruent(p, mesh, 1e-9);
  EXPECT_FALSE(p.flat_vertices().empty());
}

// Curvatures at the apex differ from the curvatures of the surface by 1e-15 if the apex is so far
// away that the least curvature, at the top of the roof, remains.
TEST(Convex_polyhedron, recovers_a_plate_with_a_shallow_roof)
{
  const std::size_t n = 12, top = 2 * n;
  std::vector<Point> corner;
  for(double z : {0., 1e-4})
    for(std::size_t i = 0; i < n; ++i)
      corner.emplace_back(std::cos(2 * pi * double(i) / n), std::sin(2 * pi * double(i) / n), z);
  corner.emplace_back(0, 0, 1.03e-4);
  Triangles triangles;
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    triangles.push_back({i, j, n + j});
    triangles.push_back({i, n + j, n + i});
    triangles.push_back({n + i, n + j, top});
    if(i > 0 && j > 0)
      triangles.push_back({0, j, i});
  }
  const Mesh mesh = make_mesh(corner, triangles);
  const Polyhedron p = polyhedron_of_lengths(Triangulation(mesh));
  EXPECT_EQ(p.kind(), IT::Polyhedron_kind::convex);
  expect_congruent(p, mesh, 1e-9);
}

// Exact arithmetic with integers decides the same.
TEST(Convex_polyhedron, positions_of_more_digits_have_exact_orientations)
{
  CGAL::Random random(6);
  const auto coordinate = [&] {
    return IT::Double_double(random.get_int(-3, 4)) + random.get_int(-3, 4) * 0x1p-90;
  };
  const auto exact = [](const IT::Double_double& x) {
    return CGAL::Gmpq(x.high()) + CGAL::Gmpq(x.low());
  };
  typedef IT::internal::Precise_vector Vector;
  for(int i = 0; i < 500; ++i) {
    std::array<Vector, 4> p;
    for(Vector& v : p)
      v = {coordinate(), coordinate(), coordinate()};
    std::array<std::array<CGAL::Gmpq, 3>, 3> m;
    for(std::size_t k = 0; k < 3; ++k)
      m[k] = {exact(p[k + 1].x) - exact(p[0].x), exact(p[k + 1].y) - exact(p[0].y),
              exact(p[k + 1].z) - exact(p[0].z)};
    const CGAL::Gmpq determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                                   m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                                   m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    const auto orientation = IT::internal::orientation(p[0], p[1], p[2], p[3], 0x1p-95);
    if(orientation != CGAL::COPLANAR)
      EXPECT_EQ(orientation, CGAL::sign(determinant));
    else
      EXPECT_LE(CGAL::abs(determinant), CGAL::Gmpq(0x1p-85));
  }
}

TEST(Convex_polyhedron, keeps_convex_meshes)
{
  for(const Mesh& mesh : {tetrahedron(), octahedron(), cube(), rotated(cube())})
    expect_congruent(IT::convex_polyhedron(mesh), mesh, 1e-11);
}

// Returns an ellipsoid with n rings of m faces or pairs of faces. The lengths of the axes are 2, 2
// and 2h.
Mesh ellipsoid(std::size_t n, std::size_t m, double h)
{
  std::vector<Point> points{{0, 0, h}};
  for(std::size_t i = 1; i < n; ++i)
    for(std::size_t j = 0; j < m; ++j) {
      const double theta = pi * double(i) / double(n), phi = 2 * pi * double(j) / double(m);
      points.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                          h * std::cos(theta));
    }
  points.emplace_back(0, 0, -h);
  const auto at = [m](std::size_t i, std::size_t j) { return 1 + (i - 1) * m + j % m; };
  Triangles triangles;
  for(std::size_t j = 0; j < m; ++j) {
    triangles.push_back({0, at(1, j), at(1, j + 1)});
    triangles.push_back({points.size() - 1, at(n - 1, j + 1), at(n - 1, j)});
    for(std::size_t i = 1; i + 1 < n; ++i) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return make_mesh(points, triangles);
}

// Returns a prism over a regular polygon with n corners on a unit circle, or an antiprism if the
// corners of its top are turned.
Mesh prism(std::size_t n, double height, bool is_turned)
{
  std::vector<Point> points;
  for(std::size_t ring = 0; ring < 2; ++ring)
    for(std::size_t j = 0; j < n; ++j) {
      const double phi = 2 * pi * (double(j) + (is_turned ? 0.5 * double(ring) : 0.)) / double(n);
      points.emplace_back(std::cos(phi), std::sin(phi), height * double(ring));
    }
  Triangles triangles;
  for(std::size_t j = 0; j < n; ++j) {
    const std::size_t k = (j + 1) % n;
    triangles.push_back({j, k, n + j});
    triangles.push_back({n + j, k, n + k});
  }
  for(std::size_t j = 1; j + 1 < n; ++j) {
    triangles.push_back({0, j + 1, j});
    triangles.push_back({n, n + j, n + j + 1});
  }
  return make_mesh(points, triangles);
}

// The radii of a ring can grow together almost without a change of curvatures.
TEST(Convex_polyhedron, recovers_tall_prisms)
{
  for(const std::size_t n : {3, 20, 48})
    for(const double height : {1e3, 5e4, 3e5})
      for(const bool is_turned : {false, true}) {
        const Mesh mesh = prism(n, height, is_turned);
        const Polyhedron p = IT::convex_polyhedron(mesh);
        EXPECT_EQ(p.points().size(), 2 * n);
        EXPECT_TRUE(p.flat_vertices().empty());
        EXPECT_TRUE(p.certificate().is_convex() ||
                    p.kind() == IT::Polyhedron_kind::convex_before_rounding);
        for(const auto e : mesh.edges()) {
          const Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
          EXPECT_NEAR(distance(p, v, w) / distance(mesh.point(v), mesh.point(w)), 1, 1e-9);
        }
      }
}

// The curvatures of most vertices are less than rounding of lengths, but not of positions.
TEST(Convex_polyhedron, keeps_the_vertices_of_thin_ellipsoids)
{
  for(const double h : {1e-4, 3e-6}) {
    const Mesh mesh = ellipsoid(12, 24, h);
    const Polyhedron p = IT::convex_polyhedron(mesh);
    EXPECT_TRUE(p.flat_vertices().empty());
    expect_congruent(p, mesh, h / 1000);
  }
}

TEST(Convex_polyhedron, takes_flat_vertices_along)
{
  for(int n : {2, 5})
    for(const Mesh& mesh : {gridded_cube(n), rotated(gridded_cube(n)),
                            rotated(stretched(gridded_cube(n), 1, 3, 0.01))}) {
      const Polyhedron p = IT::convex_polyhedron(mesh);
      EXPECT_EQ(p.flat_vertices().size(), mesh.number_of_vertices() - 8);
      expect_congruent(p, mesh, 1e-9);
      EXPECT_LT(p.max_edge_error(), 1e-9);
      EXPECT_TRUE(p.triangulation().is_valid());
    }
}

// Flat vertices lie on straight lines between others within rounding, which differs by the scale.
TEST(Convex_polyhedron, removes_flat_vertices_at_any_scale)
{
  CGAL::Random random(3);
  for(int n : {2, 3, 4, 6})
    for(int sample = 0; sample < 50; ++sample) {
      const double scale = random.get_double(0.1, 1);
      const Mesh mesh = stretched(gridded_cube(n), scale, scale, scale);
      const Polyhedron p = IT::convex_polyhedron(mesh);
      EXPECT_EQ(p.flat_vertices().size(), mesh.number_of_vertices() - 8);
      expect_congruent(p, mesh, 1e-11);
    }
}

// Vertices on edges and faces of hulls get edges to themselves before they are removed.
TEST(Convex_polyhedron, removes_the_flat_vertices_of_subdivided_hulls)
{
  for(unsigned int seed = 0; seed < 60; ++seed) {
    const Mesh hull = stretched(random_sphere(6 + seed % 20, seed), 1, 1, 1. / (1 + seed % 7)),
               mesh = subdivided(subdivided(hull));
    const Polyhedron p = IT::convex_polyhedron(mesh);
    EXPECT_EQ(p.flat_vertices().size(), mesh.number_of_vertices() - hull.number_of_vertices());
    expect_congruent(p, mesh, 1e-9);
  }
}

TEST(Convex_polyhedron, flat_vertices_of_lengths_are_flat_by_rounding)
{
  CGAL::Random random(2);
  const Mesh mesh = rotated(gridded_cube(4));
  const Polyhedron p = polyhedron_of_lengths(with_random_flips(mesh, random));
  EXPECT_EQ(p.flat_vertices().size(), mesh.number_of_vertices() - 8);
  expect_congruent(p, mesh, 1e-9);
}

TEST(Convex_polyhedron, unfolds_a_dent)
{
  // The cap above a plane is reflected in it, so angles at vertices on the plane do not change.
  const std::size_t n = 7;
  Mesh mesh = bipyramid(n, 0.8), dented = mesh;
  dented.point(Vertex_index(unsigned(n))) = Point(0, 0, -0.8 + 1e-3);
  mesh.point(Vertex_index(unsigned(n))) = Point(0, 0, 0.8 - 1e-3);
  expect_congruent(IT::convex_polyhedron(dented), mesh, 1e-11);
}

TEST(Convex_polyhedron, recognizes_polygons_with_two_sides)
{
  for(std::size_t n : {3, 4, 5, 8, 20}) {
    std::vector<Point> corner;
    for(std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * pi * double(i) / double(n) + 0.1 * std::sin(double(i));
      corner.emplace_back(std::cos(angle), 0.7 * std::sin(angle), 0);
    }
    const Mesh mesh = double_polygon(corner, 1);
    const Polyhedron p = IT::convex_polyhedron(mesh);
    EXPECT_TRUE(p.is_flat()) << n;
    EXPECT_EQ(p.kind(), IT::Polyhedron_kind::polygon);
    EXPECT_EQ(p.certificate().convex_edges, n);
    expect_congruent(p, mesh, 1e-10);
  }
}

// Corners are at random places of a thin ellipse, which is turned.
TEST(Convex_polyhedron, recognizes_thin_polygons)
{
  CGAL::Random random(9);
  for(const std::size_t n : {3, 4, 5, 8, 20})
    for(const double length : {1e2, 1e4})
      for(const double turn : {0., 0.3}) {
        std::vector<double> angle(n);
        for(double& a : angle)
          a = random.get_double(0, 2 * pi);
        std::sort(angle.begin(), angle.end());
        std::vector<Point> corner;
        for(const double a : angle) {
          const double x = length * std::cos(a), y = std::sin(a);
          corner.emplace_back(x * std::cos(turn) - y * std::sin(turn),
                              x * std::sin(turn) + y * std::cos(turn), 0);
        }
        const Mesh mesh = double_polygon(corner, 1);
        const Polyhedron p = IT::convex_polyhedron(mesh);
        EXPECT_EQ(p.kind(), IT::Polyhedron_kind::polygon) << n << ' ' << length;
        expect_congruent(p, mesh, 1e-14 * length);
      }
}

// Rounded lengths belong to a polyhedron whose heights are rounding errors.
TEST(Convex_polyhedron, finds_polygons_from_lengths)
{
  CGAL::Random random(5);
  for(int n = 5; n < 25; ++n)
    for(double width : {1., 20.}) {
      std::vector<double> angle(static_cast<std::size_t>(n));
      for(double& a : angle)
        a = random.get_double(0, 2 * pi);
      std::sort(angle.begin(), angle.end());
      std::vector<Point> corner;
      for(double a : angle)
        corner.emplace_back(width * std::cos(a), std::sin(a), 0);
      const Mesh mesh = double_polygon(corner, 1);
      const Polyhedron p = polyhedron_of_lengths(with_random_flips(mesh, random));
      expect_congruent(p, mesh, 1e-8 * width);
      EXPECT_LE(p.max_edge_error(), 1e-9) << n << ' ' << width;
    }
}

// A flat apex of a bipyramid can have loops. It is removed by flips that lower its degree.
TEST(Convex_polyhedron, removes_flat_vertices_with_loops)
{
  CGAL::Random random(7);
  for(std::size_t n : {3, 4, 5, 6})
    for(double height : {0., 3e-8})
      for(int i = 0; i < 5; ++i) {
        Triangulation t = with_random_flips(bipyramid(n, height), random);
        if(i > 0)
          IT::make_Delaunay(t);
        const Polyhedron p = polyhedron_of_lengths(t);
        EXPECT_EQ(p.kind(), IT::Polyhedron_kind::polygon) << n << ' ' << height;
        EXPECT_EQ(p.flat_vertices().size(), 2u) << n << ' ' << height;
      }
}

TEST(Convex_polyhedron, corresponds_to_the_input)
{
  CGAL::Random random(3);
  const Mesh mesh = random_sphere(60, 5);
  const Triangulation t = with_random_flips(mesh, random);
  const Polyhedron p = polyhedron_of_lengths(t);
  for(Edge_index e : t.mesh().edges())
    EXPECT_EQ(p.triangulation().input_length(e), t.length(e));
  const IT::Correspondence<IT::Euclidean_geometry_traits<>> correspondence(p.triangulation());
  const IT::Common_subdivision<> subdivision(correspondence);
  EXPECT_GT(subdivision.mesh().number_of_faces(), t.mesh().number_of_faces());
  EXPECT_EQ(p.mesh().number_of_faces(), t.mesh().number_of_faces());
}

TEST(Convex_polyhedron, names_vertices_of_negative_curvature)
{
  Mesh mesh = gridded_cube(2);
  for(Vertex_index v : mesh.vertices())
    if(mesh.point(v) == Point(0.5, 0.5, 1))
      mesh.point(v) = Point(0.5, 0.5, 0.7);
  try {
    IT::convex_polyhedron(mesh);
    FAIL();
  } catch(const IT::Negative_curvature& e) {
    EXPECT_FALSE(e.vertices().empty());
    EXPECT_NE(std::string(e.what()).find("negative curvature"), std::string::npos);
  }
}

// A prism has a vertex on an edge that is convex by 1e-16, as lengths and their curvatures of 32
// digits know. Rounding of its position moves it inside.
TEST(Convex_polyhedron, may_be_convex_before_rounding_only)
{
  const Triangles triangles{{0, 4, 2}, {1, 3, 5}, {2, 4, 5}, {2, 5, 3}, {0, 2, 6},
                            {2, 3, 6}, {3, 1, 6}, {0, 6, 4}, {4, 6, 5}, {5, 6, 1}};
  const std::map<std::pair<std::size_t, std::size_t>, double> length{
    {{0, 2}, 0x1.4fb5ecee36d8ep+0}, {{1, 3}, 0x1.4fb5ecee36d8ep+0}, {{2, 3}, 0x1p+1},
    {{0, 4}, 0x1.4fb5ecee36d8ep+0}, {{2, 4}, 0x1.0abba0b01d3ecp+0}, {{1, 5}, 0x1.4fb5ecee36d8ep+0},
    {{2, 5}, 0x1.20a814ab49e34p+1}, {{3, 5}, 0x1.0abba0b01d3ecp+0}, {{4, 5}, 0x1p+1},
    {{0, 6}, 0x1.1bfea6a19fd5cp+0}, {{1, 6}, 0x1.c802b2bcc0547p-1}, {{2, 6}, 0x1.b7b899f1bebc7p+0},
    {{3, 6}, 0x1.95d157aaab5ddp+0}, {{4, 6}, 0x1.b7b899f1bebc7p+0}, {{5, 6}, 0x1.95d157aaab5ddp+0}};
  const Mesh mesh = make_mesh(std::vector<Point>(7, Point(0, 0, 0)), triangles);
  const auto of = [&](Edge_index e) {
    const std::size_t v = mesh.vertex(e, 0).idx(), w = mesh.vertex(e, 1).idx();
    return length.at(std::minmax(v, w));
  };
  const auto lengths = boost::make_function_property_map<Edge_index>(of);
  const Polyhedron p =
    IT::convex_polyhedron(mesh, IT::parameters::edge_length_map(lengths).curvature_tolerance(0));
  EXPECT_EQ(p.kind(), IT::Polyhedron_kind::convex_before_rounding);
  EXPECT_FALSE(p.certificate().is_convex());
  EXPECT_TRUE(p.flat_vertices().empty());
  EXPECT_LT(p.max_edge_error(), 1e-15);
  // Rounding of lengths may have caused this curvature, so the vertex is flat by default.
  const Polyhedron rounded = IT::convex_polyhedron(mesh, IT::parameters::edge_length_map(lengths));
  EXPECT_EQ(rounded.kind(), IT::Polyhedron_kind::convex);
  EXPECT_EQ(rounded.flat_vertices().size(), 1u);
}

TEST(Convex_polyhedron, refuses_what_is_no_sphere)
{
  EXPECT_THROW(IT::convex_polyhedron(square()), IT::Invalid_input);
}

TEST(Convex_polyhedron, takes_a_tolerance_of_curvature)
{
  Mesh mesh = gridded_cube(4);
  CGAL::Random random(4);
  for(Vertex_index v : mesh.vertices()) {
    Point& p = mesh.point(v);
    p = Point(std::round(1e6 * p.x() / 3) / 1e6, std::round(1e6 * p.y() / 3) / 1e6,
              std::round(1e6 * (p.z() + 0.3 * p.x() + 0.1 * p.y())) / 1e6);
  }
  EXPECT_THROW(IT::convex_polyhedron(mesh), IT::Negative_curvature);
  const Polyhedron p = IT::convex_polyhedron(mesh, IT::parameters::curvature_tolerance(1e-4));
  EXPECT_EQ(p.flat_vertices().size(), mesh.number_of_vertices() - 8);
  expect_congruent(p, mesh, 1e-4);
}

// ---- Nets ----

namespace {

// Returns the polyhedron of a polygon in the plane, cut into triangles, whose sides are glued by
// pairs of numbers. Side i leads from corner i to the next.
Polyhedron folded(const std::vector<Point>& corner, const Triangles& triangles,
                  const std::vector<std::pair<std::size_t, std::size_t>>& sides)
{
  Mesh net = make_mesh(corner, triangles);
  const auto length = net.add_property_map<Edge_index, double>("e:length").first;
  IT::compute_edge_lengths(net, length);
  const auto side = [&](std::size_t i) {
    return net.halfedge(Vertex_index(unsigned(i)), Vertex_index(unsigned((i + 1) % corner.size())));
  };
  std::vector<std::pair<Halfedge_index, Halfedge_index>> pairs;
  for(const auto& [i, j] : sides)
    pairs.emplace_back(side(i), side(j));
  IT::Glued_surface glued = IT::glue_boundary(net, length, pairs);
  return IT::convex_polyhedron(
    glued.mesh, IT::parameters::edge_length_map(IT::stored_length_map<double>(glued.mesh)));
}

const std::vector<Point> cross{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {3, 1, 0}, {3, 2, 0},
                               {2, 2, 0}, {2, 3, 0}, {2, 4, 0}, {1, 4, 0}, {1, 3, 0},
                               {1, 2, 0}, {0, 2, 0}, {0, 1, 0}, {1, 1, 0}};
const Triangles squares_of_cross{{0, 1, 2},  {0, 2, 13},  {2, 3, 4},    {2, 4, 5},
                                 {13, 2, 5}, {13, 5, 10}, {12, 13, 10}, {12, 10, 11},
                                 {10, 5, 6}, {10, 6, 9},  {9, 6, 7},    {9, 7, 8}};

// Returns all distances of the vertices, in increasing order.
std::vector<double> distances_of(const Polyhedron& p)
{
  std::vector<double> result;
  for(std::size_t i = 0; i < p.points().size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      result.push_back(std::sqrt(CGAL::squared_distance(p.points()[i], p.points()[j])));
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

TEST(Convex_polyhedron, cross_folds_to_a_cube)
{
  const Polyhedron p =
    folded(cross, squares_of_cross, {{1, 2}, {4, 5}, {9, 10}, {12, 13}, {0, 7}, {3, 6}, {11, 8}});
  EXPECT_TRUE(p.certificate().is_convex());
  const std::vector<double> distance = distances_of(p);
  ASSERT_EQ(distance.size(), 28);
  for(std::size_t i = 0; i < 28; ++i)
    EXPECT_NEAR(distance[i], std::sqrt(i < 12 ? 1. : i < 24 ? 2. : 3.), 1e-11);
}

TEST(Convex_polyhedron, closed_zipper_of_the_cross_is_convex)
{
  // Each side is glued to the side with the same distance from corner 0 in the other direction.
  std::vector<std::pair<std::size_t, std::size_t>> sides;
  for(std::size_t start = 0; start < 14; ++start) {
    sides.clear();
    for(std::size_t i = 0; i < 7; ++i)
      sides.emplace_back((start + i) % 14, (start + 13 - i) % 14);
    try {
      const Polyhedron p = folded(cross, squares_of_cross, sides);
      EXPECT_TRUE(p.certificate().is_convex()) << start;
      EXPECT_LT(p.max_edge_error(), 1e-9) << start;
    } catch(const IT::Negative_curvature&) {
    }
  }
}

TEST(Convex_polyhedron, triangle_folds_to_a_regular_tetrahedron)
{
  const double s = std::sqrt(3.) / 2;
  const Polyhedron p =
    folded({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1.5, s, 0}, {1, 2 * s, 0}, {0.5, s, 0}},
           {{0, 1, 5}, {1, 2, 3}, {1, 3, 5}, {5, 3, 4}}, {{0, 1}, {2, 3}, {4, 5}});
  const std::vector<double> distance = distances_of(p);
  ASSERT_EQ(distance.size(), 6);
  for(double d : distance)
    EXPECT_NEAR(d, 1, 1e-11);
}

// ---- Regular and Archimedean solids from nets ----

namespace {

typedef std::array<double, 3> Coordinates;

// The changes of signs of coordinates.
enum class Signs
{
  all,
  even
};

bool is_even(unsigned int signs) { return ((signs ^ signs >> 1 ^ signs >> 2) & 1u) == 0; }

// Adds the points of all signs, and of all even permutations or of all permutations, of `p`.
void add_orbit(const Coordinates& p, bool has_odd, Signs changes, std::set<Coordinates>& points)
{
  for(unsigned int signs = 0; signs < 8; ++signs)
    for(std::size_t shift = 0; shift < 3 && (changes == Signs::all || is_even(signs)); ++shift) {
      Coordinates q;
      for(std::size_t c = 0; c < 3; ++c)
        q[(c + shift) % 3] = (signs >> c & 1u ? -1 : 1) * p[c] + 0.; // no negative zero
      points.insert(q);
      if(has_odd)
        points.insert({q[1], q[0], q[2]});
    }
}

// Returns a solid as the hull of orbits of points.
Mesh solid(const std::vector<Coordinates>& orbits, bool has_odd, Signs changes = Signs::all)
{
  std::set<Coordinates> coordinates;
  for(const Coordinates& p : orbits)
    add_orbit(p, has_odd, changes, coordinates);
  std::vector<Point> points;
  for(const Coordinates& p : coordinates)
    points.emplace_back(p[0], p[1], p[2]);
  return convex_hull(points);
}

// The snub cube has half of the points of all permutations.
Mesh snub_cube()
{
  const double t = 1.8392867552141612;
  std::vector<Point> points;
  for(unsigned int signs = 0; signs < 8; ++signs) {
    const auto sign = [signs](unsigned int c) { return signs >> c & 1u ? -1. : 1.; };
    const double x = sign(0), y = sign(1) / t, z = sign(2) * t;
    if(is_even(signs))
      for(const Point& p : {Point(x, y, z), Point(y, z, x), Point(z, x, y)})
        points.push_back(p);
    else
      for(const Point& p : {Point(y, x, z), Point(x, z, y), Point(z, y, x)})
        points.push_back(p);
  }
  return convex_hull(points);
}

// The snub dodecahedron has points of an even number of positive signs. Here xi is the real root of
// xi^3 - 2 xi = phi.
Mesh snub_dodecahedron(double phi)
{
  const double xi = 1.7155614996973678, a = xi - 1 / xi, b = xi * phi + phi * phi + phi / xi,
               c = b / phi, d = a * phi, e = a / phi, f = b * phi;
  return solid({{-2 * a, -2, -2 * b},
                {-(a + c + phi), -(-d + b + 1 / phi), -(e + f - 1)},
                {-(a + c - phi), -(d - b + 1 / phi), -(e + f + 1)},
                {-(-e + f + 1), -(-a + c - phi), -(d + b - 1 / phi)},
                {-(-e + f - 1), -(a - c - phi), -(d + b + 1 / phi)}},
               false, Signs::even);
}

// Cuts the surface of a solid along all edges without a dual spanning tree, unfolds it, and folds
// it again.
Polyhedron folded_from_net(const Mesh& mesh)
{
  std::map<Halfedge_index, std::size_t> corner; // of the net, at the source
  std::vector<Point> points;
  Triangles triangles;
  std::set<Edge_index> is_joined;
  std::queue<Halfedge_index> next;
  const auto place = [&](Halfedge_index h, std::size_t from, std::size_t to) {
    const Halfedge_index n = mesh.next(h), p = mesh.prev(h);
    const auto length = [&](Halfedge_index x) {
      return std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.source(x)), mesh.point(mesh.target(x))));
    };
    const double c = length(h), a = length(n), b = length(p), x = (b * b + c * c - a * a) / (2 * c),
                 y = std::sqrt(b * b - x * x);
    typedef CGAL::Kernel_traits<Point>::Kernel::Vector_3 Vector;
    const Vector along = (points[to] - points[from]) / c;
    corner[h] = from;
    corner[n] = to;
    corner[p] = points.size();
    points.push_back(points[from] + x * along + y * Vector(-along.y(), along.x(), 0));
    triangles.push_back({from, to, corner[p]});
    for(Halfedge_index side : {h, n, p})
      next.push(mesh.opposite(side));
  };
  const Halfedge_index first = mesh.halfedge(*mesh.faces().begin());
  points = {Point(0, 0, 0), Point(std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(first)),
                                                                   mesh.point(mesh.target(first)))),
                                  0, 0)};
  for(place(first, 0, 1); !next.empty(); next.pop())
    if(const Halfedge_index h = next.front(); corner.count(h) == 0) {
      const Halfedge_index o = mesh.opposite(h);
      is_joined.insert(mesh.edge(h));
      place(h, corner[mesh.next(o)], corner[o]);
    }
  Mesh net = make_mesh(points, triangles);
  const auto length = net.add_property_map<Edge_index, double>("e:length").first;
  IT::compute_edge_lengths(net, length);
  const auto in_net = [&](Halfedge_index h) {
    return net.halfedge(Vertex_index(unsigned(corner[h])),
                        Vertex_index(unsigned(corner[mesh.next(h)])));
  };
  std::vector<std::pair<Halfedge_index, Halfedge_index>> pairs;
  for(Edge_index e : mesh.edges())
    if(is_joined.count(e) == 0)
      pairs.emplace_back(in_net(mesh.halfedge(e)), in_net(mesh.opposite(mesh.halfedge(e))));
  IT::Glued_surface glued = IT::glue_boundary(net, length, pairs);
  return IT::convex_polyhedron(
    glued.mesh, IT::parameters::edge_length_map(IT::stored_length_map<double>(glued.mesh)));
}

} // namespace

TEST(Convex_polyhedron, solids_fold_from_nets)
{
  const double root = std::sqrt(2.), phi = (1 + std::sqrt(5.)) / 2;
  const std::pair<Mesh, std::size_t> solids[] = {
    {tetrahedron(), 4},
    {octahedron(), 6},
    {solid({{1, 1, 1}}, false), 8},
    {solid({{0, 1, phi}}, false), 12},
    {solid({{1, 1, 1}, {0, 1 / phi, phi}}, false), 20},
    {solid({{0, 1, 1}}, true), 12},
    {solid({{root - 1, 1, 1}}, true), 24},
    {solid({{0, 1, 2}}, true), 24},
    {solid({{1, 1, 1 + root}}, true), 24},
    {solid({{1, 1 + root, 1 + 2 * root}}, true), 48},
    {snub_cube(), 24},
    {solid({{0, 0, 2 * phi}, {1, phi, phi * phi}}, false), 30},
    {solid({{0, 1, 3 * phi}, {1, 2 + phi, 2 * phi}, {phi, 2, 2 * phi + 1}}, false), 60},
    {solid({{0, 1 / phi, 2 + phi}, {1 / phi, phi, 2 * phi}, {phi, 2, phi + 1}}, false), 60},
    {solid({{1, 1, phi * phi * phi}, {phi * phi, phi, 2 * phi}, {2 + phi, 0, phi * phi}}, false),
     60},
    {solid({{1, 1, 3}}, true, Signs::even), 12},
    {solid({{1 / phi, 1 / phi, 3 + phi},
            {2 / phi, phi, 1 + 2 * phi},
            {1 / phi, phi * phi, 3 * phi - 1},
            {2 * phi - 1, 2, 2 + phi},
            {phi, 3, 2 * phi}},
           false),
     120},
    {snub_dodecahedron(phi), 60}};
  for(const auto& [mesh, n] : solids) {
    ASSERT_EQ(mesh.number_of_vertices(), n);
    const Polyhedron p = folded_from_net(mesh);
    EXPECT_EQ(p.kind(), IT::Polyhedron_kind::convex);
    std::vector<double> before;
    for(const Vertex_index v : mesh.vertices())
      for(const Vertex_index w : mesh.vertices())
        if(w < v)
          before.push_back(std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w))));
    std::sort(before.begin(), before.end());
    const std::vector<double> after = distances_of(p);
    ASSERT_EQ(after.size(), before.size());
    for(std::size_t i = 0; i < after.size(); ++i)
      EXPECT_NEAR(after[i], before[i], 1e-9) << n;
  }
}

TEST(Paired_sides, of_a_square)
{
  Mesh net = square();
  const auto length = net.add_property_map<Edge_index, double>("e:length", 1).first;
  const auto v = [](unsigned i) { return Vertex_index(i); };
  IT::Paired_sides torus(net, length), disk(net, length), wrong(net, length);
  EXPECT_THROW(wrong.add(v(0), v(2), v(0), v(3)), IT::Invalid_input); // not on the boundary
  EXPECT_THROW(wrong.add(v(0), v(1), v(2), v(3)), IT::Invalid_input); // not oriented
  torus.add(v(0), v(1), v(3), v(2));
  EXPECT_THROW(torus.complete_pairs(), IT::Invalid_input);
  torus.add(v(1), v(2), v(0), v(3));
  EXPECT_THROW(torus.add(v(0), v(1), v(0), v(3)), IT::Invalid_input); // twice
  EXPECT_EQ(IT::glue_boundary(net, length, torus.complete_pairs()).mesh.number_of_vertices(), 1);
  disk.add(v(0), v(1), v(0), v(3));
  disk.add(v(2), v(1), v(2), v(3));
  EXPECT_EQ(IT::glue_boundary(net, length, disk.complete_pairs()).mesh.number_of_vertices(), 3);
  length[net.edge(net.halfedge(v(0), v(1)))] = 1.1;
  EXPECT_THROW(IT::Paired_sides(net, length).add(v(0), v(1), v(0), v(3)), IT::Invalid_input);
}

TEST(Glue_boundary, refuses_sides_that_are_missing_or_glued_twice)
{
  Mesh net = square();
  const auto length = net.add_property_map<Edge_index, double>("e:length", 1).first;
  const auto side = [&](unsigned i) {
    return net.halfedge(Vertex_index(i), Vertex_index((i + 1) % 4));
  };
  EXPECT_THROW(IT::glue_boundary(net, length, {{side(0), side(1)}}), IT::Invalid_input);
  EXPECT_THROW(IT::glue_boundary(net, length, {{side(0), side(1)}, {side(1), side(2)}}),
               IT::Invalid_input);
  const IT::Glued_surface glued =
    IT::glue_boundary(net, length, {{side(0), side(1)}, {side(2), side(3)}});
  EXPECT_EQ(glued.mesh.number_of_vertices(), 3);
  EXPECT_EQ(glued.mesh.number_of_edges(), 3);
  EXPECT_TRUE(glued.mesh.is_valid());
}
