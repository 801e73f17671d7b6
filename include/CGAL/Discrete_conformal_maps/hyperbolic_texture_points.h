// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_HYPERBOLIC_TEXTURE_POINTS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_HYPERBOLIC_TEXTURE_POINTS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Hyperbolic_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/texture_points.h>

#include <array>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// returns the images in the Poincare disk under `map` of the corners of a part, in their order.
/// They are rounded such that no face is reversed, if that is possible (\ref dcm_reversed).
/// Complexity: linear if rounding reverses no face.
inline Rounded_points<std::array<double, 2>> texture_points(const Hyperbolic_conformal_map& map,
                                                            const Input_part& part,
                                                            const Texture_corners& corners)
{
  return internal::rounded_corners(map, part, corners, [](const std::array<double, 3>& z) {
    return internal::coordinates(Hyperbolic_conformal_map::to_disk(z));
  });
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_HYPERBOLIC_TEXTURE_POINTS_H
