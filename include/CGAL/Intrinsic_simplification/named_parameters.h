// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_NAMED_PARAMETERS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_NAMED_PARAMETERS_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Intrinsic_simplification {

namespace internal_np {
enum number_of_vertices_t
{
  number_of_vertices
};
enum maximum_cost_t
{
  maximum_cost
};
} // namespace internal_np

namespace parameters {

/// \ingroup PkgIntrinsicSimplificationGreedy
/// names the number of vertices that shall be left.
template <typename Number>
auto number_of_vertices(const Number& value)
{
  return CGAL::Named_function_parameters<Number, internal_np::number_of_vertices_t>(value);
}

/// \ingroup PkgIntrinsicSimplificationGreedy
/// the same, after the parameters `np`.
template <typename Number, typename NamedParameters>
auto number_of_vertices(const Number& value, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Number, internal_np::number_of_vertices_t,
                                         NamedParameters>(value, np);
}

/// \ingroup PkgIntrinsicSimplificationGreedy
/// names the greatest cost of a removal that is allowed.
template <typename Number>
auto maximum_cost(const Number& value)
{
  return CGAL::Named_function_parameters<Number, internal_np::maximum_cost_t>(value);
}

/// \ingroup PkgIntrinsicSimplificationGreedy
/// the same, after the parameters `np`.
template <typename Number, typename NamedParameters>
auto maximum_cost(const Number& value, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Number, internal_np::maximum_cost_t, NamedParameters>(
    value, np);
}

} // namespace parameters

} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_NAMED_PARAMETERS_H
