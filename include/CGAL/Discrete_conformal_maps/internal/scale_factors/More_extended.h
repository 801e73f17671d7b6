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

#ifdef CGAL_USE_MPFR // many times as fast
typedef boost::multiprecision::mpfr_float_backend<115, boost::multiprecision::allocate_stack>
  More_extended_backend;
#else
typedef boost::multiprecision::cpp_bin_float<115> More_extended_backend;
#endif

// takes over from `Extended` where errors grow on very long ways
typedef boost::multiprecision::number<More_extended_backend, boost::multiprecision::et_off>
  More_extended;

inline More_extended to_more_extended(const More_extended& x) { return x; }
inline More_extended to_more_extended(double x) { return x; }
inline More_extended to_more_extended(const Extended& x)
{
  return More_extended(x.high()) + x.low();
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_MORE_EXTENDED_H
