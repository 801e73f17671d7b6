// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LONG_FLOAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LONG_FLOAT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>

#include <cmath>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Numbers are enclosed with at most this number of binary digits.
constexpr int most_digits = 1024;

// The type has 309 decimal digits, which are at least `most_digits` binary digits.
typedef Decimal_float<309> Long_float;

// Stores the unit of roundoff u of a number type.
template <typename N>
struct Rounding
{
  static constexpr double unit() { return std::numeric_limits<N>::epsilon() / 2; }
};

// The unit is zero if it is below the range of `double`.
template <unsigned int Digits>
struct Rounding<Decimal_float<Digits>>
{
  static double unit()
  {
    return std::ldexp(1.0, -std::numeric_limits<Decimal_float<Digits>>::digits);
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LONG_FLOAT_H
