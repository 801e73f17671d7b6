// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_AXIS_CROSSINGS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_AXIS_CROSSINGS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Triple_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Outgoing_halfedges.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the coordinates on T_3 of the points where edges of T_3 cross the axis of a symmetric
// double, from the symmetry. Each point is found in T_2, where rounding can exceed the distance of
// a vertex from the axis.
//
// Let x' and y' be the mirror images of x and y. An edge from x to x' crosses the axis in its
// middle. If at most four vertices are on a circle, other edges are diagonals, from x to y', of
// quadrilaterals x x' y' y. As vectors of the light cone, x - x' and y - y' are orthogonal
// to the axis, and their lengths are the lengths of these edges. Hence a x + b y' is on the axis if
// and only if a : b = l(y y') : l(x x').
template <typename Subdivision>
class Axis_crossings
{
  typedef typename Subdivision::FT FT;

public:
  // The first `number_of_original_faces` faces of T_1 are the original. `original` contains the
  // vertex of the original for each vertex.
  Axis_crossings(Subdivision& subdivision, std::size_t number_of_original_faces,
                 const std::vector<Vertex_index>& original)
    : m_subdivision(subdivision),
      m_number_of_original_faces(number_of_original_faces),
      m_original(original)
  {}

  // Sets the coordinates. `length(h)` is the length of an edge of T_3 for the decoration that the
  // coordinates belong to. Complexity: linear.
  template <typename Length>
  void set_coordinates(const Length& length)
  {
    for(Halfedge_index h : m_subdivision.mesh().halfedges())
      if(is_first_on_axis(h)) {
        find_crossings(h);
        if(is_symmetric())
          set_coordinates_of_crossings(length);
      }
  }

private:
  // Stores a vertex on the axis, and the halfedge of T_3 that crosses the axis at it from left to
  // right.
  struct Crossing
  {
    Vertex_index vertex;
    Halfedge_index across;
  };

  const Delta_complex& mesh() const { return m_subdivision.mesh(Layer::C); }

  bool is_original(Halfedge_index h_of_A) const
  {
    const Delta_complex& a = m_subdivision.mesh(Layer::A);
    return !a.is_border(h_of_A) && a.face(h_of_A).idx() < m_number_of_original_faces;
  }

  // Returns whether `h` is the first piece of an edge of T_1 between an original face and a copy.
  bool is_first_on_axis(Halfedge_index h) const
  {
    const Halfedge_index on_A = m_subdivision.parent_halfedge(Layer::A, h);
    return on_A.is_valid() && is_original(on_A) && !is_original(opposite(on_A)) &&
           m_subdivision.is_vertex(Layer::A, m_subdivision.mesh().source(h));
  }

  void find_crossings(Halfedge_index h)
  {
    using Intrinsic_triangulations::next_around_source;
    const auto& pieces = m_subdivision.mesh();
    m_crossings.clear();
    while(!m_subdivision.is_vertex(Layer::A, pieces.target(h))) {
      const Halfedge_index right = next_around_source(opposite(h), pieces);
      const Halfedge_index on_C = m_subdivision.parent_halfedge(Layer::C, right);
      if(on_C.is_valid())
        m_crossings.push_back({pieces.target(h), on_C});
      h = next_around_source(right, pieces);
    }
  }

  // Returns whether every second edge, from the first to the last, joins mirror images, and the
  // edges between them are diagonals.
  bool is_symmetric() const
  {
    bool result = m_crossings.size() % 2 == 1;
    for(std::size_t i = 0; result && i < m_crossings.size(); i += 2)
      result = joins_mirror_images(across(i)) && (i == 0 || is_diagonal(i - 1));
    return result;
  }

  Halfedge_index across(std::size_t i) const { return m_crossings[i].across; }

  bool joins_mirror_images(Halfedge_index h) const
  {
    return m_original[mesh().source(h).idx()] == m_original[mesh().target(h).idx()];
  }

  bool is_diagonal(std::size_t i) const
  {
    return (has_left_end_of_next(i - 1) && has_right_end_of_next(i)) ||
           (has_right_end_of_next(i - 1) && has_left_end_of_next(i));
  }

  // Returns whether the edges of crossing `i` and of the next one meet on the left of the axis.
  bool has_left_end_of_next(std::size_t i) const
  {
    return across(i + 1) == opposite(mesh().prev(across(i)));
  }
  bool has_right_end_of_next(std::size_t i) const
  {
    return across(i + 1) == opposite(mesh().next(across(i)));
  }

  template <typename Length>
  void set_coordinates_of_crossings(const Length& length)
  {
    for(std::size_t i = 0; i < m_crossings.size(); ++i) {
      std::array<FT, 2> part{1, 1};
      if(i % 2 == 1) {
        const FT before = length(across(i - 1)), after = length(across(i + 1));
        part = has_left_end_of_next(i) ? std::array<FT, 2>{before, after}
                                       : std::array<FT, 2>{after, before};
      }
      m_subdivision.divide_weight(m_crossings[i].vertex, across(i), part);
    }
  }

  Subdivision& m_subdivision;
  std::size_t m_number_of_original_faces;
  const std::vector<Vertex_index>& m_original;
  std::vector<Crossing> m_crossings; // along one edge of T_1
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_AXIS_CROSSINGS_H
