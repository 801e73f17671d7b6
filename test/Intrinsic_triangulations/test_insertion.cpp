// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"
#include "measuring.h"
#include "more_generators.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/function_transfer.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/io.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>

#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace Test_insertion {

using namespace Test_surfaces;
using IT::Side;

typedef IT::Vertex_inserter<> Vertex_inserter;
typedef IT::Correspondence<> Correspondence;
typedef IT::Common_subdivision<> Subdivision;
typedef Delta_complex::size_type size_type;

template <typename Any_mesh>
std::int64_t Euler_characteristic(const Any_mesh& mesh)
{
  return std::int64_t(mesh.number_of_vertices()) - std::int64_t(mesh.number_of_edges()) +
         std::int64_t(mesh.number_of_faces());
}

std::string text_of(const Triangulation& t)
{
  std::ostringstream os;
  IT::write_intrinsic_triangulation(os, t);
  return os.str();
}

// Changes a triangulation at random: vertices come and go, and it is flipped towards Delaunay.
class Random_changes
{
public:
  Random_changes(Triangulation& t, unsigned int seed) : m_t(t), m_inserter(t), m_random(seed) {}

  const Vertex_inserter& inserter() const { return m_inserter; }
  std::size_t inserted() const { return m_vertices.size(); }

  void step()
  {
    const int kind = m_random.get_int(0, 10);
    if(kind < 3)
      flip_to_Delaunay();
    else if(kind < 6)
      insert(kind == 5 ? 0.05 : 0);
    else if(kind < 8)
      split(kind == 7 ? 0.1 : 0);
    else
      remove();
  }

  void remove_all()
  {
    flip_to_Delaunay();
    while(!m_vertices.empty()) {
      EXPECT_TRUE(m_inserter.remove(m_vertices.back()).is_valid());
      m_vertices.pop_back();
      flip_to_Delaunay();
    }
  }

private:
  template <typename Index>
  Index random_index(size_type count)
  {
    return Index(static_cast<size_type>(m_random.get_int(0, static_cast<int>(count))));
  }

  void flip_to_Delaunay()
  {
    for(bool changed = true; changed;) {
      changed = false;
      for(Edge_index e : m_t.mesh().edges())
        if(!m_t.is_Delaunay(e)) {
          m_inserter.flip(m_t.mesh().halfedge(e));
          changed = true;
        }
    }
  }

  void insert(double closeness)
  {
    const auto f = random_index<Face_index>(m_t.mesh().num_faces());
    if(m_t.mesh().is_removed(f))
      return;
    const double a = m_random.get_double(0.1, 1), b = m_random.get_double(0.1, 1),
                 c = m_random.get_double(0.1, 1), sum = a + b + c;
    const double scale = m_t.length(m_t.mesh().edge(m_t.mesh().halfedge(f)));
    m_vertices.push_back(
      m_inserter.insert({f, {1 - b / sum - c / sum, b / sum, c / sum}}, closeness * scale));
  }

  void split(double closeness)
  {
    const auto h = random_index<Halfedge_index>(m_t.mesh().num_halfedges());
    if(m_t.mesh().is_removed(h) || !m_inserter.can_be_split(h))
      return;
    m_vertices.push_back(m_inserter.split_edge(h, m_random.get_double(0.2, 0.8),
                                               closeness * m_t.length(m_t.mesh().edge(h))));
  }

  void remove()
  {
    if(m_vertices.empty())
      return;
    const auto i =
      static_cast<std::size_t>(m_random.get_int(0, static_cast<int>(m_vertices.size())));
    if(m_inserter.remove(m_vertices[i]).is_valid())
      m_vertices.erase(m_vertices.begin() + std::ptrdiff_t(i));
  }

  Triangulation& m_t;
  Vertex_inserter m_inserter;
  CGAL::Random m_random;
  std::vector<Vertex_index> m_vertices;
};

// Calls `check(t)` for triangulations of all test surfaces.
template <typename Check>
void for_each_triangulation(const Check& check)
{
  for(const Named_mesh& m : meshes())
    for(unsigned int seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(m.name + ", seed " + std::to_string(seed));
      check(Triangulation(m.mesh), seed);
    }
  for(const Named_complex& c : complexes())
    for(unsigned int seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(c.name + ", seed " + std::to_string(seed));
      check(triangulation(c.mesh, random_lengths(c.mesh, seed)), seed);
    }
}

// The lists are the crossings that tracing every curve gives.
void check_lists(const Vertex_inserter& inserter)
{
  const Triangulation& t = inserter.triangulation();
  Triangulation compact(t);
  const IT::internal::Crossing_lists<IT::Euclidean_geometry_traits<>> fresh(compact);
  for(Halfedge_index h : t.mesh().halfedges()) {
    ASSERT_EQ(inserter.crossing_lists().count(h), fresh.count(h));
    for(std::size_t m = 0; m < fresh.count(h); ++m)
      ASSERT_EQ(inserter.crossing_lists()(h, m), fresh(h, m)) << h << ' ' << m;
  }
}

Triangulation changed(Triangulation t, unsigned int seed, int steps)
{
  Random_changes changes(t, seed);
  for(int step = 0; step < steps; ++step)
    changes.step();
  t.collect_garbage();
  t.recompute_lengths();
  IT::make_Delaunay(t);
  return t;
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
    check_lists(changes.inserter());
    inserted += changes.inserted();
  });
  EXPECT_GT(inserted, 1000u);
}

// Removal of all vertices leaves a triangulation of the input's own vertices, and that flips back.
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

// A vertex on an edge, and then in the middle of its parts: places and lengths are dyadic, to the
// bit.
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
    EXPECT_EQ(t.start_on_spoke(parts[i]).t, double(i) / 64);
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
        const double scale = IT::internal::Face_metric<double>(face, t.input()).area();
        for(std::size_t k = 1; k + 1 < region.size(); ++k) {
          const double part = scale * IT::internal::orientation(region.image(0), region.image(k),
                                                                region.image(k + 1));
          EXPECT_GT(part, -1e-9);
          area += part;
        }
      }
    }
    for(Face_index f : t.input_mesh().faces())
      whole += IT::internal::Face_metric<double>(f, t.input()).area();
    EXPECT_NEAR(area / whole, 1, 1e-9); // the regions, as they lie on T1, cover it
  });
}

// Single traces, and those of the correspondence, are laid out on different strips.
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
