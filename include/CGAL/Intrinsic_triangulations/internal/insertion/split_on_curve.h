// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SPLIT_ON_CURVE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SPLIT_ON_CURVE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the coordinates of the edges from a new vertex on `curve` to the corners of the face. Its
// outgoing halfedge number `forward` leads to the mark where the curve leaves the face, and the
// other one back.
template <typename Integer>
Face_split<Integer> split_on_curve(const Face_regions::Curve& curve,
                                   Outgoing_halfedges::size_type forward,
                                   const Face_regions& regions)
{
  const auto back = 1 - forward;
  const auto n = regions.crossings_to_corners(curve);
  Face_split<Integer> split{{Integer(n[0]), Integer(n[1]), Integer(n[2])}, {back, back, back}};
  // between this corner and the next lies the outgoing halfedge that leads forward
  split.r[curve.from_apex ? (curve.corner + 1) % 3 : curve.corner] = forward;
  return split;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SPLIT_ON_CURVE_H
