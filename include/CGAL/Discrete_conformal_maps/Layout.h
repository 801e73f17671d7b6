// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// how flat faces, cut open, are laid out in the plane. Up to rounding, all give the same up to
/// motions.
enum class Layout
{
  /// face by face; then points are shifted such that the sum of squared relative errors of the
  /// sides of all faces is least
  least_squares,
  /// the non-constant function with the least conformal energy relative to its mean square on the
  /// boundary (Mullen et al. 2008), by inverse iteration from faces laid out one by one
  spectral,
  /// face by face: errors add up on the way
  incremental
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_LAYOUT_H
