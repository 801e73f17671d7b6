// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_TRACED_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_TRACED_CROSSINGS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_crossings.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// The halfedges of T1 that cross an edge of T2, found by following each to its end: nothing is
// stored. For all edges at once there are `Input_crossings`, and while T2 changes `Crossing_lists`
// and `Crossings_on_demand`.
template <typename Traits>
class Traced_crossings
{
  typedef Triangulation_pair<Traits> Pair;
  typedef typename Pair::Coordinates Coordinates;
  typedef typename Pair::Integer Integer;

public:
  explicit Traced_crossings(const Pair& pair) : m_pair(pair) {}

  // returns the number of crossings on the edge of `h`
  std::size_t count(Halfedge_index h) const { return m_pair.number_of_crossings(h); }

  // returns the halfedge of T1 that crosses `h` as its crossing `m` from left to right
  Halfedge_index operator()(Halfedge_index h, std::size_t m) const
  {
    std::size_t steps = 0;
    return follow(h, m, steps);
  }

  // does so, and adds the number of edges of T2 that it crosses from there on to `steps`
  Halfedge_index follow(Halfedge_index h, std::size_t m, std::size_t& steps) const
  {
    const Coordinates& coordinates = m_pair.coordinates();
    typename Coordinates::Crossing c{h, Integer(m)};
    do
      ++steps;
    while(coordinates.advance(c, m_pair.mesh()) != Coordinates::Turn::ends);
    return opposite(coordinates.spoke_at_end(c, m_pair.mesh(), m_pair.spokes()));
  }

private:
  const Pair& m_pair;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_TRACED_CROSSINGS_H
