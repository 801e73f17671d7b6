// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_COMPOSED_MAP_H
#define CGAL_INTRINSIC_SIMPLIFICATION_COMPOSED_MAP_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_map.h>

#include <CGAL/assertions.h>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationApplications
/// the composition of two maps. Each is a `Surface_map`, a `Correspondence_map` or a
/// `Composed_map`. The object refers to both.
///
/// Between levels of one surface, use `Surface_map`, which also has curves and subdivisions.
template <typename First, typename Second>
class Composed_map
{
public:
  /// a face and barycentric coordinates that sum up to one.
  typedef Surface_map::Location Location;

  /// composes two maps.
  /// \pre the second map starts at the last triangulation of the first map, with equal indices
  Composed_map(const First& first, const Second& second) : m_first(first), m_second(second)
  {
    CGAL_precondition(first.coarse().mesh().number_of_edges() ==
                      second.fine().mesh().number_of_edges());
  }

  /// returns the surface on which the first map starts.
  decltype(auto) fine() const { return m_first.fine(); }
  /// returns the surface on which the second map ends.
  decltype(auto) coarse() const { return m_second.coarse(); }

  /// returns the vertex of the coarse surface that corresponds to the vertex `v` of the fine
  /// surface; null if it has been removed. Complexity: logarithmic.
  Vertex_index coarse_vertex(Vertex_index v) const
  {
    const Vertex_index between = m_first.coarse_vertex(v);
    return between.is_valid() ? m_second.coarse_vertex(between) : between;
  }

  /// maps a point of the fine surface to the coarse surface: a `Location`, or a `Surface_point` of
  /// `Intrinsic_triangulations`.
  template <typename Point = Location>
  Location to_coarse(const Point& p) const
  {
    return m_second.to_coarse(m_first.to_coarse(p));
  }

  /// maps a point of the coarse surface to the fine surface.
  template <typename Point = Location>
  Location to_fine(const Point& p) const
  {
    return m_first.to_fine(m_second.to_fine(p));
  }

private:
  const First& m_first;
  const Second& m_second;
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_COMPOSED_MAP_H
