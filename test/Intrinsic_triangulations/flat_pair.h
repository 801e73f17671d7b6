// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_FLAT_PAIR_H
#define INTRINSIC_TRIANGULATIONS_TEST_FLAT_PAIR_H

#include "brute_force.h"

#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>

namespace Test_surfaces {

using IT::Integer_coordinates;
using IT::Operation_status;
using IT::Outgoing_halfedges;

// Stores T2 over a flat T1, with the exact vectors of T2's halfedges beside its integer
// coordinates.
template <typename Integer = std::int64_t>
class Flat_pair
{
public:
  using Coordinates = Integer_coordinates<Integer>;

  explicit Flat_pair(Flat_surface surface)
    : t1(std::move(surface)),
      mesh(t1.mesh),
      coordinates(mesh),
      outgoing_halfedges(t1.mesh, coordinates.roundabout_map()),
      vector(t1.vector)
  {}
  Flat_pair(const Flat_pair&) = delete;
  Flat_pair& operator=(const Flat_pair&) = delete;

  // Returns whether the diamond is strictly convex, and not too long for brute force afterwards.
  bool can_flip(Halfedge_index h) const
  {
    if(IT::flip_status(h, mesh) != Operation_status::possible)
      return false;
    const Halfedge_index o = mesh.opposite(h);
    const Vector jk = vector[mesh.next(h)], ki = vector[mesh.prev(h)];
    const Vector il = vector[mesh.next(o)], lj = vector[mesh.prev(o)];
    return det(ki, il) > 0 && det(lj, jk) > 0 && length(ki + il) < 15000;
  }

  void flip(Halfedge_index h)
  {
    const Vector lk = -vector[mesh.next(mesh.opposite(h))] - vector[mesh.prev(h)];
    coordinates.flip(h, mesh, outgoing_halfedges);
    vector[h] = lk;
    vector[mesh.opposite(h)] = -lk;
  }

  Segment segment1(Halfedge_index h) const { return {t1.point[t1.mesh.source(h)], t1.vector[h]}; }
  Segment segment2(Halfedge_index h) const { return {t1.point[mesh.source(h)], vector[h]}; }

  // Returns the normal coordinate of the edge of h in T2.
  std::int64_t normal_coordinate(Halfedge_index h) const
  {
    std::int64_t count = 0;
    for(Halfedge_index x : t1.mesh.halfedges()) {
      if(t1.mesh.source(x) == mesh.source(h) && t1.vector[x] == vector[h])
        return -1;
      if(x.idx() % 2 == 0)
        count += count_crossings(segment2(h), segment1(x), t1);
    }
    return count;
  }

  // Returns the first halfedge of T1 at or counterclockwise from h.
  Halfedge_index roundabout(Halfedge_index h) const
  {
    Halfedge_index result;
    for(Halfedge_index x : t1.mesh.halfedges())
      if(t1.mesh.source(x) == mesh.source(h) &&
         (!result.is_valid() || is_before(vector[h], t1.vector[x], t1.vector[result])))
        result = x;
    return result;
  }

  void check(Edge_index e) const
  {
    const Halfedge_index h = mesh.halfedge(e);
    ASSERT_EQ(coordinates.normal_coordinate(e), normal_coordinate(h)) << e;
    for(Halfedge_index x : {h, mesh.opposite(h)})
      ASSERT_EQ(outgoing_halfedges.halfedge(mesh.source(x), coordinates.roundabout(x)),
                roundabout(x))
        << x;
  }

  void check_all() const
  {
    for(Edge_index e : mesh.edges())
      check(e);
    EXPECT_TRUE(IT::is_valid_Delta_complex(mesh, true));
    EXPECT_TRUE(coordinates.is_valid(mesh, outgoing_halfedges));
    EXPECT_EQ(IT::internal::curve_defect(coordinates, mesh, t1.mesh, outgoing_halfedges), "");
  }

  Flat_surface t1;
  Delta_complex mesh; // T2
  Coordinates coordinates;
  Outgoing_halfedges outgoing_halfedges;
  std::vector<Vector> vector;
};

template <typename Integer>
std::size_t random_flips(Flat_pair<Integer>& pair, int tries, unsigned int seed)
{
  CGAL::Random random(seed);
  std::size_t flips = 0;
  for(int i = 0; i < tries && !testing::Test::HasFatalFailure(); ++i) {
    const Halfedge_index h = random_halfedge(pair.mesh, random);
    if(!pair.can_flip(h))
      continue;
    pair.flip(h);
    pair.check(pair.mesh.edge(h));
    ++flips;
  }
  return flips;
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_FLAT_PAIR_H
