// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_OVERLAY_BASELINE_H
#define INTRINSIC_BENCHMARK_OVERLAY_BASELINE_H

#include "Flipped_mesh.h"
#include "Overlay_mesh.h"
#include "method.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <cstddef>
#include <vector>

namespace Methods {

// Implements the explicit overlay (Fisher, Springborn, Schroeder, Bobenko 2006). The common
// subdivision always exists, and every flip changes it. The connectivity alone determines which
// curves of T1 the new edge crosses, and in which order. A flip takes time linear in the crossings
// of its quadrangle.
class Overlay_baseline
{
public:
  explicit Overlay_baseline(const IT::Intrinsic_triangulation<>& tri)
    : m_tri(tri), m_overlay(m_tri.input())
  {
    for(Halfedge_index h : m_tri.mesh().halfedges())
      m_first.push_back(h);
  }

  std::size_t make_Delaunay()
  {
    return m_tri.make_Delaunay([this](Halfedge_index h) {
      remove_path(h);
      insert_path(m_tri.mesh().opposite(h));
    });
  }

  Subdivision_size subdivide() const
  {
    const Subdivision_size size{m_overlay.number_of_vertices(), m_overlay.number_of_edges(),
                                count_faces()};
    check(size, m_tri.input());
    return size;
  }

private:
  typedef Overlay_mesh::Halfedge Halfedge;
  typedef Overlay_mesh::Vertex Vertex;

  // ---- Removal ----

  std::vector<Halfedge> path(Halfedge_index h) const
  {
    std::vector<Halfedge> result{m_first[h]};
    while(m_overlay.is_crossing(m_overlay.target(result.back())))
      result.push_back(m_overlay.straight_on(result.back()));
    return result;
  }

  void remove_path(Halfedge_index h)
  {
    const std::vector<Halfedge> pieces = path(h);
    if(m_overlay.input(pieces[0]).is_valid() && m_overlay.intrinsic(pieces[0]).is_valid()) {
      m_overlay.set_intrinsic(pieces[0], Halfedge_index(), Halfedge_index());
      return;
    }
    std::vector<Vertex> crossings;
    for(std::size_t k = 1; k < pieces.size(); ++k)
      crossings.push_back(m_overlay.source(pieces[k]));
    for(Halfedge piece : pieces)
      m_overlay.remove_edge(piece);
    for(Vertex w : crossings)
      m_overlay.unsplit(w);
  }

  // ---- Insertion ----

  // Represents the quadrangle k-i-l-j around the new edge of T2 from k to l, with only curves of T1
  // inside. Its boundary from k over i to l comes before l, and its boundary from l over j to k
  // comes after l.
  struct Quadrangle
  {
    Halfedge_index kl, lk, ki, il, lj, jk;
  };
  enum class Place
  {
    before,
    at,
    after
  };

  Quadrangle quadrangle(Halfedge_index kl) const
  {
    const Delta_complex& mesh = m_tri.mesh();
    const Halfedge_index lk = mesh.opposite(kl);
    return {kl, lk, mesh.next(lk), mesh.prev(lk), mesh.next(kl), mesh.prev(kl)};
  }

  // Returns the end of the halfedge `x` in the quadrangle.
  Place end(Halfedge x, const Quadrangle& q) const
  {
    Halfedge side = m_overlay.next(x);
    while(!m_overlay.intrinsic(side).is_valid())
      side = m_overlay.previous_around_source(side);
    const Halfedge_index h = m_overlay.intrinsic(side);
    const bool is_corner = !m_overlay.is_crossing(m_overlay.source(side));
    if(h == q.il || (h == q.ki && !is_corner))
      return Place::before;
    return h == q.lj && is_corner ? Place::at : Place::after;
  }

  void set_path(Halfedge x, const Quadrangle& q)
  {
    m_overlay.set_intrinsic(x, q.kl, q.lk);
    if(!m_overlay.is_crossing(m_overlay.source(x)))
      m_first[q.kl] = x;
    if(!m_overlay.is_crossing(m_overlay.target(x)))
      m_first[q.lk] = Overlay_mesh::twin(x);
  }

  void insert_path(Halfedge_index kl)
  {
    const Quadrangle q = quadrangle(kl);
    Halfedge start = m_first[q.ki];
    for(;;) {
      const Halfedge outgoing = m_overlay.next_around_source(start);
      const Place place =
        m_overlay.intrinsic(outgoing).is_valid() ? Place::after : end(outgoing, q);
      if(place == Place::at)
        return set_path(outgoing, q);
      if(place == Place::after)
        return cut_to_end(start, q);
      start = outgoing;
    }
  }

  // Cuts faces one after the other, the first one at the source of `from`.
  void cut_to_end(Halfedge from, const Quadrangle& q)
  {
    Halfedge x = from;
    for(std::size_t step = 0; step < m_overlay.number_of_halfedges(); ++step)
      switch(end(x, q)) {
        case Place::before: x = m_overlay.next(x); break;
        case Place::at: return set_path(m_overlay.cut(from, m_overlay.next(x)), q);
        case Place::after:
          if(m_overlay.intrinsic(x).is_valid())
            throw Failure("an edge leaves its quadrangle");
          set_path(m_overlay.cut(from, m_overlay.split(x)), q);
          x = from = Overlay_mesh::twin(x);
      }
    throw Failure("an edge does not reach its end");
  }

  // ---- Faces ----

  bool is_border(Halfedge x) const
  {
    const Halfedge_index h = m_overlay.input(x);
    return h.is_valid() && m_tri.input().is_border(h);
  }

  std::size_t count_faces() const
  {
    std::size_t count = 0;
    std::vector<char> is_seen(m_overlay.number_of_halfedges(), 0);
    for(Halfedge first = 0; first < is_seen.size(); ++first) {
      if(m_overlay.is_removed(first) || is_seen[first] || is_border(first))
        continue;
      std::size_t degree = 0;
      for(Halfedge x = first; !is_seen[x]; x = m_overlay.next(x)) {
        is_seen[x] = 1;
        ++degree;
      }
      if(degree < 3 || degree > 6)
        throw Failure("a face is no convex polygon");
      ++count;
    }
    return count;
  }

  Flipped_mesh m_tri;
  Overlay_mesh m_overlay;
  std::vector<Halfedge> m_first; // of the path of each halfedge of T2
};

} // namespace Methods

#endif // INTRINSIC_BENCHMARK_OVERLAY_BASELINE_H
