// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DIAGNOSIS_DIAGNOSE_TOPOLOGY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DIAGNOSIS_DIAGNOSE_TOPOLOGY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Input_diagnosis.h>
#include <CGAL/Intrinsic_triangulations/internal/diagnosis/diagnose_complex.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

struct Disjoint_sets_storage
{
  explicit Disjoint_sets_storage(std::size_t n) : m_parent(n), m_rank(n, 0)
  {
    std::iota(m_parent.begin(), m_parent.end(), Diagnosis_complex::Index(0));
  }

  std::vector<Diagnosis_complex::Index> m_parent;
  std::vector<unsigned char> m_rank;
};

// Stores disjoint sets of the numbers below `n`, in a third of the memory of Boost's storage.
class Disjoint_sets : Disjoint_sets_storage,
                      public boost::disjoint_sets<unsigned char*, Diagnosis_complex::Index*>
{
public:
  explicit Disjoint_sets(std::size_t n)
    : Disjoint_sets_storage(n), disjoint_sets(m_rank.data(), m_parent.data())
  {}
};

// Diagnoses a complex without lengths.
class Topology_diagnoser
{
  using Index = Diagnosis_complex::Index;

  static constexpr Index no_edge = (std::numeric_limits<Index>::max)();

public:
  Topology_diagnoser(const Diagnosis_complex& complex, Input_diagnosis& diagnosis)
    : m_complex(complex),
      m_diagnosis(diagnosis),
      m_fans(complex.corner_vertex.size()),
      m_components(complex.number_of_faces())
  {}

  void operator()()
  {
    check_face_degrees();
    for(std::size_t e = 0; e < m_complex.number_of_edges(); ++e) {
      check_edge(e);
      glue_faces_along(e);
    }
    check_vertices();
    count_components();
    count_elements();
    m_diagnosis.statistics().boundary_loops = count_boundary_loops();
  }

private:
  const Edge_side& side(std::size_t e, std::size_t i) const
  {
    return m_complex.sides[m_complex.first_side[e] + i];
  }

  // Faces without corners have been reported already.
  void check_face_degrees()
  {
    for(std::size_t f = 0; f < m_complex.number_of_faces(); ++f)
      if(m_complex.degree(f) != 3 && m_complex.degree(f) != 0)
        m_diagnosis.add(Defect_kind::NON_TRIANGULAR_FACE, m_complex.face(f));
  }

  void check_edge(std::size_t e)
  {
    const std::size_t n = m_complex.sides_of(e);
    if(n == 0 || n > 2)
      m_diagnosis.add(Defect_kind::NON_MANIFOLD_EDGE, m_complex.edge(e));
    else if(n == 2 && side(e, 0).forward == side(e, 1).forward)
      m_diagnosis.add(Defect_kind::INCONSISTENT_ORIENTATION, m_complex.edge(e));
  }

  void glue_faces_along(std::size_t e)
  {
    for(std::size_t i = 1; i < m_complex.sides_of(e); ++i) {
      const Edge_side& s = side(e, 0);
      const Edge_side& t = side(e, i);
      m_components.union_set(m_complex.corner_face[s.corner], m_complex.corner_face[t.corner]);
      for(const int end : {0, 1})
        m_fans.union_set(m_complex.corner_at(s, end), m_complex.corner_at(t, end));
    }
  }

  void check_vertices()
  {
    std::vector<Index> fans(m_complex.number_of_vertices, 0);
    for(std::size_t c = 0; c < m_complex.corner_vertex.size(); ++c)
      if(m_fans.find_set(c) == c)
        ++fans[m_complex.corner_vertex[c]];
    for(std::size_t v = 0; v < fans.size(); ++v) {
      if(fans[v] > 1)
        m_diagnosis.add(Defect_kind::NON_MANIFOLD_VERTEX, m_complex.vertex(v));
      if(!m_complex.is_mentioned[v])
        m_diagnosis.add(Defect_kind::ISOLATED_VERTEX, m_complex.vertex(v));
    }
  }

  void count_components()
  {
    std::vector<std::size_t> first_faces;
    std::vector<bool> is_met(m_complex.number_of_faces(), false);
    for(std::size_t f = 0; f < m_complex.number_of_faces(); ++f) {
      const std::size_t root = m_components.find_set(f);
      if(m_complex.degree(f) > 0 && !is_met[root])
        first_faces.push_back(f);
      is_met[root] = true;
    }
    m_diagnosis.statistics().components = first_faces.size();
    if(first_faces.size() > 1)
      for(const std::size_t f : first_faces)
        m_diagnosis.add(Defect_kind::SEVERAL_COMPONENTS, m_complex.face(f));
  }

  void count_elements()
  {
    Input_diagnosis::Statistics& s = m_diagnosis.statistics();
    s.vertices = m_complex.number_of_vertices;
    s.edges = m_complex.number_of_edges();
    s.faces = m_complex.number_of_faces();
    s.euler_characteristic =
      static_cast<long>(s.vertices - m_diagnosis.count(Defect_kind::ISOLATED_VERTEX)) -
      static_cast<long>(s.edges) + static_cast<long>(s.faces);
  }

  // A boundary edge follows another one if both bound the same vertex fan.
  std::size_t count_boundary_loops()
  {
    std::vector<Index> boundary_corner(m_complex.corner_vertex.size(), no_edge);
    Disjoint_sets loops(m_complex.number_of_edges());
    std::size_t n = 0;
    for(std::size_t e = 0; e < m_complex.number_of_edges(); ++e)
      if(m_complex.sides_of(e) == 1) {
        ++n;
        for(const int end : {0, 1})
          n -= join_at(m_fans.find_set(m_complex.corner_at(side(e, 0), end)), e, boundary_corner,
                       loops);
      }
    return n;
  }

  // Returns 1 if the edge was joined with another loop.
  static std::size_t join_at(std::size_t fan, std::size_t e, std::vector<Index>& edge_at,
                             Disjoint_sets& loops)
  {
    if(edge_at[fan] == no_edge)
      edge_at[fan] = static_cast<Index>(e);
    const std::size_t a = loops.find_set(e), b = loops.find_set(edge_at[fan]);
    if(a == b)
      return 0;
    loops.link(a, b);
    return 1;
  }

  const Diagnosis_complex& m_complex;
  Input_diagnosis& m_diagnosis;
  Disjoint_sets m_fans;       // corners around a vertex, joined across edges
  Disjoint_sets m_components; // faces, joined across edges
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DIAGNOSIS_DIAGNOSE_TOPOLOGY_H
