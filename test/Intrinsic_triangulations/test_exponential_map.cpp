// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "known_surfaces.h"

#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/tangent_vector_across.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>

namespace Test_exponential_map {

using namespace Test_surfaces;
using Geodesic = IT::Geodesic<double>;
using IT::At_boundary;
using Status = IT::Geodesic_status;

// Returns the number of the corner at `p`, or 3 if `p` is not a corner.
std::size_t corner_at(const Location& p)
{
  for(std::size_t s = 0; s < 3; ++s)
    if(p.second[s] == 1 && p.second[(s + 1) % 3] == 0 && p.second[(s + 2) % 3] == 0)
      return s;
  return 3;
}

bool is_on_border(const Location& p, const Flat_faces& faces)
{
  for(std::size_t s = 0; s < 3; ++s)
    if(p.second[(s + 2) % 3] == 0 && faces.mesh().is_border(Edge_index(faces.sides(p.first)[s])))
      return true;
  const std::size_t s = corner_at(p);
  return s < 3 && faces.mesh().is_border(faces.mesh().source(faces.sides(p.first)[s]));
}

void expect_close(const Complex& z, const Complex& w, double tolerance)
{
  EXPECT_NEAR(z.real(), w.real(), tolerance);
  EXPECT_NEAR(z.imag(), w.imag(), tolerance);
}

// ---- Surfaces in the plane, or the plane modulo a lattice ----

// Checks a geodesic that starts with `vector` and the frame `frame` at `start` in the plane.
void check_straight(const Geodesic& g, const Complex& start, const Complex& frame,
                    const Complex& vector, const Flat_places& flat)
{
  const double size = static_cast<double>(flat.faces().longest_edge());
  const Complex unit = vector / std::abs(vector);
  const Complex end_frame = flat.frame(g.end.first);
  EXPECT_LT(flat.distance(flat.place(g.end), start + g.length * frame * unit), 1e-10 * size);
  expect_close(g.direction * end_frame, frame * unit, 1e-11);
  expect_close(g.transport * end_frame, frame, 1e-11);
  if(g.status == Status::reached) {
    EXPECT_NEAR(g.length, std::abs(vector), 1e-12 * std::abs(vector));
  } else {
    EXPECT_EQ(g.status, Status::stopped_at_boundary);
    EXPECT_LT(g.length, std::abs(vector));
    EXPECT_TRUE(is_on_border(g.end, flat.faces()));
  }
}

void check_flat(Side side, const Flat_triangulation& t, unsigned int seed)
{
  const Flat_places flat(side, t);
  const Delta_complex& mesh = flat.faces().mesh();
  CGAL::Random random(seed);
  for(int i = 0; i < 200; ++i) {
    const Location p = random_location(mesh, random);
    const Complex v = random_vector(8000, random);
    check_straight(IT::trace_geodesic(t->surface(side), p, v), flat.place(p), flat.frame(p.first),
                   v, flat);
  }
  for(Vertex_index v : mesh.vertices()) {
    if(mesh.is_border(v))
      continue;
    const Complex vector = random_vector(8000, random);
    const Complex axis = flat.vector(IT::first_outgoing_halfedge(v, mesh));
    const auto& origin = t.surface().point[v];
    check_straight(IT::trace_geodesic(t->surface(side), v, vector),
                   {static_cast<double>(origin.x), static_cast<double>(origin.y)},
                   axis / std::abs(axis), vector, flat);
  }
}

// ---- Any surface ----

// Checks that a geodesic is traced back to its start.
void check_reverse(Side side, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  const double size = static_cast<double>(faces.longest_edge());
  CGAL::Random random(5);
  for(int i = 0; i < 40; ++i) {
    const Location p = random_location(faces.mesh(), random);
    const Complex v = random_vector(5 * size, random);
    const Geodesic there = IT::trace_geodesic(t.surface(side), p, v);
    const Geodesic back =
      IT::trace_geodesic(t.surface(side), there.end, -there.length * there.direction);
    EXPECT_EQ(back.status, Status::reached);
    EXPECT_LT(static_cast<double>(faces.path(p, back.end)), 1e-9 * size) << i;
    if(back.end.first == p.first) {
      expect_close(there.transport * back.transport, 1, 1e-9);
    }
  }
}

// Checks that edges are geodesics, and transport along them is the transport of the frames.
void check_edges(Side side, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  const Delta_complex& mesh = faces.mesh();
  const IT::Tangent_frames<> frames(t.surface(side));
  for(Halfedge_index h : mesh.halfedges()) {
    const Complex vector = std::polar(static_cast<double>(faces.length(h)), frames.angle(h));
    const Geodesic g = IT::trace_geodesic(t.surface(side), mesh.source(h), vector);
    EXPECT_EQ(g.status, Status::reached);
    const std::size_t s = corner_at(g.end);
    ASSERT_LT(s, 3u) << h;
    const Halfedge_index outgoing = faces.sides(g.end.first)[s];
    EXPECT_EQ(mesh.source(outgoing), mesh.target(h));
    const Complex arrival = IT::tangent_vector_at_vertex(t.surface(side), outgoing, g.direction);
    expect_close(arrival * std::abs(vector) / vector, frames.transport(h), 1e-11);
  }
}

// Returns the angle of a corner by the law of cosines.
double corner_angle(Halfedge_index h, const Flat_faces& faces)
{
  const Delta_complex& mesh = faces.mesh();
  const Real a = faces.length(h), b = faces.length(mesh.prev(h)), c = faces.length(mesh.next(h));
  return std::acos(std::clamp(static_cast<double>((a * a + b * b - c * c) / (2 * a * b)), -1., 1.));
}

// Checks that sums of corners around a vertex lead from an outgoing halfedge to the others.
void check_angles(Side side, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  const Delta_complex& mesh = faces.mesh();
  const IT::Tangent_frames<> frames(t.surface(side));
  for(Halfedge_index h : mesh.halfedges()) {
    Halfedge_index k = h;
    double angle = 0;
    do {
      expect_close(IT::tangent_vector_at_angle(t.surface(side), h, angle, 2),
                   std::polar(2., frames.angle(k)), 1e-6);
      if(mesh.is_border(k))
        break;
      angle += corner_angle(k, faces);
      k = IT::next_around_source(k, mesh);
    } while(k != h);
    if(mesh.is_border(mesh.source(h))) {
      EXPECT_THROW(IT::tangent_vector_at_angle(t.surface(side), h, angle + 7, 1),
                   IT::Invalid_input);
    }
  }
}

// Checks that the logarithm inverts the exponential map in a star, and within a face.
void check_logarithm(Side side, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  const double size = static_cast<double>(faces.longest_edge());
  CGAL::Random random(6);
  for(int i = 0; i < 40; ++i) {
    const Location p = random_location(faces.mesh(), random);
    for(Halfedge_index h : faces.sides(p.first)) {
      const Complex v = IT::logarithm(t.surface(side), h, p);
      const Geodesic g = IT::trace_geodesic(t.surface(side), faces.mesh().source(h), v);
      EXPECT_LT(static_cast<double>(faces.path(p, g.end)), 1e-12 * size);
      EXPECT_NEAR(std::abs(v), static_cast<double>(faces.distance(p, faces.on(h, 0))),
                  1e-12 * size);
    }
    Location q = random_location(faces.mesh(), random);
    q.first = p.first;
    const Geodesic g = IT::trace_geodesic(t.surface(side), p, IT::logarithm(t.surface(side), p, q));
    EXPECT_LT(static_cast<double>(faces.path(q, g.end)), 1e-12 * size);
  }
}

// Checks that every piece between recorded points is in one face, and the lengths add up.
void check_path(Side side, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  const Delta_complex& mesh = faces.mesh();
  const double size = static_cast<double>(faces.longest_edge());
  CGAL::Random random(8);
  for(int i = 0; i < 20; ++i) {
    const Location p = random_location(mesh, random);
    std::vector<Edge_place> path;
    const Geodesic g = IT::trace_geodesic(t.surface(side), p, random_vector(5 * size, random),
                                          At_boundary::stop, std::back_inserter(path));
    Location from = p;
    Real sum = 0;
    for(const Edge_place& crossing : path) {
      ASSERT_EQ(mesh.face(crossing.halfedge), from.first);
      sum += faces.distance(from, faces.on(crossing.halfedge, crossing.t));
      from = faces.on(mesh.opposite(crossing.halfedge), 1 - crossing.t);
    }
    ASSERT_EQ(from.first, g.end.first);
    sum += faces.distance(from, g.end);
    EXPECT_NEAR(static_cast<double>(sum), g.length, 1e-10 * size);
  }
}

// ---- The two triangulations of one surface ----

// Checks that geodesics from vertices are equal on both sides.
void check_independence(const Triangulation& t, int count, double tolerance)
{
  const Correspondence c(t);
  const Flat_faces faces(Side::intrinsic, t);
  const double size = longest_input_edge(t);
  CGAL::Random random(9);
  for(int i = 0; i < count; ++i) {
    const Vertex_index v = random_vertex(t.mesh(), random);
    const Complex vector = random_vector(3 * size, random);
    const Geodesic on_intrinsic = IT::trace_geodesic(t.intrinsic(), v, vector);
    const Geodesic on_input = IT::trace_geodesic(
      t, Side::input, v, IT::tangent_vector_across(t, Side::intrinsic, v, vector));
    EXPECT_EQ(on_intrinsic.status, on_input.status);
    EXPECT_NEAR(on_intrinsic.length, on_input.length, tolerance * size);
    EXPECT_LT(static_cast<double>(
                faces.path(on_intrinsic.end, IT::point_across(c, Side::input, on_input.end))),
              tolerance * size)
      << i;
  }
}

// ---- A cone ----

// Checks that the geodesic is a straight line if the cone is unrolled.
void check_cone(const Cone& cone, unsigned int seed)
{
  CGAL::Random random(seed);
  for(int i = 0; i < 100; ++i) {
    const Geodesic out =
      IT::trace_geodesic(cone.mesh.input(), cone.apex, std::polar(0.3, random.get_double(-pi, pi)));
    const Complex from = cone.polar(out.end);
    EXPECT_NEAR(from.real(), 0.3, 1e-12);
    const Complex v = std::polar(random.get_double(0, 0.5), random.get_double(-pi, pi));
    const Geodesic g = IT::trace_geodesic(cone.mesh.input(), out.end, v * cone.outwards(out.end));
    const Complex end = 0.3 + v, to = cone.polar(g.end);
    EXPECT_EQ(g.status, Status::reached);
    EXPECT_NEAR(to.real(), std::abs(end), 1e-11);
    const double turn = (to.imag() - from.imag() - std::arg(end)) / cone.total;
    EXPECT_NEAR(turn, std::round(turn), 1e-10);
    expect_close(g.direction / cone.outwards(g.end), v / std::abs(v) * std::abs(end) / end, 1e-9);
  }
}

// Returns the rotation of a vector after a polygon around the apex.
Complex holonomy(const Cone& cone)
{
  const int corners = 100;
  const double step = cone.total / corners;
  const Geodesic out = IT::trace_geodesic(cone.mesh.input(), cone.apex, std::polar(0.4, 0.3));
  Location p = out.end;
  const Complex start = cone.outwards(p);
  Complex vector = start;
  for(int i = 0; i < corners; ++i) {
    const Complex chord = std::polar(0.8 * std::sin(step / 2), pi / 2 + step / 2);
    const Geodesic g = IT::trace_geodesic(cone.mesh.input(), p, chord * cone.outwards(p));
    vector *= g.transport;
    p = g.end;
  }
  EXPECT_LT(static_cast<double>(Flat_faces(Side::input, cone.mesh).path(p, out.end)), 1e-10);
  return vector / cone.outwards(p);
}

// ---- Others ----

// Returns a square of width 3 with its boundary.
Triangulation square()
{
  return Triangulation(grid(3, 3, [](double x, double y) { return Point(x, y, 0); }));
}

// Returns the frame coordinates of a vector in space that is in the plane of `f`.
Complex in_frame(const Kernel::Vector_3& v, Face_index f, const Mesh& mesh)
{
  const auto [a, b, c] = corners(f, mesh);
  const Kernel::Vector_3 n = CGAL::cross_product(b - a, c - a), x = b - a,
                         y = CGAL::cross_product(n, x);
  return {v * x / std::sqrt(x.squared_length()), v * y / std::sqrt(y.squared_length())};
}

void expect_at(const Geodesic& g, const Point& p, const Mesh& mesh)
{
  EXPECT_LT(CGAL::squared_distance(place_in_space(g.end, mesh), p), 1e-24)
    << place_in_space(g.end, mesh);
}

Geodesic trace_in_space(const Point& p, const Kernel::Vector_3& v, const Mesh& mesh,
                        At_boundary at_boundary = At_boundary::stop)
{
  const Location start = locate(p, mesh);
  return IT::trace_geodesic(Triangulation(mesh).input(), start, in_frame(v, start.first, mesh),
                            at_boundary);
}

// Returns two rows of needles between two lines of points that are close together.
Flat_surface needles(int n, int width, int height)
{
  std::vector<Vector> points;
  CGAL::Random random(3);
  for(int i = 0; i <= n; ++i)
    for(int row = 0; row < 3; ++row)
      points.push_back({width * i + (row == 1 ? random.get_int(0, height / 3) : 0), height * row});
  return flat_surface(points, lattice(static_cast<std::size_t>(n), 2));
}

TEST(Exponential_map, straight_in_the_plane_and_around_a_torus)
{
  for(const auto& [s, seed] : traced(flat_surfaces(), 3)) {
    Flat_triangulation flat(s.surface);
    flat.flip_at_random(20 * s.surface.mesh.number_of_edges(), seed);
    for(Side side : both_sides)
      check_flat(side, flat, seed);
  }
}

TEST(Exponential_map, back_to_the_start) { check_all(check_reverse); }

TEST(Exponential_map, edges_end_at_vertices) { check_all(check_edges); }

TEST(Exponential_map, angles_run_along_all_faces) { check_all(check_angles); }

TEST(Exponential_map, inverse_of_the_logarithm) { check_all(check_logarithm); }

TEST(Exponential_map, path_in_pieces) { check_all(check_path); }

TEST(Exponential_map, same_on_both_triangulations)
{
  for(const Named_triangulation& t : traced(triangulations()))
    check_independence(t.triangulation, 40, 1e-9);
}

TEST(Exponential_map, same_on_both_triangulations_from_inserted_vertices)
{
  for(const Named_triangulation& named : traced(triangulations())) {
    Triangulation t = named.triangulation;
    IT::refine(t);
    check_independence(t, 100, 1e-9);
  }
}

// In the frame of the face, the vertex is an ordinary point.
TEST(Exponential_map, from_a_vertex_inserted_in_a_face)
{
  Triangulation t(random_sphere(40, 1));
  IT::refine(t);
  CGAL::Random random(3);
  int count = 0;
  for(Vertex_index v : t.mesh().vertices()) {
    if(!t.is_inserted(v) || IT::on_edge(t.inserted_vertex(v)))
      continue;
    const Complex vector = random_vector(2, random);
    const Geodesic a = IT::trace_geodesic(t, Side::input, v, vector);
    const Geodesic b = IT::trace_geodesic(
      t.input(), IT::face_location(t.inserted_vertex(v), t.input_mesh()), vector);
    EXPECT_EQ(a.end, b.end);
    EXPECT_EQ(a.transport, b.transport);
    ++count;
  }
  EXPECT_GT(count, 5);
}

// The directions along the two halfedges of T1 lead to their ends, and transport is the transport
// of the frames.
TEST(Exponential_map, from_a_vertex_inserted_on_an_edge)
{
  Triangulation t(punctured(random_sphere(40, 6), {0, 20, 50}));
  IT::Vertex_inserter<> inserter(t);
  for(Edge_index e : t.input_mesh().edges())
    inserter.split_edge(Halfedge_index(2 * e.idx()), 0.3);
  const Delta_complex& mesh = t.input_mesh();
  for(Vertex_index v : t.mesh().vertices())
    for(Delta_complex::size_type r : {0u, 1u}) {
      if(!t.is_inserted(v))
        continue;
      const Halfedge_index h = t.outgoing_halfedges().halfedge(v, r);
      const double length = t.input_length(mesh.edge(h)) * (1 - t.place_along(h, v));
      const Complex vector = length * Complex(r == 0 ? 1 : -1);
      const Geodesic g = IT::trace_geodesic(t, Side::input, v, vector);
      EXPECT_EQ(g.status, Status::reached);
      const std::size_t s = corner_at(g.end);
      ASSERT_LT(s, 3u);
      EXPECT_EQ(mesh.source(Flat_faces(Side::input, t).sides(g.end.first)[s]), mesh.target(h));
      expect_close(g.transport * vector / length, g.direction, 1e-14);
    }
}

TEST(Exponential_map, same_on_both_triangulations_of_data)
{
  for_data_meshes(
    {"elephant.off", "oblong.off", "camel.off", "pig.off", "knot1.off", "hand.off", "cheese.off"},
    [](const Mesh& mesh) {
      Triangulation t(mesh);
      IT::make_Delaunay(t);
      check_independence(t, 100, 1e-9);
    });
}

TEST(Exponential_map, unrolled_cone)
{
  for(const Cone& cone : cones()) {
    SCOPED_TRACE(cone.total);
    check_cone(cone, 1);
  }
}

TEST(Exponential_map, holonomy_of_a_cone)
{
  for(const Cone& cone : cones()) {
    SCOPED_TRACE(cone.total);
    expect_close(holonomy(cone), std::polar(1., 2 * pi - cone.total), 1e-9);
  }
}

TEST(Exponential_map, over_the_edges_of_a_cube)
{
  const Mesh mesh = cube();
  expect_at(trace_in_space({0.3, 0.2, 0}, {-0.5, 0.25, 0}, mesh), {0, 0.45, 0.2}, mesh);
  expect_at(trace_in_space({0.5, 0.25, 1}, {0, -1.5, 0}, mesh), {0.5, 0.25, 0}, mesh);
  for(double x : {0.1, 0.5, 0.7}) // around four faces
    expect_at(trace_in_space({x, 0.3, 0}, {0, 4, 0}, mesh), {x, 0.3, 0}, mesh);
  const double side = 0.5; // around six faces: a regular hexagon
  expect_at(trace_in_space({0.5, 0, 0}, {-6 * side, 6 * side, 0}, mesh), {0.5, 0, 0}, mesh);
}

// The angle on either side of a cube's corner is three quarters of pi.
TEST(Exponential_map, straight_on_at_a_vertex)
{
  const Mesh mesh = cube();
  const double root = std::sqrt(0.5);
  expect_at(trace_in_space({0.5, 0.5, 0}, {-1, -1, 0}, mesh), {0, 0, 2 * root - root}, mesh);
  expect_at(trace_in_space({0, 0, 0.5}, {0, 0, -1}, mesh), {0.5 * root, 0.5 * root, 0}, mesh);
}

TEST(Exponential_map, stops_at_the_boundary)
{
  const Mesh mesh = grid(3, 3, [](double x, double y) { return Point(x, y, 0); });
  const Geodesic g = trace_in_space({1.5, 1.2, 0}, {0, -5, 0}, mesh);
  EXPECT_EQ(g.status, Status::stopped_at_boundary);
  EXPECT_NEAR(g.length, 1.2, 1e-12);
  expect_at(g, {1.5, 0, 0}, mesh);
  const Geodesic at_vertex = trace_in_space({1.5, 0.5, 0}, {-5, -5, 0}, mesh);
  EXPECT_EQ(at_vertex.status, Status::stopped_at_boundary);
  expect_at(at_vertex, {1, 0, 0}, mesh);
  const Geodesic from_boundary = trace_in_space({1.5, 0, 0}, {1, -1, 0}, mesh);
  EXPECT_EQ(from_boundary.status, Status::stopped_at_boundary);
  EXPECT_EQ(from_boundary.length, 0);
}

// A geodesic along a border of the square continues past its vertices, and stops at the corner.
TEST(Exponential_map, runs_along_a_straight_border)
{
  const Mesh mesh = grid(3, 3, [](double x, double y) { return Point(x, y, 0); });
  for(const Kernel::Vector_3& v : {Kernel::Vector_3(1, 0, 0), Kernel::Vector_3(-1, 0, 0)}) {
    const double length = 1.4, start = v.x() > 0 ? 0.1 : 2.9;
    const Geodesic g = trace_in_space({start, 0, 0}, length * v, mesh);
    EXPECT_EQ(g.status, Status::reached);
    EXPECT_NEAR(g.length, length, 1e-12);
    const Geodesic far = trace_in_space({start, 0, 0}, 9 * v, mesh);
    EXPECT_EQ(far.status, Status::stopped_at_boundary);
    EXPECT_NEAR(far.length, 2.9, 1e-12);
  }
}

// Transport along the straight parts of the boundary keeps a vector; a corner turns it with the
// boundary.
TEST(Exponential_map, slides_along_the_boundary)
{
  const Mesh mesh = grid(3, 3, [](double x, double y) { return Point(x, y, 0); });
  const Kernel::Vector_3 right(1, 0, 0), up(0, 1, 0), down(0, -1, 0);
  const auto check = [&](const Point& p, const Kernel::Vector_3& v, const Point& end,
                         const Kernel::Vector_3& turned_right) {
    const Geodesic g = trace_in_space(p, v, mesh, At_boundary::slide);
    EXPECT_EQ(g.status, Status::slid_along_boundary);
    EXPECT_NEAR(g.length, std::sqrt(v.squared_length()), 1e-12);
    expect_at(g, end, mesh);
    expect_close(g.transport * in_frame(right, locate(p, mesh).first, mesh),
                 in_frame(turned_right, g.end.first, mesh), 1e-12);
  };
  check({1.4, 0.3, 0}, {0.3, -0.4, 0}, {1.75, 0, 0}, right);
  check({1.4, 0.3, 0}, {-0.3, -0.4, 0}, {1.05, 0, 0}, right);
  check({1.4, 0.3, 0}, {0, -2, 0}, {3, 0.1, 0}, up); // left if to neither side
  check({1.5, 0.75, 0}, {1.2, -1.6, 0}, {3, 0.125, 0}, up);
  check({1.5, 0.5, 0}, {-2, -2, 0}, {0, std::sqrt(4.5) - 1, 0}, down); // from a vertex
}

TEST(Exponential_map, slides_from_a_boundary_vertex)
{
  const Triangulation t = square();
  for(double angle : {-0.5, -pi / 2, pi + 0.5}) {
    const Geodesic g =
      IT::trace_geodesic(t.input(), Vertex_index(4), std::polar(1., angle), At_boundary::slide);
    EXPECT_EQ(g.status, Status::slid_along_boundary);
    const Halfedge_index outgoing = Flat_faces(Side::input, t).sides(g.end.first)[corner_at(g.end)];
    EXPECT_EQ(t.input_mesh().source(outgoing), Vertex_index(angle < 0 ? 8 : 0));
  }
}

// Thin faces cost no digits: as many are correct as with longer numbers.
TEST(Exponential_map, needles)
{
  for(const int height : {1000, 1000000, 1000000000}) {
    const Flat_surface surface = needles(40, 1, height);
    const Triangulation t = triangulation(surface);
    std::vector<long double> lengths;
    for(Edge_index e : t.mesh().edges())
      lengths.push_back(t.length(e));
    const auto map =
      boost::make_function_property_map<Edge_index>([&](Edge_index e) { return lengths[e.idx()]; });
    CGAL::Random random(1);
    for(int i = 0; i < 300; ++i) {
      const Location p = random_location(t.mesh(), random);
      const Complex v = random_vector(i % 2 == 0 ? height : 20, random);
      const Geodesic g = IT::trace_geodesic(t.input(), p, v);
      const auto exact = IT::trace_geodesic(
        IT::Surface_view(t.mesh(), map),
        IT::Face_location<long double>(p.first, {p.second[0], p.second[1], p.second[2]}),
        std::complex<long double>(v.real(), v.imag()));
      const Location q(exact.end.first, {static_cast<double>(exact.end.second[0]),
                                         static_cast<double>(exact.end.second[1]),
                                         static_cast<double>(exact.end.second[2])});
      EXPECT_EQ(g.status, exact.status);
      EXPECT_LT(static_cast<double>(Flat_faces(Side::input, t).path(g.end, q)), 1e-12 * height)
        << height << ' ' << i;
    }
    check_reverse(Side::input, t);
    check_logarithm(Side::input, t);
    check_path(Side::input, t);
  }
}

// Eight faces are in the plane, four of them on a line. A geodesic may start or end in any face of
// this line, and its points agree with the plane.
TEST(Exponential_map, faces_without_area)
{
  const Mesh mesh = make_mesh(
    {{4, -2, 0}, {6, 0, 0}, {4, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}, {5, 0, 0}, {3, 2, 0}},
    {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {2, 1, 6}, {2, 6, 4}, {4, 6, 5}, {5, 6, 7}, {4, 5, 7}});
  const Triangulation t(mesh);
  CGAL::Random random(4);
  for(int i = 0; i < 2000; ++i) {
    const Location p = random_location(t.mesh(), random);
    const Complex v = random_vector(3, random);
    const Geodesic g = IT::trace_geodesic(t.input(), p, v);
    const Halfedge_index h = mesh.halfedge(p.first);
    const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h));
    const Complex axis(b.x() - a.x(), b.y() - a.y());
    const Complex step = std::polar(g.length, std::arg(v) + std::arg(axis));
    const Point start = place_in_space(p, mesh);
    expect_at(g, start + Kernel::Vector_3(step.real(), step.imag(), 0), mesh);
    expect_at(IT::trace_geodesic(t.input(), g.end, -g.length * g.direction), start, mesh);
  }
}

TEST(Exponential_map, no_length)
{
  const Triangulation t(cube());
  const Location p{Face_index(3), {0.2, 0.3, 0.5}};
  const Geodesic g = IT::trace_geodesic(t.input(), p, Complex(0));
  EXPECT_EQ(g.status, Status::reached);
  EXPECT_EQ(g.end, p);
  EXPECT_EQ(g.length, 0);
  EXPECT_EQ(g.transport, Complex(1));
}

TEST(Exponential_map, endless_lengths_are_refused)
{
  const Triangulation t(cube());
  EXPECT_THROW(IT::trace_geodesic(t.input(), Vertex_index(0), Complex(1e30)), IT::Numerical_error);
  const Triangulation s = square();
  EXPECT_THROW(
    IT::trace_geodesic(s.input(), Vertex_index(0), Complex(0, -1e30), At_boundary::slide),
    IT::Numerical_error);
}

} // namespace Test_exponential_map
