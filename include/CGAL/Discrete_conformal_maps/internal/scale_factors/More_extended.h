// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_MORE_EXTENDED_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_MORE_EXTENDED_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>

namespace CGAL::Discrete_conformal_maps::internal {

// This type replaces `Extended` if errors grow on very long paths.
typedef Intrinsic_triangulations::Decimal_float<115> More_extended;

// This type stores positions of faces in one plane. Sizes of faces may differ by a factor of
// e^3400.
typedef Intrinsic_triangulations::Decimal_float<1500> Long_number;

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_MORE_EXTENDED_H
