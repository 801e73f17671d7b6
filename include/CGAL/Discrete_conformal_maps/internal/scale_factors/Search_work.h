// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WORK_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WORK_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>
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
  // The limit is divided by `parts`.
  explicit Search_work(double parts = 1) : m_done(tolerance::work_for_map * (1 - 1 / parts)) {}

  // Adds faces and flips that were measured in numbers of type `FT`.
  template <typename FT>
  void add(std::size_t measured)
  {
    m_done += of<FT>(measured);
  }

  double done() const { return m_done; }

  // Returns the work that is left until `end`.
  double left(double end = tolerance::work_for_map) const { return (std::max)(end - m_done, 0.); }

  // Returns the end of the next of several searches that have the work until `end`.
  double end_of_part(double end = tolerance::work_for_map,
                     double parts = tolerance::parts_of_work) const
  {
    return m_done + left(end) / parts;
  }

  // Returns the cost of measured faces and flips. Processors compute in `double`. Numbers with more
  // digits are functions, so that `double` costs less than in proportion to its digits.
  template <typename FT>
  static double of(std::size_t measured)
  {
    const double digits =
      double(std::numeric_limits<FT>::digits) / double(std::numeric_limits<Double_double>::digits);
    return double(measured) * (digits < 1 ? cost_of_double : digits * std::sqrt(digits));
  }

private:
  static constexpr double cost_of_double = 0.17;

  double m_done;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WORK_H
