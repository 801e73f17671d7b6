// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_CROSSINGS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The indices of the crossings on all edges of T2.
template <typename Integer>
Edge_marks number_crossings(const Integer_coordinates<Integer>& coordinates,
                            const Delta_complex& mesh, Concurrency concurrency)
{
  std::vector<Delta_complex::size_type> count(mesh.num_edges(), 0);
  for_each_in_chunks<Edge_index>(concurrency, mesh, [&](Edge_index e) {
    count[e.idx()] = countable(coordinates.crossings(first_halfedge(e)));
  });
  return Edge_marks(std::move(count));
}

// The halfedges of T1 that cross each edge of T2, in order. No geometry.
// Complexity: linear in the edges and crossings.
class Input_crossings
{
  typedef Delta_complex::size_type size_type;

public:
  template <typename Integer>
  Input_crossings(const Integer_coordinates<Integer>& coordinates, const Delta_complex& mesh,
                  const Vertex_spokes& spokes, Concurrency concurrency = Concurrency())
    : m_marks(number_crossings(coordinates, mesh, concurrency)), m_crossing(m_marks.size())
  {
    for_each_in_chunks<Edge_index>(concurrency, mesh, [&](Edge_index e) {
      const Halfedge_index h = first_halfedge(e), o = opposite(h);
      if(count(e) == 1 && coordinates.curves_leaving(h, mesh) == 1 &&
         coordinates.curves_leaving(o, mesh) == 1) {
        // its curve crosses nothing else: either end will do
        m_crossing[m_marks(h, 0)] = coordinates.spoke_in_corner(mesh.prev(h), 0, mesh, spokes);
      } else if(count(e) > 0)
        for(Halfedge_index side : {h, o})
          record_curves(mesh.prev(side), coordinates, mesh, spokes);
    });
  }

  // returns the number of crossings on the edge `e` of T2
  size_type count(Edge_index e) const { return m_marks.size(e); }
  // returns the number of crossings on the edge of `h`
  size_type count(Halfedge_index h) const { return m_marks.size(Edge_index(h)); }

  // returns the halfedge of T1 that crosses the halfedge `h` as its crossing `m` from left to right
  Halfedge_index operator()(Halfedge_index h, std::size_t m) const
  {
    return directed_as(h, m_crossing[m_marks(h, static_cast<size_type>(m))]);
  }

private:
  // those that start inside the corner at the source of `spoke`
  template <typename Integer>
  void record_curves(Halfedge_index spoke, const Integer_coordinates<Integer>& coordinates,
                     const Delta_complex& mesh, const Vertex_spokes& spokes)
  {
    coordinates.for_each_curve_end(
      spoke, mesh, spokes, [&](const Integer& k, Halfedge_index start) {
        if(is_first_halfedge(start))
          record(start, coordinates, coordinates.first_crossing(spoke, k, mesh), mesh);
      });
  }

  template <typename Integer>
  void record(Halfedge_index input, const Integer_coordinates<Integer>& coordinates,
              typename Integer_coordinates<Integer>::Crossing c, const Delta_complex& mesh)
  {
    typedef typename Integer_coordinates<Integer>::Turn Turn;
    do
      m_crossing[m_marks(c.halfedge, static_cast<size_type>(c.number))] =
        directed_as(c.halfedge, input);
    while(coordinates.advance(c, mesh) != Turn::ends);
  }

  Edge_marks m_marks;
  std::vector<Halfedge_index> m_crossing;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_CROSSINGS_H
