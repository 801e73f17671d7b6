// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/more_generators.h"
#include "../Intrinsic_triangulations/near_degenerate_meshes.h"
#include "circles.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/internal/circles/Spherical_circle_triangle.h>
#include <CGAL/Discrete_conformal_maps/pack_circles.h>
#include <CGAL/Discrete_conformal_maps/uniformize.h>

namespace Test_circles_on_sphere {

using namespace Test_circles;
using DCM::Spherical_conformal_map;
using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector difference(const Vector& a, const Vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double volume(const Vector& a, const Vector& b, const Vector& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// ---- Triangles ----

// Rounding of differences has no influence.
using Number = long double;
using Numbers = std::array<Number, 3>;
using Edge = IT::Decorated_length<Number>;
using Triangle = DCM::internal::Spherical_circle_triangle<Number>;

// Returns the sides of a triangle with circles after scaling, for variables w.
std::array<Edge, 3> sides_for(const Numbers& tangent, const Numbers& radius, const Numbers& w)
{
  // From tan R = r e^u and dw = cos R du follows dw = dR / sin R, hence tan(R/2) grows by e^w.
  Numbers factor, scaled;
  for(std::size_t i = 0; i < 3; ++i) {
    scaled[i] = std::tan(2 * std::atan(std::tan(std::atan(radius[i]) / 2) * std::exp(w[i])));
    factor[i] = radius[i] > 0 ? scaled[i] / radius[i] : std::exp(w[i]);
  }
  std::array<Edge, 3> result;
  for(std::size_t s = 0; s < 3; ++s)
    result[s] = {tangent[s] * std::sqrt(factor[s] * factor[(s + 1) % 3]), scaled[s],
                 scaled[(s + 1) % 3]};
  return result;
}

Triangle triangle_of(const std::array<Edge, 3>& side)
{
  Numbers length, depth;
  for(std::size_t s = 0; s < 3; ++s) {
    length[s] = side[s].spherical_length() / 2;
    depth[s] = Triangle::depth(side[s].source_radius);
  }
  return {length, depth};
}

// Returns the angle at the source of side s, by the law of cosines for the cosines of the sides.
Number angle(const std::array<Edge, 3>& side, std::size_t s)
{
  const auto cosine = [](const Edge& e) {
    return (1 - e.gram()) / std::sqrt((1 + e.source_radius * e.source_radius) *
                                      (1 + e.target_radius * e.target_radius));
  };
  const Number a = cosine(side[(s + 1) % 3]), b = cosine(side[(s + 2) % 3]), c = cosine(side[s]);
  return std::acos((a - b * c) / std::sqrt((1 - b * b) * (1 - c * c)));
}

TEST(Spherical_circle_triangles, have_angles_and_symmetric_derivatives)
{
  for(unsigned int seed = 0; seed < 50; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.2, 0.6);
    Numbers tangent, radius;
    for(std::size_t i = 0; i < 3; ++i) {
      tangent[i] = uniform(random);
      radius[i] = (seed + i) % 3 == 0 ? 0 : uniform(random) / 2;
    }
    const std::array<Edge, 3> side = sides_for(tangent, radius, {0, 0, 0});
    const Triangle triangle = triangle_of(side);
    if(!triangle.exists())
      continue;
    for(std::size_t s = 0; s < 3; ++s) {
      EXPECT_NEAR(double(triangle.corner(s).angle() - angle(side, s)), 0, 1e-14);
      EXPECT_NEAR(double(std::cos(2 * std::asin(triangle.length(s))) - triangle.cosine_of_side(s)),
                  0, 1e-14);
    }
    // The derivatives by the variable at corner j.
    for(std::size_t j = 0; j < 3; ++j) {
      const Number h = 1e-7L;
      Numbers w{0, 0, 0};
      w[j] = h;
      const auto after = sides_for(tangent, radius, w);
      w[j] = -h;
      const auto before = sides_for(tangent, radius, w);
      const auto slope = [&](std::size_t s) {
        return (angle(after, s) - angle(before, s)) / (2 * h);
      };
      const std::size_t k = (j + 1) % 3, i = (j + 2) % 3;
      const Number own = -triangle.cosine_of_side(j) * triangle.derivative(j) -
                         triangle.cosine_of_side(i) * triangle.derivative(i);
      EXPECT_NEAR(double(triangle.derivative(j) - slope(k)), 0, 1e-8) << seed;
      EXPECT_NEAR(double(triangle.derivative(i) - slope(i)), 0, 1e-8) << seed;
      EXPECT_NEAR(double(own - slope(j)), 0, 1e-8) << seed;
    }
  }
}

// ---- Maps ----

Spherical_conformal_map decorated(const Triangulation& t, const Radii& radii)
{
  const std::vector<double> length = lengths_of(t);
  return DCM::map_to_sphere(t.mesh(), length_parameter(length).vertex_radius_map(as_radii(radii)));
}

// Returns (cos R cos S - cos d) / (sin R sin S) for the distance d of centers.
double inversive_distance(double r, double s, const Vector& p, const Vector& q)
{
  const Vector d = difference(p, q);
  return (dot(d, d) / 2 - 2 * std::pow(std::sin((r - s) / 2), 2)) / (std::sin(r) * std::sin(s)) - 1;
}

double inversive_distance(const Spherical_conformal_map& map, Vertex_index v, Vertex_index w)
{
  return inversive_distance(map.circle_radius(v), map.circle_radius(w), map.position(v),
                            map.position(w));
}

// Checks that edges of the input that have not been flipped have the inversive distances of the
// input. Returns their number.
std::size_t check_inversive_distances(const Spherical_conformal_map& map, const Radii& radii)
{
  const Delta_complex& mesh = map.ideal().mesh();
  std::size_t result = 0;
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e);
    if(!map.ideal().coordinates().is_shared(e))
      continue;
    const Edge_index b = Edge_index(map.ideal().input_halfedge(h));
    const Vertex_index v = mesh.source(h), w = mesh.target(h);
    const double r = radii[map.input_vertex(v)], s = radii[map.input_vertex(w)];
    if(r * s == 0 || !map.Delaunay().coordinates().is_shared(b))
      continue;
    const double length = map.Delaunay().length(b),
                 before = (length * length - r * r - s * s) / (2 * r * s);
    EXPECT_NEAR(inversive_distance(map, v, w) / before, 1, 1e-9) << e;
    ++result;
  }
  return result;
}

// Returns the vertices of the polyhedron: the poles of the circles.
std::vector<Vector> poles(const Spherical_conformal_map& map)
{
  std::vector<Vector> result;
  for(Vertex_index v : map.ideal().mesh().vertices()) {
    result.push_back(map.position(v));
    for(double& x : result.back())
      x /= std::cos(map.circle_radius(v));
  }
  return result;
}

// Checks that T_3 is the boundary of the convex hull of the poles, and that angles of spherical
// triangles add up to 2 pi.
void check_polyhedron(const Spherical_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  const std::vector<Vector> pole = poles(map);
  std::vector<double> sum(pole.size(), 0);
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    const Vector &a = pole[mesh.source(h)], &b = pole[mesh.target(h)],
                 &c = pole[mesh.source(mesh.prev(h))];
    EXPECT_GT(volume(a, b, c), 0) << f;
    for(const Vector& p : pole)
      EXPECT_LT(volume(difference(b, a), difference(c, a), difference(p, a)), 1e-10) << f;
    for(Halfedge_index g : {h, mesh.next(h), mesh.prev(h)}) {
      const Vector &p = map.position(mesh.source(g)), &q = map.position(mesh.target(g)),
                   &r = map.position(mesh.source(mesh.prev(g)));
      sum[mesh.source(g)] += std::atan2(volume(p, q, r), dot(q, r) - dot(p, q) * dot(p, r));
    }
  }
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v)) {
      EXPECT_NEAR(sum[v], 2 * pi, 1e-9) << v;
    }
}

// Checks that the map is projective on each face of the subdivision, and continuous across edges.
void check_continuity(const Spherical_conformal_map& map)
{
  const auto& subdivision = map.subdivision();
  const auto& mesh = subdivision.mesh();
  const auto image = [&](Halfedge_index h) {
    return map.image(map.homogeneous_coordinates(subdivision.location(DCM::Layer::C, h)));
  };
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
    if(mesh.is_border(h) || mesh.is_border(o))
      continue;
    const Vector d = difference(image(h), image(mesh.prev(o)));
    EXPECT_LT(dot(d, d), 1e-20) << e;
  }
}

void check(const Spherical_conformal_map& map)
{
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  EXPECT_LT(map.max_curvature_error(), 1e-10);
  EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-9);
  EXPECT_TRUE(map.certificate().is_convex());
  EXPECT_TRUE(map.ideal().is_valid());
  EXPECT_EQ(map.lost_in_output(), 0u);
  check_polyhedron(map);
  check_continuity(map);
}

TEST(Circles_on_the_sphere, have_the_inversive_distances)
{
  std::size_t distances = 0, flips = 0;
  for(const double part : {0.3, 1.})
    for(const Mesh& mesh :
        {octahedron(), cube(), random_sphere(150, 3), perturbed(bipyramid(9, 1.5), 0.2, 5)}) {
      const Triangulation t(mesh);
      const Radii radii = random_radii(t, part, 7);
      const Spherical_conformal_map map = decorated(t, radii);
      check(map);
      distances += check_inversive_distances(map, radii);
      flips += map.number_of_flips(DCM::Layer::B) + map.number_of_flips(DCM::Layer::C);
      // The center of mass is the center of the sphere.
      Vector sum{0, 0, 0};
      for(Face_index f : mesh.faces())
        for(const auto v : vertices_around_face(mesh.halfedge(f), mesh))
          for(std::size_t i = 0; i < 3; ++i)
            sum[i] +=
              polygon_area(Face_index(f.idx()), mesh) * map.position(Vertex_index(v.idx()))[i];
      EXPECT_LT(dot(sum, sum), 1e-20);
    }
  EXPECT_GT(distances, 200u);
  EXPECT_GT(flips, 0u);
}

TEST(Circles_on_the_sphere, of_regular_solids_are_equal)
{
  for(const auto& [mesh, angle] :
      {std::pair{tetrahedron(), std::acos(-1 / 3.)}, {octahedron(), pi / 2}}) {
    const Triangulation t(mesh);
    const std::size_t n = mesh.number_of_vertices();
    const double length = t.length(Edge_index(0));
    for(const double part : {0.1, 0.3, 0.5}) {
      const Spherical_conformal_map map = decorated(t, Radii(n, part * length));
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      // The inversive distance I = (cos^2 R - cos angle) / sin^2 R determines R.
      const double I = (1 - 2 * part * part) / (2 * part * part),
                   sine = std::sqrt((1 - std::cos(angle)) / (1 + I));
      for(Vertex_index v : t.mesh().vertices())
        EXPECT_NEAR(map.circle_radius(v), std::asin(sine), 1e-12);
    }
  }
}

// Inversive distances of all pairs of circles determine them up to Moebius transformations.
TEST(Circles_on_the_sphere, that_touch_are_the_packing)
{
  for(const Mesh& mesh : {octahedron(), random_sphere(40, 1), random_sphere(40, 2)}) {
    const std::size_t n = mesh.number_of_vertices();
    const std::vector<double> length(mesh.number_of_edges(), 2.);
    const Triangulation t(mesh);
    const Spherical_conformal_map map = DCM::map_to_sphere(
      t.mesh(), length_parameter(length).vertex_radius_map(as_radii(Radii(n, 1.))));
    check(map);
    const DCM::Circle_packing packing = DCM::pack_circles(t.mesh());
    EXPECT_EQ(packing.status(), DCM::Map_status::success);
    for(Vertex_index v : t.mesh().vertices())
      for(Vertex_index w : t.mesh().vertices())
        if(v != w) {
          const auto a = packing.spherical_circle(v), b = packing.spherical_circle(w);
          const double I = inversive_distance(a.angle, b.angle, a.center, b.center);
          EXPECT_NEAR(inversive_distance(map, v, w) / I, 1, 1e-8) << v << ' ' << w;
        }
  }
}

// Checks that the circles at the ends of each edge of the input touch.
void check_tangency(const Spherical_conformal_map& map, const Delta_complex& mesh)
{
  for(Edge_index e : mesh.edges()) {
    const Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    const Vector d = difference(map.position(v), map.position(w));
    EXPECT_NEAR(2 * std::asin(std::sqrt(dot(d, d)) / 2),
                map.circle_radius(v) + map.circle_radius(w), 1e-9)
      << e;
  }
}

// All edges of such a tetrahedron are weighted Delaunay. Without circles, some are not Delaunay.
TEST(Circles_on_the_sphere, that_touch_are_the_packing_of_a_tetrahedron)
{
  const Triangulation t(tetrahedron());
  std::vector<Radii> cases{{0.2426, 0.4372, 15.73, 2.833}}; // leads along a path of many steps
  std::mt19937 random(1);
  for(int i = 0; i < 100; ++i) {
    cases.emplace_back();
    for(std::size_t v = 0; v < 4; ++v)
      cases.back().push_back(std::exp(std::uniform_real_distribution<double>(-2, 2)(random)));
  }
  for(const Radii& radii : cases) {
    std::vector<double> length;
    for(Edge_index e : t.mesh().edges())
      length.push_back(radii[t.mesh().vertex(e, 0)] + radii[t.mesh().vertex(e, 1)]);
    const Spherical_conformal_map map =
      DCM::map_to_sphere(t.mesh(), length_parameter(length).vertex_radius_map(as_radii(radii)));
    ASSERT_EQ(map.status(), DCM::Map_status::success) << map.cause();
    check(map);
    check_tangency(map, t.mesh());
  }
}

// Three circles on the equator touch each other and the circle between them. Without circles,
// their common edges are no Delaunay edges of the double.
TEST(Circles_of_a_disk, that_touch_form_a_wheel)
{
  const double circumradius = 2 / std::sqrt(3.);
  std::vector<Point> points{Point(0, 0, 0)};
  for(int i = 0; i < 3; ++i)
    points.emplace_back(circumradius * std::cos(2 * pi * i / 3),
                        circumradius * std::sin(2 * pi * i / 3), 0);
  const Triangulation t(make_mesh(points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}));
  const Spherical_conformal_map map = decorated(t, {circumradius - 1, 1, 1, 1});
  ASSERT_EQ(map.status(), DCM::Map_status::success) << map.cause();
  check(map);
  EXPECT_NEAR(map.circle_radius(Vertex_index(0)), pi / 6, 1e-12);
  EXPECT_NEAR(map.position(Vertex_index(0))[2], 1, 1e-12);
  for(unsigned int v = 1; v < 4; ++v) {
    EXPECT_NEAR(map.circle_radius(Vertex_index(v)), pi / 3, 1e-12);
    EXPECT_NEAR(map.position(Vertex_index(v))[2], 0, 1e-15);
  }
}

// The circles of a packing in the plane touch on the sphere, too.
TEST(Circles_of_a_disk, that_are_packed_touch)
{
  for(unsigned int seed = 1; seed <= 30; ++seed) {
    Mesh mesh = punctured(random_sphere(8 + seed / 2, seed), {0});
    const DCM::Circle_packing packing = DCM::pack_circles(mesh);
    ASSERT_EQ(packing.status(), DCM::Map_status::success);
    Radii radii;
    for(const auto v : mesh.vertices()) {
      const auto circle = packing.circle(Vertex_index(v.idx()));
      radii.push_back(circle.radius);
      mesh.point(v) = Point(circle.center.real(), circle.center.imag(), 0);
    }
    const Triangulation t(mesh);
    const Spherical_conformal_map map = decorated(t, radii);
    ASSERT_EQ(map.status(), DCM::Map_status::success) << seed << ' ' << map.cause();
    check_tangency(map, t.mesh());
  }
}

TEST(Circles_of_a_disk, lie_on_a_hemisphere_if_they_touch)
{
  for(const std::size_t n : {2, 4, 6}) {
    const Triangulation t(grid(n, n, [](double x, double y) { return Point(x, y, 0); }));
    const Spherical_conformal_map map = decorated(t, Radii(t.mesh().num_vertices(), 0.5));
    ASSERT_EQ(map.status(), DCM::Map_status::success) << map.cause();
    for(Vertex_index v : t.mesh().vertices())
      if(t.mesh().is_border(v)) {
        EXPECT_NEAR(map.position(v)[2], 0, 1e-15);
      }
  }
}

TEST(Circles_on_the_sphere, are_near_points_if_they_are_small)
{
  const Triangulation t(random_sphere(60, 5));
  const Spherical_conformal_map none =
    DCM::map_to_sphere(t.mesh(), length_parameter(lengths_of(t)));
  double before = 0;
  for(const double part : {1e-1, 1e-2, 1e-3}) {
    const Spherical_conformal_map map = decorated(t, random_radii(t, part, 11));
    double difference = 0;
    for(Vertex_index v : t.mesh().vertices())
      difference = (std::max)(difference, std::abs(map.log_scale(v) - none.log_scale(v)));
    if(before > 0) {
      EXPECT_NEAR(difference / before, 0.01, 0.002); // of second order
    }
    before = difference;
  }
}

TEST(Circles_on_the_sphere, with_radii_of_zero_are_none)
{
  const Triangulation t(random_sphere(60, 5));
  const Spherical_conformal_map none =
                                  DCM::map_to_sphere(t.mesh(), length_parameter(lengths_of(t))),
                                zero = decorated(t, Radii(60, 0.));
  EXPECT_FALSE(zero.has_radii());
  for(Vertex_index v : t.mesh().vertices()) {
    EXPECT_EQ(none.log_scale(v), zero.log_scale(v));
    EXPECT_EQ(none.position(v), zero.position(v));
    EXPECT_EQ(zero.circle_radius(v), 0);
  }
}

TEST(Circles_of_a_disk, lie_on_a_hemisphere)
{
  for(const double part : {0.1, 0.2})
    for(const Mesh& mesh :
        {punctured(random_sphere(100, 3), {0}),
         perturbed(grid(6, 5, [](double x, double y) { return Point(x, y, 0); }), 0.02, 3)}) {
      const Triangulation t(mesh);
      const Radii radii = random_radii(t, part, 7);
      const Spherical_conformal_map map = decorated(t, radii);
      EXPECT_TRUE(map.is_disk());
      check(map);
      EXPECT_GT(check_inversive_distances(map, radii), 20u);
      for(Vertex_index v : t.mesh().vertices()) {
        if(t.mesh().is_border(v)) {
          EXPECT_NEAR(map.position(v)[2], 0, 1e-15);
        } else {
          EXPECT_GT(map.position(v)[2], 0);
        }
      }
    }
}

// The double of a disk is a sphere.
TEST(Circles_of_a_disk, are_half_of_a_sphere)
{
  const Mesh disk = punctured(random_sphere(40, 3), {0});
  const Triangulation half(disk);
  const Radii radii = random_radii(half, 0.15, 7);
  const Spherical_conformal_map map = decorated(half, radii);
  ASSERT_EQ(map.status(), DCM::Map_status::success);
  const Delta_complex& whole = map.Delaunay().input_mesh();
  Radii all;
  for(Vertex_index v : whole.vertices())
    all.push_back(radii[map.input_vertex(v)]);
  std::vector<double> length;
  for(Edge_index e : whole.edges())
    length.push_back(map.Delaunay().input_length(e));
  const Spherical_conformal_map sphere =
    DCM::map_to_sphere(whole, length_parameter(length).vertex_radius_map(as_radii(all)));
  check(sphere);
  EXPECT_FALSE(sphere.is_disk());
  for(Vertex_index v : whole.vertices())
    for(Vertex_index w : whole.vertices())
      if(v != w && all[v] * all[w] > 0) {
        EXPECT_NEAR(inversive_distance(sphere, v, w) / inversive_distance(map, v, w), 1, 1e-8);
      }
}

// Other triangulations of the same surface lead to other masses, starts and paths.
TEST(Circles_on_the_sphere, do_not_depend_on_the_triangulation)
{
  for(const Mesh& mesh : {cube(), random_sphere(60, 8), punctured(random_sphere(60, 9), {0})})
    for(unsigned int seed = 1; seed <= 2; ++seed) {
      const Triangulation t(mesh);
      const Radii radii = random_radii(t, has_border(t.mesh()) ? 0.2 : 0.9, seed);
      const Spherical_conformal_map first = decorated(t, radii);
      ASSERT_EQ(first.status(), DCM::Map_status::success);
      CGAL::Random random(seed);
      for(int i = 0; i < 5; ++i) {
        const Spherical_conformal_map map = decorated(with_random_flips(mesh, random), radii);
        ASSERT_EQ(map.status(), DCM::Map_status::success);
        for(Vertex_index v : t.mesh().vertices())
          for(Vertex_index w : t.mesh().vertices())
            if(w < v && radii[v] * radii[w] > 0) {
              EXPECT_NEAR(inversive_distance(map, v, w) / inversive_distance(first, v, w), 1, 1e-9);
            }
      }
    }
}

// Returns a map of a tube with rings of three points. All circles have the radius 0.2.
Spherical_conformal_map map_of_tube(std::size_t rings)
{
  const Triangulation t(tube(rings, 3, 0.5, 0, Tube_ends::capped));
  return decorated(t, Radii(t.mesh().num_vertices(), 0.2));
}

// Rings of an infinite tube become homothetic polygons in the plane, by the factor q. The law of
// cosines for circles gives q + 1/q - 2 = 1 / (R^2 - r^2) for rings of radius R at unit distances.
// The smallest circles have about the radii e^-66 and e^-141.
TEST(Circles_on_the_sphere, shrink_along_a_tube)
{
  const double step = 2 * std::asinh(1 / (2 * std::sqrt(0.25 - 0.04)));
  for(const std::size_t rings : {70, 150}) {
    const Spherical_conformal_map map = map_of_tube(rings);
    EXPECT_EQ(map.status(), DCM::Map_status::success) << map.cause();
    EXPECT_LT(map.max_curvature_error(), 1e-20);
    EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-9);
    EXPECT_TRUE(map.certificate().is_convex());
    EXPECT_FALSE(map.crowded_faces().empty());
    std::size_t small = 0;
    for(unsigned v = 0; v + 3 < 3 * rings; ++v) {
      const double u = map.log_scale(Vertex_index(v)), next = map.log_scale(Vertex_index(v + 3));
      const std::size_t ring = v / 3;
      if(u > -30 || next > -30 || ring < 10 || ring + 10 > rings)
        continue;
      EXPECT_NEAR(std::abs(next - u), step, 1e-9) << ring;
      ++small;
    }
    EXPECT_GT(2 * small, rings);
  }
}

// The center of mass of crowded circles is known with few digits, the mirror plane with more.
TEST(Circles_of_a_disk, lie_on_a_hemisphere_if_they_are_crowded)
{
  const Triangulation t(punctured(tube(80, 3, 0.5, 0, Tube_ends::capped), {0}));
  const Spherical_conformal_map map = decorated(t, random_radii(t, 0.2, 7));
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  EXPECT_FALSE(map.crowded_faces().empty());
  for(Vertex_index v : t.mesh().vertices())
    if(t.mesh().is_border(v)) {
      EXPECT_NEAR(map.position(v)[2], 0, 1e-15);
    }
}

TEST(Circles_on_the_sphere, uniformize_spheres_and_disks)
{
  const Triangulation t(octahedron());
  const std::vector<double> length = lengths_of(t);
  const Radii radii(6, length[0] / 2);
  const auto result =
    DCM::uniformize(t.mesh(), length_parameter(length).vertex_radius_map(as_radii(radii)));
  ASSERT_NE(result.spherical(), nullptr);
  EXPECT_EQ(result.status(), DCM::Map_status::success);
  for(Vertex_index v : t.mesh().vertices())
    EXPECT_NEAR(result.spherical()->circle_radius(v), pi / 4, 1e-12);
}

TEST(Circles_on_the_sphere, are_refused_if_they_meet_or_have_no_sphere)
{
  const Triangulation t(octahedron());
  EXPECT_THROW(decorated(t, Radii(6, 0.6 * t.length(Edge_index(0)))), IT::Invalid_input);
  const Triangulation torus(embedded_torus(5, 4));
  EXPECT_THROW(decorated(torus, Radii(20, 1e-3)), IT::Invalid_input);
  const Triangulation polygon(square());
  EXPECT_THROW(decorated(polygon, Radii(4, 0.1)), IT::Invalid_input);
}

} // namespace Test_circles_on_sphere
