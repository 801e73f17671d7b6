// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_WITH_DIGITS_AS_NEEDED_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_WITH_DIGITS_AS_NEEDED_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Map_status.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/input_rounding.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <optional>
#include <utility>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the map `find(input, exactness)` with rounded lengths. If rounding changes angles of the
// input, its errors are measured on the exact surface. If this fails, or errors are not
// `measurable`, returns the map with lengths of the exact surface.
//
// \throws Error as the last call of `find()` does
template <typename Find>
auto with_digits_as_needed(Intrinsic_triangulations::Intrinsic_triangulation<> input,
                           const Find& find, bool measurable = true)
{
  typedef decltype(find(std::move(input), Exactness::none)) Map;
  if(!(has_unknown_angles(input) && has_exact_metric(input)))
    return find(std::move(input), Exactness::none);
  std::optional<Map> rounded;
  try {
    if(measurable)
      rounded = find(Intrinsic_triangulations::Intrinsic_triangulation<>(input), Exactness::errors);
    if(rounded && rounded->status() == Map_status::success)
      return std::move(*rounded);
  } catch(const Intrinsic_triangulations::Error&) { // such as flips without end
  }
  try {
    Map exact = find(std::move(input), Exactness::lengths);
    if(!rounded || exact.status() == Map_status::success)
      return exact;
  } catch(const Intrinsic_triangulations::Error&) {
    if(!rounded)
      throw;
  }
  return std::move(*rounded);
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_WITH_DIGITS_AS_NEEDED_H
