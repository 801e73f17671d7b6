// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ANGLE_IN_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ANGLE_IN_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/lay_out_strip.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The angle on the surface of the halfedge `h` of T2 from the spoke of T1 before it. It leaves faces
// of T1 through exit(0), ..., exit(n - 1).
template <typename Traits, typename Exit>
typename Traits::FT angle_in_strip(Halfedge_index h, const Exit& exit, std::size_t n,
                                   const Intrinsic_triangulation<Traits>& tri,
                                   Euclidean_strip<typename Traits::FT>& strip)
{
  lay_out_strip(strip, tri.input_mesh(), tri.input_length_map(), exit, n);
  if(!tri.traits().is_length_object()(strip.length()))
    throw Numerical_error("the strip of edge " + std::to_string(tri.mesh().edge(h).idx()) +
                          " has no positive finite length");
  return strip.angle();
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ANGLE_IN_STRIP_H
