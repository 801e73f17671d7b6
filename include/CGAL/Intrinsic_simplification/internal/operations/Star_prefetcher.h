// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_STAR_PREFETCHER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_STAR_PREFETCHER_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_simplification/internal/operations/Vertex_heap.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Requests a byte of memory that will be read soon, which affects only time.
inline void prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

// Requests some bytes, at most two lines of the cache.
inline void prefetch(const void* address, std::size_t size)
{
  prefetch(address);
  prefetch(static_cast<const char*>(address) + size - 1);
}

// Requests the data of a cost for a vertex. For an unknown cost, requests nothing.
inline void prefetch_vertex(Intrinsic_triangulations::Vertex_index, const void*) {}

// Brings the stars of the vertices near the top of a heap into the cache, many at once. A walk
// around a star waits for memory at each outgoing halfedge. Many simultaneous walks hardly wait
// longer than one. On surfaces larger than the cache, waiting would take a quarter of the time.
// Results do not depend on it.
class Star_prefetcher
{
public:
  template <typename Cost>
  void operator()(const Vertex_heap& heap, const Intrinsic_surface& surface, const Cost& cost)
  {
    if(is_recent(heap.top()))
      return;
    for(std::size_t place = 0; place < heap.size() && place < number_at_once; ++place)
      if(!is_recent(heap.vertex(place)))
        start(heap.vertex(place), surface, cost);
    for(std::size_t left; !m_walks.empty(); m_walks.resize(left)) {
      left = 0;
      for(Walk walk : m_walks)
        if(step(walk, surface, cost))
          m_walks[left++] = walk;
    }
  }

private:
  struct Walk
  {
    Halfedge_index outgoing, first;
  };

  static constexpr std::size_t number_at_once = 21; // three levels of the heap

  bool is_recent(Vertex_index v) const { return m_recent[slot(v)] == v; }

  static std::size_t slot(Vertex_index v) { return (v.idx() * 2654435769U) >> 22U; }

  template <typename Cost>
  void start(Vertex_index v, const Intrinsic_surface& surface, const Cost& cost)
  {
    m_recent[slot(v)] = v;
    prefetch_vertex(v, &cost);
    const Halfedge_index first = first_outgoing_halfedge(v, surface.mesh());
    m_walks.push_back({first, first});
  }

  // Returns whether a next outgoing halfedge exists.
  template <typename Cost>
  static bool step(Walk& walk, const Intrinsic_surface& surface, const Cost& cost)
  {
    const Delta_complex& mesh = surface.mesh();
    const Halfedge_index h = walk.outgoing;
    prefetch(&surface.direction(h));
    prefetch(&surface.length_map()[mesh.edge(h)]);
    prefetch_vertex(mesh.target(h), &cost);
    if(mesh.is_border(h))
      return false;
    prefetch(&surface.length_map()[mesh.edge(mesh.next(h))]);
    walk.outgoing = next_around_source(h, mesh);
    return walk.outgoing != walk.first;
  }

  std::array<Vertex_index, 1024> m_recent; // the last vertex of each slot
  std::vector<Walk> m_walks;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_STAR_PREFETCHER_H
