// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACE_SPLITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACE_SPLITS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores a point at which a vertex is inserted. If lengths follow from T1, the location on T2 is
// not set.
template <typename FT>
struct Point_to_insert
{
  Surface_point<FT> on_input;
  Face_location<FT> on_intrinsic;
};

// Returns the coordinates of the edges from a new vertex on `curve` to the corners of the face. Its
// outgoing halfedge number `forward` leads to the mark where the curve leaves the face. The other
// one leads back.
template <typename Integer>
Face_split<Integer> split_on_curve(const Face_regions::Curve& curve,
                                   Outgoing_halfedges::size_type forward,
                                   const Face_regions& regions)
{
  if(!curve.from_apex && curve.mark.side != curve.corner)
    forward = 1 - forward; // the curve leaves the face before the corner
  const auto back = 1 - forward;
  const auto n = regions.crossings_to_corners(curve);
  Face_split<Integer> split{{Integer(n[0]), Integer(n[1]), Integer(n[2])}, {back, back, back}};
  // The outgoing halfedge that leads forward lies between this corner and the next.
  split.r[curve.from_apex ? (curve.corner + 1) % 3 : curve.corner] = forward;
  return split;
}

// Returns the regions of the face of `h`, with `h` as side 0.
template <typename Traits>
Face_regions regions_at(Halfedge_index h, const Delta_complex& mesh,
                        const Edge_courses<Traits>& courses)
{
  return Face_regions({courses.count(h), courses.count(mesh.next(h)), courses.count(mesh.prev(h))});
}

// Returns the number of crossings from a point on `h` after `p` of its crossings to the opposite
// corner.
template <typename Traits>
typename Traits::Integer crossings_to_apex(Halfedge_index h, std::size_t p,
                                           const Delta_complex& mesh,
                                           const Edge_courses<Traits>& courses)
{
  typedef typename Traits::Integer Integer;
  if(mesh.is_border(h))
    return Integer(0);
  const Face_regions regions = regions_at(h, mesh, courses);
  return Integer(regions.crossings_to_corners(regions.region_at_side(0, p))[2]);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACE_SPLITS_H
