// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_NAMED_PARAMETERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_NAMED_PARAMETERS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal_np {
enum edge_length_map_t
{
  edge_length_map
};
enum time_step_factor_t
{
  time_step_factor
};
} // namespace internal_np

namespace parameters {

/// \ingroup PkgIntrinsicTriangulationsRef
/// names a readable property map from the edges of the input to their lengths; it takes the place of
/// vertex positions.
template <typename Map>
auto edge_length_map(const Map& map)
{
  return CGAL::Named_function_parameters<Map, internal_np::edge_length_map_t>(map);
}

/// \ingroup PkgIntrinsicTriangulationsRef
/// the same, after the parameters `np`.
template <typename Map, typename NamedParameters>
auto edge_length_map(const Map& map, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Map, internal_np::edge_length_map_t, NamedParameters>(map,
                                                                                               np);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// names the time for which heat flows, in squared mean edge lengths of the component. Less follows the
/// surface more closely, more is smoother.
template <typename Number>
auto time_step_factor(const Number& factor)
{
  return CGAL::Named_function_parameters<Number, internal_np::time_step_factor_t>(factor);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// the same, after the parameters `np`.
template <typename Number, typename NamedParameters>
auto time_step_factor(const Number& factor, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Number, internal_np::time_step_factor_t, NamedParameters>(
    factor, np);
}

} // namespace parameters

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_NAMED_PARAMETERS_H
