// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CARRIED_PLACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CARRIED_PLACES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The places of a path on a triangulation, as they are found. A straight path does not cross the
// edges that start at a vertex which it leaves, or to which it comes; where rounding has it do so,
// these crossings are left out.
template <typename FT>
class Carried_places
{
  typedef Surface_place<FT> Place;

public:
  explicit Carried_places(const Delta_complex& mesh) : m_mesh(mesh) {}

  bool is_empty() const { return m_places.empty(); }

  // adds a place that stays
  void add(const Place& p)
  {
    m_places.push_back(p);
    m_crossings = 0;
  }

  void add_crossing(const Place& x)
  {
    const Halfedge_index h = x.along, o = m_mesh.opposite(h);
    if(!m_places.empty() && is_at_vertex(m_places.back())) {
      const Halfedge_index from = m_places.back().along;
      if(from == h || from == m_mesh.next(h)) {
        go_on_along(from == h ? m_mesh.next(o) : o);
        return;
      }
    }
    m_places.push_back(x);
    ++m_crossings;
  }

  // Ends at the vertex where `back` starts, with the path on its left. A path through a face from
  // vertex to vertex follows an edge.
  void come_to_vertex(Halfedge_index back)
  {
    for(; m_crossings > 0; --m_crossings) {
      const Halfedge_index h = m_places.back().along, o = m_mesh.opposite(h);
      if(back != o && back != m_mesh.next(o))
        return;
      back = back == o ? m_mesh.next(h) : h;
      m_places.pop_back();
    }
    if(!m_places.empty() && is_at_vertex(m_places.back()) &&
       m_mesh.next(back) == m_places.back().along)
      go_on_along(m_mesh.opposite(back));
  }

  std::vector<Place> release() { return std::move(m_places); }

private:
  // the path leaves the vertex where it is along `h`, or beside it on the left
  void go_on_along(Halfedge_index h)
  {
    m_places.back() = place_on(Edge_point<FT>{h, FT(0)}, m_mesh);
  }

  const Delta_complex& m_mesh;
  std::vector<Place> m_places;
  std::size_t m_crossings = 0; // the last places that are crossings
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CARRIED_PLACES_H
