// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ANGLE_ON_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ANGLE_ON_INPUT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/angle_in_strip.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTangent
/// computes the normalized angle in which the halfedge `h` of \f$T_2\f$ of `tri` leaves its source,
/// in the frame of \f$T_1\f$ at the source.
///
/// At a vertex of \f$T_1\f$ the frame is the frame of `Tangent_frames`. At a vertex inserted on an
/// edge of \f$T_1\f$ the real axis is along its first outgoing halfedge (see
/// `Outgoing_halfedges`). At a vertex inside a face `f` it is along `halfedge(f)`, as in
/// `trace_geodesic()`. The surface is flat at inserted vertices, and normalized angles are angles.
///
/// The corner of \f$T_1\f$ follows from the integer coordinates and is exact. The direction in the
/// corner comes from the strip of triangles of \f$T_1\f$ that `h` passes. So the flips that led to
/// \f$T_2\f$ have no influence on it. A shared edge has the angle of its twin, to the bit.
/// Complexity: the complexity of `trace_intrinsic_edge()`, and linear in the degree of the source
/// in \f$T_1\f$. For many halfedges use `Angular_coordinates`.
/// \throws Numerical_error if the angles at the source have no positive finite sum, or if the
///         layout has no positive finite length
template <typename Traits>
typename Traits::FT angle_on_input(const Intrinsic_triangulation<Traits>& tri, Halfedge_index h)
{
  typedef typename Traits::FT FT;
  Euclidean_strip<FT> strip;
  const FT angle =
    internal::angle_from_outgoing(h, internal::Edge_courses<Traits>(tri)(h), tri, strip);
  if(tri.is_inserted(tri.mesh().source(h)))
    return internal::angle_of_inserted_outgoing(h, tri) + angle;
  return internal::Vertex_angles<FT>(tri.input_outgoing_before(h), tri.input()).normalized(angle);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ANGLE_ON_INPUT_H
