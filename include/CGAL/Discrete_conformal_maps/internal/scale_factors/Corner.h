// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CORNER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CORNER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Discrete_conformal_maps::internal {

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

  // with a factor for which the greater of both is 1 or -1
  Corner scaled() const
  {
    const FT size = (std::max)(cosine < 0 ? FT(-cosine) : cosine, sine < 0 ? FT(-sine) : sine);
    return {cosine / size, sine / size};
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
