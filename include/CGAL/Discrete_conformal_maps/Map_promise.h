// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_MAP_PROMISE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_MAP_PROMISE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Map_status.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMaps
/// a property of every successful map, with the error of a result.
///
/// `Discrete_conformal_map::promises()` lists the measurements on the result; \ref dcm_status
/// explains each name.
struct Map_promise
{
  const char* name;     ///< the property
  double error;         ///< the error of the result; NaN if it cannot be measured
  double bound;         ///< the greatest error of a success
  Map_status if_missed; ///< the status of a map that misses it

  /// returns whether the error is within the bound.
  bool is_kept() const { return error <= bound; }
};

namespace internal {

// Returns the status of a map with these promises, whose scale factors were found with the status
// `search`. It does not depend on how the result was reached. If scale factors are wrong, `search`
// explains why.
inline Map_status status_of(const std::vector<Map_promise>& promises, Map_status search)
{
  const auto missed = std::find_if(promises.begin(), promises.end(),
                                   [](const Map_promise& p) { return !p.is_kept(); });
  if(missed == promises.end())
    return Map_status::success;
  const bool is_by_search = missed->if_missed == Map_status::wrong_curvature ||
                            missed->if_missed == Map_status::not_laid_out;
  return is_by_search && search != Map_status::success ? search : missed->if_missed;
}

// Returns the greater of two errors; NaN is greater than all numbers.
inline double greater_error(double a, double b) { return b <= a || std::isnan(a) ? a : b; }

// Returns the error of the curvatures of a map with these promises. The error of the search counts
// only if the map fails.
inline double curvature_error_of(const std::vector<Map_promise>& promises, double search)
{
  double result = status_of(promises, Map_status::success) == Map_status::success ? 0 : search;
  for(const Map_promise& p : promises)
    if(p.if_missed == Map_status::wrong_curvature)
      result = greater_error(result, p.error);
  return result;
}

} // namespace internal

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_MAP_PROMISE_H
