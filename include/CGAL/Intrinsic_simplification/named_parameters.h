// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_NAMED_PARAMETERS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_NAMED_PARAMETERS_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_triangulations/named_parameters.h>

namespace CGAL::Intrinsic_simplification {

#ifndef DOXYGEN_RUNNING

namespace internal_np {
using namespace Intrinsic_triangulations::internal_np;
} // namespace internal_np

#define CGAL_NAMED_PARAMETERS <CGAL/Intrinsic_simplification/internal/list_of_named_parameters.h>
#include <CGAL/Intrinsic_triangulations/internal/input/define_named_parameters.h>

#else

namespace parameters {

/// \ingroup PkgIntrinsicSimplificationRef
/// names `value`, the number of remaining vertices.
template <typename Number>
auto number_of_vertices(const Number& value);

/// \ingroup PkgIntrinsicSimplificationRef
/// names `value`, the greatest allowed cost of a removal, in the unit of the cost.
template <typename Number>
auto maximum_cost(const Number& value);

/// \ingroup PkgIntrinsicSimplificationRef
/// names the map that gets the locations of inserted vertices.
template <typename Map>
auto location_map(const Map& map);

} // namespace parameters

#endif // DOXYGEN_RUNNING

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_NAMED_PARAMETERS_H
