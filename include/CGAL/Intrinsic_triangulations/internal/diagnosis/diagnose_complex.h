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
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents a side of a face by a corner: its vertex and the side that leaves it. `forward` states
// whether that side runs from the first to the second end of its edge.
struct Edge_side
{
  std::uint32_t corner;
  bool forward;
};

// Represents faces glued arbitrarily along edges: any number of faces at an edge, any orientation.
// Faces that cannot be part of it have no corner. Indices have 32 bits, as in `Surface_mesh`.
struct Diagnosis_complex
{
  typedef std::uint32_t Index;

  std::size_t number_of_vertices = 0;
  std::vector<Index> first_corner = {0}; // of each face, and the end
  std::vector<Index> corner_vertex;
  std::vector<Index> corner_face;
  std::vector<std::array<Index, 2>> edge_ends;
  std::vector<Index> first_side = {0}; // of each edge, and the end
  std::vector<Edge_side> sides;        // grouped by edge
  std::vector<bool> is_mentioned;      // vertices named by a face, valid or not

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
    return {{edge_ends[e][0], edge_ends[e][1]},
            has_face ? corner_face[sides[first_side[e]].corner] : Input_diagnosis::none};
  }

  // Checks that indices suffice for `n` elements.
  // \throws std::length_error if they do not
  static void check_number(std::size_t n)
  {
    if(n >= (std::numeric_limits<Index>::max)())
      throw std::length_error("the surface has too many elements");
  }

  void add_vertices(std::size_t n)
  {
    check_number(n);
    number_of_vertices = n;
    is_mentioned.assign(n, false);
  }

  void add_corner(std::size_t v)
  {
    corner_vertex.push_back(static_cast<Index>(v));
    corner_face.push_back(static_cast<Index>(number_of_faces()));
    is_mentioned[v] = true;
  }

  void close_face()
  {
    check_number(corner_vertex.size());
    first_corner.push_back(static_cast<Index>(corner_vertex.size()));
  }

  void add_edge(std::size_t u, std::size_t v)
  {
    edge_ends.push_back({static_cast<Index>(u), static_cast<Index>(v)});
    first_side.push_back(static_cast<Index>(sides.size()));
    is_mentioned[u] = is_mentioned[v] = true;
  }

  void add_side_of_last_edge(std::size_t corner, bool forward)
  {
    sides.push_back({static_cast<Index>(corner), forward});
    first_side.back() = static_cast<Index>(sides.size());
  }
};

// Turns faces given by vertex indices into a complex whose edges are pairs of vertices.
class Soup_complex_builder
{
  typedef Diagnosis_complex::Index Index;

public:
  Soup_complex_builder(std::size_t number_of_points, Input_diagnosis& diagnosis)
    : m_diagnosis(diagnosis), m_last_face(number_of_points, (std::numeric_limits<Index>::max)())
  {
    m_complex.add_vertices(number_of_points);
  }

  template <class PolygonRange>
  Diagnosis_complex operator()(const PolygonRange& polygons)
  {
    reserve(polygons);
    for(const auto& polygon : polygons)
      add_face(polygon);
    sort_sides();
    add_edges();
    return std::move(m_complex);
  }

private:
  // Represents an edge of a face by its larger end and the corner that it leaves.
  struct Side
  {
    Index larger_end, corner;
  };

  template <class PolygonRange>
  void reserve(const PolygonRange& polygons)
  {
    std::size_t faces = 0, corners = 0;
    for(const auto& polygon : polygons) {
      ++faces;
      corners += polygon.size();
    }
    m_complex.first_corner.reserve(faces + 1);
    m_complex.corner_vertex.reserve(corners);
    m_complex.corner_face.reserve(corners);
  }

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
    const Index f = static_cast<Index>(m_complex.number_of_faces());
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

  // Calls `function(smaller, larger, corner)` with the ends of the side that leaves each corner.
  template <class Function>
  void for_each_side(const Function& function) const
  {
    for(std::size_t f = 0; f < m_complex.number_of_faces(); ++f) {
      const Index first = m_complex.first_corner[f], end = m_complex.first_corner[f + 1];
      for(Index corner = first; corner < end; ++corner) {
        const Index v = m_complex.corner_vertex[corner];
        const Index w = m_complex.corner_vertex[corner + 1 == end ? first : corner + 1];
        function((std::min)(v, w), (std::max)(v, w), corner);
      }
    }
  }

  // Sorts the sides by the smaller end, in linear time, then by the larger one.
  void sort_sides()
  {
    m_first_side.assign(m_complex.number_of_vertices + 2, 0);
    for_each_side([this](Index u, Index, Index) { ++m_first_side[u + 2]; });
    for(std::size_t v = 2; v < m_first_side.size(); ++v)
      m_first_side[v] += m_first_side[v - 1];
    m_sides.resize(m_complex.corner_vertex.size());
    for_each_side([this](Index u, Index w, Index corner) {
      m_sides[m_first_side[u + 1]++] = {w, corner};
    });
    const auto comes_before = [](const Side& a, const Side& b) {
      return a.larger_end != b.larger_end ? a.larger_end < b.larger_end : a.corner < b.corner;
    };
    for(std::size_t v = 0; v < m_complex.number_of_vertices; ++v)
      std::sort(m_sides.begin() + m_first_side[v], m_sides.begin() + m_first_side[v + 1],
                comes_before);
  }

  bool starts_edge(std::size_t v, Index side) const
  {
    return side == m_first_side[v] || m_sides[side].larger_end != m_sides[side - 1].larger_end;
  }

  template <class Function>
  void for_each_sorted_side(const Function& function) const
  {
    for(Index v = 0; v < m_complex.number_of_vertices; ++v)
      for(Index i = m_first_side[v]; i < m_first_side[v + 1]; ++i)
        function(v, m_sides[i], starts_edge(v, i));
  }

  void add_edges()
  {
    std::size_t edges = 0;
    for_each_sorted_side([&](Index, const Side&, bool is_new) { edges += is_new; });
    m_complex.edge_ends.reserve(edges);
    m_complex.first_side.reserve(edges + 1);
    m_complex.sides.reserve(m_sides.size());
    for_each_sorted_side([this](Index v, const Side& side, bool is_new) {
      if(is_new)
        m_complex.add_edge(v, side.larger_end);
      m_complex.add_side_of_last_edge(side.corner, m_complex.corner_vertex[side.corner] == v);
    });
  }

  Input_diagnosis& m_diagnosis;
  Diagnosis_complex m_complex;
  std::vector<Index> m_last_face;  // the last face with the vertex
  std::vector<Index> m_first_side; // of each smaller end, in the next
  std::vector<Side> m_sides;
};

// Makes the edges from the halfedges of a graph, so that loops and parallel edges stay different.
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
