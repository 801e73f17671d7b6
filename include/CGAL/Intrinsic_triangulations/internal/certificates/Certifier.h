// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTIFIER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTIFIER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delaunay_certificate.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Delaunay_by_lengths.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_crossings.h>

#include <CGAL/enum.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Proves that T2 is a geodesic triangulation and Delaunay, edge by edge.
template <typename Traits>
class Certifier
{
  typedef Triangulation_pair<Traits> Pair;

public:
  explicit Certifier(const Pair& pair)
    : m_pair(pair),
      m_mesh(pair.mesh()),
      m_decisions(pair, Input_crossings(pair.coordinates(), pair.mesh(), pair.spokes())),
      m_length(m_mesh.num_edges())
  {}

  Delaunay_certificate run()
  {
    if(m_pair.input_metric().points.empty())
      m_decisions.check_triangles();
    for(Edge_index e : m_mesh.edges())
      check_straightness(e);
    for(Edge_index e : m_mesh.edges())
      check_Delaunay(e);
    for(Vertex_index v : m_mesh.vertices())
      if(m_pair.is_inserted(v) && !is_turned_around_once(v))
        m_certificate.folded_vertices.push_back(v);
    m_certificate.decided_in_floating_point = m_decisions.count().floating_point;
    m_certificate.decided_in_multiprecision = m_decisions.count().multiprecision;
    m_certificate.decided_exactly = m_decisions.count().exact;
    return std::move(m_certificate);
  }

private:
  // notes the length too
  void check_straightness(Edge_index e)
  {
    const Straight_edge straight = m_decisions.straight_edge(m_mesh.halfedge(e));
    m_length[e] = straight.length;
    if(!straight.is_certain && !m_decisions.is_straight(m_mesh.halfedge(e)))
      m_certificate.bent_edges.push_back(e);
  }

  void check_Delaunay(Edge_index e)
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    const auto length = [this](Halfedge_index x) { return m_length[m_mesh.edge(x)]; };
    if(m_mesh.is_border(e) || m_pair.is_constrained(e))
      return;
    const Halfedge_index o = m_mesh.opposite(h);
    if(m_by_lengths.is_certain({length(h), length(m_mesh.next(h)), length(m_mesh.prev(h)),
                                length(m_mesh.next(o)), length(m_mesh.prev(o))})) {
      ++m_certificate.decided_by_lengths;
      return;
    }
    switch(m_decisions.Delaunay_sign(h)) {
      case POSITIVE: return;
      case ZERO: m_certificate.ties.push_back(e); return;
      case NEGATIVE: m_certificate.non_Delaunay_edges.push_back(e); return;
    }
  }

  // Returns whether the faces at an inserted vertex lie the right way round and around it once. The
  // sum of the angles is a multiple of a full turn (of a half turn on the boundary): rounding
  // does not matter.
  bool is_turned_around_once(Vertex_index v)
  {
    double sum = 0;
    bool is_oriented = true;
    for_each_spoke(v, m_mesh, [&](Halfedge_index h) {
      if(m_mesh.is_border(h))
        return;
      is_oriented = is_oriented && m_decisions.is_oriented(h);
      sum += m_decisions.rounded_angle(h);
    });
    return is_oriented && std::lround(sum / pi<double>()) == (m_mesh.is_border(v) ? 1 : 2);
  }

  const Pair& m_pair;
  const Delta_complex& m_mesh;
  Exact_decisions<Traits, Input_crossings> m_decisions;
  std::vector<double> m_length; // NaN if it is not known well enough
  Delaunay_by_lengths m_by_lengths;
  Delaunay_certificate m_certificate;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTIFIER_H
