// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PART_STARTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PART_STARTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_tracer.h>

#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the positions on T2 at which the parts of the edges of T1 start, along the first halfedges
// of the edges. One part starts at the source, and one at each inserted vertex.
template <typename Traits>
class Part_starts
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::Integer Integer;
  typedef Delta_complex::size_type size_type;

public:
  // Numbers the parts, as marks on the edges of T1, and allocates memory for their starts.
  Part_starts(const Triangulation& tri, Edge_marks& numbers)
    : m_tri(tri), m_rank(tri.number_of_inserted_vertices()), m_numbers(numbers)
  {
    numbers = count_parts();
    m_starts.reserve(numbers.size());
  }

  // Allocates the starts. Must be called before `find()`.
  void resize() { m_starts.resize(m_numbers.size()); }

  // Finds the starts. Also stores the last outgoing halfedge at or clockwise from each halfedge of
  // T1 in `outgoing_before`.
  void find(std::vector<Halfedge_index>& outgoing_before, Concurrency concurrency)
  {
    for_each_in_chunks<Halfedge_index>(concurrency, m_tri.mesh(), [&](Halfedge_index h) {
      const Vertex_index v = m_tri.mesh().source(h);
      const auto note = [&](const Integer& k, Halfedge_index start) {
        if(!m_tri.is_inserted(v))
          outgoing_before[start.idx()] = h;
        if(is_first_halfedge(start))
          m_starts[number(Edge_index(start), v)] = {h, k};
      };
      if(m_tri.coordinates().is_shared(m_tri.mesh().edge(h)))
        note(Integer(-1), m_tri.input_halfedge(h));
      m_tri.coordinates().for_each_curve_end(h, m_tri.mesh(), m_tri.outgoing_halfedges(), note);
    });
  }

  // Returns the part of the edge `e` of T1 that starts at the vertex `v` of T2.
  const Curve_start<Integer>& operator()(Edge_index e, Vertex_index v) const
  {
    return m_starts[number(e, v)];
  }

private:
  // Parts of an edge are in the order of the indices of their starts.
  Edge_marks count_parts()
  {
    std::vector<size_type> count(m_tri.input_mesh().num_edges(), 1);
    for(std::size_t i = 0; i < m_rank.size(); ++i) {
      const auto* p = on_edge(m_tri.inserted_vertices()[i]);
      if(p != nullptr)
        m_rank[i] = count[Edge_index(p->halfedge).idx()]++;
    }
    return Edge_marks(std::move(count));
  }

  size_type number(Edge_index e, Vertex_index v) const
  {
    return m_numbers.before(e) +
           (m_tri.is_inserted(v) ? m_rank[v.idx() - m_tri.input_mesh().number_of_vertices()] : 0);
  }

  const Triangulation& m_tri;
  std::vector<size_type> m_rank; // of each inserted vertex on its edge
  const Edge_marks& m_numbers;
  std::vector<Curve_start<Integer>> m_starts;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_PART_STARTS_H
