// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CONVEXITY_CERTIFICATE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CONVEXITY_CERTIFICATE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <cstddef>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsSphere
/// the results of exact predicates about an inscribed polyhedron.
///
/// An inverse stereographic projection maps points of the plane, and infinity, to the vertices. An
/// edge is convex if and only if the edge in the plane is Delaunay. So decisions need no positions
/// on the sphere, and do not depend on Moebius transformations. They hold for the stored positions
/// in the plane, without a tolerance.
struct Convexity_certificate
{
  std::size_t concave_edges = 0;     ///< edges that are not convex; edges in flat faces are convex
  std::size_t flipped_triangles = 0; ///< triangles in the plane that are flipped or have no area
  bool is_simple = true; ///< whether the triangles that are not flipped cover the plane only once

  /// returns whether the polyhedron is convex, and its faces cover the sphere once, without folds.
  bool is_convex() const { return concave_edges == 0 && flipped_triangles == 0 && is_simple; }
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CONVEXITY_CERTIFICATE_H
