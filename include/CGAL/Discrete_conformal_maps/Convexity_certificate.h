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
/// The vertices are the images of points in the plane, and one of infinity, under the inverse of a
/// stereographic projection. An edge is convex if and only if the edge of the plane is Delaunay.
/// The images need not be known for this, and Moebius transformations do not change it. Decisions
/// hold for the stored positions in the plane, without a tolerance.
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
