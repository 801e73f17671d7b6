// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ANGLE_IN_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ANGLE_IN_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/internal/Vertex_angles.h>

#include <complex>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The angle on the surface of the halfedge `h` of T2 from the spoke of T1 before it; if the source lies
// inside a face of T1, from the first halfedge of that face. It leaves faces of T1 through exit(0), ...,
// exit(n - 1). The edge is not shared.
template <typename Traits, typename Exit>
typename Traits::FT angle_in_strip(Halfedge_index h, const Exit& exit, std::size_t n,
                                   const Intrinsic_triangulation<Traits>& tri,
                                   Euclidean_strip<typename Traits::FT>& strip)
{
  typedef typename Traits::FT FT;
  if(n > 0 && !tri.traits().is_length_object()(tri.lay_out(strip, h, exit, n)))
    throw Numerical_error("the strip of edge " + std::to_string(tri.mesh().edge(h).idx()) +
                          " has no positive finite length");
  if(!tri.is_inserted(tri.mesh().source(h)) && n > 0)
    return strip.angle();
  const Delta_complex& input = tri.input_mesh();
  const Face_location<FT> start = tri.input_location(h);
  // the end in the same face, or the end of the first edge that is crossed
  const Face_location<FT> to = n > 0 ? face_location(Edge_point<FT>{exit(0), FT(0)}, input)
                                     : tri.input_location(tri.mesh().opposite(h));
  const Flat_face<FT> face(input.halfedge(start.first), input, tri.input_length_map());
  const Halfedge_index spoke = tri.input_spoke_before(h);
  const auto axis =
    spoke.is_valid() ? face.direction(side_number(spoke, input)) : std::complex<FT>(1);
  const FT angle =
    std::arg(face.between(start.second, to.second) / axis) + (n > 0 ? strip.angle() : FT(0));
  return angle < 0 ? angle + 2 * pi<FT>() : angle;
}

// The angle of the spoke of T1 before the halfedge `h` of T2, whose source has been inserted, in the frame
// there: its real axis is along spoke 0, or in a face of T1, along the first halfedge.
template <typename Traits>
typename Traits::FT angle_of_inserted_spoke(Halfedge_index h,
                                            const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::FT FT;
  const Halfedge_index spoke = tri.input_spoke_before(h);
  return spoke.is_valid() && tri.number_of_inserted_spoke(spoke) == 1 ? pi<FT>() : FT(0);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ANGLE_IN_STRIP_H
