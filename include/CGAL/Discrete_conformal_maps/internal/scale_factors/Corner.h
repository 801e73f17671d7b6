// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CORNER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CORNER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Extended.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the exponent of two that is just above `x`.
template <typename FT>
int exponent_of(const FT& x)
{
  using std::frexp;
  int result = 0;
  (void)frexp(x, &result);
  return result;
}
inline int exponent_of(const Extended& x) { return exponent_of(x.high()); }

// The cosine and the sine of an angle, up to a common factor.
template <typename FT>
struct Corner
{
  FT cosine, sine;

  FT angle() const
  {
    using std::atan2;
    return atan2(sine, cosine);
  }

  // with a power of two as factor, for which the greater of both is from 1/2 to 1; NaN if both are
  // zero
  Corner scaled() const
  {
    const FT size = (std::max)(cosine < 0 ? FT(-cosine) : cosine, sine < 0 ? FT(-sine) : sine);
    if(!(size > 0))
      return {cosine / size, sine / size};
    using std::ldexp;
    const int exponent = exponent_of(size);
    return {ldexp(cosine, -exponent), ldexp(sine, -exponent)};
  }

  // in double precision
  double rounded_angle() const
  {
    const Corner unit = scaled();
    return std::atan2(static_cast<double>(unit.sine), static_cast<double>(unit.cosine));
  }

  // of the sum of both angles
  friend Corner operator*(const Corner& a, const Corner& b)
  {
    return {a.cosine * b.cosine - a.sine * b.sine, a.cosine * b.sine + a.sine * b.cosine};
  }
};

// pi, for any number type
template <typename FT>
FT straight_angle()
{
  return Corner<FT>{FT(-1), FT(0)}.angle();
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CORNER_H
