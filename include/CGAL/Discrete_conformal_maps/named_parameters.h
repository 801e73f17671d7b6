// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_NAMED_PARAMETERS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_NAMED_PARAMETERS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL {
namespace Discrete_conformal_maps {

namespace internal_np {
enum vertex_condition_map_t
{
  vertex_condition_map
};
enum maximum_log_scale_t
{
  maximum_log_scale
};
enum minimizer_t
{
  minimizer
};
enum flipping_t
{
  flipping
};
enum initial_log_scale_map_t
{
  initial_log_scale_map
};
enum layout_t
{
  layout
};
} // namespace internal_np

namespace parameters {

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a readable property map from the vertices of the input to `Vertex_condition`.
template <typename Map>
auto vertex_condition_map(const Map& map)
{
  return CGAL::Named_function_parameters<Map, internal_np::vertex_condition_map_t>(map);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// the same, after the parameters `np`.
template <typename Map, typename NamedParameters>
auto vertex_condition_map(const Map& map, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Map, internal_np::vertex_condition_map_t, NamedParameters>(
    map, np);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// names the bound of logarithmic scale factors for which cones are placed.
template <typename Number>
auto maximum_log_scale(const Number& value)
{
  return CGAL::Named_function_parameters<Number, internal_np::maximum_log_scale_t>(value);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// the same, after the parameters `np`.
template <typename Number, typename NamedParameters>
auto maximum_log_scale(const Number& value, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Number, internal_np::maximum_log_scale_t, NamedParameters>(
    value, np);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a model of `ConvexMinimizer`.
template <typename Minimizer>
auto minimizer(const Minimizer& value)
{
  return CGAL::Named_function_parameters<Minimizer, internal_np::minimizer_t>(value);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// the same, after the parameters `np`.
template <typename Minimizer, typename NamedParameters>
auto minimizer(const Minimizer& value, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Minimizer, internal_np::minimizer_t, NamedParameters>(
    value, np);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a `Flipping`: whether triangulations follow the scale factors.
template <typename Flipping>
auto flipping(const Flipping& value)
{
  return CGAL::Named_function_parameters<Flipping, internal_np::flipping_t>(value);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// the same, after the parameters `np`.
template <typename Flipping, typename NamedParameters>
auto flipping(const Flipping& value, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Flipping, internal_np::flipping_t, NamedParameters>(value,
                                                                                             np);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a readable property map from the vertices of the input to the logarithmic scale factors to
/// start from.
template <typename Map>
auto initial_log_scale_map(const Map& map)
{
  return CGAL::Named_function_parameters<Map, internal_np::initial_log_scale_map_t>(map);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// the same, after the parameters `np`.
template <typename Map, typename NamedParameters>
auto initial_log_scale_map(const Map& map, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Map, internal_np::initial_log_scale_map_t,
                                         NamedParameters>(map, np);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// names a `Layout`: how flat faces are laid out in the plane.
template <typename Layout>
auto layout(const Layout& value)
{
  return CGAL::Named_function_parameters<Layout, internal_np::layout_t>(value);
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// the same, after the parameters `np`.
template <typename Layout, typename NamedParameters>
auto layout(const Layout& value, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Layout, internal_np::layout_t, NamedParameters>(value, np);
}

} // namespace parameters
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_NAMED_PARAMETERS_H
