// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_CROSSINGS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// For each edge of T2 the number of crossings on all edges before it, and last the number of all.
template <typename Integer>
std::vector<Delta_complex::size_type>
first_crossings(const Integer_coordinates<Integer>& coordinates, const Delta_complex& mesh)
{
  typedef Delta_complex::size_type size_type;
  const std::uint64_t limit = (std::numeric_limits<size_type>::max)() / 8;
  std::vector<size_type> first(mesh.num_edges() + 1, 0);
  std::uint64_t total = 0;
  for(size_type i = 0; i < mesh.num_edges(); ++i) {
    first[i] = static_cast<size_type>(total);
    if(mesh.is_removed(Edge_index(i)))
      continue;
    total += static_cast<std::uint64_t>(coordinates.crossings(Halfedge_index(2 * i)));
    if(total > limit)
      throw Overflow_error("more crossings than a mesh can number");
  }
  first.back() = static_cast<size_type>(total);
  return first;
}

// The halfedges of T1 that cross each edge of T2, in order. No geometry.
// Complexity: linear in the edges and crossings.
class Input_crossings
{
  typedef Delta_complex::size_type size_type;

public:
  template <typename Integer>
  Input_crossings(const Integer_coordinates<Integer>& coordinates, const Delta_complex& mesh,
                  const Vertex_spokes& spokes)
    : m_first(first_crossings(coordinates, mesh)), m_crossing(m_first.back())
  {
    coordinates.for_each_curve_end(
      mesh, spokes, [&](Halfedge_index h, const Integer& k, Halfedge_index start) {
        if(start.idx() % 2 == 0)
          record(start, coordinates, coordinates.first_crossing(h, k, mesh), mesh);
      });
  }

  // returns the number of crossings on the edge `e` of T2
  size_type count(Edge_index e) const { return m_first[e.idx() + 1] - m_first[e]; }

  // returns the halfedge of T1 that crosses the first halfedge of `e` as its number `m` from left
  // to right
  Halfedge_index operator()(Edge_index e, std::size_t m) const
  {
    return m_crossing[m_first[e] + m];
  }

private:
  template <typename Integer>
  void record(Halfedge_index input, const Integer_coordinates<Integer>& coordinates,
              typename Integer_coordinates<Integer>::Crossing c, const Delta_complex& mesh)
  {
    typedef typename Integer_coordinates<Integer>::Turn Turn;
    do {
      const Edge_index e(c.halfedge);
      const size_type number = static_cast<size_type>(c.number);
      if(c.halfedge.idx() % 2 == 0)
        m_crossing[m_first[e] + number] = input;
      else
        m_crossing[m_first[e.idx() + 1] - 1 - number] = opposite(input);
    } while(coordinates.advance(c, mesh) != Turn::ends);
  }

  std::vector<size_type> m_first;
  std::vector<Halfedge_index> m_crossing;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_CROSSINGS_H
