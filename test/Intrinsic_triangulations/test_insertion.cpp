// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "equality.h"
#include "measuring.h"
#include "random_changes.h"

#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/function_transfer.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/trace_edge.h>

namespace Test_insertion {

using namespace Test_surfaces;
using IT::Side;

typedef IT::Vertex_inserter<> Vertex_inserter;
typedef IT::Correspondence<> Correspondence;
typedef IT::Common_subdivision<> Subdivision;
typedef Delta_complex::size_type size_type;

// Checks that the courses equal the traces of every curve.
void check_courses(const Vertex_inserter& inserter)
{
  const Triangulation& t = inserter.triangulation();
  Triangulation compact(t);
  const IT::internal::Edge_courses fresh(compact, IT::Concurrency());
  for(Halfedge_index h : t.mesh().halfedges()) {
    const IT::Edge_course course = inserter.course(h), expected = fresh(h);
    ASSERT_EQ(course.size(), expected.size()) << h;
    for(std::size_t m = 0; m < course.size(); ++m)
      ASSERT_EQ(course[m], expected[m]) << h << ' ' << m;
  }
}

TEST(Insertion, valid_after_every_step)
{
  std::size_t inserted = 0;
  for_each_triangulation([&](Triangulation t, unsigned int seed) {
    Random_changes changes(t, seed);
    for(int step = 0; step < 60; ++step) {
      changes.step();
      ASSERT_TRUE(t.is_valid(true)) << step;
    }
    check_courses(changes.inserter());
    inserted += changes.inserted();
  });
  EXPECT_GT(inserted, 1000u);
}

// Removal of all vertices leaves a triangulation of the input's own vertices, which can be flipped
// back.
TEST(Insertion, removal_undoes_it)
{
  for_each_triangulation([&](Triangulation t, unsigned int seed) {
    const Triangulation original = t;
    Random_changes changes(t, seed);
    for(int step = 0; step < 40; ++step)
      changes.step();
    changes.remove_all();
    t.collect_garbage();
    ASSERT_TRUE(t.is_valid(true));
    EXPECT_EQ(t.mesh().number_of_vertices(), original.mesh().number_of_vertices());
    flip_to_input(t);
    for(Edge_index e : t.mesh().edges())
      EXPECT_TRUE(t.coordinates().is_shared(e));
  });
}

TEST(Insertion, same_bytes_every_time)
{
  const Triangulation t(embedded_torus(5, 4));
  EXPECT_EQ(text_of(changed(t, 3, 200)), text_of(changed(t, 3, 200)));
}

TEST(Insertion, saved_and_loaded)
{
  for_each_triangulation([&](const Triangulation& t, unsigned int seed) {
    const std::string text = text_of(changed(t, seed, 40));
    std::istringstream is(text);
    EXPECT_EQ(text_of(IT::read_intrinsic_triangulation(is)), text);
  });
}

TEST(Insertion, at_a_vertex_that_is_there)
{
  Triangulation t(octahedron());
  Vertex_inserter inserter(t);
  const Face_index f(3);
  const auto side = IT::sides(f, t.mesh());
  for(std::size_t s = 0; s < 3; ++s) {
    std::array<double, 3> p{0, 0, 0};
    p[s] = 1;
    EXPECT_EQ(inserter.insert({f, p}), t.mesh().source(side[s]));
  }
  EXPECT_EQ(t.number_of_inserted_vertices(), 0u);
}

// A vertex is inserted on an edge, and others in the middle of its parts. Positions and lengths are
// dyadic and bitwise exact.
TEST(Insertion, exact_places_on_input_edges)
{
  Triangulation t(octahedron());
  Vertex_inserter inserter(t);
  const Edge_index e(2);
  const double length = t.input_length(e);
  std::vector<Halfedge_index> parts{t.mesh().halfedge(e, 0)};
  for(int round = 0; round < 6; ++round) {
    std::vector<Halfedge_index> next;
    for(Halfedge_index h : parts) {
      inserter.split_edge(h, 0.5);
      next.push_back(IT::first_part(h, t.mesh()));
      next.push_back(h);
    }
    parts = next;
  }
  ASSERT_EQ(parts.size(), 64u);
  for(std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(t.length(t.mesh().edge(parts[i])), length / 64);
    EXPECT_EQ(t.input_halfedge(parts[i]), t.input_mesh().halfedge(e, 0));
    EXPECT_EQ(t.start_on_outgoing(parts[i]).t, double(i) / 64);
  }
  EXPECT_TRUE(t.is_valid(true));
}

TEST(Insertion, boundary_vertices_come_and_go)
{
  const Mesh mesh = grid(2, 2, [](double x, double y) { return Point(x, y, 0); });
  const Triangulation original(mesh);
  Triangulation t(mesh);
  Vertex_inserter inserter(t);
  for(Edge_index e : original.mesh().edges())
    if(t.mesh().is_border(e)) {
      const Halfedge_index h(2 * e.idx());
      const double length = t.length(e);
      const Vertex_index v = inserter.split_edge(h, 0.25);
      EXPECT_TRUE(t.mesh().is_border(v));
      EXPECT_TRUE(inserter.remove(v).is_valid());
      ASSERT_TRUE(t.is_valid(true));
      double sum = 0;
      for(Edge_index x : t.mesh().edges())
        if(t.mesh().is_border(x)) {
          EXPECT_TRUE(t.coordinates().is_shared(x));
          sum += t.length(x);
        }
      EXPECT_EQ(sum, 8 * length);
    }
}

// ---- Correspondence ----

TEST(Insertion, subdivision)
{
  for_each_triangulation([&](const Triangulation& input, unsigned int seed) {
    const Triangulation t = changed(input, seed, 40);
    const Correspondence c(t);
    const Subdivision s(c);
    EXPECT_TRUE(s.mesh().is_valid());
    EXPECT_EQ(Euler_characteristic(s.mesh()), Euler_characteristic(t.input_mesh()));
    EXPECT_EQ(s.mesh().number_of_vertices(),
              t.mesh().number_of_vertices() + c.number_of_crossings());
    double area = 0, whole = 0;
    for(Face_index f : t.mesh().faces()) {
      const IT::internal::Correspondence_marks<IT::Euclidean_geometry_traits<>> marks(
        Side::intrinsic, f, c);
      const IT::internal::Face_map<double, std::decay_t<decltype(marks)>> map(marks,
                                                                              t.input_mesh());
      for(std::size_t m = 0; m < map.regions().size(); ++m) {
        const auto [face, region] = map.region_map(m);
        const double scale = IT::Face_metric<double>(face, t.input()).area();
        for(std::size_t k = 1; k + 1 < region.size(); ++k) {
          const double part = scale * IT::internal::orientation(region.image(0), region.image(k),
                                                                region.image(k + 1));
          EXPECT_GT(part, -1e-9);
          area += part;
        }
      }
    }
    for(Face_index f : t.input_mesh().faces())
      whole += IT::Face_metric<double>(f, t.input()).area();
    EXPECT_NEAR(area / whole, 1, 1e-9); // the regions, as they lie on T1, cover it
  });
}

// Single traces, and traces of the correspondence, are laid out on different strips.
TEST(Insertion, traces)
{
  for_each_triangulation([&](const Triangulation& input, unsigned int seed) {
    const Triangulation t = changed(input, seed, 30);
    const Correspondence c(t);
    for(Side side : both_sides)
      for(Halfedge_index h : c.mesh(side).halfedges()) {
        const auto many = IT::trace_edge(side, h, c);
        const auto one =
          side == Side::input ? IT::trace_input_edge(t, h) : IT::trace_intrinsic_edge(t, h);
        ASSERT_EQ(many.size(), one.size());
        for(std::size_t k = 0; k < one.size(); ++k) {
          EXPECT_NEAR(on(side, many[k]).t, on(side, one[k]).t, 1e-8);
          EXPECT_TRUE(k == 0 || on(side, many[k]).t >= on(side, many[k - 1]).t);
        }
      }
  });
}

TEST(Insertion, points_across)
{
  for_each_triangulation([&](const Triangulation& input, unsigned int seed) {
    const Triangulation t = changed(input, seed, 40);
    const Correspondence c(t);
    CGAL::Random random(seed);
    for(Side side : both_sides)
      for(int i = 0; i < 50; ++i) {
        const Location p = random_location(c.mesh(side), random);
        const Location back = IT::point_across(c, other(side), IT::point_across(c, side, p));
        const Flat_faces faces(side, t);
        EXPECT_LT(double(faces.path(p, back)), 1e-8) << i;
      }
  });
}

TEST(Insertion, linear_functions_of_the_plane)
{
  const Mesh mesh = planar_mesh(random_points(25, 1000, 5));
  const Triangulation t = changed(Triangulation(mesh), 1, 100);
  const Correspondence c(t);
  const Subdivision s(c);
  const auto from_input = IT::interpolation_matrix(Side::input, s);
  const auto from_intrinsic = IT::interpolation_matrix(Side::intrinsic, s);
  Eigen::VectorXd x(Eigen::Index(mesh.number_of_vertices()));
  for(Vertex_index v : mesh.vertices())
    x[Eigen::Index(v.idx())] = mesh.point(v).x() + 2 * mesh.point(v).y();
  const Eigen::VectorXd on_s = from_input * x;
  const Eigen::VectorXd on_t = on_s.head(Eigen::Index(t.mesh().number_of_vertices()));
  EXPECT_LT((from_intrinsic * on_t - on_s).cwiseAbs().maxCoeff(), 1e-7);
  const Eigen::VectorXd ones =
    from_input * Eigen::VectorXd::Ones(Eigen::Index(mesh.number_of_vertices()));
  EXPECT_LT((ones.array() - 1).abs().maxCoeff(), 1e-14);
}

} // namespace Test_insertion
