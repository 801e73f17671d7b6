// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FINE_VERTICES_H
#define INTRINSIC_FINE_VERTICES_H

#include "reading/Polygon_soup.h"

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Subdivision_base.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <cstddef>
#include <vector>

// Determines values at the vertices of the fine level of a simplification from values at the
// vertices of the input. Vertices of the input come first. Then come inserted vertices, and finally
// vertices that disks and cuts have added.
class Fine_vertices
{
public:
  typedef CGAL::Intrinsic_triangulations::Intrinsic_triangulation<> Triangulation;
  typedef CGAL::Intrinsic_triangulations::Vertex_weights<double> Weights;

  // Constructs the vertices of the input, or of `split` unless it is null, with its inserted
  // vertices. It must outlive this object.
  Fine_vertices(std::size_t number_of_input_vertices, const Triangulation* split);

  // Adds the vertices of disks and cuts.
  void add(const CGAL::Intrinsic_simplification::Surface_surgery& surgery);

  std::size_t size() const { return m_size + m_sources.size(); }
  // Returns the number of vertices without disks and cuts.
  std::size_t number_before_surgery() const { return m_size; }

  // Extends values at the first vertices, at least the vertices of the input, to the others.
  template <class Value>
  void extend(std::vector<Value>& values, const Value& zero) const
  {
    for(std::size_t i = values.size(); i < m_size; ++i)
      values.push_back(sum(weights(i), values, zero));
    for(std::size_t i = values.size() - m_size; i < m_sources.size(); ++i) {
      Value sum = zero;
      for(const Vertex_index v : m_sources[i])
        sum = sum + values[v];
      values.push_back(sum / static_cast<double>(m_sources[i].size()));
    }
  }

  // Returns the positions of all vertices.
  template <class PointRange>
  std::vector<Point> positions(const PointRange& points_of_input) const
  {
    std::vector<Kernel::Vector_3> vectors;
    for(const Point& p : points_of_input)
      vectors.push_back(p - CGAL::ORIGIN);
    extend(vectors, Kernel::Vector_3(CGAL::NULL_VECTOR));
    std::vector<Point> result;
    for(const Kernel::Vector_3& p : vectors)
      result.push_back(CGAL::ORIGIN + p);
    return result;
  }

  // Returns the weights of vertices of the input. For a vertex in the middle of others, returns the
  // weights of the first of them.
  Weights weights(std::size_t i) const;

private:
  typedef CGAL::Intrinsic_triangulations::Vertex_index Vertex_index;

  template <class Value>
  static Value sum(const Weights& w, const std::vector<Value>& values, Value result)
  {
    for(std::size_t c = 0; c < w.size; ++c)
      result = result + w.weight[c] * values[w.vertex[c]];
    return result;
  }

  const Triangulation* m_split;
  std::size_t m_size; // without disks and cuts
  // Stores the vertices that determine the position of each vertex added by disks and cuts. They
  // are the vertex that it copies, or the vertices around its disk.
  std::vector<std::vector<Vertex_index>> m_sources;
};

#endif // INTRINSIC_FINE_VERTICES_H
