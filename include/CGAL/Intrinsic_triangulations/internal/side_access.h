// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SIDE_ACCESS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SIDE_ACCESS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

template <typename Traits>
const Delta_complex& mesh_of(Side side, const Intrinsic_triangulation<Traits>& tri)
{
  return side == Side::input ? tri.input_mesh() : tri.mesh();
}

template <typename Traits>
const auto& lengths_of(Side side, const Intrinsic_triangulation<Traits>& tri)
{
  return side == Side::input ? tri.input_length_map() : tri.length_map();
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SIDE_ACCESS_H
