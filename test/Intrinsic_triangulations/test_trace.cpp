// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hard_meshes.h"
#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/trace.h>
#include <CGAL/Intrinsic_triangulations/trace_edge.h>

namespace Test_trace {

using namespace Test_surfaces;
using Trace = std::vector<Trace_place>;

// Returns the position along the first halfedge of the edge.
double along_edge(const Edge_place& p) { return IT::place_on_first_halfedge(p); }

// ---- Every trace ----

// Checks that consecutive points are in a common face, which the trace leaves at the second point.
void check_faces(Side side, const Trace& trace, const Triangulation& t)
{
  const Delta_complex& mesh = Flat_faces(other(side), t).mesh();
  if(trace.size() == 2) {
    EXPECT_EQ(on(other(side), trace[0]).halfedge, on(other(side), trace[1]).halfedge);
    return;
  }
  const auto halfedge = [&](std::size_t k) { return on(other(side), trace[k]).halfedge; };
  const std::size_t last = trace.size() - 1;
  EXPECT_EQ(mesh.next(halfedge(0)), halfedge(1));
  for(std::size_t k = 2; k < last; ++k)
    EXPECT_EQ(mesh.face(mesh.opposite(halfedge(k - 1))), mesh.face(halfedge(k)));
  EXPECT_EQ(mesh.opposite(mesh.prev(mesh.opposite(halfedge(last - 1)))), halfedge(last));
}

void check_ends(Side side, Halfedge_index h, const Trace& trace, const Triangulation& t)
{
  const Delta_complex& mesh = Flat_faces(side, t).mesh();
  const Delta_complex& other_mesh = Flat_faces(other(side), t).mesh();
  const Edge_place first = on(other(side), trace.front()), last = on(other(side), trace.back());
  EXPECT_EQ(on(side, trace.front()).t, 0);
  EXPECT_EQ(on(side, trace.back()).t, 1);
  EXPECT_EQ(first.t, 0);
  EXPECT_EQ(last.t, 1);
  EXPECT_EQ(other_mesh.source(first.halfedge), mesh.source(h));
  EXPECT_EQ(other_mesh.target(last.halfedge), mesh.target(h));
}

void check_order(Side side, Halfedge_index h, const Trace& trace)
{
  for(std::size_t k = 0; k < trace.size(); ++k) {
    EXPECT_EQ(on(side, trace[k]).halfedge, h);
    EXPECT_GE(on(other(side), trace[k]).t, 0);
    EXPECT_LE(on(other(side), trace[k]).t, 1);
    EXPECT_TRUE(k == 0 || on(side, trace[k - 1]).t <= on(side, trace[k]).t);
  }
}

// Checks that every piece has the length between the positions on the edge, in the faces of the
// other side.
void check_lengths(Side side, Halfedge_index h, const Trace& trace, const Triangulation& t)
{
  const Real length = Flat_faces(side, t).length(h);
  const std::vector<Real> pieces = lengths_of_pieces(side, trace, t);
  Real sum = 0;
  for(std::size_t k = 0; k < pieces.size(); ++k) {
    const Real expected = (on(side, trace[k + 1]).t - on(side, trace[k]).t) * length;
    EXPECT_NEAR(double((pieces[k] - expected) / length), 0, 1e-9);
    sum += pieces[k];
  }
  EXPECT_NEAR(double(sum / length), 1, 1e-9);
}

void expect_same(const Trace& a, const Trace& b)
{
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t k = 0; k < a.size(); ++k)
    for(Side side : both_sides) {
      EXPECT_EQ(on(side, a[k]).halfedge, on(side, b[k]).halfedge);
      EXPECT_NEAR(on(side, a[k]).t, on(side, b[k]).t, 1e-11); // of two ways to lay out an edge
    }
}

void check_traces(const Triangulation& t)
{
  const Correspondence c(t);
  for(Edge_index e : t.mesh().edges())
    EXPECT_EQ(c.number_of_crossings(Side::intrinsic, e),
              (std::max<std::int64_t>)(0, t.coordinates().normal_coordinate(e)));
  for(Side side : both_sides)
    for(Halfedge_index h : c.mesh(side).halfedges()) {
      const Trace trace = IT::trace_edge(side, h, c);
      EXPECT_EQ(trace.size(), c.number_of_crossings(side, Edge_index(h)) + 2);
      check_ends(side, h, trace, t);
      check_faces(side, trace, t);
      check_order(side, h, trace);
      check_lengths(side, h, trace, t);
      expect_same(trace, side == Side::input ? IT::trace_input_edge(t, h)
                                             : IT::trace_intrinsic_edge(t, h));
    }
}

// ---- Crossings as a set ----

struct Crossing
{
  Edge_index input, intrinsic;
  double s, t; // along their first halfedges

  std::tuple<Edge_index, Edge_index, double> key() const { return {input, intrinsic, s}; }
  friend bool operator<(const Crossing& a, const Crossing& b) { return a.key() < b.key(); }
};

std::vector<Crossing> traced_crossings(Side side, const Correspondence& c)
{
  std::vector<Crossing> result;
  for(Edge_index e : c.mesh(side).edges()) {
    const Trace trace = IT::trace_edge(side, Halfedge_index(2 * e.idx()), c);
    for(std::size_t k = 1; k + 1 < trace.size(); ++k)
      result.push_back({Edge_index(trace[k].on_input.halfedge),
                        Edge_index(trace[k].on_intrinsic.halfedge), along_edge(trace[k].on_input),
                        along_edge(trace[k].on_intrinsic)});
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_same(const std::vector<Crossing>& a, const std::vector<Crossing>& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].input, b[k].input);
    EXPECT_EQ(a[k].intrinsic, b[k].intrinsic);
    EXPECT_NEAR(a[k].s, b[k].s, tolerance);
    EXPECT_NEAR(a[k].t, b[k].t, tolerance);
  }
}

// Returns how many translates must be tested, from the longest vector and the size of the surface.
std::pair<std::int64_t, std::int64_t> translates(const Flat_triangulation& flat)
{
  const Vector a = flat.surface().a, b = flat.surface().b;
  double reach = 0;
  for(Halfedge_index h : flat->mesh().halfedges())
    reach = (std::max)({reach, length(flat.vector(h)), length(flat.input_vector(h))});
  double extent = 0;
  for(const Vector& p : flat.surface().point)
    for(const Vector& q : flat.surface().point)
      extent = (std::max)(extent, length(p - q));
  const double area = std::abs(static_cast<double>(det(a, b)));
  const double distance = 2 * reach + extent;
  return {static_cast<std::int64_t>(distance * length(b) / area),
          static_cast<std::int64_t>(distance * length(a) / area)};
}

// Adds the crossing of p + [0, 1] v and q + [0, 1] w, exact but for one rounding, if there is one.
void add_crossing(Edge_index e, const Vector& p, const Vector& v, Edge_index f, const Vector& q,
                  const Vector& w, std::vector<Crossing>& result)
{
  std::int64_t d = det(v, w), s = det(q - p, w), t = det(q - p, v);
  if(d < 0) {
    d = -d;
    s = -s;
    t = -t;
  }
  if(0 < s && s < d && 0 < t && t < d)
    result.push_back({e, f, static_cast<double>(s) / static_cast<double>(d),
                      static_cast<double>(t) / static_cast<double>(d)});
}

// Returns the crossings of all segments of T1 with all segments of T2, in integers.
std::vector<Crossing> exact_crossings(const Flat_triangulation& flat)
{
  const Flat_surface& surface = flat.surface();
  const auto [m, n] = translates(flat);
  std::vector<Crossing> result;
  for(Edge_index e : surface.mesh.edges())
    for(Edge_index f : flat->mesh().edges()) {
      const Halfedge_index g(2 * e.idx()), h(2 * f.idx());
      for(std::int64_t i = -m; i <= m; ++i)
        for(std::int64_t j = -n; j <= n; ++j)
          add_crossing(e, surface.point[surface.mesh.source(g)], surface.vector[g], f,
                       surface.point[flat->mesh().source(h)] + i * surface.a + j * surface.b,
                       flat.vector(h), result);
    }
  std::sort(result.begin(), result.end());
  return result;
}

// Checks that crossings have equal positions, and shared edges have the same vector on both sides.
void expect_exact(const Flat_triangulation& flat, double tolerance)
{
  const Correspondence c(*flat);
  const std::vector<Crossing> exact = exact_crossings(flat);
  for(Side side : both_sides)
    expect_same(traced_crossings(side, c), exact, tolerance);
  for(Edge_index e : flat->mesh().edges())
    if(c.is_shared(Side::intrinsic, e)) {
      const Trace trace = IT::trace_edge(Side::intrinsic, Halfedge_index(2 * e.idx()), c);
      EXPECT_EQ(flat.input_vector(trace[0].on_input.halfedge),
                flat.vector(trace[0].on_intrinsic.halfedge));
    }
}

Point place_in_space(const Edge_place& p, const Mesh& mesh)
{
  const Point a = mesh.point(mesh.source(p.halfedge)), b = mesh.point(mesh.target(p.halfedge));
  return a + p.t * (b - a);
}

TEST(Trace, every_trace_is_a_chain_through_flat_faces)
{
  for(const Named_triangulation& t : traced(triangulations()))
    check_traces(t.triangulation);
}

TEST(Trace, both_sides_tell_the_same_crossings)
{
  std::size_t crossings = 0;
  for(const Named_triangulation& t : traced(triangulations())) {
    const Correspondence c(t.triangulation);
    const auto from_input = traced_crossings(Side::input, c);
    expect_same(from_input, traced_crossings(Side::intrinsic, c), 1e-15);
    EXPECT_EQ(from_input.size(), c.number_of_crossings());
    crossings += from_input.size();
  }
  EXPECT_GT(crossings, 10000u);
}

TEST(Trace, lengths_in_space)
{
  for(const auto& [m, seed] : traced(meshes(), 5)) {
    Triangulation t(m.mesh);
    flip_at_random(t, 20 * m.mesh.number_of_edges(), seed);
    const Correspondence c(t);
    for(Edge_index e : t.mesh().edges()) {
      const Trace trace = IT::trace_edge(Side::intrinsic, t.mesh().halfedge(e), c);
      double sum = 0;
      for(std::size_t k = 0; k + 1 < trace.size(); ++k)
        sum += std::sqrt(CGAL::squared_distance(place_in_space(trace[k].on_input, m.mesh),
                                                place_in_space(trace[k + 1].on_input, m.mesh)));
      EXPECT_NEAR(sum / t.length(e), 1, 1e-9);
    }
  }
}

TEST(Trace, exact_crossings_on_flat_surfaces)
{
  std::size_t crossings = 0;
  for(const auto& [s, seed] : traced(flat_surfaces(), 5)) {
    Flat_triangulation flat(s.surface);
    flat.flip_at_random(20 * s.surface.mesh.number_of_edges(), seed);
    expect_exact(flat, 1e-12);
    crossings += Correspondence(*flat).number_of_crossings();
    flat.make_Delaunay();
    expect_exact(flat, 1e-12);
  }
  EXPECT_GT(crossings, 1000u);
}

TEST(Trace, recomputed_lengths_are_exact_on_flat_surfaces)
{
  for(const auto& [s, seed] : traced(flat_surfaces(), 5)) {
    Flat_triangulation flat(s.surface);
    flat.flip_at_random(20 * s.surface.mesh.number_of_edges(), seed);
    Triangulation t(*flat);
    t.recompute_lengths();
    EXPECT_TRUE(t.is_valid(true));
    for(Edge_index e : t.mesh().edges())
      EXPECT_NEAR(t.length(e) / length(flat.vector(t.mesh().halfedge(e))), 1, 1e-13);
  }
}

// The crossing edges are exact even if their positions are not.
TEST(Trace, exact_crossings_with_slivers)
{
  for(unsigned int seed : seeds(5)) {
    Flat_triangulation flat(flat_polygon(random_points(60, 1 << 19, seed)));
    flat.make_Delaunay();
    EXPECT_GT(Correspondence(*flat).number_of_crossings(), 100u);
    expect_exact(flat, 1e-7);
  }
}

// A torus is the plane modulo a lattice with a vertex at every lattice point. An edge w of T2 and
// an edge v of T1 meet at the multiples of 1 / det(v, w), in units of the lattice.
TEST(Trace, closed_form_on_a_torus_with_one_vertex)
{
  for(unsigned int seed : seeds(30)) {
    Flat_triangulation flat(flat_torus(1, 1, 0));
    flat.flip_at_random(40, seed);
    const Correspondence c(*flat);
    for(Edge_index e : flat->mesh().edges()) {
      std::vector<double> expected;
      for(Edge_index f : flat->input_mesh().edges()) {
        const Vector v = flat.input_vector(Halfedge_index(2 * f.idx()));
        const Vector w = flat.vector(Halfedge_index(2 * e.idx()));
        const auto n = std::abs(det(v, w) / det(flat.surface().a, flat.surface().b));
        for(std::int64_t k = 1; k < n; ++k)
          expected.push_back(static_cast<double>(k) / static_cast<double>(n));
      }
      std::sort(expected.begin(), expected.end());
      const Trace trace = IT::trace_edge(Side::intrinsic, Halfedge_index(2 * e.idx()), c);
      ASSERT_EQ(trace.size(), expected.size() + 2);
      for(std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_NEAR(trace[k + 1].on_intrinsic.t, expected[k], 1e-12);
    }
  }
}

TEST(Trace, correspondence_of_the_empty_surface)
{
  const Triangulation t;
  EXPECT_EQ(Correspondence(t).number_of_crossings(), 0u);
}

// ---- Crossings, without geometry ----

// Courses are computed first, and finally stored, while edges are flipped.
TEST(Edge_courses, are_those_that_are_traced)
{
  Triangulation t(random_sphere(60, 7));
  flip_at_random(t, 400, 1);
  IT::internal::Edge_courses courses(t);
  std::size_t asked = 0;
  const auto check = [&](Halfedge_index h) {
    const IT::Edge_course course = courses(h), traced = IT::internal::Edge_courses(t)(h);
    ASSERT_EQ(course.size(), traced.size());
    for(std::size_t m = 0; m < traced.size(); ++m, ++asked)
      ASSERT_EQ(course[m], traced[m]) << h << ' ' << m;
  };
  for(unsigned int seed = 2; seed < 20; ++seed) {
    flip_at_random(t, 40, seed, [&](Halfedge_index h) {
      courses.after_flip(h);
      check(h);
    });
    if(seed > 10)
      for(Halfedge_index h : t.mesh().halfedges())
        check(h);
  }
  EXPECT_GT(asked, 1000u);
}

// A correspondence stores the courses that follow from the ends of the curves, in both directions.
TEST(Edge_courses, of_a_correspondence)
{
  std::size_t crossed = 0;
  Triangulation t(random_sphere(60, 7));
  flip_at_random(t, 400, 1);
  const Correspondence c(t);
  for(Halfedge_index h : t.mesh().halfedges()) {
    const IT::Edge_course course = c.course(h), back = c.course(t.mesh().opposite(h)),
                          followed = IT::internal::Edge_courses(t)(h);
    ASSERT_EQ(course.size(), followed.size());
    ASSERT_EQ(course.size(), back.size());
    for(std::size_t m = 0; m < course.size(); ++m, ++crossed) {
      ASSERT_EQ(course[m], followed[m]) << h << ' ' << m;
      ASSERT_EQ(course[m], IT::opposite(back[course.size() - 1 - m])) << h << ' ' << m;
    }
  }
  EXPECT_GT(crossed, 300u);
}

// The positions of a crossing on its two edges are one point, up to the height of faces whose area
// is rounding error.
TEST(Trace, places_on_both_edges_of_hard_meshes)
{
  for_each_hard_mesh([](const Mesh& mesh) {
    Triangulation t(mesh);
    IT::make_Delaunay(t);
    const Correspondence c(t);
    const Real size = Flat_faces(Side::input, t).longest_edge();
    for(Side side : both_sides)
      for(Halfedge_index h : c.mesh(side).halfedges()) {
        const Trace trace = IT::trace_edge(side, h, c);
        check_order(side, h, trace);
        const Real length = Flat_faces(side, t).length(h);
        const std::vector<Real> pieces = lengths_of_pieces(side, trace, t);
        for(std::size_t k = 0; k < pieces.size(); ++k)
          EXPECT_NEAR(double(pieces[k] / size),
                      double((on(side, trace[k + 1]).t - on(side, trace[k]).t) * length / size),
                      1e-7);
      }
  });
}

} // namespace Test_trace
