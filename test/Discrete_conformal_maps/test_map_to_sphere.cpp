// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/hard_meshes.h"
#include "../Intrinsic_triangulations/known_surfaces.h"
#include "../Intrinsic_triangulations/more_generators.h"

#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Conformal_barycenter.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Sphere_unfolding.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

namespace Test_map_to_sphere {

using namespace Test_surfaces;
namespace DCM = CGAL::Discrete_conformal_maps;
using DCM::Layer;
using DCM::Spherical_conformal_map;
using IT::Double_double;
typedef std::array<double, 3> Position;

double distance(const Position& p, const Position& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

Position position(const Mesh& mesh, std::size_t v)
{
  const Point& p = mesh.point(Mesh::Vertex_index(Mesh::size_type(v)));
  return {p.x(), p.y(), p.z()};
}

// Returns the chord from the positions in the plane, which keep their digits if positions on the
// sphere are close.
Double_double chord(const Spherical_conformal_map& map, Vertex_index v, Vertex_index w)
{
  const auto x = [&](Vertex_index i) { return map.stereographic_position(i)[0]; };
  const auto root = [&](Vertex_index i) { return sqrt(1 + x(i) * x(i)); };
  if(v == map.vertex_at_infinity() || w == map.vertex_at_infinity())
    return 2 / root(v == map.vertex_at_infinity() ? w : v);
  return 2 * abs(x(v) - x(w)) / root(v) / root(w);
}

Double_double precise_distance(const Spherical_conformal_map& map, Vertex_index v, Vertex_index w)
{
  if(map.is_flat())
    return chord(map, v, w);
  const auto p = map.precise_position(v), q = map.precise_position(w);
  Double_double square(0);
  for(std::size_t c = 0; c < 3; ++c)
    square += (p[c] - q[c]) * (p[c] - q[c]);
  return sqrt(square);
}

// Returns a cross ratio, which is invariant under Moebius transformations.
template <typename Distance>
double cross_ratio(const std::array<unsigned, 4>& v, const Distance& distance)
{
  return distance(v[0], v[1]) / distance(v[1], v[2]) * distance(v[2], v[3]) / distance(v[3], v[0]);
}

// Checks all properties of a map.
void check_map(const Spherical_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  EXPECT_TRUE(map.certificate().is_convex());
  EXPECT_EQ(map.bound_violations(), 0u);
  EXPECT_EQ(map.minimization().status, DCM::Minimization_status::converged);
  EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-9);
  EXPECT_LE(map.max_inscribed_error(), 4e-16);
  for(Edge_index e : mesh.edges()) {
    const Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    const double expected =
      map.ideal().length(e) * std::exp((map.log_scale(v) + map.log_scale(w)) / 2);
    EXPECT_NEAR(double(precise_distance(map, v, w)) / expected, 1, 1e-9);
  }
}

// Checks all properties of a map whose scale factors may be beyond the range of `double`.
void check_conformal(const Spherical_conformal_map& map)
{
  EXPECT_EQ(map.status(), DCM::Map_status::success) << map.cause();
  EXPECT_TRUE(map.certificate().is_convex());
  EXPECT_EQ(map.bound_violations(), 0u);
  EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-8);
  EXPECT_LE(map.max_inscribed_error(), 4e-16);
}

// Returns the distance of the center of mass, where each vertex has a third of its faces. The
// mirror images of a disk leave it in the mirror plane.
double distance_from_center(const Spherical_conformal_map& map)
{
  const Delta_complex& mesh = map.Delaunay().input_mesh();
  Position sum{0, 0, 0};
  double total = 0;
  for(Face_index f : mesh.faces()) {
    if(!map.is_original(f))
      continue;
    const auto side = IT::sides(f, mesh);
    const double a = map.Delaunay().input_length(mesh.edge(side[0])),
                 b = map.Delaunay().input_length(mesh.edge(side[1])),
                 c = map.Delaunay().input_length(mesh.edge(side[2])), s = (a + b + c) / 2;
    const double area = std::sqrt((std::max)(0., s * (s - a) * (s - b) * (s - c)));
    total += area;
    for(Halfedge_index h : side)
      for(std::size_t k = 0; k < 3; ++k)
        sum[k] += area / 3 * map.position(mesh.target(h))[k];
  }
  if(map.is_disk())
    sum[2] = 0;
  return distance(sum, {0, 0, 0}) / total;
}

// Whether all vertices are on the inner side of all faces, exactly for the positions in double.
bool is_hull(const Spherical_conformal_map& map)
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel::Point_3 Exact_point;
  const Delta_complex& mesh = map.ideal().mesh();
  std::vector<Exact_point> point;
  for(Vertex_index v : mesh.vertices())
    point.emplace_back(map.position(v)[0], map.position(v)[1], map.position(v)[2]);
  for(Face_index f : mesh.faces()) {
    const auto side = IT::sides(f, mesh);
    const Exact_point &p = point[mesh.source(side[0])], &q = point[mesh.source(side[1])],
                      &r = point[mesh.source(side[2])];
    for(const Exact_point& x : point)
      if(CGAL::orientation(p, q, r, x) == CGAL::POSITIVE)
        return false;
  }
  return true;
}

typedef std::multiset<std::pair<unsigned, unsigned>> Edges;

template <typename AnyMesh>
Edges edges_of(const AnyMesh& mesh)
{
  Edges result;
  for(auto e : mesh.edges()) {
    const unsigned v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    result.emplace((std::min)(v, w), (std::max)(v, w));
  }
  return result;
}

// Returns a closed tube with `n` rings of `m` vertices, each `step` from the next, with radius one.
Mesh tube(std::size_t m, std::size_t n, double step)
{
  std::vector<Point> points;
  Triangles triangles;
  for(std::size_t k = 0; k < n; ++k)
    for(std::size_t i = 0; i < m; ++i) {
      const double angle = 2 * pi * (double(i) + 0.1 * double(k)) / double(m);
      points.emplace_back(std::cos(angle), std::sin(angle), step * double(k));
    }
  points.emplace_back(0, 0, -0.5);
  points.emplace_back(0, 0, step * double(n - 1) + 0.5);
  for(std::size_t i = 0; i < m; ++i) {
    const std::size_t j = (i + 1) % m;
    triangles.push_back({j, i, m * n});
    triangles.push_back({m * (n - 1) + i, m * (n - 1) + j, m * n + 1});
    for(std::size_t k = 0; k + 1 < n; ++k) {
      triangles.push_back({m * k + i, m * k + j, m * (k + 1) + j});
      triangles.push_back({m * k + i, m * (k + 1) + j, m * (k + 1) + i});
    }
  }
  return make_mesh(points, triangles);
}

Mesh without_a_face(const Mesh& mesh) { return punctured(mesh, {0}); }

// Vertices on the sphere, in convex position, are their own image, even if scaling and flips change
// the intrinsic geometry.
TEST(Map_to_sphere, brings_inscribed_polyhedra_back)
{
  for(unsigned int seed : seeds(1, 9)) {
    const Mesh polyhedron = random_sphere(4 + 12 * seed, seed);
    const Triangulation t(polyhedron);
    DCM::Penner_surface<double> surface(t.mesh(), t.length_map());
    CGAL::Random random(seed + 100);
    std::vector<double> u;
    for(std::size_t v = 0; v < polyhedron.number_of_vertices(); ++v)
      u.push_back(random.get_double(-1.5, 1.5));
    surface.scale(u);
    EXPECT_GT(surface.number_of_flips(), 0u);
    const auto length = boost::make_function_property_map<Edge_index>(
      [&](Edge_index e) { return surface.scaled_length(e); });
    const Triangulation input(surface.mesh(), IT::parameters::edge_length_map(length));
    const Spherical_conformal_map map =
      DCM::map_to_sphere(surface.mesh(), IT::parameters::edge_length_map(length));
    check_map(map);
    EXPECT_TRUE(is_hull(map));
    EXPECT_LT(distance_from_center(map), 1e-12);
    EXPECT_EQ(edges_of(map.ideal().mesh()), edges_of(polyhedron));
    for(int i = 0; i < 1000; ++i) {
      std::array<unsigned, 4> v;
      for(unsigned& x : v)
        x = unsigned(random.get_int(0, int(u.size())));
      if(std::set<unsigned>(v.begin(), v.end()).size() < 4)
        continue;
      const double result = cross_ratio(v, [&](unsigned a, unsigned b) {
        return double(precise_distance(map, Vertex_index(a), Vertex_index(b)));
      });
      const double expected = cross_ratio(v, [&](unsigned a, unsigned b) {
        return distance(position(polyhedron, a), position(polyhedron, b));
      });
      EXPECT_NEAR(result / expected, 1, 1e-9);
    }
  }
}

TEST(Map_to_sphere, platonic_solids_stay)
{
  for(const Mesh& m : {tetrahedron(), octahedron(), cube()}) {
    const Spherical_conformal_map map = DCM::map_to_sphere(m);
    check_map(map);
    EXPECT_LT(distance_from_center(map), 1e-13);
    // Masses are equal, so the image is centered already. Only the scale is not one.
    const std::size_t n = m.number_of_vertices();
    if(n == 8)
      continue; // the corners of a cube do not have the same areas in a triangulation
    std::vector<double> distances;
    for(unsigned v = 0; v < n; ++v)
      for(unsigned w = 0; w < v; ++w)
        distances.push_back(distance(map.position(Vertex_index(v)), map.position(Vertex_index(w))));
    const double edge = n == 4 ? std::sqrt(8 / 3.) : std::sqrt(2.);
    for(double d : distances)
      EXPECT_LT((std::min)(std::abs(d - edge), std::abs(d - 2)), 1e-13);
  }
}

TEST(Map_to_sphere, rough_surfaces)
{
  for(const Mesh& m : {perturbed(random_sphere(200, 1), 0.2, 2), perturbed(bipyramid(7, 0), 0.2, 2),
                       bipyramid(30, 0.5), bipyramid(20, 20), tube(8, 30, 0.4)}) {
    const Spherical_conformal_map map = DCM::map_to_sphere(m);
    check_map(map);
    EXPECT_LT(distance_from_center(map), 1e-12);
    EXPECT_EQ(map.lost_in_output() == 0, is_hull(map));
  }
}

// The image is unique: the distances of vertices do not depend on the one at infinity.
TEST(Map_to_sphere, does_not_depend_on_the_vertex_at_infinity)
{
  const Mesh m = perturbed(random_sphere(60, 3), 0.2, 4);
  const Triangulation input(m);
  DCM::internal::Doubled_problem problem(input, std::vector<DCM::Vertex_condition>(60),
                                         DCM::Flipping::to_Delaunay);
  const std::vector<double> mass(60, 1.);
  DCM::Default_flattening_visitor silent;
  auto visitor = DCM::internal::Any_visitor::of(silent);
  std::vector<std::vector<double>> distances;
  for(unsigned at_infinity : {0u, 17u, 44u}) {
    const DCM::internal::Unfolded_sphere sphere =
      DCM::internal::Sphere_unfolding(problem, mass, Vertex_index(at_infinity)).run(visitor);
    EXPECT_TRUE(sphere.is_good(1e-9));
    std::vector<Position> p;
    for(unsigned v = 0; v < 60; ++v) {
      const double x = double(sphere.layout.in_plane[v][0]),
                   y = double(sphere.layout.in_plane[v][1]);
      const double s = 1 + x * x + y * y;
      p.push_back(v == at_infinity ? Position{0, 0, -1}
                                   : Position{2 * x / s, 2 * y / s, 2 / s - 1});
    }
    distances.emplace_back();
    for(const Position& a : p)
      for(const Position& b : p)
        distances.back().push_back(distance(a, b));
  }
  for(std::size_t i = 0; i < distances[0].size(); ++i) {
    EXPECT_NEAR(distances[1][i], distances[0][i], 1e-11);
    EXPECT_NEAR(distances[2][i], distances[0][i], 1e-11);
  }
}

// Rings shrink by exp(-0.8 / 1) each. Fifty rings, from the middle, shrink by a factor of 1e17 and
// more.
TEST(Map_to_sphere, long_limbs_need_more_digits)
{
  const Spherical_conformal_map map = DCM::map_to_sphere(perturbed(tube(10, 101, 0.8), 0.1, 1));
  check_map(map);
  EXPECT_TRUE(map.is_extended());
  EXPECT_GT(map.lost_in_output(), 0u);
  double least = 0, greatest = -1000;
  for(Vertex_index v : map.ideal().mesh().vertices()) {
    least = (std::min)(least, map.log_scale(v));
    greatest = (std::max)(greatest, map.log_scale(v));
  }
  EXPECT_GT(greatest - least, std::log(1e12));
}

// Spheres become long tubes with sharp ends. Searches start from flat tubes.
TEST(Map_to_sphere, stretched_spheres)
{
  for(const double factor : {100., 300., 1000.})
    for(std::uint32_t seed : {1u, 2u, 3u}) {
      SCOPED_TRACE(testing::Message() << factor << ' ' << seed);
      Mesh mesh = random_sphere(60, seed);
      for(Vertex_index v : mesh.vertices()) {
        const Point p = mesh.point(v);
        mesh.point(v) = Point(factor * p.x(), p.y(), p.z());
      }
      check_conformal(DCM::map_to_sphere(mesh));
    }
}

TEST(Map_to_sphere, disks_become_hemispheres)
{
  for(const Mesh& m : {without_a_face(random_sphere(60, 5)), without_a_face(bipyramid(9, 1)),
                       grid(7, 5, [](double x, double y) { return Point(x, y, x * y / 9); }),
                       planar_mesh(random_points(40, 1000, 5)), without_a_face(tube(8, 12, 0.4))}) {
    const Spherical_conformal_map map = DCM::map_to_sphere(m);
    EXPECT_TRUE(map.is_disk());
    check_map(map);
    EXPECT_LT(distance_from_center(map), 1e-12);
    for(Mesh::Vertex_index v : m.vertices()) {
      const double height = map.position(Vertex_index(v.idx()))[2];
      EXPECT_EQ(height > 0, !m.is_border(v));
      EXPECT_EQ(height == 0, m.is_border(v));
      const auto z = Spherical_conformal_map::to_plane(map.position(Vertex_index(v.idx())));
      EXPECT_LE(std::abs(z), 1 + 1e-15);
    }
    // The image preserves orientation.
    const Mesh::Face_index f = *m.faces().begin();
    const auto h = m.halfedge(f);
    const auto at = [&](Mesh::Halfedge_index x) {
      const Position& p = map.position(Vertex_index(m.target(x).idx()));
      return Point(p[0], p[1], p[2]);
    };
    EXPECT_GT(CGAL::determinant(at(h) - CGAL::ORIGIN, at(m.next(h)) - CGAL::ORIGIN,
                                at(m.prev(h)) - CGAL::ORIGIN),
              0);
  }
}

// ---- Disks without vertices inside: the polyhedron is a polygon, seen from both sides ----

double image_cross_ratio(const Spherical_conformal_map& map, const std::array<unsigned, 4>& v)
{
  return cross_ratio(v, [&](unsigned a, unsigned b) {
    return double(precise_distance(map, Vertex_index(a), Vertex_index(b)));
  });
}

// Checks all properties of an inscribed polygon: vertices in order on the equator, and faces of the
// subdivision that cover it once.
void check_polygon(const Spherical_conformal_map& map, const Mesh& mesh)
{
  check_map(map);
  EXPECT_TRUE(map.is_disk());
  EXPECT_TRUE(map.is_flat());
  EXPECT_LE(map.lost_in_output(), mesh.number_of_faces());
  double turn = 0, polygon = 0, faces = 0, least = 1;
  const auto sine = [](const Position& p, const Position& q) { return p[0] * q[1] - p[1] * q[0]; };
  for(Mesh::Halfedge_index h : mesh.halfedges()) {
    if(!mesh.is_border(h))
      continue;
    const Position &p = map.position(Vertex_index(mesh.target(h).idx())),
                   &q = map.position(Vertex_index(mesh.source(h).idx()));
    EXPECT_EQ(p[2], 0);
    const double angle = std::atan2(sine(p, q), p[0] * q[0] + p[1] * q[1]);
    turn += angle < 0 ? angle + 2 * pi : angle;
    polygon += sine(p, q) / 2;
  }
  EXPECT_NEAR(turn, 2 * pi, 1e-9);
  const auto& subdivision = map.subdivision();
  for(Face_index f : subdivision.mesh().faces()) {
    const Halfedge_index first = subdivision.mesh().halfedge(f);
    if(!map.is_original(first))
      continue;
    const auto at = [&](Halfedge_index h) {
      return map.image(map.homogeneous_coordinates(subdivision.location(Layer::C, h)));
    };
    double area = 0;
    Halfedge_index h = first;
    do {
      area += sine(at(h), at(subdivision.mesh().next(h))) / 2;
      h = subdivision.mesh().next(h);
    } while(h != first);
    faces += area;
    least = (std::min)(least, area);
  }
  EXPECT_NEAR(faces, polygon, 1e-12);
  EXPECT_GT(least, -1e-14);
}

// Returns a polygon from which ears are cut at random. Its vertices are given counterclockwise.
Mesh ears(const std::vector<Point>& points, CGAL::Random& random)
{
  return make_mesh(points, random_ears(consecutive(0, points.size()), random));
}

// Returns points of an ellipse, one in each of `n` sectors of the same size.
std::vector<Point> on_ellipse(std::size_t n, double width, CGAL::Random& random)
{
  std::vector<double> angle;
  for(std::size_t i = 0; i < n; ++i)
    angle.push_back(2 * pi * (double(i) + random.get_double(0, 0.9)) / double(n));
  std::vector<Point> result;
  for(double a : angle)
    result.emplace_back(width * std::cos(a), std::sin(a), 0);
  return result;
}

// Returns triangles in space, each glued to a side of the previous ones. Most have obtuse angles.
Mesh tree_of_triangles(std::size_t n, double roughness, CGAL::Random& random)
{
  std::vector<Point> points{Point(0, 0, 0), Point(1, 0, 0), Point(0.5, 0.8, 0)};
  Triangles triangles{{0, 1, 2}};
  std::vector<std::array<std::size_t, 2>> side{{0, 1}, {1, 2}, {2, 0}};
  const auto noise = [&] { return roughness * random.get_double(-1, 1); };
  while(triangles.size() < n) {
    const std::size_t k = std::size_t(random.get_int(0, int(side.size()))), v = points.size();
    const auto [i, j] = side[k];
    points.push_back(CGAL::midpoint(points[i], points[j]) +
                     Kernel::Vector_3(noise(), noise(), noise()));
    triangles.push_back({j, i, v});
    side[k] = {i, v};
    side.push_back({v, j});
  }
  return make_mesh(points, triangles);
}

// Checks that the cross ratios of vertices of the polygon, all around it, are the cross ratios of
// their images.
void check_cross_ratios(const Spherical_conformal_map& map, const Mesh& polygon,
                        const std::array<unsigned, 4>& steps, double tolerance)
{
  const auto n = static_cast<unsigned>(polygon.number_of_vertices());
  for(unsigned v = 0; v < n; ++v) {
    std::array<unsigned, 4> quad;
    for(std::size_t k = 0; k < 4; ++k)
      quad[k] = (v + steps[k]) % n;
    const double expected = cross_ratio(quad, [&](unsigned a, unsigned b) {
      return distance(position(polygon, a), position(polygon, b));
    });
    EXPECT_NEAR(image_cross_ratio(map, quad) / expected, 1, tolerance);
  }
}

// Returns `n` unit squares in a row, each with one of its diagonals.
Mesh strip(std::size_t n, CGAL::Random& random)
{
  std::vector<Point> points{Point(0, 0, 0), Point(0, 1, 0)};
  Triangles triangles;
  for(std::size_t i = 0; i < n; ++i) {
    points.emplace_back(i + 1, 0, 0);
    points.emplace_back(i + 1, 1, 0);
    const std::size_t a = 2 * i, b = a + 1, c = a + 2, d = a + 3;
    if(random.get_bool()) {
      triangles.push_back({a, c, d});
      triangles.push_back({a, d, b});
    } else {
      triangles.push_back({a, c, b});
      triangles.push_back({b, c, d});
    }
  }
  return make_mesh(points, triangles);
}

TEST(Map_to_sphere, triangles_become_equilateral)
{
  for(const Point& apex : {Point(0, 1, 0), Point(2, 0.1, 0), Point(9, 1e-3, 4)}) {
    const Mesh triangle = make_mesh({Point(0, 0, 0), Point(3, 0, 0), apex}, {{0, 1, 2}});
    const Spherical_conformal_map map = DCM::map_to_sphere(triangle);
    check_polygon(map, triangle);
    for(unsigned v = 0; v < 3; ++v)
      EXPECT_NEAR(distance(map.position(Vertex_index(v)), map.position(Vertex_index((v + 1) % 3))),
                  std::sqrt(3.), 1e-14);
  }
}

// A polygon in a circle with the center inside has acute angles opposite its sides. So it is its
// own image, whatever its triangulation is.
TEST(Map_to_sphere, inscribed_polygons_stay)
{
  CGAL::Random random(11);
  for(const std::size_t n : {4, 7, 12, 60}) {
    const Mesh polygon = ears(on_ellipse(n, 1, random), random);
    const Spherical_conformal_map map = DCM::map_to_sphere(polygon);
    check_polygon(map, polygon);
    check_cross_ratios(map, polygon, {0, 1, 2, 3}, 1e-12);
  }
}

// Scale factors do not change the image, as long as angles opposite the sides stay acute. Then the
// sides are in the Delaunay triangulation of the double.
TEST(Map_to_sphere, scaled_polygons_come_back)
{
  CGAL::Random random(12);
  for(int i = 0; i < 10; ++i) {
    const std::size_t n = 20;
    const Mesh polygon = ears(on_ellipse(n, 1, random), random);
    const Triangulation t(polygon);
    DCM::Penner_surface<double> surface(t.mesh(), t.length_map());
    std::vector<double> u(n);
    for(double& x : u)
      x = random.get_double(-0.01, 0.01);
    surface.scale(u);
    EXPECT_GT(surface.number_of_flips(), 0u);
    const auto length = boost::make_function_property_map<Edge_index>(
      [&](Edge_index e) { return surface.scaled_length(e); });
    const Spherical_conformal_map map =
      DCM::map_to_sphere(surface.mesh(), IT::parameters::edge_length_map(length));
    check_map(map);
    check_cross_ratios(map, polygon, {0, 3, 4, 9}, 1e-11);
  }
}

// The ends of a square, and the four corners of two triangles of the same shape on an edge between
// squares, have the cross ratio one.
TEST(Map_to_sphere, strips_of_squares)
{
  CGAL::Random random(13);
  for(const std::size_t n : {1, 2, 3, 8, 20, 100, 120, 300}) {
    const Mesh mesh = strip(n, random);
    const Spherical_conformal_map map = DCM::map_to_sphere(mesh);
    check_polygon(map, mesh);
    for(unsigned a = 0; a + 3 < mesh.number_of_vertices(); a += 2) {
      EXPECT_NEAR(image_cross_ratio(map, {a, a + 2, a + 3, a + 1}), 1, 1e-10);
      if(a + 5 < mesh.number_of_vertices()) {
        EXPECT_NEAR(image_cross_ratio(map, {a, a + 2, a + 4, a + 3}), 1, 1e-10);
      }
    }
    EXPECT_EQ(map.lost_in_output() > 0, n > 20);
    if(n <= 20) {
      EXPECT_LT(distance_from_center(map), 1e-12);
    }
  }
}

// The ends of a strip of n squares are (3 + 2 sqrt(2))^(-n/2) of it. With n = 400, this is below
// the range of `double`. The center is hundreds of steps from the mean.
TEST(Map_to_sphere, polygons_beyond_the_range_of_positions)
{
  CGAL::Random random(14);
  for(std::size_t n : {400, 1600}) {
    const Spherical_conformal_map map = DCM::map_to_sphere(strip(n, random));
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    EXPECT_FALSE(map.crowded_faces().empty());
    EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-8);
  }
}

// One flip leads across the side ij of an obtuse triangle ijk: a loop at k of length 2h, if h is
// its height. Ptolemy's relation yields the length ki kj / h of ij instead of ki kj sin(k) / h.
TEST(Map_to_sphere, obtuse_angles_opposite_the_boundary)
{
  for(const double height : {0.9, 0.6, 0.45}) {
    const Mesh mesh =
      make_mesh({Point(-1, 0, 0), Point(1, 0, 0), Point(0, height, 0), Point(1, 1 + height, 0)},
                {{0, 1, 2}, {2, 1, 3}});
    const Spherical_conformal_map map = DCM::map_to_sphere(mesh);
    check_polygon(map, mesh);
    const double side = std::hypot(1, height), ij = side * side / height;
    const auto at = [&](std::size_t v) { return position(mesh, v); };
    const double expected = ij / distance(at(1), at(3)) * distance(at(3), at(2)) / side;
    EXPECT_NEAR(image_cross_ratio(map, {0, 1, 3, 2}) / expected, 1, 1e-13);
  }
}

TEST(Map_to_sphere, random_polygons)
{
  CGAL::Random random(15);
  for(int i = 0; i < 40; ++i) {
    const auto n = static_cast<std::size_t>(random.get_int(4, 60));
    const Mesh polygon = ears(on_ellipse(n, random.get_double(1, 5), random), random);
    const Spherical_conformal_map map = DCM::map_to_sphere(polygon);
    check_polygon(map, polygon);
    EXPECT_LT(distance_from_center(map), 1e-12);
    const Mesh tree = tree_of_triangles(n, random.get_double(0.2, 1), random);
    check_polygon(DCM::map_to_sphere(tree), tree);
  }
  const Mesh large = tree_of_triangles(2000, 0.5, random);
  check_polygon(DCM::map_to_sphere(large), large);
  const Mesh bent = grid(1, 5, [](double x, double y) { return Point(x, y + x * x, 0); });
  check_polygon(DCM::map_to_sphere(bent), bent);
}

// Inserts vertices at random in faces, and flattens the mesh along y by a factor.
Mesh thin_with_vertices_inside(Mesh mesh, std::size_t n, double factor, CGAL::Random& random)
{
  for(; n > 0; --n) {
    const Face_index f(Mesh::size_type(random.get_int(0, int(mesh.number_of_faces()))));
    const double a = random.get_double(0.1, 1), b = random.get_double(0.1, 1),
                 c = random.get_double(0.1, 1);
    const auto side = IT::sides(f, mesh);
    const Point &p = mesh.point(mesh.source(side[0])), &q = mesh.point(mesh.source(side[1])),
                &r = mesh.point(mesh.source(side[2]));
    const Point center = CGAL::barycenter(p, a, q, b, r, c);
    mesh.point(mesh.target(CGAL::Euler::add_center_vertex(side[0], mesh))) = center;
  }
  for(Vertex_index v : mesh.vertices()) {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(p.x(), factor * p.y(), p.z());
  }
  return mesh;
}

// Edges that cross the boundary differ on both sides by rounding. Numbers with more digits resolve
// the difference.
TEST(Map_to_sphere, thin_polygons_with_vertices_inside)
{
  CGAL::Random random(16);
  for(int i = 0; i < 40; ++i) {
    const auto n = static_cast<std::size_t>(random.get_int(5, 120));
    const Mesh polygon = ears(on_ellipse(n, 1, random), random);
    const double factor = std::pow(10, random.get_double(-2.5, 0));
    SCOPED_TRACE(testing::Message() << i << ' ' << n << ' ' << factor);
    check_conformal(
      DCM::map_to_sphere(thin_with_vertices_inside(polygon, 1 + n / 8, factor, random)));
  }
}

// Mirror images of edges have the same bits, and the diagonals of a trapezoid satisfy Ptolemy's
// relation with all digits.
TEST(Symmetric_lengths, are_symmetric)
{
  CGAL::Random random(17);
  std::size_t trapezoids = 0;
  for(int i = 0; i < 20; ++i) {
    const auto n = static_cast<std::size_t>(random.get_int(5, 60));
    const Mesh mesh =
      thin_with_vertices_inside(ears(on_ellipse(n, 2, random), random), n / 2, 0.3, random);
    DCM::internal::Doubled_problem problem(
      Triangulation(mesh), std::vector<DCM::Vertex_condition>(mesh.number_of_vertices()),
      DCM::Flipping::to_Delaunay);
    problem.complete();
    const auto& t = problem.triangulation();
    const auto length = problem.symmetric_lengths<Double_double>(t);
    const auto original = [&](Vertex_index v) { return problem.original(v); };
    const auto is_inside = [&](Vertex_index v) { return !problem.is_on_boundary(original(v)); };
    for(Edge_index e : t.mesh().edges()) {
      EXPECT_NEAR(double(get(length, e)) / t.length(e), 1, 1e-12);
      const Halfedge_index h = t.mesh().halfedge(e), o = t.mesh().opposite(h);
      const Vertex_index v = t.mesh().source(h), w = t.mesh().target(h);
      const auto side = [&](Halfedge_index x) { return get(length, t.mesh().edge(x)); };
      const auto apex = [&](Halfedge_index x) { return t.mesh().target(t.mesh().next(x)); };
      if(!is_inside(v) || !is_inside(w) || original(v) == original(w))
        continue;
      if(std::minmax(original(v), original(w)) ==
         std::minmax(original(apex(h)), original(apex(o)))) {
        const Double_double products = side(t.mesh().next(h)) * side(t.mesh().next(o)) +
                                       side(t.mesh().prev(h)) * side(t.mesh().prev(o));
        const double error = std::abs(double(products / (side(h) * side(h)) - 1));
        const bool is_trapezoid = error < 1e-11;
        EXPECT_TRUE(!is_trapezoid || error < 1e-30) << error;
        trapezoids += is_trapezoid ? 1 : 0;
      } else
        EXPECT_GE(std::count_if(t.mesh().edges().begin(), t.mesh().edges().end(),
                                [&](Edge_index f) { return get(length, f) == side(h); }),
                  2);
    }
  }
  EXPECT_GT(trapezoids, 20u);
}

// The two sides of a quadrilateral have different diagonals. The image of a square is a square, and
// points of its sides stay in the plane of the vertices.
TEST(Map_to_sphere, spheres_without_volume)
{
  CGAL::Random random(16);
  for(int i = 0; i < 20; ++i) {
    const std::vector<Point> points =
      i == 0 ? std::vector<Point>{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}
             : on_ellipse(4, 1, random);
    const Mesh mesh = make_mesh(points, {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {2, 1, 3}});
    const Spherical_conformal_map map = DCM::map_to_sphere(mesh);
    check_map(map);
    EXPECT_FALSE(map.is_disk());
    EXPECT_TRUE(map.is_flat());
    EXPECT_EQ(map.lost_in_output(), 0u);
    for(const Position& p : {map.position(Vertex_index(0)), map.position(Vertex_index(1)),
                             map.position(Vertex_index(2)), map.position(Vertex_index(3))})
      EXPECT_EQ(p[1], 0);
    if(i == 0) {
      EXPECT_NEAR(distance(map.position(Vertex_index(0)), map.position(Vertex_index(1))),
                  std::sqrt(2.), 1e-14);
    }
    for(Halfedge_index h : map.subdivision().mesh().halfedges()) {
      const Position p =
        map.image(map.homogeneous_coordinates(map.subdivision().location(Layer::C, h)));
      EXPECT_EQ(p[1], 0);
      EXPECT_LE(std::hypot(p[0], p[2]), 1 + 1e-15);
    }
  }
}

TEST(Map_to_sphere, is_continuous_on_the_subdivision)
{
  const Mesh m = perturbed(random_sphere(60, 8), 0.25, 9);
  const Spherical_conformal_map map = DCM::map_to_sphere(m);
  const auto& subdivision = map.subdivision();
  std::vector<Position> image(subdivision.mesh().number_of_vertices(), Position{0, 0, 0});
  std::vector<char> is_set(image.size(), 0);
  for(Halfedge_index h : subdivision.mesh().halfedges()) {
    const Vertex_index v = subdivision.mesh().target(h);
    const Position p = Spherical_conformal_map::project(
      map.homogeneous_coordinates(subdivision.location(Layer::C, h)));
    if(is_set[v]) {
      EXPECT_LT(distance(p, image[v]), 1e-12);
    }
    image[v] = p;
    is_set[v] = 1;
    if(subdivision.is_vertex(Layer::A, v)) {
      EXPECT_LT(distance(p, map.position(v)), 1e-15);
    }
    EXPECT_LT(
      distance(map(IT::face_location(subdivision.place(Layer::A, v), subdivision.mesh(Layer::A))),
               p),
      1e-9);
  }
  // Faces cover the sphere without folds.
  for(Face_index f : subdivision.mesh().faces()) {
    const Halfedge_index h = subdivision.mesh().halfedge(f);
    const auto at = [&](Halfedge_index x) {
      const Position& p = image[subdivision.mesh().target(x)];
      return Kernel::Vector_3(p[0], p[1], p[2]);
    };
    for(Halfedge_index x = subdivision.mesh().next(h); subdivision.mesh().next(x) != h;
        x = subdivision.mesh().next(x))
      EXPECT_GT(CGAL::determinant(at(h), at(x), at(subdivision.mesh().next(x))), -1e-14);
  }
}

TEST(Map_to_sphere, other_surfaces_are_refused)
{
  EXPECT_THROW(DCM::map_to_sphere(embedded_torus(5, 4)), IT::Invalid_input);
  EXPECT_THROW(DCM::map_to_sphere(punctured(random_sphere(40, 6), {0, 20})), IT::Invalid_input);
  Mesh two = tetrahedron();
  two += octahedron();
  EXPECT_THROW(DCM::map_to_sphere(two), IT::Invalid_input);
}

// Vertices without faces come between the others, and change only numbers.
TEST(Map_to_sphere, isolated_vertices_are_carried_along)
{
  for(const Mesh& m : {perturbed(random_sphere(50, 8), 0.25, 9),
                       without_a_face(random_sphere(50, 5)), octahedron()}) {
    std::vector<Point> points{Point(9, 9, 9)};
    std::vector<unsigned> number;
    for(Mesh::Vertex_index v : m.vertices()) {
      number.push_back(static_cast<unsigned>(points.size()));
      points.push_back(m.point(v));
      if(v.idx() % 7 == 3)
        points.push_back(m.point(v));
    }
    Triangles triangles;
    for(Mesh::Face_index f : m.faces()) {
      const Mesh::Halfedge_index h = m.halfedge(f);
      triangles.push_back({number[m.source(h)], number[m.target(h)], number[m.target(m.next(h))]});
    }
    const Mesh with_more = make_mesh(points, triangles);
    const Spherical_conformal_map map = DCM::map_to_sphere(with_more),
                                  expected = DCM::map_to_sphere(m);
    check_map(map);
    EXPECT_LT(distance_from_center(map), 1e-12);
    EXPECT_EQ(map.is_disk(), expected.is_disk());
    for(Mesh::Vertex_index v : m.vertices()) { // the sphere can be turned
      EXPECT_NEAR(map.log_scale(Vertex_index(number[v])), expected.log_scale(v), 1e-11);
      for(Mesh::Vertex_index w : m.vertices())
        EXPECT_NEAR(
          distance(map.position(Vertex_index(number[v])), map.position(Vertex_index(number[w]))),
          distance(expected.position(v), expected.position(w)), 1e-11);
    }
    for(Mesh::Vertex_index v : with_more.vertices())
      if(with_more.is_isolated(v)) {
        EXPECT_EQ(map.position(v), map.is_disk() ? (Position{1, 0, 0}) : (Position{0, 0, 1}));
        EXPECT_EQ(map.log_scale(v), 0);
      }
  }
}

// After flips, loops at one vertex can bound most of the area. Half of the mass at one vertex
// leaves no center. Length cross ratios are those of the tetrahedron, whose edges are Delaunay.
TEST(Map_to_sphere, one_vertex_has_most_of_the_area)
{
  const Mesh m = make_mesh({{1, 1, 1}, {1.2, -1, -1}, {-1, 1.1, -1}, {-1, -1, 0.9}},
                           {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  const auto edge = [&](unsigned v, unsigned w) {
    return distance(position(m, v), position(m, w));
  };
  CGAL::Random random(7);
  int loops = 0;
  for(int trial = 0; trial < 40; ++trial) {
    Triangulation t(m);
    for(int flip = 0; flip < 18; ++flip) {
      const Halfedge_index h(2 * static_cast<unsigned>(random.get_int(0, 6)));
      if(t.is_flippable(h))
        t.flip(h);
      if(t.length(Edge_index(h)) > 20 && t.is_flippable(h))
        t.flip(h);
    }
    std::vector<double> length;
    for(Edge_index e : t.mesh().edges()) {
      length.push_back(t.length(e));
      loops += t.mesh().vertex(e, 0) == t.mesh().vertex(e, 1);
    }
    const Spherical_conformal_map map = DCM::map_to_sphere(
      t.mesh(), DCM::parameters::edge_length_map(boost::make_iterator_property_map(
                  length.begin(), get(boost::edge_index, t.mesh()))));
    check_map(map);
    const auto chord = [&](unsigned v, unsigned w) {
      return distance(map.position(Vertex_index(v)), map.position(Vertex_index(w)));
    };
    for(const std::array<unsigned, 4>& v : {std::array<unsigned, 4>{0, 1, 2, 3}, {0, 2, 1, 3}})
      EXPECT_NEAR(cross_ratio(v, chord), cross_ratio(v, edge), 1e-12);
  }
  EXPECT_GT(loops, 10);
}

TEST(Map_to_sphere, same_input_gives_same_bits)
{
  const Mesh m = perturbed(random_sphere(60, 8), 0.25, 9);
  const Spherical_conformal_map one = DCM::map_to_sphere(m), other = DCM::map_to_sphere(m);
  for(Vertex_index v : one.ideal().mesh().vertices()) {
    EXPECT_EQ(one.position(v), other.position(v));
    EXPECT_EQ(one.log_scale(v), other.log_scale(v));
  }
}

// ---- Parts ----

// Points are in three clusters, and the smallest one has most of the mass: far away in hyperbolic
// space.
TEST(Conformal_barycenter, is_in_balance)
{
  CGAL::Random random(1);
  for(const double size : {1., 1e-3, 1e-9, 1e-15}) {
    std::vector<std::array<Double_double, 2>> position;
    std::vector<double> mass;
    for(int i = 0; i < 60; ++i) {
      const double scale = i < 30 ? 1 : size;
      position.push_back(
        {Double_double(i < 30 ? 0. : 3.) + Double_double(scale * random.get_double(-1, 1)),
         Double_double(scale * random.get_double(-1, 1))});
      mass.push_back(i < 30 ? 0.01 : random.get_double(1, 2));
    }
    const DCM::internal::Conformal_barycenter<Double_double> center(position, mass, 7);
    Position sum{0, 0, -mass[7]};
    double total = mass[7];
    for(std::size_t i = 0; i < 60; ++i) {
      if(i == 7)
        continue;
      const auto p = center.centered(position[i]);
      const double x = double(p[0]), y = double(p[1]), s = 1 + x * x + y * y;
      sum = {sum[0] + mass[i] * 2 * x / s, sum[1] + mass[i] * 2 * y / s,
             sum[2] + mass[i] * (2 / s - 1)};
      total += mass[i];
    }
    EXPECT_LT(distance(sum, {0, 0, 0}) / total, 1e-13) << size;
  }
}

typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;

// Compares both predicates with those of the kernel; returns the orientation.
template <typename FT>
int check_predicates(const std::array<std::array<FT, 2>, 4>& p,
                     const std::array<Exact::Point_2, 4>& q)
{
  const DCM::internal::Plane_predicates<FT> predicates;
  const int turn = int(CGAL::orientation(q[0], q[1], q[2]));
  EXPECT_EQ(predicates.orientation(p[0], p[1], p[2]), turn);
  if(turn != 0) {
    EXPECT_EQ(predicates.in_circle(p[0], p[1], p[2], p[3]),
              int(CGAL::side_of_oriented_circle(q[0], q[1], q[2], q[3])));
  }
  return turn;
}

TEST(Plane_predicates, are_exact)
{
  CGAL::Random random(1);
  for(int i = 0; i < 20000; ++i) {
    // A grid of few points has the width of a few rounding errors, so most tuples are degenerate.
    std::array<std::array<double, 2>, 4> p;
    std::array<std::array<Double_double, 2>, 4> e;
    std::array<Exact::Point_2, 4> q;
    for(std::size_t k = 0; k < 4; ++k) {
      for(std::size_t c = 0; c < 2; ++c) {
        p[k][c] = 0.1 + random.get_int(0, 4) * 1.4e-17 * (i % 2 == 0 ? 1 : 1e12);
        e[k][c] = Double_double(p[k][c]);
      }
      q[k] = {p[k][0], p[k][1]};
    }
    check_predicates(p, q);
    check_predicates(e, q);
  }
}

// Exponents are far apart, and numbers of type `Double_double` have second parts.
TEST(Plane_predicates, have_all_digits)
{
  CGAL::Random random(2);
  int degenerate = 0;
  for(int i = 0; i < 5000; ++i) {
    std::array<std::array<Double_double, 2>, 4> e;
    std::array<Exact::Point_2, 4> q;
    for(std::size_t k = 0; k < 4; ++k) {
      std::array<Exact::FT, 2> exact;
      for(std::size_t c = 0; c < 2; ++c) {
        const double high = random.get_int(-1, 2) * std::ldexp(1., 60 * random.get_int(-3, 4)),
                     low = random.get_int(-1, 2) * std::ldexp(1., -400);
        e[k][c] = Double_double(high) + Double_double(low);
        exact[c] = Exact::FT(e[k][c].high()) + Exact::FT(e[k][c].low());
      }
      q[k] = {exact[0], exact[1]};
    }
    degenerate += check_predicates(e, q) == 0;
  }
  EXPECT_GT(degenerate, 50);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const DCM::internal::Plane_predicates<Double_double> predicates;
  EXPECT_EQ(predicates.orientation({nan, nan}, {1, 0}, {0, 1}), 0);
  EXPECT_EQ(predicates.in_circle({0, 0}, {1, 0}, {0, 1}, {nan, 1}), 0);
}

TEST(Plane_predicates, are_exact_in_space)
{
  const DCM::internal::Plane_predicates<double> predicates;
  CGAL::Random random(3);
  int degenerate = 0;
  for(int i = 0; i < 20000; ++i) {
    std::array<std::array<double, 3>, 4> p;
    std::vector<Exact::Point_3> q;
    for(auto& x : p) {
      for(double& c : x)
        c = 0.1 + random.get_int(0, 3) * 1.4e-17 * (i % 2 == 0 ? 1 : 1e12);
      q.emplace_back(x[0], x[1], x[2]);
    }
    const int side = int(CGAL::orientation(q[3], q[0], q[1], q[2]));
    degenerate += side == 0;
    EXPECT_EQ(predicates.orientation(p[0], p[1], p[2], p[3]), side);
  }
  EXPECT_GT(degenerate, 1000);
}

} // namespace Test_map_to_sphere
