// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DIAGNOSE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DIAGNOSE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Input_diagnosis.h>
#include <CGAL/Intrinsic_triangulations/internal/diagnosis/diagnose_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/diagnosis/diagnose_metric.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
namespace internal {

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
    check_orientability();
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

  // Glues two copies of each face, one for each orientation, along edges with two faces. If both
  // copies of a face become connected, no orientation of its component is consistent.
  void check_orientability()
  {
    if(m_diagnosis.count(Defect_kind::INCONSISTENT_ORIENTATION) == 0)
      return;
    const std::size_t n = m_complex.number_of_faces();
    Disjoint_sets copies(2 * n);
    for(std::size_t e = 0; e < m_complex.number_of_edges(); ++e)
      if(m_complex.sides_of(e) == 2) {
        const Edge_side &s = side(e, 0), &t = side(e, 1);
        const std::size_t f = m_complex.corner_face[s.corner], g = m_complex.corner_face[t.corner];
        const bool is_reversed = s.forward == t.forward;
        copies.union_set(f, is_reversed ? g + n : g);
        copies.union_set(f + n, is_reversed ? g : g + n);
      }
    std::vector<bool> is_met(2 * n, false);
    for(std::size_t f = 0; f < n; ++f) {
      const std::size_t root = copies.find_set(f);
      if(root == copies.find_set(f + n) && !is_met[root])
        m_diagnosis.add(Defect_kind::NON_ORIENTABLE_COMPONENT, m_complex.face(f));
      is_met[root] = true;
    }
  }

  void check_vertices()
  {
    std::vector<Index> fans(m_complex.number_of_vertices, 0);
    for(std::size_t c = 0; c < m_complex.corner_vertex.size(); ++c)
      if(m_fans.find_set(c) == c)
        ++fans[m_complex.corner_vertex[c]];
    for(std::size_t v = 0; v < fans.size(); ++v) {
      if(fans[v] > 1) {
        m_diagnosis.add(Defect_kind::NON_MANIFOLD_VERTEX, m_complex.vertex(v));
        m_number_of_further_fans += fans[v] - 1;
      }
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
    s.faces = number_of_usable_faces();
    s.euler_characteristic =
      static_cast<long>(number_of_used_vertices() + m_number_of_further_fans) -
      static_cast<long>(s.edges) + static_cast<long>(s.faces);
  }

  // Returns the number of faces with corners. Other faces have no edges either.
  std::size_t number_of_usable_faces() const
  {
    std::size_t result = 0;
    for(std::size_t f = 0; f < m_complex.number_of_faces(); ++f)
      result += m_complex.degree(f) > 0;
    return result;
  }

  // Returns the number of vertices with edges.
  std::size_t number_of_used_vertices() const
  {
    std::vector<bool> is_used(m_complex.number_of_vertices, false);
    for(const auto& ends : m_complex.edge_ends)
      is_used[ends[0]] = is_used[ends[1]] = true;
    return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), true));
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
  std::size_t m_number_of_further_fans = 0; // beyond the first one of each vertex
  Disjoint_sets m_fans;                     // corners around a vertex, joined across edges
  Disjoint_sets m_components;               // faces, joined across edges
};

// Diagnoses a complex whose lengths follow from `data`: from points, or the lengths themselves.
template <class Metric, class Data>
void diagnose_with(const Diagnosis_complex& complex, const Data& data, Input_diagnosis& diagnosis)
{
  Topology_diagnoser(complex, diagnosis)();
  Metric_diagnoser<Metric>(complex, Metric(complex, data, diagnosis), diagnosis)();
}

} // namespace internal

/*!
\ingroup PkgIntrinsicTriangulationsDiagnosis

\brief finds all defects of a polygon soup, as read from a file, that prevent an intrinsic
triangulation.

A face with a repeated vertex or an index out of range is reported and left out of all other checks.
An index that is negative counts as out of range. Positions are rounded to `double`.

\tparam PointRange a model of `RandomAccessContainer` whose value type has three coordinates under
        `operator[]`, of a type that is a model of `RealEmbeddable`
\tparam PolygonRange a range of ranges of integers
\param points the points
\param polygons the faces, as indices of points
\param kept_occurrences the number of occurrences of each kind of defect that are kept
\returns the defects found and numbers about the surface

Complexity: linear in the size of the soup, up to sorting the edges at each vertex and the inverse
of Ackermann's function.
\throws std::length_error if there are \f$2^{32}-1\f$ points or corners of faces, or more
*/
template <class PointRange, class PolygonRange>
Input_diagnosis
diagnose_polygon_soup(const PointRange& points, const PolygonRange& polygons,
                      std::size_t kept_occurrences = Input_diagnosis::maximal_number_of_occurrences)
{
  Input_diagnosis result(kept_occurrences);
  const internal::Diagnosis_complex complex =
    internal::Soup_complex_builder(points.size(), result)(polygons);
  internal::diagnose_with<internal::Embedded_metric<PointRange>>(complex, points, result);
  return result;
}

/*!
\ingroup PkgIntrinsicTriangulationsDiagnosis

\brief examines a graph for everything that keeps an intrinsic triangulation from being built on it.

Loops and parallel edges are no defects. A vertex with several fans of faces is one.
Elements are given by their positions in `vertices(g)` and `faces(g)`.

\tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam NamedParameters a sequence of named parameters
\param g the graph
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the positions of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` whose value type has three coordinates under
                   `operator[]`}
    \cgalParamDefault{`get(CGAL::vertex_point, g)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_length_map}
    \cgalParamDescription{the lengths of the edges, in place of positions; rounded to `double`}
    \cgalParamType{a model of `ReadablePropertyMap`}
    \cgalParamDefault{the distances of the positions}
  \cgalParamNEnd
\cgalNamedParamsEnd
\returns the defects found and numbers about the surface

Complexity: linear in the size of the graph, up to the inverse of Ackermann's function.
*/
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
Input_diagnosis diagnose(const Graph& g,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  Input_diagnosis result;
  const internal::Diagnosis_complex complex = internal::Graph_complex_builder<Graph>(g)();
  if constexpr(!internal::has_parameter<NamedParameters, internal_np::edge_length_map_t>()) {
    const auto vpm = internal::vertex_points(g, np);
    using Point = typename boost::property_traits<std::decay_t<decltype(vpm)>>::value_type;
    std::vector<Point> points;
    points.reserve(complex.number_of_vertices);
    for(const auto v : vertices(g))
      points.push_back(get(vpm, v));
    internal::diagnose_with<internal::Embedded_metric<std::vector<Point>>>(complex, points, result);
  } else {
    const auto map = CGAL::parameters::get_parameter(np, internal_np::edge_length_map);
    std::vector<double> lengths;
    lengths.reserve(complex.number_of_edges());
    for(const auto e : edges(g))
      lengths.push_back(CGAL::to_double(get(map, e)));
    internal::diagnose_with<internal::Abstract_metric>(complex, lengths, result);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DIAGNOSE_H
