// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "known_surfaces.h"

#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/tangent_vector_across.h>
#include <CGAL/Surface_mesh_shortest_path.h>

namespace Test_logarithmic_map {

using namespace Test_surfaces;
using Logarithm = IT::Logarithm<double>;
using Status = IT::Logarithm_status;

// Returns the shortest of all straight lines, through copies of the plane.
double shortest(const Complex& d, const Flat_surface& surface)
{
  const Vector &a = surface.a, &b = surface.b;
  double result = std::numeric_limits<double>::infinity();
  for(int i = -40; i <= 40; ++i)
    for(int j = -40; j <= 40; ++j)
      result = (std::min)(result, std::abs(d + complex(i * a + j * b)));
  return result;
}

// Checks that the line along the logarithm ends at its point. Close to a vertex with curvature, a
// line can be on the wrong side by rounding. A path can touch the boundary.
template <typename Source>
void expect_end(Side side, const Source& source, const Location& target, const Logarithm& logarithm,
                const Triangulation& t, double tolerance)
{
  const auto g =
    IT::trace_geodesic(t.surface(side), source, logarithm.vector, IT::At_boundary::slide);
  EXPECT_LT(static_cast<double>(Flat_faces(side, t).path(g.end, target)), tolerance)
    << logarithm.vector;
}

Location at_vertex(Side side, Vertex_index v, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  const Halfedge_index h = IT::first_outgoing_halfedge(v, faces.mesh());
  return faces.on(h, 0);
}

// ---- Surfaces in the plane, or the plane modulo a lattice ----

void check_flat(Side side, const Flat_triangulation& t, unsigned int seed)
{
  const Flat_places flat(side, t);
  const double size = static_cast<double>(flat.faces().longest_edge());
  CGAL::Random random(seed);
  for(int i = 0; i < 50; ++i) {
    const Location p = random_location(flat.faces().mesh(), random);
    const Location q = random_location(flat.faces().mesh(), random);
    const Logarithm logarithm = IT::logarithmic_map(t->surface(side), p, q);
    EXPECT_EQ(logarithm.status, Status::straight);
    EXPECT_NEAR(std::abs(logarithm.vector), shortest(flat.place(p) - flat.place(q), t.surface()),
                1e-11 * size);
    expect_end(side, p, q, logarithm, *t, 1e-10 * size);
  }
  for(Vertex_index v : flat.faces().mesh().vertices()) {
    const Location q = random_location(flat.faces().mesh(), random);
    const Logarithm logarithm = IT::logarithmic_map(t->surface(side), v, q);
    EXPECT_EQ(logarithm.status, Status::straight);
    EXPECT_NEAR(std::abs(logarithm.vector),
                shortest(flat.place(at_vertex(side, v, *t)) - flat.place(q), t.surface()),
                1e-11 * size);
    expect_end(side, v, q, logarithm, *t, 1e-10 * size);
  }
}

// ---- Any surface ----

// Checks that straight lines lead to the ends of straight paths, and distances are symmetric.
void check_inverse(Side side, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  const double size = static_cast<double>(faces.longest_edge());
  CGAL::Random random(7);
  for(int i = 0; i < 30; ++i) {
    const Location p = random_location(faces.mesh(), random);
    const Location q = random_location(faces.mesh(), random);
    const Logarithm logarithm = IT::logarithmic_map(t.surface(side), p, q);
    const Logarithm back = IT::logarithmic_map(t.surface(side), q, p);
    EXPECT_EQ(logarithm.status, back.status);
    EXPECT_NEAR(std::abs(logarithm.vector), std::abs(back.vector), 1e-12 * size);
    if(logarithm.status == Status::straight)
      expect_end(side, p, q, logarithm, t, 1e-9 * size);
  }
}

// Checks that a line is at least as long as the logarithm of its end.
void check_lines(Side side, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  const double size = static_cast<double>(faces.longest_edge());
  CGAL::Random random(8);
  for(int i = 0; i < 30; ++i) {
    const Location p = random_location(faces.mesh(), random);
    const auto g = IT::trace_geodesic(t.surface(side), p, random_vector(3 * size, random));
    EXPECT_LE(std::abs(IT::logarithmic_map(t.surface(side), p, g.end).vector),
              g.length + 1e-9 * size);
  }
}

void check_all_at_once(Side side, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  const auto of_vertices = IT::logarithmic_map(t.surface(side), Vertex_index(0));
  CGAL::Random random(9);
  const Location p = random_location(faces.mesh(), random);
  const auto at_point = IT::logarithmic_map(t.surface(side), p);
  for(Vertex_index v : faces.mesh().vertices()) {
    const Location q = at_vertex(side, v, t);
    const Logarithm one = IT::logarithmic_map(t.surface(side), Vertex_index(0), q);
    EXPECT_EQ(one.status, of_vertices[v].status);
    EXPECT_DOUBLE_EQ(std::abs(one.vector), std::abs(of_vertices[v].vector));
    EXPECT_DOUBLE_EQ(std::abs(IT::logarithmic_map(t.surface(side), p, q).vector),
                     std::abs(at_point[v].vector));
    // The rounded lengths of T2 let lines miss vertices that they pass by symmetry.
    if(one.status == Status::straight && side == Side::input)
      expect_end(side, Vertex_index(0), q, one, t,
                 1e-9 * static_cast<double>(faces.longest_edge()));
  }
}

// ---- CGAL's shortest paths ----

void check_with_CGAL(const Mesh& mesh)
{
  typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh> Traits;
  const Triangulation t(mesh);
  CGAL::Random random(11);
  for(int i = 0; i < 3; ++i) {
    const Location p = random_location(t.input_mesh(), random);
    CGAL::Surface_mesh_shortest_path<Traits> paths(mesh);
    i == 0 ? paths.add_source_point(Vertex_index(0))
           : paths.add_source_point(p.first, {p.second[0], p.second[1], p.second[2]});
    const auto logarithms =
      i == 0 ? IT::logarithmic_map(t.input(), Vertex_index(0)) : IT::logarithmic_map(t.input(), p);
    for(Vertex_index v : mesh.vertices()) {
      const double truth = paths.shortest_distance_to_source_points(v).first;
      const double distance = std::abs(logarithms[v].vector);
      if(truth < 0) // unreachable
        EXPECT_EQ(distance, std::numeric_limits<double>::infinity());
      else
        EXPECT_NEAR(distance, truth, 1e-12 * (1 + truth));
    }
  }
}

TEST(Logarithmic_map, in_a_strip_and_around_a_torus)
{
  for(const Named_surface& s : flat_surfaces()) {
    if(s.name.find("grid") != std::string::npos) // not convex
      continue;
    SCOPED_TRACE(s.name);
    Flat_triangulation flat(s.surface);
    flat.flip_at_random(20 * s.surface.mesh.number_of_edges(), 1);
    for(Side side : both_sides)
      check_flat(side, flat, 1);
  }
}

TEST(Logarithmic_map, inverse_of_the_exponential_map) { check_all(check_inverse); }

TEST(Logarithmic_map, no_line_is_shorter) { check_all(check_lines); }

TEST(Logarithmic_map, of_all_vertices) { check_all(check_all_at_once); }

TEST(Logarithmic_map, distances_as_in_CGAL)
{
  for(const Named_mesh& m : traced(meshes()))
    check_with_CGAL(m.mesh);
}

TEST(Logarithmic_map, distances_as_in_CGAL_on_data_meshes)
{
  for_data_meshes({"elephant.off", "pig.off", "anchor.off", "ALSTOM_TEST4.off"},
                  [](const Mesh& mesh) { check_with_CGAL(mesh); });
}

// Below half the distance of the nearest vertex the exponential map of these spheres is injective.
TEST(Logarithmic_map, logarithm_of_the_exponential_map)
{
  for(unsigned int seed = 0; seed < 10; ++seed) {
    const Triangulation t(random_sphere(60, seed));
    CGAL::Random random(seed);
    for(int i = 0; i < 50; ++i) {
      const Location p = random_location(t.mesh(), random);
      double nearest = std::numeric_limits<double>::infinity();
      for(const Logarithm& logarithm : IT::logarithmic_map(t.input(), p))
        nearest = (std::min)(nearest, std::abs(logarithm.vector));
      const Complex v = random_vector(nearest / 2, random);
      const auto g = IT::trace_geodesic(t.input(), p, v);
      const Logarithm logarithm = IT::logarithmic_map(t.input(), p, g.end);
      EXPECT_EQ(logarithm.status, Status::straight);
      EXPECT_LT(std::abs(logarithm.vector - v), 1e-13);
    }
  }
}

TEST(Logarithmic_map, same_on_both_triangulations)
{
  for(unsigned int seed = 0; seed < 5; ++seed) {
    Triangulation t(random_sphere(40, seed));
    flip_at_random(t, 2000, seed);
    const Correspondence c(t);
    CGAL::Random random(seed);
    for(Vertex_index v : t.mesh().vertices()) {
      const Location q = random_location(t.input_mesh(), random);
      const Logarithm on_input = IT::logarithmic_map(t.input(), v, q);
      const Logarithm on_intrinsic =
        IT::logarithmic_map(t.intrinsic(), v, IT::point_across(c, Side::input, q));
      EXPECT_EQ(on_input.status, on_intrinsic.status);
      EXPECT_LT(std::abs(IT::tangent_vector_across(t, Side::intrinsic, v, on_intrinsic.vector) -
                         on_input.vector),
                1e-9);
    }
  }
}

// On the unrolled cone, the shortest path is a straight line, or it passes the apex.
TEST(Logarithmic_map, on_a_cone)
{
  for(const Cone& cone : cones()) {
    SCOPED_TRACE(cone.total);
    CGAL::Random random(1);
    for(int i = 0; i < 100; ++i) {
      const auto place = [&] {
        const Complex v = std::polar(random.get_double(0.1, 1), random.get_double(-pi, pi));
        return IT::trace_geodesic(cone.mesh.input(), cone.apex, v).end;
      };
      const Location p = place(), q = place();
      const Complex from = cone.polar(p), to = cone.polar(q);
      const double turn = std::remainder(to.imag() - from.imag(), cone.total);
      const Logarithm logarithm = IT::logarithmic_map(cone.mesh.input(), p, q);
      const bool is_straight = std::abs(turn) < pi;
      EXPECT_EQ(logarithm.status, is_straight ? Status::straight : Status::bent);
      const Complex truth =
        is_straight ? to.real() * std::polar(1., turn) - from.real() : -from.real() - to.real();
      EXPECT_LT(std::abs(logarithm.vector / cone.outwards(p) - truth), 1e-9);
    }
  }
}

TEST(Logarithmic_map, over_the_edges_of_a_cube)
{
  const Triangulation t(cube());
  const auto logarithms = IT::logarithmic_map(t.input(), Vertex_index(0));
  for(std::size_t v = 0; v < 8; ++v) {
    const int different =
      static_cast<int>(v & 1) + static_cast<int>(v >> 1 & 1) + static_cast<int>(v >> 2);
    const double truth = different < 2 ? different : different == 2 ? std::sqrt(2.) : std::sqrt(5.);
    EXPECT_NEAR(std::abs(logarithms[v].vector), truth, 1e-14);
    EXPECT_EQ(logarithms[v].status, Status::straight);
  }
  // The path leads between the midpoints of diagonals, the centers of opposite sides.
  const Location bottom{Face_index(0), {0.5, 0, 0.5}}, top{Face_index(2), {0.5, 0, 0.5}};
  EXPECT_NEAR(std::abs(IT::logarithmic_map(t.input(), bottom, top).vector), 2, 1e-14);
}

// The surface consists of four unit squares without the first one. The path from corner to corner
// bends at their common corner.
TEST(Logarithmic_map, bends_at_the_boundary)
{
  const Triangulation t(
    punctured(grid(2, 2, [](double x, double y) { return Point(x, y, 0); }), {0, 1}));
  const auto logarithms = IT::logarithmic_map(t.input(), Vertex_index(1));
  EXPECT_EQ(logarithms[3].status, Status::bent);
  EXPECT_NEAR(std::abs(logarithms[3].vector), 2, 1e-15);
  EXPECT_NEAR(std::arg(logarithms[3].vector), 0, 1e-15);
  EXPECT_EQ(logarithms[4].status, Status::straight);
  EXPECT_EQ(logarithms[7].status, Status::straight); // straight on along the edge
}

// Rounding gives needles on a folded strip some curvature, but no shadow that paths cannot reach.
TEST(Logarithmic_map, needles)
{
  const auto height = [](double x) { return 0.3 * std::sin(x); };
  const Triangulation t(
    grid(60, 60, [&](double x, double y) { return Point(x, 1e-5 * y, height(x)); }));
  const auto logarithms = IT::logarithmic_map(t.input(), Vertex_index(0));
  double unrolled = 0;
  for(std::size_t i = 0; i <= 60; ++i) {
    for(std::size_t j = 0; j <= 60; ++j)
      EXPECT_NEAR(std::abs(logarithms[61 * i + j].vector),
                  std::hypot(unrolled, 1e-5 * static_cast<double>(j)), 1e-10);
    const double x = static_cast<double>(i);
    unrolled += std::hypot(1, height(x + 1) - height(x));
  }
}

TEST(Logarithmic_map, itself)
{
  const Triangulation t(cube());
  const Location p{Face_index(3), {0.2, 0.3, 0.5}}, corner{Face_index(3), {0, 1, 0}};
  EXPECT_EQ(IT::logarithmic_map(t.input(), p, p).vector, Complex(0));
  const Vertex_index v = t.input_mesh().target(t.input_mesh().halfedge(Face_index(3)));
  EXPECT_EQ(IT::logarithmic_map(t.input(), v, corner).vector, Complex(0));
}

// Paths start on an edge and lead into both of its faces.
TEST(Logarithmic_map, from_an_edge)
{
  const Triangulation t(cube());
  for(Halfedge_index h : t.input_mesh().halfedges()) {
    const Flat_faces faces(Side::input, t);
    const Location p = faces.on(h, 0.3);
    for(Halfedge_index x : {h, t.input_mesh().opposite(h)}) {
      const Location q{t.input_mesh().face(x), {0.2, 0.3, 0.5}};
      const Logarithm logarithm = IT::logarithmic_map(t.input(), p, q);
      EXPECT_NEAR(std::abs(logarithm.vector),
                  static_cast<double>(faces.distance(faces.on(x, x == h ? 0.3 : 0.7), q)), 1e-14);
      expect_end(Side::input, p, q, logarithm, t, 1e-14);
    }
  }
}

TEST(Logarithmic_map, other_component)
{
  Mesh mesh = tetrahedron();
  mesh.join(cube());
  const Triangulation t(mesh);
  const auto logarithms = IT::logarithmic_map(t.input(), Vertex_index(0));
  for(std::size_t v = 4; v < 12; ++v) {
    EXPECT_EQ(logarithms[v].status, Status::unreachable);
    EXPECT_EQ(std::abs(logarithms[v].vector), std::numeric_limits<double>::infinity());
  }
  const Location p{Face_index(0), {0.2, 0.3, 0.5}}, q{Face_index(9), {0.2, 0.3, 0.5}};
  EXPECT_EQ(IT::logarithmic_map(t.input(), p, q).status, Status::unreachable);
}

} // namespace Test_logarithmic_map
