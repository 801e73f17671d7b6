// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VERTEX_ANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VERTEX_ANGLES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// The angles at one vertex: on the surface, counterclockwise from a given outgoing halfedge, and
// normalized, from its first outgoing halfedge (Section 2.3.2).
template <typename FT>
class Vertex_angles
{
public:
  // Complexity: linear in the degree.
  template <typename Surface>
  Vertex_angles(Halfedge_index outgoing, const Surface& surface)
    : m_vertex(surface.mesh().source(outgoing)), m_before(0), m_sum(0)
  {
    const Delta_complex& mesh = surface.mesh();
    const Halfedge_index first = first_outgoing_halfedge(m_vertex, mesh);
    Halfedge_index h = first;
    do {
      if(h == outgoing)
        m_before = m_sum;
      m_sum += angle_at_source(h, surface);
      h = next_around_source(h, mesh);
    } while(h != first && !mesh.is_border(h));
    m_is_border = mesh.is_border(h);
    if(m_is_border && h == outgoing)
      m_before = m_sum;
  }

  bool is_border() const { return m_is_border; }
  // zero at a vertex where all faces are needles without an area
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VERTEX_ANGLES_H
