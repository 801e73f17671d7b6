// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/Angular_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/tangent_vector_across.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>
#include <CGAL/Intrinsic_triangulations/trace.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <string>

namespace {

using namespace Test_surfaces;
using Complex = std::complex<double>;
using Angles = IT::Angular_coordinates<>;

const double pi = std::acos(-1.);

void expect_same_direction(double a, double b, double tolerance)
{
  EXPECT_NEAR(std::remainder(a - b, 2 * pi), 0, tolerance) << a << ' ' << b;
}

// From the place where `h` first meets an edge of T1, which comes from T2.
double angle_from_crossing(Halfedge_index h, const Triangulation& t,
                           const IT::Tangent_frames<>& frames)
{
  if(t.coordinates().is_shared(t.mesh().edge(h)))
    return frames.angle(t.input_halfedge(h));
  const Edge_place p = IT::trace_intrinsic_edge(h, t)[1].on_input;
  const Location location = IT::internal::face_location(p, t.input_mesh());
  return std::arg(IT::logarithm(Side::input, t.input_mesh().prev(p.halfedge), location, t));
}

Complex complex(const Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

// From exact vectors; `frames` tells the angle sum on the boundary.
double angle_in_plane(Halfedge_index h, const Flat_triangulation& flat,
                      const IT::Tangent_frames<>& frames)
{
  const Vertex_index v = flat->mesh().source(h);
  const Halfedge_index first = IT::first_spoke(v, flat->input_mesh());
  const double angle = std::arg(complex(flat.vector(h)) / complex(flat.input_vector(first)));
  if(!flat->mesh().is_border(v))
    return angle;
  const double positive = angle < -1e-9 ? angle + 2 * pi : angle;
  return positive * pi / frames.angle_sum(v);
}

// Those that are kept, against those that are computed afresh.
void check_kept(const Angles& kept, const Triangulation& t, double tolerance)
{
  const Angles fresh(t);
  for(Halfedge_index h : t.mesh().halfedges()) {
    expect_same_direction(kept.angle(h), fresh.angle(h), tolerance);
    if(t.coordinates().is_shared(t.mesh().edge(h))) {
      EXPECT_EQ(kept.angle(h), fresh.angle(h));
    }
  }
}

} // namespace

TEST(Angular_coordinates, of_vectors_in_the_plane)
{
  for(const Named_surface& s : flat_surfaces())
    for(unsigned int seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(s.name + ", seed " + std::to_string(seed));
      Flat_triangulation flat(s.surface);
      flat.flip_at_random(20 * s.surface.mesh.number_of_edges(), seed);
      const IT::Tangent_frames<> frames(Side::input, *flat);
      for(Halfedge_index h : flat->mesh().halfedges())
        expect_same_direction(IT::angle_on_input(h, *flat), angle_in_plane(h, flat, frames), 1e-12);
    }
}

TEST(Angular_coordinates, of_crossings)
{
  for(const Named_triangulation& named : triangulations()) {
    SCOPED_TRACE(named.name);
    const Triangulation& t = named.triangulation;
    const IT::Tangent_frames<> frames(Side::input, t);
    const Angles angles(t);
    for(Halfedge_index h : t.mesh().halfedges()) {
      expect_same_direction(angles.angle(h), angle_from_crossing(h, t, frames), 1e-9);
      expect_same_direction(angles.angle(h), IT::angle_on_input(h, t), 1e-14);
      if(t.coordinates().is_shared(t.mesh().edge(h))) {
        EXPECT_EQ(angles.angle(h), frames.angle(t.input_halfedge(h)));
        EXPECT_EQ(IT::angle_on_input(h, t), frames.angle(t.input_halfedge(h)));
      }
    }
  }
}

TEST(Angular_coordinates, kept_through_flips)
{
  for(const Named_triangulation& named : triangulations())
    for(unsigned int seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(named.name + ", seed " + std::to_string(seed));
      Triangulation t = named.triangulation;
      Angles angles(t);
      flip_at_random(t, 40 * t.mesh().number_of_edges(), seed,
                     [&](Halfedge_index h) { angles.after_flip(h); });
      check_kept(angles, t, 1e-9);
    }
}

TEST(Angular_coordinates, errors_do_not_grow)
{
  Triangulation t(random_sphere(100, 3));
  Angles angles(t);
  int flips = 0;
  for(unsigned int seed = 0; seed < 200; ++seed) {
    flip_at_random(t, 1000, seed, [&](Halfedge_index h) {
      angles.after_flip(h);
      ++flips;
    });
    t.recompute_lengths();
  }
  EXPECT_GT(flips, 50000);
  check_kept(angles, t, 1e-10);
}

TEST(Angular_coordinates, visitor_of_make_Delaunay)
{
  for(const Named_triangulation& named : triangulations()) {
    SCOPED_TRACE(named.name);
    Triangulation t = named.triangulation;
    Angles angles(t);
    IT::make_Delaunay(t, CGAL::parameters::visitor(std::ref(angles)));
    check_kept(angles, t, 1e-9);
  }
}

// Transport in either frames is the same.
TEST(Angular_coordinates, tangent_vectors_across)
{
  for(const Named_triangulation& named : triangulations()) {
    SCOPED_TRACE(named.name);
    const Triangulation& t = named.triangulation;
    const IT::Tangent_frames<> frames(Side::intrinsic, t);
    const Angles angles(t);
    for(Halfedge_index h : t.mesh().halfedges()) {
      const Vertex_index v = t.mesh().source(h), w = t.mesh().target(h);
      const Complex vector = std::polar(2., frames.angle(h));
      const Complex on_input = IT::tangent_vector_across(Side::intrinsic, v, vector, t);
      EXPECT_NEAR(std::abs(on_input - std::polar(2., angles.angle(h))), 0, 1e-9);
      EXPECT_LT(std::abs(IT::tangent_vector_across(Side::input, v, on_input, t) - vector), 1e-14);
      EXPECT_LT(std::abs(IT::tangent_vector_across(Side::intrinsic, v, vector, angles) - on_input),
                1e-14);
      if(t.mesh().is_border(v)) {
        EXPECT_EQ(on_input, vector);
      }
      const Complex there =
        IT::tangent_vector_across(Side::intrinsic, w, vector * frames.transport(h), t);
      EXPECT_LT(std::abs(there - on_input * angles.transport(h)), 1e-9);
    }
  }
}

// ---- Inserted vertices ----

namespace {

// The angles between neighbors around `v`, as the angular coordinates and as the corners of T2 have them.
void check_around(Vertex_index v, const IT::Angular_coordinates<>& angles)
{
  const Triangulation& t = angles.triangulation();
  IT::internal::for_each_spoke(v, t.mesh(), [&](Halfedge_index h) {
    EXPECT_NEAR(std::remainder(angles.angle(h) - IT::angle_on_input(h, t), 2 * pi), 0, 1e-8);
    if(t.mesh().is_border(h))
      return;
    const double corner = IT::internal::angle_at_source(h, t.mesh(), t.length_map());
    const double gap = angles.angle(IT::next_spoke(h, t.mesh())) - angles.angle(h);
    const double scale = t.is_inserted(v) ? 1 : angles.frames().scale(v);
    EXPECT_NEAR(std::remainder(gap - scale * corner, 2 * pi), 0, 1e-7);
  });
}

} // namespace

TEST(Angular_coordinates, at_inserted_vertices)
{
  for(const Named_mesh& m : meshes()) {
    SCOPED_TRACE(m.name);
    Triangulation t(m.mesh);
    IT::refine(t, IT::parameters::minimum_angle(28.));
    const IT::Angular_coordinates<> angles(t);
    for(Vertex_index v : t.mesh().vertices())
      check_around(v, angles);
  }
}

TEST(Angular_coordinates, kept_through_insertions_and_flips)
{
  for(const Named_mesh& m : meshes()) {
    SCOPED_TRACE(m.name);
    Triangulation t(m.mesh);
    IT::make_Delaunay(t);
    IT::Angular_coordinates<> angles(t);
    IT::Vertex_inserter<> inserter(t);
    CGAL::Random random(1);
    for(int i = 0; i < 30; ++i) {
      const auto p = random_location(t.mesh(), random);
      angles.after_insertion(i % 3 == 0 ? inserter.split_edge(t.mesh().halfedge(p.first), 0.5)
                                        : inserter.insert(p));
      for(Edge_index e : t.mesh().edges())
        if(!t.is_Delaunay(e)) {
          inserter.flip(t.mesh().halfedge(e));
          angles.after_flip(t.mesh().halfedge(e));
        }
    }
    for(Vertex_index v : t.mesh().vertices())
      check_around(v, angles);
  }
}
