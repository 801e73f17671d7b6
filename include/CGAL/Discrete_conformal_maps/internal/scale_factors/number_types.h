// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_NUMBER_TYPES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_NUMBER_TYPES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Intrinsic_triangulations/double_double_functions.h>

namespace CGAL::Discrete_conformal_maps::internal {

// The searches for scale factors try the following numbers one after the other:
// - `double`;
// - `Double_double`, with 31 decimal digits, if `double` has too few;
// - `Wide_number` of either, if scale factors exceed their range;
// - `Decimal_115`, if errors grow on very long paths.
using Intrinsic_triangulations::Double_double;
typedef Intrinsic_triangulations::Decimal_float<115> Decimal_115;

// This type stores positions of faces in one plane. Sizes of faces may differ by a factor of
// e^3400.
typedef Intrinsic_triangulations::Decimal_float<1500> Decimal_1500;

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_NUMBER_TYPES_H
