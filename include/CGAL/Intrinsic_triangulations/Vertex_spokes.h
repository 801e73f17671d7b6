// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_SPOKES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_SPOKES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// the outgoing halfedges ("spokes") of every vertex of a fixed Delta-complex, numbered from 0 in
/// counterclockwise order. Roundabouts are such numbers (Section 3.1.2). At a boundary vertex the
/// numbering starts at the spoke with the boundary on its right and ends at the border halfedge.
/// Memory: four bytes per vertex and eight per halfedge.
class Vertex_spokes
{
public:
  typedef Delta_complex::size_type size_type;

  /// creates the numbering of an empty complex.
  Vertex_spokes() = default;

  /// numbers the spokes of `mesh`. Complexity: linear.
  /// \pre `mesh` is a valid Delta-complex without removed elements
  explicit Vertex_spokes(const Delta_complex& mesh)
    : m_first(mesh.number_of_vertices() + 1, 0),
      m_halfedge(mesh.number_of_halfedges()),
      m_number(mesh.number_of_halfedges())
  {
    size_type position = 0;
    for(Vertex_index v : mesh.vertices()) {
      m_first[v] = position;
      if(!mesh.is_isolated(v))
        position = number_spokes(v, mesh);
    }
    m_first.back() = position;
  }

  /// returns the number of edges at `v`, a self-edge counted twice.
  size_type degree(Vertex_index v) const { return m_first[v + 1] - m_first[v]; }

  /// returns spoke `number` of `v`. \pre `number < degree(v)`
  Halfedge_index halfedge(Vertex_index v, size_type number) const
  {
    return m_halfedge[m_first[v] + number];
  }

  /// returns the number of `h` among the spokes of its source.
  size_type number(Halfedge_index h) const { return m_number[h]; }

private:
  size_type number_spokes(Vertex_index v, const Delta_complex& mesh)
  {
    const Halfedge_index first = first_spoke(v, mesh);
    const size_type start = m_first[v];
    size_type position = start;
    for(Halfedge_index h = first;; h = next_spoke(h, mesh)) {
      m_number[h] = position - start;
      m_halfedge[position++] = h;
      if(mesh.is_border(h) || next_spoke(h, mesh) == first)
        return position;
    }
  }

  std::vector<size_type> m_first;
  std::vector<Halfedge_index> m_halfedge;
  std::vector<size_type> m_number;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_SPOKES_H
