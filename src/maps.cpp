// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILED extern
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#undef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED

#include <CGAL/Discrete_conformal_maps/internal/maps/Hyperbolic_uniformization.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Repeated_flattening.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Sphere_mapping.h>
#include <CGAL/Discrete_conformal_maps/internal/planar_layouts/Named_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Circular_boundary.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Free_shape.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Rectangular_boundary.h>

namespace CGAL::Discrete_conformal_maps::internal {

typedef Intrinsic_triangulations::Intrinsic_triangulation<> Surface;

template Planar_conformal_map flattened<Free_shape>(Surface, Map_parameters, Any_visitor);
template Planar_conformal_map flattened<Circular_boundary>(Surface, Map_parameters, Any_visitor);
template Planar_conformal_map flattened<Rectangular_boundary>(Surface, Map_parameters, Any_visitor);
template Spherical_conformal_map mapped_to_sphere(Surface, const Map_parameters&, Any_visitor);
template Hyperbolic_conformal_map uniformized(const Surface&, const Map_parameters&, Any_visitor);

} // namespace CGAL::Discrete_conformal_maps::internal
