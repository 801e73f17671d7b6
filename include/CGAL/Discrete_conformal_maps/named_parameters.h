// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_NAMED_PARAMETERS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_NAMED_PARAMETERS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/named_parameters.h>

namespace CGAL::Discrete_conformal_maps {

#ifndef DOXYGEN_RUNNING

namespace internal_np {
using namespace Intrinsic_triangulations::internal_np;
} // namespace internal_np

#define CGAL_NAMED_PARAMETERS <CGAL/Discrete_conformal_maps/internal/list_of_named_parameters.h>
#include <CGAL/Intrinsic_triangulations/internal/input/define_named_parameters.h>

#else

namespace parameters {

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a readable property map from the vertices of the input to `Vertex_condition`.
template <typename Map>
auto vertex_condition_map(const Map& map);

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a `Cones`: whether cones are placed.
template <typename Cones>
auto cones(const Cones& value);

/// \ingroup PkgDiscreteConformalMapsFlat
/// names `value`, a bound of logarithmic scale factors. Beyond the bound, cones are placed.
template <typename Number>
auto maximum_log_scale(const Number& value);

/// \ingroup PkgDiscreteConformalMapsFlat
/// names `value`, the factor by which areas may change. Beyond the factor, cones are placed.
template <typename Number>
auto maximum_area_distortion(const Number& value);

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a model of `ConvexMinimizer`.
template <typename Minimizer>
auto minimizer(const Minimizer& value);

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a `Flipping`: whether triangulations follow the scale factors.
template <typename Flipping>
auto flipping(const Flipping& value);

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a readable property map from the vertices of the input to the logarithmic scale factors to
/// start from.
template <typename Map>
auto initial_log_scale_map(const Map& map);

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a `Layout`: the method that lays out flat faces in the plane.
template <typename Layout>
auto layout(const Layout& value);

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a readable property map from the vertices of the input to the radii of circles.
template <typename Map>
auto vertex_radius_map(const Map& map);

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// names a writable property map for the images of corners.
template <typename Map>
auto texture_coordinates_map(const Map& map);

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// names a writable property map for the images of corners in homogeneous coordinates.
template <typename Map>
auto homogeneous_texture_coordinates_map(const Map& map);

} // namespace parameters

#endif // DOXYGEN_RUNNING

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_NAMED_PARAMETERS_H
