// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALED_LENGTH_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALED_LENGTH_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <cmath>

namespace CGAL::Discrete_conformal_maps::internal {

// The factor by which logarithmic scale factors that sum up to `u` multiply lengths.
template <typename FT>
FT length_factor(const FT& u)
{
  using std::exp;
  return exp(u / 2);
}

// Equation 4.1: the length of an edge ij after scaling, multiplied by the factors of i and j, which
// are computed once for each vertex, or with less rounding by that of u_i + u_j.
template <typename FT, typename... Factor>
FT scaled_length(const FT& length, const Factor&... factor)
{
  return (length * ... * factor);
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALED_LENGTH_H
