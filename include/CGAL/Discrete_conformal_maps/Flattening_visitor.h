// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_FLATTENING_VISITOR_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_FLATTENING_VISITOR_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// a stage of `flatten()`, `uniformize_hyperbolic()` or `map_to_sphere()`.
enum class Flattening_stage
{
  cones,    ///< cones are placed, for a map to the plane
  optimize, ///< scale factors are computed
  layout,   ///< faces are laid out
  trace,    ///< the triangulations are traced over each other
  subdivide ///< their common subdivision is made
};

/// \ingroup PkgDiscreteConformalMapsFlat
/// a visitor that does nothing.
///
/// \cgalModels `FlatteningVisitor`
struct Default_flattening_visitor : Default_minimization_visitor
{
  /// is called when a stage begins.
  void start(Flattening_stage /* stage */) {}
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_FLATTENING_VISITOR_H
