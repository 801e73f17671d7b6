// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_rectangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/circle_angles.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/flat_boundary_lengths.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/boost/graph/copy_face_graph.h>

namespace Test_shapes {

using namespace Test_surfaces;
namespace np = DCM::parameters;

// ---- Disks, and what their boundaries are in the plane ----

Mesh flat_grid_mesh(std::size_t m, std::size_t n, double width)
{
  return grid(m, n,
              [&](double x, double y) { return Point(width * x / double(m), y / double(n), 0); });
}

// Returns a curved disk with an uneven boundary.
Mesh random_disk(unsigned int seed)
{
  return perturbed(
    grid(6, 5, [](double x, double y) { return Point(x, y, 0.05 * x * x - 0.1 * x * y); }), 0.3,
    seed);
}

// Stores the path of a boundary in the plane: positions of all its vertices in the subdivision, in
// their order, and which of them are vertices of the input.
struct Flat_boundary
{
  std::vector<Complex> points;
  std::vector<Vertex_index> vertices; // invalid at crossings
};

std::vector<Flat_boundary> flat_boundaries(const Planar_conformal_map& map)
{
  const auto& s = map.subdivision();
  const auto& mesh = s.mesh();
  const auto is_original = [&](Halfedge_index h) { return map.is_original(h); };
  const auto is_boundary = [&](Halfedge_index h) {
    return is_original(h) && !is_original(mesh.opposite(h));
  };
  std::set<Halfedge_index> seen;
  std::vector<Flat_boundary> result;
  for(Halfedge_index start : mesh.halfedges()) {
    if(!is_boundary(start) || seen.count(start) != 0)
      continue;
    result.emplace_back();
    for(Halfedge_index h = start; seen.insert(h).second;) {
      const auto z = map.homogeneous_coordinates(s.location(Layer::C, h));
      result.back().points.push_back(Complex(z[0], z[1]) / z[2]);
      const Vertex_index v = mesh.target(h);
      result.back().vertices.push_back(v.idx() < mesh_A(map).number_of_vertices() ? v
                                                                                  : Vertex_index());
      for(h = mesh.next(h); !is_boundary(h);)
        h = mesh.next(mesh.opposite(h));
    }
  }
  return result;
}

// Returns turning angles, which are positive to the left.
std::vector<double> turning_angles(const std::vector<Complex>& p)
{
  std::vector<double> result;
  const std::size_t n = p.size();
  for(std::size_t i = 0; i < n; ++i)
    result.push_back(std::arg((p[(i + 1) % n] - p[i]) / (p[i] - p[(i + n - 1) % n])));
  return result;
}

double area(const std::vector<Complex>& p)
{
  double result = 0;
  for(std::size_t i = 0; i < p.size(); ++i)
    result += (std::conj(p[i]) * p[(i + 1) % p.size()]).imag() / 2;
  return result;
}

// ---- Claims ----

// Checks that cones lie inside, scale factors are within the bound inside, and curvatures on the
// boundary are the curvatures of `condition`.
void expect_cones_inside(const Planar_conformal_map& map, const Mesh& mesh, Conditions condition,
                         double bound)
{
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  EXPECT_FALSE(map.cones().empty());
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_border(v)) {
      condition[v] = Vertex_condition();
      EXPECT_LE(std::abs(log_scale(map, v)), bound) << v;
    }
  for(Vertex_index v : map.cones()) {
    EXPECT_FALSE(mesh.is_border(v)) << v;
    condition[v] = Vertex_condition::log_scale(0);
  }
  check_conditions(map, Triangulation(mesh).mesh(), condition, 1e-9);
}

// Checks that a closed path turns around once (Gauss-Bonnet), by pi / 2 at the corners and by zero
// elsewhere.
void expect_rectangle(const Flat_boundary& boundary, const std::vector<Vertex_index>& corners)
{
  const std::vector<double> angle = turning_angles(boundary.points);
  EXPECT_NEAR(std::accumulate(angle.begin(), angle.end(), 0.), 2 * pi, 1e-9);
  std::vector<Complex> corner;
  for(std::size_t i = 0; i < angle.size(); ++i) {
    const bool is_corner =
      boundary.vertices[i].is_valid() &&
      std::find(corners.begin(), corners.end(), boundary.vertices[i]) != corners.end();
    EXPECT_NEAR(angle[i], is_corner ? pi / 2 : 0, 1e-8);
    if(is_corner)
      corner.push_back(boundary.points[i]);
  }
  ASSERT_EQ(corner.size(), 4u);
  // Sides are straight, and opposite sides are equally long.
  const double a = std::abs(corner[1] - corner[0]), b = std::abs(corner[2] - corner[1]);
  EXPECT_NEAR(std::abs(corner[3] - corner[2]), a, 1e-9 * a);
  EXPECT_NEAR(std::abs(corner[0] - corner[3]), b, 1e-9 * b);
  EXPECT_NEAR(area(boundary.points), a * b, 1e-9 * a * b);
}

// Checks that all points between two corners are on the line through the corners. Points may
// coincide.
void expect_straight_sides(const Flat_boundary& boundary, const std::vector<Vertex_index>& corners)
{
  const std::size_t n = boundary.points.size();
  std::vector<std::size_t> at;
  for(std::size_t i = 0; i < n; ++i)
    if(std::count(corners.begin(), corners.end(), boundary.vertices[i]) > 0)
      at.push_back(i);
  ASSERT_EQ(at.size(), 4u);
  for(std::size_t side = 0; side < 4; ++side) {
    const Complex start = boundary.points[at[side]],
                  line = boundary.points[at[(side + 1) % 4]] - start;
    for(std::size_t i = at[side]; i != at[(side + 1) % 4]; i = (i + 1) % n)
      EXPECT_NEAR(((boundary.points[i] - start) / line).imag(), 0, 1e-8) << side << ' ' << i;
  }
}

// Returns the center of the circle through three points.
Complex circumcenter(const Complex& a, const Complex& b, const Complex& c)
{
  const Complex p = b - a, q = c - a;
  return a + p * q * (std::conj(p) - std::conj(q)) / (std::conj(p) * q - p * std::conj(q));
}

// Checks that the path turns around once, and vertices of the input lie on one circle.
void expect_circle(const Flat_boundary& boundary)
{
  const std::vector<double> angle = turning_angles(boundary.points);
  EXPECT_NEAR(std::accumulate(angle.begin(), angle.end(), 0.), 2 * pi, 1e-9);
  std::vector<Complex> points;
  for(std::size_t i = 0; i < angle.size(); ++i)
    if(boundary.vertices[i].is_valid())
      points.push_back(boundary.points[i]);
  ASSERT_GE(points.size(), 3u);
  const std::size_t n = points.size();
  const Complex center = circumcenter(points[0], points[n / 3], points[2 * n / 3]);
  const double radius = std::abs(points[0] - center);
  for(const Complex& z : points)
    EXPECT_NEAR(std::abs(z - center), radius, 1e-8 * radius);
}

template <typename Function>
void expect_refused(const Function& function, const std::string& message)
{
  try {
    function();
    ADD_FAILURE() << "accepted, not: " << message;
  } catch(const IT::Invalid_input& e) {
    EXPECT_NE(std::string(e.what()).find(message), std::string::npos) << e.what();
  }
}

// ---- Angles of polygons in circles ----

// Points are on a circle, around the center or all on one side of it.
TEST(Circle_angles, are_those_of_inscribed_polygons)
{
  CGAL::Random random(5);
  for(const double arc : {2 * pi, 1., 0.01})
    for(const std::size_t n : {3u, 4u, 20u}) {
      std::vector<double> place;
      for(std::size_t i = 0; i < n; ++i)
        place.push_back(arc * (double(i) + 0.8 * random.get_double()) / double(n));
      std::vector<Complex> point;
      for(double t : place)
        point.push_back(std::polar(2.5, t));
      std::vector<double> length;
      for(std::size_t i = 0; i < n; ++i)
        length.push_back(std::abs(point[(i + 1) % n] - point[i]));
      const std::vector<double> expected = turning_angles(point),
                                angle = DCM::internal::circle_angles(length);
      for(std::size_t i = 0; i < n; ++i)
        EXPECT_NEAR(angle[i], expected[i], 1e-9) << arc << ' ' << n;
    }
}

// The hypotenuse of a right triangle is a diameter (Thales), where half an arc is the arc sine of
// one.
TEST(Circle_angles, are_those_of_right_triangles)
{
  CGAL::Random random(6);
  for(int i = 0; i < 1000; ++i) {
    const double a = random.get_double(0.1, 1), b = random.get_double(0.1, 1);
    const std::vector<double> expected{pi - std::atan(b / a), pi / 2, pi - std::atan(a / b)},
      angle = DCM::internal::circle_angles({a, b, std::hypot(a, b)});
    for(std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(angle[k], expected[k], 1e-14);
  }
}

TEST(Circle_angles, need_a_circle)
{
  for(const std::vector<double>& length : {std::vector<double>{1, 1, 3}, {1, 2, 1}, {2, 1, 4, 1}})
    for(const double angle : DCM::internal::circle_angles(length))
      EXPECT_TRUE(std::isnan(angle));
}

// ---- Rectangles ----

// The rectangles are longer on one side, turned, and have different numbers of cells.
TEST(Rectangle_corners, are_those_of_rectangles)
{
  for(const double width : {1., 3., 0.2}) {
    const Mesh mesh = flat_grid_mesh(7, 4, width);
    const std::vector<Vertex_index> corners = DCM::rectangle_corners(mesh);
    ASSERT_EQ(corners.size(), 4u);
    double doubled_area = 0; // counterclockwise
    for(std::size_t i = 0; i < 4; ++i) {
      const Point &p = mesh.point(corners[i]), &q = mesh.point(corners[(i + 1) % 4]);
      doubled_area += p.x() * q.y() - q.x() * p.y();
    }
    EXPECT_NEAR(doubled_area, 2 * width, 1e-12);
  }
}

TEST(Flatten_to_rectangle, leaves_rectangles_as_they_are)
{
  const Mesh mesh = flat_grid_mesh(5, 8, 4);
  const Planar_conformal_map map = DCM::flatten_to_rectangle(mesh, DCM::rectangle_corners(mesh));
  for(Vertex_index v : mesh.vertices())
    EXPECT_NEAR(map.log_scale(v), 0, 1e-12);
}

TEST(Flatten_to_rectangle, has_right_angles_and_straight_sides)
{
  for(unsigned int seed = 1; seed <= 8; ++seed) {
    const Mesh mesh = random_disk(seed);
    const std::vector<Vertex_index> chosen = DCM::rectangle_corners(mesh);
    // Any other corners are possible, too.
    std::vector<Vertex_index> others;
    for(Vertex_index v : mesh.vertices())
      if(mesh.is_border(v) && v.idx() % 3 == seed % 3 && others.size() < 4)
        others.push_back(v);
    for(const std::vector<Vertex_index>& corners : {chosen, others}) {
      const Planar_conformal_map map = DCM::flatten_to_rectangle(mesh, corners);
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      const std::vector<Flat_boundary> boundaries = flat_boundaries(map);
      ASSERT_EQ(boundaries.size(), 1u);
      expect_rectangle(boundaries[0], corners);
    }
  }
}

// Returns a flat polygon of this height. It has spikes, and a vertex inside from which all of it is
// seen.
Mesh thin_star(double height, unsigned int seed)
{
  CGAL::Random random(seed);
  const int n = random.get_int(8, 40);
  std::vector<Point> points;
  Triangles faces;
  for(int i = 0; i < n; ++i) {
    const Complex z =
      std::polar(random.get_double(0.1, 1), 2 * pi * (i + 0.8 * random.get_double()) / n);
    points.emplace_back(z.real(), height * z.imag(), 0);
    faces.push_back({std::size_t(i), std::size_t((i + 1) % n), std::size_t(n)});
  }
  points.emplace_back(0, 0, 0);
  return make_mesh(points, faces);
}

// Edges of T_3 cross the sides much closer to one of their ends than rounding of positions in T_2.
// A face of T_3 can contain two separate parts of the polygon, so that the chart has to be cut.
TEST(Flatten_to_rectangle, has_straight_sides_beside_spikes)
{
  int found = 0;
  for(unsigned int seed = 1; seed <= 40; ++seed) {
    const Mesh mesh = thin_star(std::pow(10, -2 - int(seed % 3)), seed);
    const std::vector<Vertex_index> corners = DCM::rectangle_corners(mesh);
    const Planar_conformal_map map = DCM::flatten_to_rectangle(mesh, corners);
    if(map.status() != DCM::Map_status::success) {
      EXPECT_EQ(map.status(), DCM::Map_status::not_rectangular);
      continue;
    }
    expect_straight_sides(flat_boundaries(map).front(), corners);
    ++found;
  }
  EXPECT_GE(found, 39);
}

TEST(Flatten_to_rectangle, takes_components_and_lengths)
{
  Mesh mesh = random_disk(1);
  mesh.add_vertex(Point(9, 9, 9));
  mesh += random_disk(2);
  const Triangulation t(mesh);
  std::vector<double> length = lengths_of(t);
  for(double& x : length)
    x *= 3;
  const std::vector<Vertex_index> corners = DCM::rectangle_corners(mesh, length_parameter(length));
  ASSERT_EQ(corners.size(), 8u);
  EXPECT_EQ(corners, DCM::rectangle_corners(mesh));
  const std::vector<Flat_boundary> boundaries =
    flat_boundaries(DCM::flatten_to_rectangle(mesh, corners, length_parameter(length)));
  ASSERT_EQ(boundaries.size(), 2u);
  for(const Flat_boundary& b : boundaries)
    expect_rectangle(b, corners);
}

// By Gauss-Bonnet, a handle needs a cone with the curvature -4 pi.
TEST(Flatten_to_rectangle, keeps_conditions_inside)
{
  const Mesh mesh = punctured(embedded_torus(6, 5), {0, 1, 2, 3});
  Conditions condition(mesh.number_of_vertices(),
                       Vertex_condition::log_scale(7)); // on the boundary
  Vertex_index cone;
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_border(v)) {
      condition[v] = Vertex_condition();
      cone = v;
    }
  condition[cone] = Vertex_condition::curvature(-4 * pi);
  const std::vector<Vertex_index> corners = DCM::rectangle_corners(mesh);
  const Planar_conformal_map map =
    DCM::flatten_to_rectangle(mesh, corners, np::vertex_condition_map(as_map(condition)));
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  EXPECT_LT(map.max_curvature_error(), 1e-10);
  for(Vertex_index v : mesh.vertices())
    if(mesh.is_border(v))
      condition[v] = Vertex_condition::curvature(
        std::count(corners.begin(), corners.end(), v) != 0 ? pi / 2 : 0);
  const Triangulation input(mesh);
  check_conditions(map, input.mesh(), condition, 1e-9);
  expect_refused([&] { DCM::flatten_to_rectangle(mesh, corners); }, "Euler characteristic");
}

TEST(Flatten_to_rectangle, keeps_cones_inside)
{
  const Mesh mesh = punctured(embedded_torus(9, 8), {0, 1, 2, 3});
  const std::vector<Vertex_index> corners = DCM::rectangle_corners(mesh);
  Conditions condition(mesh.number_of_vertices(), Vertex_condition());
  for(Vertex_index v : corners)
    condition[v] = Vertex_condition::curvature(pi / 2);
  for(const double bound : {5., 1., .6})
    expect_cones_inside(DCM::flatten_to_rectangle(mesh, corners, np::maximum_log_scale(bound)),
                        mesh, condition, bound);
}

TEST(Flatten_to_rectangle, names_what_is_wrong)
{
  const Mesh mesh = random_disk(3);
  const std::vector<Vertex_index> corners = DCM::rectangle_corners(mesh);
  const std::vector<Vertex_index> three(corners.begin(), corners.begin() + 3);
  expect_refused([&] { DCM::flatten_to_rectangle(mesh, three); }, "a boundary has 3");
  expect_refused([&] { DCM::rectangle_corners(tetrahedron()); }, "no boundary");
  expect_refused([&] { DCM::rectangle_corners(punctured(octahedron(), {0})); }, "too few vertices");
  expect_refused(
    [&] {
      DCM::rectangle_corners(punctured(random_sphere(40, 6), {0, 20}));
    },
    "several boundary loops");
}

// ---- Disks ----

TEST(Flatten_to_disk, puts_the_boundary_on_a_circle)
{
  for(unsigned int seed = 1; seed <= 8; ++seed)
    for(const Mesh& mesh : {random_disk(seed), punctured(random_sphere(40, seed), {0})}) {
      const Planar_conformal_map map = DCM::flatten_to_disk(mesh);
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      EXPECT_LT(map.max_curvature_error(), 1e-10);
      const std::vector<Flat_boundary> boundaries = flat_boundaries(map);
      ASSERT_EQ(boundaries.size(), 1u);
      expect_circle(boundaries[0]);
      check_layout(map);
    }
}

// Lengths in strips of T_3 are the lengths in the plane, even if edges of T_3 cross the boundary.
TEST(Flatten_to_disk, measures_the_boundary_in_strips)
{
  std::size_t crossed = 0;
  for(unsigned int seed = 1; seed <= 8; ++seed)
    for(const Mesh& mesh : {random_disk(seed), punctured(random_sphere(40, seed), {0})}) {
      const Planar_conformal_map map = DCM::flatten_to_disk(mesh);
      const IT::Intrinsic_triangulation<> input(mesh);
      DCM::internal::Doubled_problem problem(
        input, std::vector<Vertex_condition>(input.mesh().num_vertices()),
        DCM::Flipping::to_Delaunay);
      std::vector<double> scale;
      for(std::size_t v = 0; v < problem.size(); ++v)
        scale.push_back(log_scale(map, v));
      const std::vector<double> strips = DCM::internal::flat_boundary_lengths(problem, scale),
                                plane = DCM::internal::flat_boundary_lengths(map);
      for(IT::Edge_index e : input.mesh().edges())
        EXPECT_NEAR(strips[e.idx()], plane[e.idx()], 1e-8 * (1 + plane[e.idx()])) << seed;
      std::size_t segments = 0, edges = 0;
      for(IT::Edge_index e : input.mesh().edges())
        edges += input.mesh().is_border(e);
      for(const auto h : map.subdivision().mesh().halfedges())
        segments += map.is_original(h) && !map.is_original(IT::opposite(h));
      crossed += segments > edges;
    }
  EXPECT_GT(crossed, 0u);
}

// A regular polygon keeps its shape.
TEST(Flatten_to_disk, leaves_regular_polygons_as_they_are)
{
  const std::size_t n = 9;
  std::vector<Point> points{Point(0, 0, 0)};
  Triangles triangles;
  for(std::size_t i = 0; i < n; ++i) {
    const Complex z = std::polar(1., 2 * pi * double(i) / double(n));
    points.emplace_back(z.real(), z.imag(), 0);
    triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  const Planar_conformal_map map = DCM::flatten_to_disk(make_mesh(points, triangles));
  for(std::size_t v = 0; v <= n; ++v)
    EXPECT_NEAR(log_scale(map, v), 0, 1e-9);
}

// If no edge crosses the boundary of the double, the disk and the hemisphere are one map up to a
// Moebius transformation. So cross ratios of vertices in the plane agree.
TEST(Flatten_to_disk, is_the_hemisphere_in_the_plane)
{
  std::size_t compared = 0;
  for(unsigned int seed = 1; seed <= 12; ++seed) {
    const Mesh mesh =
      perturbed(grid(5, 5, [](double x, double y) { return Point(x, y, 0); }), 0.1, seed);
    const Planar_conformal_map disk = DCM::flatten_to_disk(mesh);
    const DCM::Spherical_conformal_map sphere = DCM::map_to_sphere(mesh);
    const auto is_crossed = [&](const DCM::Discrete_conformal_map& map) {
      const auto& s = map.subdivision().mesh();
      std::size_t boundary = 0;
      for(Edge_index e : s.edges())
        if(const Edge_index a = map.subdivision().parent_edge(Layer::A, e); a.is_valid())
          boundary +=
            map.is_original(mesh_A(map).face(mesh_A(map).halfedge(a))) !=
            map.is_original(mesh_A(map).face(mesh_A(map).opposite(mesh_A(map).halfedge(a))));
      return boundary != 20;
    };
    if(is_crossed(disk) || is_crossed(sphere))
      continue;
    ++compared;
    std::vector<Complex> z, w;
    for(Vertex_index v : mesh.vertices()) {
      z.push_back(disk(corner(mesh_A(disk), v)));
      w.push_back(DCM::Spherical_conformal_map::to_plane(sphere.position(v)));
    }
    const auto cross_ratio = [](const std::vector<Complex>& p, std::size_t i) {
      return (p[i] - p[0]) * (p[5] - p[35]) / ((p[i] - p[35]) * (p[5] - p[0]));
    };
    for(std::size_t i = 1; i < 35; ++i)
      EXPECT_LT(std::abs(cross_ratio(z, i) - cross_ratio(w, i)), 1e-8) << seed << ' ' << i;
  }
  EXPECT_GE(compared, 3u);
}

// Returns a strip or a fan of two to six triangles with random corners.
Mesh few_triangles(CGAL::Random& random)
{
  const int n = random.get_int(2, 7);
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < n + 2; ++i) {
    const double x = random.get_double(-1, 1), y = random.get_double(-1, 1);
    v.push_back(mesh.add_vertex(Point(x, y, random.get_double(-1, 1))));
  }
  const bool is_fan = random.get_bool();
  for(std::size_t i = 0; i + 2 < v.size(); ++i)
    is_fan ? mesh.add_face(v[0], v[i + 1], v[i + 2])
           : mesh.add_face(v[i + i % 2], v[i + 1 - i % 2], v[i + 2]);
  return mesh;
}

// An edge of T3 on the boundary crosses edges of T2 where the boundary does, up to rounding. So no
// piece of the surface lies beyond it, which would be cut off.
TEST(Flatten_to_disk, does_not_cut_few_triangles)
{
  CGAL::Random random(3);
  for(int i = 0; i < 400; ++i) {
    const auto map = DCM::flatten_to_disk(few_triangles(random));
    ASSERT_EQ(map.status(), DCM::Map_status::success) << i;
    const auto& mesh = map.subdivision().mesh();
    for(Halfedge_index h : mesh.halfedges()) {
      const Halfedge_index o = IT::opposite(h);
      if(map.is_original(h) && map.is_original(o)) {
        EXPECT_LE(std::abs(map.image(h) - map.image(mesh.prev(o))), 1e-9) << i << ' ' << h;
      }
    }
  }
}

TEST(Flatten_to_disk, takes_components)
{
  Mesh mesh = random_disk(1);
  mesh.add_vertex(Point(9, 9, 9));
  mesh += random_disk(2);
  const Planar_conformal_map map = DCM::flatten_to_disk(mesh);
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  const std::vector<Flat_boundary> boundaries = flat_boundaries(map);
  ASSERT_EQ(boundaries.size(), 2u);
  for(const Flat_boundary& b : boundaries)
    expect_circle(b);
  expect_refused([] { DCM::flatten_to_disk(punctured(embedded_torus(6, 5), {0})); },
                 "Euler characteristic");
  EXPECT_EQ(DCM::flatten_to_disk(Mesh()).status(), DCM::Map_status::success);
}

// With cones, the boundary need not close up in the plane, but its turning is the turning of a
// circle.
TEST(Flatten_to_disk, keeps_cones_inside)
{
  const Mesh mesh = punctured(embedded_torus(9, 8), {0, 1, 2, 3});
  const IT::Intrinsic_triangulation<> input(mesh);
  for(const double bound : {1., .6}) {
    const Planar_conformal_map map = DCM::flatten_to_disk(mesh, np::maximum_log_scale(bound));
    const std::vector<double> length = DCM::internal::flat_boundary_lengths(map);
    Conditions condition(mesh.number_of_vertices(), Vertex_condition());
    for(const auto& loop : DCM::internal::single_boundary_loops(input.mesh(), 3, "a circle")) {
      std::vector<double> side;
      for(Halfedge_index h : loop)
        side.push_back(length[input.mesh().edge(h).idx()]);
      const std::vector<double> angle = DCM::internal::circle_angles(side);
      for(std::size_t i = 0; i < loop.size(); ++i)
        condition[input.mesh().source(loop[i])] = Vertex_condition::curvature(angle[i]);
    }
    expect_cones_inside(map, mesh, condition, bound);
  }
}

// The boundary of a surface with a handle may have no circle if it has few edges. An edge can be
// longer than all others together.
TEST(Flatten_to_disk, says_if_there_is_no_circle)
{
  std::size_t successes = 0;
  for(unsigned int seed = 0; seed < 3; ++seed)
    for(const std::vector<std::size_t>& hole :
        {std::vector<std::size_t>{seed}, {2 * seed, 2 * seed + 1}, {0, 1, 2, 3}}) {
      const Mesh mesh = punctured(perturbed(embedded_torus(12, 8), 0.03, seed), hole);
      const Planar_conformal_map map = DCM::flatten_to_disk(mesh, np::cones(DCM::Cones::greedy));
      EXPECT_FALSE(map.cones().empty());
      if(map.status() == DCM::Map_status::success)
        ++successes;
      else
        EXPECT_FALSE(map.promises().empty());
    }
  EXPECT_GT(successes, 2u);
}

// Cones that are not needed would keep the boundary from a circle.
TEST(Flatten_to_disk, of_hilly_disks_needs_no_cones)
{
  for(const double height : {1., 3.})
    for(unsigned int seed = 0; seed < 10; ++seed) {
      CGAL::Random random(seed);
      const Mesh mesh =
        grid(7, 6, [&](double x, double y) { return Point(x, y, random.get_double(0, height)); });
      const Planar_conformal_map map = DCM::flatten_to_disk(mesh, np::cones(DCM::Cones::greedy));
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      for(const Flat_boundary& b : flat_boundaries(map))
        if(map.cones().empty())
          expect_circle(b);
    }
}

TEST(Flatten_to_disk, says_how_it_failed)
{
  const Mesh mesh = random_disk(1);
  const Planar_conformal_map first =
    DCM::flatten_to_disk(mesh, CGAL::parameters::number_of_iterations(1));
  EXPECT_EQ(first.status(), DCM::Map_status::not_circular);
  EXPECT_LT(first.max_curvature_error(), 1e-10); // of the angles of that round
  // If the minimization of a disk fails, the minimization of a hemisphere leads close to the
  // circle.
  const auto one_step = np::minimizer(DCM::Newton_minimizer(1e-13, 1));
  const Planar_conformal_map hemisphere = DCM::flatten_to_disk(mesh, one_step);
  EXPECT_EQ(hemisphere.status(), DCM::Map_status::success);
  EXPECT_LT(hemisphere.max_curvature_error(), 1e-10);
  check_layout(hemisphere);
  // Two disks are not a hemisphere.
  Mesh two = mesh;
  CGAL::copy_face_graph(random_disk(2), two);
  EXPECT_EQ(DCM::flatten_to_disk(two, one_step).status(), DCM::Map_status::not_converged);
  expect_refused([&] { DCM::flatten_to_disk(tetrahedron()); }, "no boundary");
  expect_refused(
    [&] {
      DCM::flatten_to_disk(punctured(random_sphere(40, 6), {0, 20}));
    },
    "several boundary loops");
}

} // namespace Test_shapes
