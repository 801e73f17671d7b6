// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ROOT_OF_INCREASING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ROOT_OF_INCREASING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <cmath>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns where an increasing function is at most `limit` from zero, as found from zero on with
// steps that begin with that of Newton's method, for the slope there; zero if it is nowhere. Its
// slope may change by many orders of magnitude: each second point is in the middle of the interval
// that is left.
template <typename FT, typename Function>
FT root_of_increasing(const Function& function, double slope, double limit)
{
  constexpr int most_steps = 60, most_points = 600;
  FT low(0), high(0), step(0);
  double at_low = function(low), at_high = at_low;
  step = FT(std::abs(at_low) / slope);
  for(int i = 0; i < most_steps && at_low > limit; ++i, step *= 4) {
    high = low;
    at_high = at_low;
    low -= step;
    at_low = function(low);
  }
  for(int i = 0; i < most_steps && at_high < -limit; ++i, step *= 4) {
    low = high;
    at_low = at_high;
    high += step;
    at_high = function(high);
  }
  for(int i = 0; i < most_points; ++i) {
    if(std::abs(at_low) <= limit)
      return low;
    if(std::abs(at_high) <= limit)
      return high;
    if(!(at_low < 0 && at_high > 0))
      return FT(0);
    const FT x =
      i % 2 == 0 ? FT(low + (high - low) * FT(at_low / (at_low - at_high))) : FT((low + high) / 2);
    const double at_x = function(x);
    (at_x < 0 ? low : high) = x;
    (at_x < 0 ? at_low : at_high) = at_x;
  }
  return low;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ROOT_OF_INCREASING_H
