// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips lead from one triangulation of a surface to another, where both are over a third.

#include "flat_pair.h"

#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/rebase.h>

namespace Test_flip_to {

using namespace Test_surfaces;
using Triangulation = IT::Intrinsic_triangulation<>;

bool all_are_shared(const Triangulation& t)
{
  const auto edges = t.mesh().edges();
  return std::all_of(edges.begin(), edges.end(),
                     [&](Edge_index e) { return t.coordinates().is_shared(e); });
}

// Checks that `t` has become `target`, up to the numbers of elements.
void expect_same_triangulation(const Triangulation& t, const Triangulation& target)
{
  EXPECT_TRUE(t.is_valid(true));
  const Triangulation over = IT::rebase(target, t);
  EXPECT_TRUE(all_are_shared(over));
  for(Halfedge_index h : t.mesh().halfedges()) {
    const Halfedge_index there =
      over.coordinates().shared_halfedge(h, over.mesh(), over.outgoing_halfedges());
    const Edge_index e(h), e_there(there);
    EXPECT_EQ(t.mesh().target(h), target.mesh().target(there));
    EXPECT_EQ(t.coordinates().roundabout(h), target.coordinates().roundabout(there));
    EXPECT_EQ(t.coordinates().normal_coordinate(e),
              target.coordinates().normal_coordinate(e_there));
    EXPECT_EQ(t.length(e), target.length(e_there));
  }
}

// ---- Brute force on flat surfaces ----

// Stores a triangulation of a flat surface with the exact vectors of its halfedges.
struct Flat_triangulation
{
  Flat_pair<> exact;
  Triangulation tri;

  Flat_triangulation(const Flat_surface& surface, int tries, unsigned seed)
    : exact(surface), tri(triangulation(surface))
  {
    CGAL::Random random(seed);
    for(int i = 0; i < tries; ++i) {
      const Halfedge_index h = random_halfedge(exact.mesh, random);
      if(!exact.can_flip(h))
        continue;
      exact.flip(h);
      tri.flip(h);
    }
  }
};

void expect_brute_force(const Flat_triangulation& t2, const Flat_triangulation& t3)
{
  const Triangulation over = IT::rebase(t2.tri, t3.tri);
  Flat_surface surface(t2.exact.t1);
  surface.mesh = t2.exact.mesh;
  surface.vector = t2.exact.vector;
  Flat_pair<> pair(surface);
  pair.mesh = over.mesh();
  pair.coordinates = Flat_pair<>::Coordinates(pair.mesh);
  pair.vector = t3.exact.vector;
  pair.check_all();
}

void check_flat_surface(const Flat_surface& surface, unsigned seed)
{
  SCOPED_TRACE(seed);
  const Flat_triangulation t2(surface, 150, seed), t3(surface, 150, seed + 1000);
  expect_brute_force(t2, t3);
  Triangulation t(t2.tri);
  flip_to(t, t3.tri);
  expect_same_triangulation(t, t3.tri);
}

TEST(Flip_to, convex_polygons_against_brute_force)
{
  for(unsigned seed = 0; seed < 400; ++seed)
    check_flat_surface(flat_polygon(random_points(6 + seed % 20, 5000, seed)), seed);
}

TEST(Flip_to, tori_against_brute_force)
{
  for(unsigned seed = 0; seed < 400; ++seed)
    check_flat_surface(flat_torus(1 + int(seed % 4), 1 + int(seed / 4 % 4), seed), seed);
}

TEST(Flip_to, cylinders_against_brute_force)
{
  for(unsigned seed = 0; seed < 200; ++seed)
    check_flat_surface(flat_cylinder(1 + int(seed % 5), int(seed % 3)), seed);
}

// ---- Surfaces with curvature ----

// Checks lengths. If they are recomputed in the strips of T2, they are the lengths of T3 only if
// the strips are correct.
void expect_lengths(Triangulation over, const Triangulation& t3)
{
  EXPECT_TRUE(over.is_valid(true));
  over.recompute_lengths();
  for(Edge_index e : over.mesh().edges())
    EXPECT_NEAR(over.length(e) / t3.length(e), 1, 1e-8);
}

TEST(Flip_to, all_complexes)
{
  for(const auto& [c, seed] : traced(complexes(), 10)) {
    const Triangulation t1 = triangulation(c.mesh, random_lengths(c.mesh, seed));
    Triangulation t2(t1), t3(t1);
    // More flips of few edges make slivers, whose lengths are rounding errors.
    const int tries = static_cast<int>(std::min(3 * c.mesh.number_of_edges(), 100u));
    random_flips(t2, tries, seed);
    random_flips(t3, tries, seed + 100);
    expect_lengths(IT::rebase(t2, t3), t3);
    Triangulation t(t2);
    flip_to(t, t3);
    expect_same_triangulation(t, t3);
  }
}

TEST(Flip_to, flips_to_a_neighbor_at_once)
{
  Triangulation t2 = triangulation(flat_torus(4, 4, 1));
  random_flips(t2, 300, 1);
  Triangulation t3(t2);
  EXPECT_EQ(flip_to(t2, t3), 0u);
  EXPECT_TRUE(all_are_shared(IT::rebase(t2, t3)));
  CGAL::Random random(2);
  Halfedge_index h;
  do
    h = random_halfedge(t3.mesh(), random);
  while(!t3.is_flippable(h));
  t3.flip(h);
  EXPECT_EQ(flip_to(t2, t3), 1u);
  expect_same_triangulation(t2, t3);
}

TEST(Flip_to, composes_to_the_input)
{
  const Triangulation t1 = triangulation(flat_torus(3, 4, 3));
  Triangulation t2(t1);
  random_flips(t2, 300, 1);
  const Triangulation over = IT::rebase(t1, t2);
  for(Edge_index e : t2.mesh().edges())
    EXPECT_EQ(over.coordinates().normal_coordinate(e), t2.coordinates().normal_coordinate(e));
  Triangulation back(t2);
  EXPECT_EQ(flip_to(back, t1) > 0, !all_are_shared(t2));
  EXPECT_TRUE(all_are_shared(back));
}

TEST(Flip_to, names_what_does_not_fit)
{
  Triangulation t = triangulation(flat_torus(3, 4, 3));
  EXPECT_THROW(flip_to(t, triangulation(flat_torus(4, 3, 3))), IT::Invalid_input);
  EXPECT_THROW(IT::rebase(t, triangulation(flat_torus(3, 3, 3))), IT::Invalid_input);
}

} // namespace Test_flip_to
