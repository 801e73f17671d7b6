// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// the methods that lay out a flat surface, cut open, in the plane. Up to rounding, their results
/// differ by rigid motions only.
enum class Layout
{
  /// face by face. Then points are moved to minimize the sum of squared relative errors of all
  /// sides
  least_squares,
  /// spectral \cgalCite{MTAD08}: the non-constant function with the least conformal energy relative
  /// to its mean square on the boundary. Inverse iteration starts from faces laid out one by one
  spectral,
  /// face by face; errors add up
  incremental
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_LAYOUT_H
