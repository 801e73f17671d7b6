// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_WITH_DIGITS_AS_NEEDED_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_WITH_DIGITS_AS_NEEDED_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Map_status.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/input_rounding.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <optional>
#include <utility>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns whether more digits may prevent the failure of a map. They do not if steps were too few,
// or if a fixed triangulation has no map.
inline bool may_need_digits(const Discrete_conformal_map& map)
{
  switch(map.status()) {
    case Map_status::success:
    case Map_status::triangle_inequality:
    case Map_status::no_minimum: return false;
    case Map_status::not_converged:
      return map.minimization().status == Minimization_status::rounding_limit;
    default: return true;
  }
}

// Returns the map `find(input, exactness)` with rounded lengths. If rounding changes angles of the
// input, its errors are measured on the exact surface. If this fails, or errors are not
// `measurable`, returns the map with lengths of the exact surface. If rounding changes no angles of
// the input, it may change angles after flips: a map with `needs_digits(map)` is computed again,
// too.
//
// \throws Error as the last call of `find()` does
template <typename Find, typename Predicate = bool (*)(const Discrete_conformal_map&)>
auto with_digits_as_needed(Intrinsic_triangulations::Intrinsic_triangulation<> input, Find&& find,
                           bool measurable, const Predicate& needs_digits = may_need_digits)
{
  typedef decltype(find(std::move(input), Exactness::none)) Map;
  if(!has_exact_metric(input))
    return find(std::move(input), Exactness::none);
  const auto found = [&](Exactness exactness) {
    return find(Intrinsic_triangulations::Intrinsic_triangulation<>(input), exactness);
  };
  std::optional<Map> rounded;
  if(!has_unknown_angles(input)) {
    rounded = found(Exactness::none);
    if(!needs_digits(*rounded))
      return std::move(*rounded);
  } else
    try {
      if(measurable)
        rounded = found(Exactness::errors);
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
