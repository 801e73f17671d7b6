// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Delaunay_by_lengths.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_decisions_of.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/flipped_length.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Edge_stack.h>

#include <algorithm>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Exact decisions about flips, and lengths that stay within `certified_length_error()`: that of a
// flipped edge comes from its diamond as long as error bounds allow, otherwise from its strip.
template <typename Traits>
class Exact_flipping
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef Traced_crossings<Traits> Crossings;

public:
  // \pre the stored lengths are within `certified_length_error()`
  explicit Exact_flipping(Triangulation& tri)
    : m_tri(tri), m_mesh(tri.mesh()), m_decisions(tri, Crossings(tri))
  {
    // an edge of T1 has a length of a few roundings
    m_error.reserve(m_mesh.num_edges());
    for(Edge_index e : m_mesh.edges())
      m_error.push_back(static_cast<float>(m_decisions.is_input_edge(m_mesh.halfedge(e))
                                             ? input_length_error()
                                             : certified_length_error()));
  }

  bool is_certainly_Delaunay(Edge_index e) const
  {
    return m_by_lengths.is_certain(diamond(m_tri.length_map(), m_mesh.halfedge(e), m_mesh));
  }

  bool is_Delaunay(Edge_index e)
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    if(!m_tri.can_be_turned(h))
      return true;
    const Uncertain<bool> by_lengths = m_by_lengths(diamond(m_tri.length_map(), h, m_mesh));
    return is_certain(by_lengths) ? get_certain(by_lengths)
                                  : m_decisions.Delaunay_sign(h) != NEGATIVE;
  }

  // returns true: it is always possible
  bool flip(Halfedge_index h)
  {
    const Bounded_length flipped =
      flipped_length(diamond(m_tri.length_map(), h, m_mesh), greatest_error_around(h));
    const Edge_index e = m_mesh.edge(h);
    m_tri.turn(h, [&] {
      return flipped.is_good() && !m_tri.coordinates().is_shared(e) ? flipped.length
                                                                    : m_decisions.length(h);
    });
    m_error[e.idx()] =
      static_cast<float>(flipped.is_good() ? 2 * flipped.error : certified_length_error());
    return true;
  }

  // Computes all lengths anew.
  void recompute_lengths()
  {
    for(Edge_index e : m_mesh.edges())
      m_tri.m_length[e] = m_decisions.length(m_mesh.halfedge(e));
  }

private:
  double greatest_error_around(Halfedge_index h) const
  {
    float error = m_error[m_mesh.edge(h).idx()];
    for(Edge_index e : edges_around(h, m_mesh))
      error = (std::max)(error, m_error[e.idx()]);
    return double(error);
  }

  Triangulation& m_tri;
  const Delta_complex& m_mesh;
  Exact_decisions<Traits, Crossings> m_decisions;
  Delaunay_by_lengths m_by_lengths;
  std::vector<float> m_error; // relative error bounds of the lengths
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H
