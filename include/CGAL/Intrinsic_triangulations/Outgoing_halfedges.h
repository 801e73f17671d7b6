// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OUTGOING_HALFEDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OUTGOING_HALFEDGES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <boost/property_map/property_map.hpp>

#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// the outgoing halfedges of every vertex of a fixed Delta-complex \f$T_1\f$, indexed from 0 in
/// counterclockwise order. Roundabouts are such indices (Section 3.1.2). At a boundary vertex the
/// order starts at the outgoing halfedge with the boundary on its right and ends at the border
/// halfedge.
///
/// A vertex that has been inserted on an edge of \f$T_1\f$ has two outgoing halfedges, the
/// halfedges of that edge. Each represents the part that starts at the vertex. A vertex inserted
/// in a face has none. Memory: eight bytes per vertex and four per halfedge.
class Outgoing_halfedges
{
public:
  /// the type of indices of outgoing halfedges.
  typedef Delta_complex::size_type size_type;

  /// creates the outgoing halfedges of an empty complex.
  Outgoing_halfedges() = default;

  /// orders the outgoing halfedges of `mesh` and writes the index of every halfedge to `number`.
  /// Complexity: linear.
  /// \param mesh a valid Delta-complex without removed elements
  /// \param number a writable property map from halfedges to indices
  /// \throws Invalid_input if an interior vertex has more than one vertex fan
  template <typename NumberMap>
  Outgoing_halfedges(const Delta_complex& mesh, NumberMap number)
    : m_range(mesh.number_of_vertices()), m_halfedge(mesh.number_of_halfedges())
  {
    size_type position = 0;
    Walk ahead(0, mesh);
    for(size_type v = 0; v < m_range.size(); ++v) {
      const Walk walk = std::exchange(ahead, Walk(v + 1, mesh)); // memory answers during this walk
      const size_type first = position;
      if(walk.first.is_valid())
        position = number_outgoing_halfedges(walk, position, mesh, number);
      m_range[v] = {first, position - first};
    }
    if(position != mesh.number_of_halfedges())
      throw Invalid_input(internal::Delta_complex_defect(mesh));
  }

  /// returns the number of edges at `v`, a self-edge counted twice.
  size_type degree(Vertex_index v) const { return m_range[v].degree; }

  /// returns outgoing halfedge `number` of `v`. \pre `number < degree(v)`
  Halfedge_index halfedge(Vertex_index v, size_type number) const
  {
    return m_halfedge[m_range[v].first + number];
  }

  /// returns the index of the outgoing halfedge `h` of `v`. Complexity: linear in the degree.
  size_type number(Vertex_index v, Halfedge_index h) const
  {
    size_type number = 0;
    while(halfedge(v, number) != h)
      ++number;
    return number;
  }

  /// gives the inserted vertex `v` its outgoing halfedges: `outgoing` and its opposite, or none if
  /// `outgoing` is null. Complexity: amortized constant.
  void set_inserted(Vertex_index v, Halfedge_index outgoing)
  {
    if(v.idx() >= m_range.size())
      m_range.resize(v.idx() + 1);
    m_range[v] = {};
    if(outgoing.is_valid()) {
      m_range[v] = {static_cast<size_type>(m_halfedge.size()), 2};
      m_halfedge.insert(m_halfedge.end(), {outgoing, opposite(outgoing)});
    }
  }

private:
  struct Range
  {
    size_type first = 0, degree = 0;
  };

  // Stores the start of a walk around a vertex. It is null if no vertex or no edge exists.
  struct Walk
  {
    Halfedge_index first, second;

    Walk(size_type v, const Delta_complex& mesh)
    {
      if(v == mesh.number_of_vertices() || mesh.is_isolated(Vertex_index(v)))
        return;
      first = first_outgoing_halfedge(Vertex_index(v), mesh);
      second = next_around_source(first, mesh);
    }
  };

  template <typename NumberMap>
  size_type number_outgoing_halfedges(const Walk& walk, size_type position,
                                      const Delta_complex& mesh, NumberMap& number)
  {
    size_type i = 0;
    m_halfedge[position++] = walk.first;
    put(number, walk.first, i++);
    // The loop leads from the border halfedge to the first one.
    for(Halfedge_index h = walk.second; h != walk.first; h = next_around_source(h, mesh)) {
      m_halfedge[position++] = h;
      put(number, h, i++);
    }
    return position;
  }

  std::vector<Range> m_range;
  std::vector<Halfedge_index> m_halfedge;
};

namespace internal {

// Returns the first outgoing halfedge of a vertex inserted on the edge of `along`. It has the
// boundary on its right. Without a boundary, it is the halfedge with an even index.
inline Halfedge_index first_inserted_outgoing(Halfedge_index along, bool is_border,
                                              bool opposite_is_border)
{
  const bool is_first = opposite_is_border || (!is_border && is_first_halfedge(along));
  return is_first ? along : opposite(along);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OUTGOING_HALFEDGES_H
