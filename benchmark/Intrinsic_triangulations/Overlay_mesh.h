// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_OVERLAY_MESH_H
#define INTRINSIC_BENCHMARK_OVERLAY_MESH_H

#include "method.h"

#include <cstddef>
#include <vector>

namespace Methods {

// Represents the mesh into which the edges of T1 and T2 cut the surface, as halfedges that change.
// A halfedge stores the halfedges of T1 and of T2 along which it runs, if any. The number of its
// twin differs in the last bit.
class Overlay_mesh
{
public:
  typedef std::size_t Halfedge;
  typedef std::size_t Vertex;

  // Constructs the mesh for T1 = T2, with the same numbers.
  explicit Overlay_mesh(const Delta_complex& mesh)
    : m_number_of_input_vertices(mesh.number_of_vertices()), m_out(mesh.number_of_vertices())
  {
    for(Halfedge_index h : mesh.halfedges()) {
      m_halfedges.push_back({mesh.next(h), mesh.prev(h), mesh.source(h), h, h});
      m_out[mesh.source(h).idx()] = h;
    }
    m_is_removed.assign(m_halfedges.size() / 2, 0);
  }

  static Halfedge twin(Halfedge h) { return h ^ 1; }
  std::size_t number_of_halfedges() const { return m_halfedges.size(); }
  bool is_removed(Halfedge h) const { return m_is_removed[h / 2] != 0; }
  Halfedge next(Halfedge h) const { return m_halfedges[h].next; }
  Halfedge prev(Halfedge h) const { return m_halfedges[h].prev; }
  Vertex source(Halfedge h) const { return m_halfedges[h].source; }
  Vertex target(Halfedge h) const { return source(twin(h)); }
  Halfedge_index input(Halfedge h) const { return m_halfedges[h].input; }
  Halfedge_index intrinsic(Halfedge h) const { return m_halfedges[h].intrinsic; }
  bool is_crossing(Vertex v) const { return v >= m_number_of_input_vertices; }

  // Returns the outgoing halfedges before and after `h` in counterclockwise order around its
  // source.
  Halfedge next_around_source(Halfedge h) const { return twin(prev(h)); }
  Halfedge previous_around_source(Halfedge h) const { return next(twin(h)); }

  // Returns the halfedge straight beyond the crossing at the end of `h`.
  Halfedge straight_on(Halfedge h) const { return previous_around_source(next(h)); }

  // Sets the halfedge of T2 along which `h` runs, or null if it no longer follows one.
  void set_intrinsic(Halfedge h, Halfedge_index intrinsic, Halfedge_index opposite)
  {
    m_halfedges[h].intrinsic = intrinsic;
    m_halfedges[twin(h)].intrinsic = opposite;
  }

  // Inserts a crossing on `h`, which then ends at it. Returns the part beyond.
  Halfedge split(Halfedge h)
  {
    const Halfedge beyond = add_edge(), t = twin(h), back = twin(beyond);
    const Vertex w = add_crossing(beyond), q = source(t);
    m_halfedges[beyond].input = input(h);
    m_halfedges[back].input = input(t);
    m_halfedges[beyond].source = w;
    m_halfedges[back].source = q;
    m_halfedges[t].source = w;
    m_out[q] = back;
    link(beyond, next(h));
    link(h, beyond);
    link(prev(t), back);
    link(back, t);
    return beyond;
  }

  // Removes the crossing `w`, at which at most one edge of T1 remains.
  void unsplit(Vertex w)
  {
    const Halfedge beyond = m_out[w], back = twin(beyond), h = prev(beyond), t = twin(h);
    link(h, next(beyond));
    link(prev(back), t);
    m_halfedges[t].source = source(back);
    m_out[source(t)] = t;
    release_edge(beyond);
    m_free_crossings.push_back(w);
  }

  // Cuts a face from the source of `a` to the source of `b`, two of its halfedges.
  Halfedge cut(Halfedge a, Halfedge b)
  {
    const Halfedge h = add_edge(), t = twin(h);
    m_halfedges[h].source = source(a);
    m_halfedges[t].source = source(b);
    link(prev(a), h);
    link(prev(b), t);
    link(h, b);
    link(t, a);
    return h;
  }

  // Joins the faces on both sides.
  void remove_edge(Halfedge h)
  {
    const Halfedge t = twin(h);
    m_out[source(h)] = next(t);
    m_out[source(t)] = next(h);
    link(prev(h), next(t));
    link(prev(t), next(h));
    release_edge(h);
  }

  std::size_t number_of_vertices() const { return m_out.size() - m_free_crossings.size(); }
  std::size_t number_of_edges() const { return m_halfedges.size() / 2 - m_free_edges.size(); }

private:
  struct Record
  {
    Halfedge next, prev;
    Vertex source;
    Halfedge_index input, intrinsic;
  };

  void link(Halfedge h, Halfedge next)
  {
    m_halfedges[h].next = next;
    m_halfedges[next].prev = h;
  }

  Halfedge add_edge()
  {
    if(m_free_edges.empty()) {
      m_free_edges.push_back(m_halfedges.size());
      m_halfedges.resize(m_halfedges.size() + 2);
      m_is_removed.push_back(1);
    }
    const Halfedge h = m_free_edges.back();
    m_free_edges.pop_back();
    m_is_removed[h / 2] = 0;
    m_halfedges[h] = m_halfedges[twin(h)] = Record{};
    return h;
  }

  void release_edge(Halfedge h)
  {
    m_is_removed[h / 2] = 1;
    m_free_edges.push_back(h & ~Halfedge(1));
  }

  Vertex add_crossing(Halfedge out)
  {
    if(m_free_crossings.empty()) {
      m_free_crossings.push_back(m_out.size());
      m_out.push_back(out);
    }
    const Vertex w = m_free_crossings.back();
    m_free_crossings.pop_back();
    m_out[w] = out;
    return w;
  }

  std::size_t m_number_of_input_vertices;
  std::vector<Record> m_halfedges;
  std::vector<char> m_is_removed;
  std::vector<Halfedge> m_out; // of each vertex
  std::vector<Halfedge> m_free_edges;
  std::vector<Vertex> m_free_crossings;
};

} // namespace Methods

#endif // INTRINSIC_BENCHMARK_OVERLAY_MESH_H
