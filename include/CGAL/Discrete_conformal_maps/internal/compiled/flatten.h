// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_COMPILED_FLATTEN_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_COMPILED_FLATTEN_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Intrinsic_triangulations/internal/compiled/make_Delaunay.h>

#if !defined(CGAL_LINKED_WITH_TBB) && !defined(CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD)

namespace CGAL::Discrete_conformal_maps::internal {

CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Planar_conformal_map
flattened(Intrinsic_triangulations::Intrinsic_triangulation<>, const Map_parameters&,
          const Least_squares_layout&, const Free_shape&, Any_visitor);

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_LINKED_WITH_TBB

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_COMPILED_FLATTEN_H
