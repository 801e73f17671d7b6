// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ROOT_OF_INCREASING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ROOT_OF_INCREASING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <cmath>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores an interval, and the values of a function at its ends.
template <typename FT>
struct Interval_of_root
{
  FT low, high;
  double at_low, at_high;
};

// Returns an interval at whose ends an increasing function has different signs, or is at most
// `limit` from zero at one of them. Returns nothing if it finds none. Steps from zero begin with
// the step of Newton's method, for the slope at zero.
template <typename FT, typename Function>
Interval_of_root<FT> interval_of_root(const Function& function, double slope, double limit)
{
  constexpr int most_steps = 60;
  const double at_zero = function(FT(0));
  Interval_of_root<FT> x{FT(0), FT(0), at_zero, at_zero};
  FT step(std::abs(at_zero) / slope);
  for(int i = 0; i < most_steps && x.at_low > limit; ++i, step *= 4) {
    const FT low = x.low - step;
    x = {low, x.low, function(low), x.at_low};
  }
  for(int i = 0; i < most_steps && x.at_high < -limit; ++i, step *= 4) {
    const FT high = x.high + step;
    x = {x.high, high, x.at_high, function(high)};
  }
  return x;
}

// Returns a point at which an increasing function is at most `limit` from zero, or zero if no such
// point is found. `slope` is the slope at zero. The slope may change by many orders of magnitude,
// so each second point is the center of the remaining interval.
template <typename FT, typename Function>
FT root_of_increasing(const Function& function, double slope, double limit)
{
  constexpr int most_points = 600;
  auto [low, high, at_low, at_high] = interval_of_root<FT>(function, slope, limit);
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
