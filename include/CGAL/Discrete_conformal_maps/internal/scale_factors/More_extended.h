// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_MORE_EXTENDED_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_MORE_EXTENDED_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Extended.h>

#ifdef CGAL_USE_MPFR
#include <boost/multiprecision/mpfr.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace CGAL::Discrete_conformal_maps::internal {

// a floating point number with that many decimal digits, whose exponent has no end in practice
#ifdef CGAL_USE_MPFR // many times as fast
template <unsigned int Digits>
using Decimal_number = boost::multiprecision::number<
  boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
  boost::multiprecision::et_off>;
#else
template <unsigned int Digits>
using Decimal_number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>,
                                                     boost::multiprecision::et_off>;
#endif

// takes over from `Extended` where errors grow on very long ways
typedef Decimal_number<115> More_extended;

// has positions in one plane of faces that differ in size by a factor of up to e^3400
typedef Decimal_number<1500> Long_number;

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_MORE_EXTENDED_H
