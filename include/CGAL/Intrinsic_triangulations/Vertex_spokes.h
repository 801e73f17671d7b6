// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_SPOKES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_SPOKES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <boost/property_map/property_map.hpp>

#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// the outgoing halfedges ("spokes") of every vertex of a fixed Delta-complex, numbered from 0 in
/// counterclockwise order. Roundabouts are such numbers (Section 3.1.2). At a boundary vertex the
/// numbering starts at the spoke with the boundary on its right and ends at the border halfedge.
/// Memory: four bytes per vertex and per halfedge.
class Vertex_spokes
{
public:
  /// the type of numbers of spokes.
  typedef Delta_complex::size_type size_type;

  /// creates the numbering of an empty complex.
  Vertex_spokes() = default;

  /// numbers the spokes of `mesh` and writes the number of every halfedge to `number`.
  /// Complexity: linear.
  /// \param mesh a valid Delta-complex without removed elements
  /// \param number a writable property map from halfedges to numbers
  /// \throws Invalid_input if an interior vertex has more than one umbrella
  template <typename NumberMap>
  Vertex_spokes(const Delta_complex& mesh, NumberMap number)
    : m_first(mesh.number_of_vertices() + 1), m_halfedge(mesh.number_of_halfedges())
  {
    size_type position = 0;
    for(Vertex_index v : mesh.vertices()) {
      m_first[v] = position;
      if(!mesh.is_isolated(v))
        position = number_spokes(v, position, mesh, number);
    }
    m_first.back() = position;
    if(position != mesh.number_of_halfedges())
      throw Invalid_input(internal::Delta_complex_defect(mesh));
  }

  /// returns the number of edges at `v`, a self-edge counted twice.
  size_type degree(Vertex_index v) const { return m_first[v + 1] - m_first[v]; }

  /// returns spoke `number` of `v`. \pre `number < degree(v)`
  Halfedge_index halfedge(Vertex_index v, size_type number) const
  {
    return m_halfedge[m_first[v] + number];
  }

  /// returns the number of the spoke `h` of `v`. Complexity: linear in the degree.
  size_type number(Vertex_index v, Halfedge_index h) const
  {
    size_type number = 0;
    while(halfedge(v, number) != h)
      ++number;
    return number;
  }

private:
  template <typename NumberMap>
  size_type number_spokes(Vertex_index v, size_type position, const Delta_complex& mesh,
                          NumberMap& number)
  {
    const Halfedge_index first = first_spoke(v, mesh);
    size_type i = 0;
    Halfedge_index h = first;
    do {
      m_halfedge[position++] = h;
      put(number, h, i++);
      h = next_spoke(h, mesh); // from the border halfedge on to the first one
    } while(h != first);
    return position;
  }

  std::vector<size_type> m_first;
  std::vector<Halfedge_index> m_halfedge;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_SPOKES_H
