// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WORK_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WORK_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Discrete_conformal_maps::internal {

// Counts the measured faces and flips of all searches for one map, against their limits.
struct Search_work
{
  std::size_t with_bounded_differences = 0, with_more_digits = 0;

  std::size_t left_with_bounded_differences() const
  {
    return left(with_bounded_differences, tolerance::work_with_bounded_differences);
  }
  std::size_t left_with_more_digits() const
  {
    return left(with_more_digits, tolerance::work_with_more_digits);
  }

private:
  static std::size_t left(std::size_t done, std::size_t limit)
  {
    return limit - (std::min)(done, limit);
  }
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WORK_H
