// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VERTEX_ANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VERTEX_ANGLES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <limits>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// Computes the angles at one vertex: on the surface, counterclockwise from a given outgoing
// halfedge, and normalized, from its first outgoing halfedge (Section 2.3.2).
template <typename FT>
class Vertex_angles
{
public:
  // Sums up the angles at the source of `outgoing`. Complexity: linear in the degree.
  template <typename Surface>
  Vertex_angles(Halfedge_index outgoing, const Surface& surface)
    : m_vertex(surface.mesh().source(outgoing)), m_before(0), m_sum(0)
  {
    const Delta_complex& mesh = surface.mesh();
    for_each_outgoing_halfedge(m_vertex, mesh, [&](Halfedge_index h) {
      if(h == outgoing)
        m_before = m_sum;
      m_is_border = mesh.is_border(h);
      if(!m_is_border)
        m_sum += angle_at_source(h, surface);
    });
  }

  bool is_border() const { return m_is_border; }
  // Returns the angle sum, which is zero if all faces at the vertex are needles without area.
  const FT& sum() const { return m_sum; }

  // Returns the normalized angle of the direction at this angle from the outgoing halfedge.
  // \throws Numerical_error if the sum is not positive and finite
  FT normalized(const FT& angle) const
  {
    return (m_before + angle) / positive_sum() * normalized_sum();
  }

  // Returns the angle on the surface from the first outgoing halfedge.
  // \throws Numerical_error if the sum is not positive and finite
  FT on_surface(const FT& normalized) const
  {
    return normalized / normalized_sum() * positive_sum();
  }

private:
  const FT& positive_sum() const
  {
    if(!(m_sum > 0) || !CGAL::is_finite(m_sum))
      throw Numerical_error("the angles at vertex " + std::to_string(m_vertex.idx()) +
                            " have no positive finite sum");
    return m_sum;
  }

  FT normalized_sum() const { return m_is_border ? pi<FT>() : 2 * pi<FT>(); }

  Vertex_index m_vertex;
  FT m_before, m_sum;
  bool m_is_border;
};

// Returns the error of the direction in which a path arrives at `v`. Its last straight part has the
// length `way`. The error is zero if it does not exceed the error of angles. Directions are unknown
// if another vertex is within rounding of `v`: the path may pass it on either side.
template <typename Surface>
Length_of<Surface> direction_error(Vertex_index v, const Length_of<Surface>& way,
                                   const Surface& surface)
{
  typedef Length_of<Surface> FT;
  FT longest(0), shortest = std::numeric_limits<FT>::infinity();
  for_each_outgoing_halfedge(v, surface.mesh(), [&](Halfedge_index h) {
    longest = (std::max)(longest, FT(edge_length(h, surface)));
    shortest = (std::min)(shortest, FT(edge_length(h, surface)));
  });
  if((std::min)(way, shortest) <= rounding_unit<FT>() * (way + longest))
    return FT(1);
  return 1024 * way < longest ? rounding_unit<FT>() * longest / way : FT(0);
}

// Returns whether paths that arrive at a vertex cannot continue in any direction, up to rounding.
// Their direction has the given error.
template <typename FT>
bool is_shadow_empty(const Vertex_angles<FT>& angles, const FT& error)
{
  return angles.sum() - (angles.is_border() ? 1 : 2) * pi<FT>() <= rounding_unit<FT>() - error;
}

// Stores the directions in which paths can continue at a vertex whose shadow is not empty. They
// differ by at least pi from the direction from which paths come, on either side of the surface.
template <typename FT>
class Outgoing_sector
{
public:
  // Allows all directions if `is_whole`.
  Outgoing_sector(const Vertex_angles<FT>& angles, bool is_whole, const FT& back)
    : m_sum(angles.sum()), m_back(back), m_is_border(angles.is_border()), m_is_whole(is_whole)
  {}

  // Returns whether the sector has directions between two angles.
  bool meets(const FT& first, const FT& last) const
  {
    const FT half = pi<FT>() - flat_angle_tolerance<FT>(), a = first - m_back, b = last - m_back;
    const FT other = m_is_border ? std::numeric_limits<FT>::infinity() : m_sum - half;
    return m_is_whole || (b >= half && a <= other) || (a <= -half && b >= -other);
  }

private:
  FT m_sum, m_back;
  bool m_is_border, m_is_whole;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VERTEX_ANGLES_H
