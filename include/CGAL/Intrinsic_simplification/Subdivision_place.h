// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SUBDIVISION_PLACE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SUBDIVISION_PLACE_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

namespace CGAL {
namespace Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// where a vertex of a subdivision is on one of the levels.
struct Subdivision_place
{
  Halfedge_index
    along; ///< a halfedge on which it lies, or that starts at it; null if it is inside a face
  Intrinsic_triangulations::Face_location<double>
    location; ///< its place in the face, or in that of `along`
};

} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SUBDIVISION_PLACE_H
