// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_VERTEX_CONDITION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_VERTEX_CONDITION_H

#include <CGAL/license/Discrete_conformal_maps.h>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// the condition at a vertex of a flat surface: its curvature or its scale factor.
struct Vertex_condition
{
  /// the prescribed quantities.
  enum class Quantity
  {
    curvature, ///< the angle defect, or on the boundary the exterior angle, in radians
    log_scale  ///< the logarithmic scale factor
  };

  Quantity quantity = Quantity::curvature; ///< the prescribed quantity
  double value = 0;                        ///< its value

  /// prescribes a curvature: \f$2\pi\f$ minus the sum of angles at an interior vertex, \f$\pi\f$
  /// minus the sum of angles at a boundary vertex.
  static Vertex_condition curvature(double value) { return {Quantity::curvature, value}; }

  /// prescribes a logarithmic scale factor.
  static Vertex_condition log_scale(double value) { return {Quantity::log_scale, value}; }
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_VERTEX_CONDITION_H
