// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_FUNCTIONS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_FUNCTIONS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <utility>

namespace CGAL::Discrete_conformal_maps {

class Hyperbolic_conformal_map;
class Planar_conformal_map;
class Spherical_conformal_map;

namespace internal {

// The functions behind the public ones do not depend on the types of their arguments. An
// application compiles them from the headers, or links the compiled library, which contains them
// for `Any_visitor`.

struct Free_shape;
class Circular_boundary;
class Rectangular_boundary;

// Maps a surface to the plane, as `flatten()` documents, with a boundary of this shape.
template <typename Shape, typename Visitor>
Planar_conformal_map flattened(Intrinsic_triangulations::Intrinsic_triangulation<> input,
                               Map_parameters parameters, Visitor visitor);

// Maps a surface to the sphere, as `map_to_sphere()` documents.
template <typename Visitor>
Spherical_conformal_map mapped_to_sphere(Intrinsic_triangulations::Intrinsic_triangulation<> input,
                                         const Map_parameters& parameters, Visitor visitor);

// Computes a hyperbolic metric, as `uniformize_hyperbolic()` documents.
template <typename Visitor>
Hyperbolic_conformal_map
uniformized(const Intrinsic_triangulations::Intrinsic_triangulation<>& input,
            const Map_parameters& parameters, Visitor visitor);

// Maps a surface to the plane, with the visitor of the named parameters.
template <typename Shape, typename NamedParameters>
auto flattened_to(Intrinsic_triangulations::Intrinsic_triangulation<> input,
                  Map_parameters parameters, const NamedParameters& np)
{
  Default_flattening_visitor silent;
  auto&& visitor = Intrinsic_triangulations::internal::visitor_of(np, silent);
  return flattened<Shape>(std::move(input), std::move(parameters), Any_visitor::of(visitor));
}

} // namespace internal
} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_FUNCTIONS_H
