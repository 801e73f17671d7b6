// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_EXTENDED_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_EXTENDED_H

#include <CGAL/license/Discrete_conformal_maps.h>

#ifdef CGAL_USE_MPFR
#include <boost/multiprecision/mpfr.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace CGAL::Discrete_conformal_maps::internal {

#ifdef CGAL_USE_MPFR // many times as fast
template <unsigned int digits>
using Extended_backend =
  boost::multiprecision::mpfr_float_backend<digits, boost::multiprecision::allocate_stack>;
#else
template <unsigned int digits>
using Extended_backend = boost::multiprecision::cpp_bin_float<digits>;
#endif

// takes over where double has too few digits
typedef boost::multiprecision::number<Extended_backend<34>, boost::multiprecision::et_off> Extended;

// takes over from that where errors grow on very long ways
typedef boost::multiprecision::number<Extended_backend<115>, boost::multiprecision::et_off>
  More_extended;

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_EXTENDED_H
