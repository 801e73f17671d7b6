// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WORK_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WORK_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Extended.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// Counts the measured faces and flips of all searches for one map, in units of their cost with 32
// digits, against their limit.
class Search_work
{
public:
  // Adds faces and flips that were measured in numbers of type `FT`.
  template <typename FT>
  void add(std::size_t measured)
  {
    m_done += of<FT>(measured);
  }

  // Returns the work that is left until `end`.
  std::size_t left(std::size_t end = tolerance::work_for_map) const
  {
    return end - (std::min)(m_done, end);
  }

  // Returns the end of the next of several searches.
  std::size_t end_of_part() const { return m_done + left() / tolerance::parts_of_work; }

  // Returns the cost of measured faces and flips. For needles in 384 bits, 7 times the cost with 32
  // digits has been measured.
  template <typename FT>
  static std::size_t of(std::size_t measured)
  {
    const double digits =
      double(std::numeric_limits<FT>::digits) / double(std::numeric_limits<Extended>::digits);
    return std::size_t(double(measured) * digits * std::sqrt(digits));
  }

private:
  std::size_t m_done = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WORK_H
