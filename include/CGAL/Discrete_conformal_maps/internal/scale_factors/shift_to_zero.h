// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SHIFT_TO_ZERO_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SHIFT_TO_ZERO_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Prescribed_curvatures.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Makes the greatest logarithmic scale factor of each component zero if none is prescribed, so that
// no scaled length is too great for `double`. Returns all scale factors.
template <typename FT>
const std::vector<FT>& shift_to_zero(const Prescribed_curvatures& problem,
                                     std::vector<FT>& log_scale)
{
  const auto& component = problem.components();
  const std::vector<std::size_t> fixed = problem.number_of_fixed();
  std::vector<double> greatest(fixed.size(), -std::numeric_limits<double>::infinity());
  for(std::size_t v = 0; v < problem.size(); ++v)
    greatest[component[v]] = (std::max)(greatest[component[v]], static_cast<double>(log_scale[v]));
  for(std::size_t v = 0; v < problem.size(); ++v)
    if(const std::size_t c = component[v]; fixed[c] == 0)
      log_scale[v] -= greatest[c];
  return log_scale;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SHIFT_TO_ZERO_H
