// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_CORRESPONDENCE_MAP_H
#define CGAL_INTRINSIC_SIMPLIFICATION_CORRESPONDENCE_MAP_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationApplications
/// the identity of a surface as a map between its two triangulations. It calls \f$T_1\f$ fine and
/// \f$T_2\f$ coarse, whichever has more vertices. Its members have the names of `Surface_map`, so
/// that a `Composed_map` can contain both.
///
/// The object refers to the triangulation, and is valid until the triangulation changes.
class Correspondence_map
{
public:
  /// the type of the crossings.
  typedef Intrinsic_triangulations::Correspondence<> Correspondence;
  /// a face and barycentric coordinates that sum up to one.
  typedef Surface_map::Location Location;
  /// the type of the triangulation.
  typedef Correspondence::Triangulation Triangulation;

  /// prepares the map. Complexity and exceptions: see `Intrinsic_triangulations::Correspondence`.
  explicit Correspondence_map(const Triangulation& tri) : m_correspondence(tri) {}

  /// returns the crossings of both triangulations.
  const Correspondence& correspondence() const { return m_correspondence; }

  /// returns \f$T_1\f$ as a model of `IntrinsicSurface`.
  auto fine() const { return m_correspondence.triangulation().input(); }
  /// returns \f$T_2\f$ as a model of `IntrinsicSurface`.
  auto coarse() const { return m_correspondence.triangulation().intrinsic(); }

  /// returns `v`: vertices of \f$T_1\f$ are vertices of \f$T_2\f$.
  Vertex_index coarse_vertex(Vertex_index v) const { return v; }

  /// maps a point of \f$T_1\f$ to \f$T_2\f$: a `Location`, or a `Surface_point` of
  /// `Intrinsic_triangulations`. Complexity: see
  /// `Intrinsic_triangulations::point_across()`.
  template <typename Point = Location>
  Location to_coarse(const Point& p) const
  {
    return Intrinsic_triangulations::point_across(m_correspondence,
                                                  Intrinsic_triangulations::Side::input, p);
  }

  /// maps a point of \f$T_2\f$ to \f$T_1\f$. Complexity: as `to_coarse()`.
  template <typename Point = Location>
  Location to_fine(const Point& p) const
  {
    return Intrinsic_triangulations::point_across(m_correspondence,
                                                  Intrinsic_triangulations::Side::intrinsic, p);
  }

private:
  Correspondence m_correspondence;
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_CORRESPONDENCE_MAP_H
