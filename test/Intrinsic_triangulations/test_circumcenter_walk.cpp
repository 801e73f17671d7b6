// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hard_meshes.h"

#include <CGAL/Intrinsic_triangulations/internal/refinement/Circumcenter_walk.h>

namespace Test_circumcenter_walk {

using namespace Test_surfaces;
using Walk = IT::internal::Circumcenter_walk<Triangulation::Edge_length_map>;
using Plane_vector = std::array<double, 2>;

double distance(const Plane_vector& p, const Plane_vector& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}

// Represents a needle from (0, 0) to (1, -u) and (1, v), beginning with any corner. Its other side
// is a second face.
struct Needle
{
  std::vector<Plane_vector> points;
  Triangulation triangulation;

  Needle(double u, double v, std::size_t first)
    : points{{0, 0}, {1, -u}, {1, v}},
      triangulation(make_mesh({{0, 0, 0}, {1, -u, 0}, {1, v, 0}},
                              {{first, (first + 1) % 3, (first + 2) % 3}, {0, 2, 1}}))
  {}

  // Returns the circumcenter from the equations of the bisectors.
  static Plane_vector circumcenter(double u, double v) { return {(1 + u * v) / 2, (v - u) / 2}; }

  Plane_vector at(const IT::Face_location<double>& location) const
  {
    const auto corner = IT::sides(location.first, triangulation.mesh());
    Plane_vector result{0, 0};
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t c = 0; c < 2; ++c)
        result[c] += location.second[k] * points[triangulation.mesh().source(corner[k]).idx()][c];
    return result;
  }

  Plane_vector at(Halfedge_index h, double t) const
  {
    const auto &p = points[triangulation.mesh().source(h).idx()],
               &q = points[triangulation.mesh().target(h).idx()];
    return {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
  }
};

bool nothing_is_fixed(Halfedge_index) { return false; }

auto layout(const Needle& needle)
{
  return IT::internal::Layout_by_lengths(needle.triangulation.intrinsic());
}

// Both long sides are nearer than the circumcenter may be moved. Its position along them does not
// change, although the third corner is beside one end.
TEST(Circumcenter_walk, moves_the_center_across_a_needle_only)
{
  Portable_random random(1);
  for(int i = 0; i < 300; ++i) {
    const double u = log_uniform(1e-9, 1e-7, random), v = log_uniform(1e-9, 1e-7, random);
    const Needle needle(u, v, random_size(0, 2, random));
    Walk walk(needle.triangulation.intrinsic());
    ASSERT_EQ(walk.walk(Face_index(0), nothing_is_fixed, layout(needle)), Walk::End::on_edge);
    const Plane_vector center = Needle::circumcenter(u, v);
    EXPECT_LE(distance(needle.at(walk.halfedge(), walk.along()), center), walk.closeness());
    EXPECT_LE(distance(needle.at(walk.location()), center), walk.closeness());
    EXPECT_NEAR(walk.along(), 0.5, 1e-9);
  }
}

TEST(Circumcenter_walk, is_blocked_by_the_side_that_it_would_move_to)
{
  const Needle needle(1e-8, 1e-8, 0);
  Walk walk(needle.triangulation.intrinsic());
  EXPECT_EQ(walk.walk(
              Face_index(0), [](Halfedge_index) { return true; }, layout(needle)),
            Walk::End::blocked);
}

// In a face that is not thin the center is not moved.
TEST(Circumcenter_walk, leaves_the_center_inside_a_good_face)
{
  const Needle needle(0.6, 0.5, 0);
  Walk walk(needle.triangulation.intrinsic());
  ASSERT_EQ(walk.walk(Face_index(0), nothing_is_fixed, layout(needle)), Walk::End::inside);
  EXPECT_LT(distance(needle.at(walk.location()), Needle::circumcenter(0.6, 0.5)), 1e-15);
}

} // namespace Test_circumcenter_walk
