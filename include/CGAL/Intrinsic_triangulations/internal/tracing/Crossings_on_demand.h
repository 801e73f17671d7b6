// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSINGS_ON_DEMAND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSINGS_ON_DEMAND_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Crossing_lists.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Traced_crossings.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// The halfedges of T1 that cross an edge of T2, while T2 changes by flips: followed to their ends,
// and listed when that has taken more steps than there are crossings. Where edges of T1 cross
// a large part of T2, following each crossing would take quadratic time.
template <typename Traits>
class Crossings_on_demand
{
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  explicit Crossings_on_demand(const Triangulation& tri)
    : m_tri(tri), m_traced(tri), m_allowed(static_cast<double>(tri.mesh().num_edges()))
  {}

  // returns the number of crossings on the edge of `h`
  std::size_t count(Halfedge_index h) const { return m_traced.count(h); }

  // returns the halfedge of T1 that crosses `h` as its crossing `m` from left to right
  Halfedge_index operator()(Halfedge_index h, std::size_t m) const
  {
    if(!m_lists && static_cast<double>(m_steps) > m_allowed)
      list_if_faster(static_cast<double>(m_steps));
    return m_lists ? (*m_lists)(h, m) : m_traced.follow(h, m, m_steps);
  }

  // to be called after the edge of `h` has been flipped
  void after_flip(Halfedge_index h)
  {
    if(m_lists)
      m_lists->after_flip(h);
  }

private:
  // Looks at all edges; so the next time comes after twice as many steps.
  void list_if_faster(double steps) const
  {
    double crossings = 0;
    for(Edge_index e : m_tri.mesh().edges())
      crossings += static_cast<double>(m_tri.coordinates().crossings(first_halfedge(e)));
    if(steps > crossings)
      m_lists.emplace(m_tri);
    m_allowed = (std::max)(crossings, 2 * steps);
  }

  const Triangulation& m_tri;
  Traced_crossings<Traits> m_traced;
  mutable std::optional<Crossing_lists<Traits>> m_lists;
  mutable std::size_t m_steps = 0;
  mutable double m_allowed; // steps after which lists may be faster
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSINGS_ON_DEMAND_H
