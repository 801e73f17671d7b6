// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_BOUNDED_SEARCHES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_BOUNDED_SEARCHES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Extended.h>

#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores scale factors that a search with bounded differences has found, if it has. Stores the work
// of all such searches, and of precise searches. The next problem for the same map continues.
struct Bounded_searches
{
  std::vector<Extended> found;
  std::size_t work = 0, precise_work = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_BOUNDED_SEARCHES_H
