// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/pack_circles.h>
#include <CGAL/boost/graph/Euler_operations.h>

namespace Test_pack_circles {

using namespace Test_surfaces;
using DCM::Circle_packing;
using DCM::Spherical_circle;

Spherical_circle on_sphere(const Circle_packing& packing, std::size_t v)
{
  return packing.spherical_circle(Vertex_index(static_cast<Delta_complex::size_type>(v)));
}

double dot(const Spherical_circle& a, const Spherical_circle& b)
{
  return a.center[0] * b.center[0] + a.center[1] * b.center[1] + a.center[2] * b.center[2];
}

// Returns the distance from the chord of unit vectors.
double distance_of_centers(const Spherical_circle& a, const Spherical_circle& b)
{
  double square = 0;
  for(std::size_t c = 0; c < 3; ++c)
    square += (a.center[c] - b.center[c]) * (a.center[c] - b.center[c]);
  return 2 * std::asin((std::min)(1., std::sqrt(square) / 2));
}

template <typename Surface>
void check_tangencies(const Circle_packing& packing, const Surface& mesh)
{
  for(const auto e : mesh.edges()) {
    const auto a = on_sphere(packing, mesh.vertex(e, 0).idx()),
               b = on_sphere(packing, mesh.vertex(e, 1).idx());
    EXPECT_NEAR(distance_of_centers(a, b), a.angle + b.angle, 1e-10) << e;
  }
}

// Checks that interiors of circles that are not joined by an edge are disjoint.
template <typename Surface>
void check_disjoint(const Circle_packing& packing, const Surface& mesh)
{
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    for(std::size_t w = 0; w < v; ++w) {
      const auto a = on_sphere(packing, v), b = on_sphere(packing, w);
      EXPECT_GT(distance_of_centers(a, b), a.angle + b.angle - 1e-10) << v << ' ' << w;
    }
}

// Checks that faces have the orientation of the mesh, as seen from outside.
void check_orientation(const Circle_packing& packing, const Mesh& mesh)
{
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    const auto a = on_sphere(packing, mesh.source(h)).center,
               b = on_sphere(packing, mesh.target(h)).center,
               c = on_sphere(packing, mesh.target(mesh.next(h))).center;
    const double volume = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                          a[2] * (b[0] * c[1] - b[1] * c[0]);
    EXPECT_GT(volume, 0) << f;
  }
}

Mesh icosahedron()
{
  const double phi = (1 + std::sqrt(5.)) / 2;
  std::vector<Point> points;
  for(const double s : {-1., 1.})
    for(const double t : {-phi, phi}) {
      points.emplace_back(0, s, t);
      points.emplace_back(s, t, 0);
      points.emplace_back(t, 0, s);
    }
  Triangles triangles;
  const auto square = [&](std::size_t i, std::size_t j) {
    return CGAL::squared_distance(points[i], points[j]);
  };
  for(std::size_t i = 0; i < 12; ++i)
    for(std::size_t j = 0; j < 12; ++j)
      for(std::size_t k = 0; k < 12; ++k)
        if(i < j && i < k && j != k && square(i, j) < 4.5 && square(j, k) < 4.5 &&
           square(k, i) < 4.5 &&
           CGAL::orientation(Point(0, 0, 0), points[i], points[j], points[k]) == CGAL::POSITIVE)
          triangles.push_back({i, j, k});
  return make_mesh(points, triangles);
}

TEST(Pack_circles, of_Platonic_solids_are_regular)
{
  const std::pair<Mesh, double> solids[] = {{tetrahedron(), std::acos(1 / std::sqrt(3.))},
                                            {octahedron(), pi / 4},
                                            {icosahedron(), std::atan(2.) / 2}};
  for(const auto& [mesh, angle] : solids) {
    const Circle_packing packing = DCM::pack_circles(mesh);
    EXPECT_EQ(packing.status(), DCM::Map_status::success);
    EXPECT_FALSE(packing.is_disk());
    for(std::size_t v = 0; v < packing.size(); ++v)
      EXPECT_NEAR(on_sphere(packing, v).angle, angle, 1e-12) << v;
    check_tangencies(packing, mesh);
    check_orientation(packing, mesh);
  }
}

TEST(Pack_circles, touch_on_random_spheres)
{
  for(const auto& [n, seed] : {std::pair{10u, 1u}, {50u, 2u}, {200u, 3u}, {1000u, 4u}}) {
    Mesh mesh = random_sphere(n, seed);
    const Circle_packing packing = DCM::pack_circles(mesh);
    EXPECT_EQ(packing.status(), DCM::Map_status::success);
    EXPECT_LT(packing.max_tangency_error(), 1e-10);
    check_tangencies(packing, mesh);
    if(n <= 200)
      check_disjoint(packing, mesh);
  }
}

// Flips an edge unless that joins two vertices twice.
void flip(Mesh::Halfedge_index h, Mesh& mesh)
{
  const auto a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(mesh.opposite(h)));
  if(a != b && !mesh.halfedge(a, b).is_valid())
    CGAL::Euler::flip_edge(h, mesh);
}

TEST(Pack_circles, touch_after_random_flips)
{
  for(unsigned int seed = 0; seed < 10; ++seed) {
    Mesh mesh = random_sphere(300, seed);
    CGAL::Random random(seed);
    for(int i = 0; i < 10000; ++i) {
      const Mesh::Halfedge_index h(
        static_cast<Mesh::size_type>(random.get_int(0, int(mesh.number_of_halfedges()))));
      flip(h, mesh);
    }
    const Circle_packing packing = DCM::pack_circles(mesh);
    EXPECT_EQ(packing.status(), DCM::Map_status::success) << seed;
    check_tangencies(packing, mesh);
  }
}

// Vertices in random faces let circles shrink fast. With flips of some edges they shrink less.
TEST(Pack_circles, touch_in_nested_triangulations)
{
  for(unsigned int seed = 0; seed < 12; ++seed) {
    CGAL::Random random(seed);
    Mesh mesh = tetrahedron();
    const auto edge = [&] {
      return Mesh::Halfedge_index(
        static_cast<Mesh::size_type>(random.get_int(0, int(mesh.number_of_halfedges()))));
    };
    while(mesh.number_of_vertices() < 8u << seed % 6u)
      CGAL::Euler::add_center_vertex(edge(), mesh);
    for(std::size_t i = 0; i < (seed % 3) * mesh.number_of_edges(); ++i)
      flip(edge(), mesh);
    const Circle_packing packing = DCM::pack_circles(mesh);
    EXPECT_EQ(packing.status(), DCM::Map_status::success) << seed;
    check_tangencies(packing, mesh);
    check_disjoint(packing, mesh);
  }
}

// Circles are up to a billion times smaller than others.
TEST(Pack_circles, touch_in_a_nested_triangulation_of_ten_thousand_vertices)
{
  CGAL::Random random(1);
  Mesh mesh = tetrahedron();
  while(mesh.number_of_vertices() < 10000)
    CGAL::Euler::add_center_vertex(Mesh::Halfedge_index(static_cast<Mesh::size_type>(
                                     random.get_int(0, int(mesh.number_of_halfedges())))),
                                   mesh);
  const Circle_packing packing = DCM::pack_circles(mesh);
  EXPECT_EQ(packing.status(), DCM::Map_status::success);
  check_tangencies(packing, mesh);
}

// Circles touch in points that are in balance.
TEST(Pack_circles, are_centered)
{
  const Mesh mesh = random_sphere(100, 6);
  const Circle_packing packing = DCM::pack_circles(mesh);
  std::array<double, 3> sum{0, 0, 0};
  for(const auto e : mesh.edges()) {
    const auto a = on_sphere(packing, mesh.vertex(e, 0)), b = on_sphere(packing, mesh.vertex(e, 1));
    const double angle = a.angle + b.angle;
    for(std::size_t c = 0; c < 3; ++c)
      sum[c] +=
        (std::sin(b.angle) * a.center[c] + std::sin(a.angle) * b.center[c]) / std::sin(angle);
  }
  for(const double s : sum)
    EXPECT_NEAR(s, 0, 1e-9);
}

TEST(Pack_circles, of_disks_touch_the_unit_circle)
{
  for(const Mesh& mesh :
      {punctured(random_sphere(200, 7), {3}), punctured(tetrahedron(), {0}), square(),
       grid(9, 7, [](double x, double y) { return Point(x, y, 0); })}) {
    const Circle_packing packing = DCM::pack_circles(mesh);
    EXPECT_EQ(packing.status(), DCM::Map_status::success);
    EXPECT_TRUE(packing.is_disk());
    ASSERT_EQ(packing.size(), mesh.number_of_vertices());
    for(const auto e : mesh.edges()) {
      const auto &a = packing.circle(mesh.vertex(e, 0)), &b = packing.circle(mesh.vertex(e, 1));
      EXPECT_NEAR(std::abs(a.center - b.center), a.radius + b.radius, 1e-10);
    }
    for(const auto v : mesh.vertices()) {
      const auto& c = packing.circle(v);
      if(mesh.is_border(v))
        EXPECT_NEAR(std::abs(c.center) + c.radius, 1, 1e-10);
      else
        EXPECT_LT(std::abs(c.center) + c.radius, 1 - 1e-10);
    }
    check_disjoint(packing, mesh);
  }
}

// Centers and radii of a packing have rounding errors, with which circles overlap. They count as
// touching, so that the packing is the image of itself.
TEST(Pack_circles, of_disks_are_kept_by_maps_with_circles)
{
  for(const unsigned int seed : {1u, 2u, 3u, 4u}) {
    Mesh mesh = punctured(random_sphere(50 * seed, seed), {3});
    const Circle_packing packing = DCM::pack_circles(mesh);
    double greatest_overlap = 0;
    for(const auto v : mesh.vertices()) {
      const std::complex<double> z = packing.circle(v).center;
      mesh.point(v) = Point(z.real(), z.imag(), 0);
    }
    for(const auto e : mesh.edges()) {
      const auto &a = packing.circle(mesh.vertex(e, 0)), &b = packing.circle(mesh.vertex(e, 1));
      const double length = std::abs(a.center - b.center);
      greatest_overlap = (std::max)(greatest_overlap, (a.radius + b.radius) / length - 1);
    }
    EXPECT_GT(greatest_overlap, 1e-14); // which exceeds rounding errors of lengths
    const auto flattened = [&](double factor) {
      return DCM::flatten(
        mesh, DCM::parameters::vertex_radius_map(boost::make_function_property_map<Vertex_index>(
                [&](auto v) { return factor * packing.circle(v).radius; })));
    };
    const DCM::Planar_conformal_map map = flattened(1);
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    const auto& ideal = map.ideal();
    for(const Edge_index e : ideal.mesh().edges()) {
      const double r = ideal.traits().radius(ideal.mesh().vertex(e, 0)),
                   s = ideal.traits().radius(ideal.mesh().vertex(e, 1)), t = ideal.length(e);
      EXPECT_LT(t * t / (2 * r * s), 1e-8); // the difference of the inversive distance from one
    }
    for(const auto v : mesh.vertices())
      EXPECT_NEAR(map.log_scale(v), 0, 1e-8);
    EXPECT_THROW(flattened(1 + 1e-7), IT::Invalid_input);
  }
}

// ---- Pieces of the hexagonal packing ----

struct Hexagonal_piece
{
  std::vector<std::array<int, 2>> place; // in the lattice with the basis 1 and e^(i pi/3)
  Mesh mesh;
};

Hexagonal_piece hexagonal_piece(int radius)
{
  Hexagonal_piece result;
  std::map<std::array<int, 2>, std::size_t> index;
  std::vector<Point> points;
  for(int j = -radius; j <= radius; ++j)
    for(int i = -radius; i <= radius; ++i)
      if(std::abs(i + j) <= radius) {
        index[{i, j}] = points.size();
        points.emplace_back(2 * i + j, std::sqrt(3.) * j, 0);
        result.place.push_back({i, j});
      }
  Triangles triangles;
  const auto add = [&](std::array<int, 2> a, std::array<int, 2> b, std::array<int, 2> c) {
    if(index.count(a) && index.count(b) && index.count(c))
      triangles.push_back({index[a], index[b], index[c]});
  };
  for(const auto& [i, j] : result.place) {
    add({i, j}, {i + 1, j}, {i, j + 1});
    add({i, j}, {i, j + 1}, {i - 1, j + 1});
  }
  result.mesh = make_mesh(points, triangles);
  return result;
}

// Doyle's spirals have the radii a^i b^j of a hexagonal packing. They close up around each vertex,
// for all a and b. The hexagonal packing with equal radii is the case of 1.
TEST(Pack_circles, of_hexagonal_pieces_are_spirals)
{
  const Hexagonal_piece piece = hexagonal_piece(6);
  for(const auto& [a, b] : {std::pair{1., 1.}, {1.1, 1.}, {1.2, 0.9}, {0.8, 1.3}}) {
    const auto log_radius = [&, a = a, b = b](std::size_t v) {
      return piece.place[v][0] * std::log(a) + piece.place[v][1] * std::log(b);
    };
    Conditions condition(piece.place.size());
    for(const auto v : piece.mesh.vertices())
      if(piece.mesh.is_border(v))
        condition[v] = Vertex_condition::log_scale(log_radius(v));
    const Planar_conformal_map map =
      DCM::flatten(piece.mesh, DCM::parameters::vertex_condition_map(as_map(condition))
                                 .vertex_radius_map(boost::make_function_property_map<Vertex_index>(
                                   [](Vertex_index) { return 1.; })));
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    for(std::size_t v = 0; v < piece.place.size(); ++v)
      EXPECT_NEAR(log_scale(map, v), log_radius(v), 1e-12) << a << ' ' << b;
    const Delta_complex& mesh = mesh_C(map);
    for(Halfedge_index h : mesh.halfedges())
      if(map.is_laid_out(mesh.face(h))) {
        EXPECT_NEAR(std::abs(map.position(mesh.next(h)) - map.position(h)) /
                      (map.scaled_radius(mesh.source(h)) + map.scaled_radius(mesh.target(h))),
                    1, 1e-10);
      }
  }
}

// A triangle is in a triangle, and so on: circles shrink by a constant factor. Beyond the digits of
// positions the result has a status, and no exception is thrown.
TEST(Pack_circles, of_nested_triangles_end_with_a_status)
{
  for(const std::size_t n : {30u, 60u, 200u, 400u}) {
    std::vector<Point> points(n + 4);
    std::vector<std::array<std::size_t, 3>> faces{{0, 2, 1}, {1, 2, 3}, {2, 0, 3}};
    std::array<std::size_t, 3> last{0, 1, 3};
    for(std::size_t v = 4; v < n + 4; ++v) {
      const auto [a, b, c] = last;
      const std::array<std::array<std::size_t, 3>, 3> parts{{{a, b, v}, {b, c, v}, {c, a, v}}};
      last = parts[v % 3];
      faces.push_back(parts[(v + 1) % 3]);
      faces.push_back(parts[(v + 2) % 3]);
    }
    faces.push_back(last);
    Mesh mesh;
    for(std::size_t v = 0; v < n + 4; ++v)
      mesh.add_vertex(Point(double(v), double(v * v % 53), double(v * 7 % 31)));
    for(const auto& [a, b, c] : faces)
      mesh.add_face(Mesh::Vertex_index(unsigned(a)), Mesh::Vertex_index(unsigned(b)),
                    Mesh::Vertex_index(unsigned(c)));
    const Circle_packing packing = DCM::pack_circles(mesh);
    EXPECT_EQ(packing.status() == DCM::Map_status::success, packing.max_tangency_error() < 1e-10);
    if(n <= 60) {
      EXPECT_EQ(packing.status(), DCM::Map_status::success);
      check_tangencies(packing, mesh);
    }
  }
}

// Returns rings of `n` vertices, closed by two apices.
Mesh tube(std::size_t n, std::size_t rings)
{
  std::vector<Point> points;
  Triangles triangles;
  const std::size_t below = n * rings, above = below + 1;
  const auto at = [&](std::size_t i, std::size_t j) { return i * n + j % n; };
  for(std::size_t i = 0; i < rings; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const double t = 2 * pi * double(j) / double(n);
      points.emplace_back(std::cos(t), std::sin(t), double(i));
      triangles.push_back(i == 0 ? std::array{below, at(0, j + 1), at(0, j)}
                                 : std::array{at(i - 1, j), at(i - 1, j + 1), at(i, j + 1)});
      triangles.push_back(i + 1 == rings ? std::array{above, at(i, j), at(i, j + 1)}
                                         : std::array{at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  points.emplace_back(0, 0, -1);
  points.emplace_back(0, 0, double(rings));
  return make_mesh(points, triangles);
}

// Circles shrink by 100 decimal digits and more. Angles around a vertex, of triangles on the sphere
// with sums of angular radii as sides, add up to 2 pi. This holds even around the smallest circles.
TEST(Pack_circles, of_long_tubes_have_circles_below_rounding)
{
  for(const auto& [n, rings] : {std::pair{3u, 30u}, {3u, 100u}, {3u, 300u}, {10u, 100u}}) {
    const Mesh mesh = tube(n, rings);
    const Circle_packing packing = DCM::pack_circles(mesh);
    EXPECT_EQ(packing.status(), DCM::Map_status::success) << n << ' ' << rings;
    check_tangencies(packing, mesh);
    double least = 1;
    for(Vertex_index v : mesh.vertices()) {
      const auto angle = [&](Mesh::Vertex_index w) { return packing.spherical_circle(w).angle; };
      double sum = 0;
      for(const auto h : mesh.halfedges_around_target(mesh.halfedge(v))) {
        const double a = angle(v), b = angle(mesh.source(h)), c = angle(mesh.target(mesh.next(h)));
        sum += 2 * std::atan(std::sqrt(std::sin(b) / std::sin(a + b + c)) *
                             std::sqrt(std::sin(c) / std::sin(a)));
      }
      EXPECT_NEAR(sum, 2 * pi, 1e-8) << v;
      least = (std::min)(least, angle(v));
    }
    EXPECT_LT(least, n == 3 ? 1e-14 : 1e-12);
  }
}

// Circles are beyond the range of `double`.
TEST(Pack_circles, of_endless_tubes_end_with_a_status)
{
  const Circle_packing packing = DCM::pack_circles(tube(3, 1000));
  EXPECT_NE(packing.status(), DCM::Map_status::success);
  for(unsigned v = 0; v < packing.size(); ++v)
    EXPECT_FALSE(std::isnan(packing.circle(Vertex_index(v)).radius));
}

TEST(Pack_circles, refuse_other_surfaces)
{
  EXPECT_THROW(DCM::pack_circles(embedded_torus(4, 4)), IT::Invalid_input);
  EXPECT_THROW(DCM::pack_circles(four_components()), IT::Invalid_input);
  EXPECT_THROW(DCM::pack_circles(punctured(random_sphere(40, 6), {0, 20})), IT::Invalid_input);
  EXPECT_THROW(DCM::pack_circles(glue({{1, 2, 3}, {-3, -2, -1}})), IT::Invalid_input);
}

} // namespace Test_pack_circles
