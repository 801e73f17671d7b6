// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_REMOVAL_STATUS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_REMOVAL_STATUS_H

#include <CGAL/license/Intrinsic_simplification.h>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// whether a vertex can be removed, or the reason why not.
enum class Removal_status
{
  possible,         ///< the vertex can be removed
  isolated,         ///< the vertex has no faces
  protected_vertex, ///< the vertex is protected, or has a constrained edge
  border_loop,      ///< the vertex is the only one of its boundary loop
  self_face,        ///< all three corners of a face are at the vertex
  low_degree,       ///< there are too few faces at the vertex to flatten it
  not_flattenable,  ///< no scale of the vertex makes it flat and leaves valid triangles
  not_separable     ///< flips do not bring the flat vertex to degree three
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the number of values of `Removal_status`.
constexpr int number_of_removal_statuses = 8;

/// \ingroup PkgIntrinsicSimplificationRef
/// returns a short sentence for `status`.
inline const char* to_string(Removal_status status)
{
  switch(status) {
    case Removal_status::possible: return "possible";
    case Removal_status::isolated: return "the vertex has no faces";
    case Removal_status::protected_vertex: return "the vertex is protected";
    case Removal_status::border_loop: return "the vertex is alone on its boundary loop";
    case Removal_status::self_face: return "a face has all its corners at the vertex";
    case Removal_status::low_degree: return "too few faces are at the vertex";
    case Removal_status::not_flattenable: return "no scale makes the vertex flat";
    case Removal_status::not_separable: return "flips do not bring the vertex to degree three";
  }
  return "unknown";
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_REMOVAL_STATUS_H
