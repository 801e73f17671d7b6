// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_NUMBER_CONVERSION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_NUMBER_CONVERSION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Wide_number.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>

#include <type_traits>

namespace CGAL::Discrete_conformal_maps::internal {

// `converted<To>(x)` is the number `x` of any type as the type `To`. It is rounded if `To` has
// fewer digits, and infinite or zero beyond its range.

template <typename To>
To converted(double x)
{
  return To(x);
}

template <typename To>
To converted(const Double_double& x)
{
  if constexpr(std::is_same<To, double>::value)
    return x.high();
  else
    return To(x.high()) + To(x.low());
}

template <typename To, unsigned int Digits>
To converted(const Intrinsic_triangulations::Decimal_float<Digits>& x)
{
  if constexpr(std::is_same<To, Double_double>::value) {
    const double high = static_cast<double>(x);
    return Double_double(high) + Double_double(static_cast<double>(x - high));
  } else if constexpr(std::is_same<To, Wide_number<double>>::value ||
                      std::is_same<To, Wide_number<Double_double>>::value) {
    typedef std::decay_t<decltype(To().mantissa())> Mantissa;
    int exponent = 0;
    const Intrinsic_triangulations::Decimal_float<Digits> mantissa = frexp(x, &exponent);
    return To(converted<Mantissa>(mantissa), exponent);
  } else
    return static_cast<To>(x);
}

template <typename To, typename Mantissa>
To converted(const Wide_number<Mantissa>& x)
{
  if constexpr(std::is_same<To, double>::value || std::is_same<To, Double_double>::value)
    return converted<To>(x.in_range_of_mantissa());
  else if constexpr(std::is_constructible<To, Wide_number<Mantissa>>::value)
    return To(x);
  else
    return ldexp(converted<To>(x.mantissa()), exponent_of(x));
}

// Selects a number type with as many digits of a difference of two numbers as are useful. More
// digits of a long number only keep positions apart.
template <typename FT>
using Difference_of =
  std::conditional_t<std::is_same<FT, Decimal_1500>::value, Wide_number<double>, FT>;

// Selects a number type for distances that are compared with `double`. They exceed the range of
// `double` only if positions do.
template <typename FT>
using Distance_of =
  std::conditional_t<std::is_same<FT, Decimal_1500>::value, Wide_number<double>, double>;

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_NUMBER_CONVERSION_H
