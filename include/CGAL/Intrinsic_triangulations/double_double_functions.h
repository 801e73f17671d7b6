// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOUBLE_DOUBLE_FUNCTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOUBLE_DOUBLE_FUNCTIONS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Plane_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

// The exponential function and its relatives, which argument-dependent lookup finds, have an error
// of about 100 u^2, and times the argument if it is greater.
namespace CGAL::Intrinsic_triangulations::internal {

inline Double_double ln_two()
{
  return Double_double::exact_sum(0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56);
}

// Returns e^x - 1 of a number or complex number `x` by the series for 2^-n x, and n squarings.
// Squares of e^x would lose more digits.
template <typename Number>
Number exponential(const Number& x, int n)
{
  typedef Double_double FT;
  static const auto inverse = [] {
    std::array<FT, 11> result;
    for(int k = 1; k < 11; ++k)
      result[std::size_t(k)] = FT(1) / k;
    return result;
  }();
  const Number part = ldexp(FT(1), -n) * x;
  Number result = part;
  for(int k = 10; k > 1; --k)
    result = part + inverse[std::size_t(k)] * (part * result);
  for(; n > 0; --n)
    result = FT(2) * result + result * result;
  return result;
}

inline Double_double exp(Double_double x)
{
  if(!(std::abs(x.high()) < 1000))
    return std::exp(x.high());
  const int exponent = static_cast<int>(std::round(x.high() / ln_two().high()));
  return ldexp(1 + exponential(x - exponent * ln_two(), 9), exponent);
}

// Computes the logarithm by a step of third order from the logarithm in `double`.
inline Double_double log(Double_double x)
{
  const double first = std::log(x.high());
  if(!std::isfinite(first))
    return first;
  const Double_double rest = x * exp(Double_double(-first)) - 1;
  return first + (rest - rest * rest / 2);
}

// Returns e^(ix) - 1.
inline auto turn(Double_double x)
{
  return exponential(Plane_vector<Double_double>{0, x},
                     10 + std::clamp(std::ilogb(x.high()), 0, 60));
}

inline Double_double cos(Double_double x) { return 1 + turn(x).x; }
inline Double_double sin(Double_double x) { return turn(x).y; }

// Computes the angle by a step of third order from the angle in `double`.
inline Double_double atan2(Double_double y, Double_double x)
{
  const Double_double first = std::atan2(y.high(), x.high());
  if(first == 0)
    return x > 0 ? y / x : first;
  const Double_double cosine = cos(first), sine = sin(first);
  return first + (y * cosine - x * sine) / (x * cosine + y * sine);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOUBLE_DOUBLE_FUNCTIONS_H
