// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_VERTEX_HEAP_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_VERTEX_HEAP_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Stores vertices with keys, the least key on top. Among equal keys, the vertex with the least
// number comes first.
class Vertex_heap
{
  typedef Intrinsic_triangulations::Vertex_index Vertex_index;

public:
  explicit Vertex_heap(std::size_t number_of_vertices) : m_place(number_of_vertices, nowhere) {}

  std::size_t size() const { return m_entries.size(); }
  Vertex_index vertex(std::size_t place) const { return m_entries[place].vertex; }
  bool empty() const { return m_entries.empty(); }
  Vertex_index top() const { return m_entries.front().vertex; }
  double key(Vertex_index v) const { return m_entries[m_place[v]].key; }
  bool contains(Vertex_index v) const { return m_place[v] != nowhere; }

  // Adds `v`, or changes its key.
  void set(Vertex_index v, double key)
  {
    if(!contains(v)) {
      m_place[v] = static_cast<std::uint32_t>(m_entries.size());
      m_entries.push_back({key, v});
      rise(m_place[v]);
      return;
    }
    const std::size_t place = m_place[v];
    const bool rises = key < m_entries[place].key;
    m_entries[place].key = key;
    if(rises)
      rise(place);
    else
      sink(place);
  }

  void remove(Vertex_index v)
  {
    set(v, -std::numeric_limits<double>::infinity());
    m_place[v] = nowhere;
    const Entry last = m_entries.back();
    m_entries.pop_back();
    if(!empty()) {
      put(0, last);
      sink(0);
    }
  }

private:
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t arity = 4;

  struct Entry
  {
    double key;
    Vertex_index vertex;

    friend bool operator<(const Entry& a, const Entry& b)
    {
      return a.key < b.key || (a.key == b.key && a.vertex < b.vertex);
    }
  };

  void put(std::size_t place, const Entry& entry)
  {
    m_entries[place] = entry;
    m_place[entry.vertex] = static_cast<std::uint32_t>(place);
  }

  void rise(std::size_t place)
  {
    const Entry entry = m_entries[place];
    while(place > 0) {
      const std::size_t parent = (place - 1) / arity;
      if(!(entry < m_entries[parent]))
        break;
      put(place, m_entries[parent]);
      place = parent;
    }
    put(place, entry);
  }

  void sink(std::size_t place)
  {
    const Entry entry = m_entries[place];
    for(;;) {
      const std::size_t child = least_child(place);
      if(child >= m_entries.size() || !(m_entries[child] < entry))
        break;
      put(place, m_entries[child]);
      place = child;
    }
    put(place, entry);
  }

  std::size_t least_child(std::size_t place) const
  {
    std::size_t least = place * arity + 1;
    for(std::size_t child = least + 1; child <= place * arity + arity; ++child)
      if(child < m_entries.size() && m_entries[child] < m_entries[least])
        least = child;
    return least;
  }

  std::vector<Entry> m_entries;
  std::vector<std::uint32_t> m_place; // of each vertex in the heap
};

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
// around a star waits for memory at each outgoing halfedge. Many simultaneous walks take hardly
// more time than one walk. On surfaces larger than the cache, waiting would take a quarter of the
// time. Results do not depend on it.
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

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_VERTEX_HEAP_H
