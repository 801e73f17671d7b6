// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DIAGNOSIS_DIAGNOSE_COMPLEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DIAGNOSIS_DIAGNOSE_COMPLEX_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Input_diagnosis.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A corner names its vertex and the side of its face that leaves it.
// `forward` states whether that side runs from the first to the second end of its edge.
struct Edge_side
{
  std::size_t corner;
  bool forward;
};

// Faces glued along edges in any way whatever: any number of faces at an edge, any orientation.
// Faces that cannot take part in it have no corner.
struct Diagnosis_complex
{
  std::size_t number_of_vertices = 0;
  std::vector<std::size_t> first_corner = {0}; // of each face, and the end
  std::vector<std::size_t> corner_vertex;
  std::vector<std::size_t> corner_face;
  std::vector<std::array<std::size_t, 2>> edge_ends;
  std::vector<std::size_t> first_side = {0}; // of each edge, and the end
  std::vector<Edge_side> sides;              // grouped by edge
  std::vector<bool> is_mentioned;            // vertices named by a face, valid or not

  std::size_t number_of_faces() const { return first_corner.size() - 1; }
  std::size_t number_of_edges() const { return edge_ends.size(); }
  std::size_t degree(std::size_t f) const { return first_corner[f + 1] - first_corner[f]; }
  std::size_t sides_of(std::size_t e) const { return first_side[e + 1] - first_side[e]; }

  std::size_t next(std::size_t corner) const
  {
    const std::size_t f = corner_face[corner];
    return corner + 1 == first_corner[f + 1] ? first_corner[f] : corner + 1;
  }

  // Returns the corner of the side's face at end `end` of the edge.
  std::size_t corner_at(const Edge_side& side, int end) const
  {
    return side.forward == (end == 0) ? side.corner : next(side.corner);
  }

  Input_diagnosis::Occurrence vertex(std::size_t v) const
  {
    return {{v, Input_diagnosis::none}, Input_diagnosis::none};
  }

  Input_diagnosis::Occurrence face(std::size_t f) const
  {
    return {{Input_diagnosis::none, Input_diagnosis::none}, f};
  }

  Input_diagnosis::Occurrence edge(std::size_t e) const
  {
    const bool has_face = sides_of(e) > 0;
    return {edge_ends[e],
            has_face ? corner_face[sides[first_side[e]].corner] : Input_diagnosis::none};
  }

  void add_vertices(std::size_t n)
  {
    number_of_vertices = n;
    is_mentioned.assign(n, false);
  }

  void add_corner(std::size_t v)
  {
    corner_vertex.push_back(v);
    corner_face.push_back(number_of_faces());
    is_mentioned[v] = true;
  }

  void close_face() { first_corner.push_back(corner_vertex.size()); }

  void add_edge(std::size_t u, std::size_t v)
  {
    edge_ends.push_back({u, v});
    first_side.push_back(sides.size());
    is_mentioned[u] = is_mentioned[v] = true;
  }

  void add_side_of_last_edge(std::size_t corner, bool forward)
  {
    sides.push_back({corner, forward});
    first_side.back() = sides.size();
  }
};

// Faces given by vertex indices become a complex whose edges are pairs of vertices.
class Soup_complex_builder
{
public:
  Soup_complex_builder(std::size_t number_of_points, Input_diagnosis& diagnosis)
    : m_diagnosis(diagnosis), m_last_face(number_of_points, Input_diagnosis::none)
  {
    m_complex.add_vertices(number_of_points);
  }

  template <class PolygonRange>
  Diagnosis_complex operator()(const PolygonRange& polygons)
  {
    for(const auto& polygon : polygons)
      add_face(polygon);
    add_edges();
    return std::move(m_complex);
  }

private:
  template <class Polygon>
  void add_face(const Polygon& polygon)
  {
    if(is_usable(polygon))
      for(const auto& v : polygon)
        m_complex.add_corner(static_cast<std::size_t>(v));
    m_complex.close_face();
  }

  template <class Polygon>
  bool is_usable(const Polygon& polygon)
  {
    const std::size_t f = m_complex.number_of_faces();
    bool in_range = true, distinct = true;
    for(const auto& index : polygon) {
      const std::size_t v = static_cast<std::size_t>(index);
      if(v >= m_complex.number_of_vertices) {
        in_range = false;
        continue;
      }
      distinct = distinct && m_last_face[v] != f;
      m_last_face[v] = f;
      m_complex.is_mentioned[v] = true;
    }
    if(!in_range)
      m_diagnosis.add(Defect_kind::FACE_INDEX_OUT_OF_RANGE, m_complex.face(f));
    if(!distinct)
      m_diagnosis.add(Defect_kind::REPEATED_VERTEX_IN_FACE, m_complex.face(f));
    if(polygon.size() == 0)
      m_diagnosis.add(Defect_kind::NON_TRIANGULAR_FACE, m_complex.face(f));
    return in_range && distinct;
  }

  std::size_t smaller_end(std::size_t corner) const
  {
    return (std::min)(m_complex.corner_vertex[corner],
                      m_complex.corner_vertex[m_complex.next(corner)]);
  }

  std::size_t larger_end(std::size_t corner) const
  {
    return (std::max)(m_complex.corner_vertex[corner],
                      m_complex.corner_vertex[m_complex.next(corner)]);
  }

  // Counting sort: linear also at vertices of high degree, and stable.
  template <class Key>
  std::vector<std::size_t> sorted_by(const Key& key, const std::vector<std::size_t>& order) const
  {
    std::vector<std::size_t> position(m_complex.number_of_vertices + 1, 0);
    for(const std::size_t corner : order)
      ++position[key(corner) + 1];
    for(std::size_t v = 0; v < m_complex.number_of_vertices; ++v)
      position[v + 1] += position[v];
    std::vector<std::size_t> result(order.size());
    for(const std::size_t corner : order)
      result[position[key(corner)]++] = corner;
    return result;
  }

  void add_edges()
  {
    std::vector<std::size_t> order(m_complex.corner_vertex.size());
    for(std::size_t c = 0; c < order.size(); ++c)
      order[c] = c;
    order = sorted_by([this](std::size_t c) { return larger_end(c); }, order);
    order = sorted_by([this](std::size_t c) { return smaller_end(c); }, order);
    for(const std::size_t corner : order) {
      const std::array<std::size_t, 2> ends = {smaller_end(corner), larger_end(corner)};
      if(m_complex.edge_ends.empty() || m_complex.edge_ends.back() != ends)
        m_complex.add_edge(ends[0], ends[1]);
      m_complex.add_side_of_last_edge(corner, m_complex.corner_vertex[corner] == ends[0]);
    }
  }

  Input_diagnosis& m_diagnosis;
  Diagnosis_complex m_complex;
  std::vector<std::size_t> m_last_face; // that named the vertex
};

// Edges come from the halfedges, so that loops and parallel edges keep their identity.
template <class Graph>
class Graph_complex_builder
{
  using Traits = boost::graph_traits<Graph>;
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using Vertex_tag = CGAL::dynamic_vertex_property_t<std::size_t>;
  using Halfedge_tag = CGAL::dynamic_halfedge_property_t<std::size_t>;

public:
  explicit Graph_complex_builder(const Graph& g)
    : m_graph(g), m_vertex_index(get(Vertex_tag(), g)), m_corner(get(Halfedge_tag(), g))
  {}

  Diagnosis_complex operator()()
  {
    std::size_t n = 0;
    for(const vertex_descriptor v : vertices(m_graph))
      put(m_vertex_index, v, n++);
    m_complex.add_vertices(n);
    for(const auto f : faces(m_graph))
      add_face(halfedge(f, m_graph));
    for(const auto e : edges(m_graph))
      add_edge(halfedge(e, m_graph));
    return std::move(m_complex);
  }

private:
  std::size_t index_of_source(halfedge_descriptor h) const
  {
    return get(m_vertex_index, source(h, m_graph));
  }

  void add_face(halfedge_descriptor first)
  {
    halfedge_descriptor h = first;
    do {
      put(m_corner, h, m_complex.corner_vertex.size());
      m_complex.add_corner(index_of_source(h));
      h = next(h, m_graph);
    } while(h != first);
    m_complex.close_face();
  }

  void add_edge(halfedge_descriptor h)
  {
    const halfedge_descriptor o = opposite(h, m_graph);
    m_complex.add_edge(index_of_source(h), index_of_source(o));
    if(has_face(h))
      m_complex.add_side_of_last_edge(get(m_corner, h), true);
    if(has_face(o))
      m_complex.add_side_of_last_edge(get(m_corner, o), false);
  }

  bool has_face(halfedge_descriptor h) const { return face(h, m_graph) != Traits::null_face(); }

  const Graph& m_graph;
  Diagnosis_complex m_complex;
  typename boost::property_map<Graph, Vertex_tag>::const_type m_vertex_index;
  typename boost::property_map<Graph, Halfedge_tag>::const_type m_corner;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DIAGNOSIS_DIAGNOSE_COMPLEX_H
