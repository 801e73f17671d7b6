// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_BEST_UNFOLDING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_BEST_UNFOLDING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/layout/Sphere_unfolding.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Unfolded_sphere.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/vertex_masses.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Unfolds a sphere from several vertices, until a result is good or the searches have reached the
// limit of work for a map. Returns the first good result, or else the best one.
// Results with different copies of a disk cannot be compared. So later results contain the whole
// copy unless the first result is good. `mass` has the mass of each vertex of the surface.
inline Unfolded_sphere best_unfolding(Doubled_problem& problem, const std::vector<double>& mass,
                                      Any_visitor& visitor, Unfolding_use use = Unfolding_use::map)
{
  constexpr std::size_t distant_vertices = 4, maximum_number_of_trials = 16;
  const std::vector<Vertex_index> vertices = vertices_at_infinity(problem, mass);
  const auto unfolded = [&](Vertex_index v) {
    return Sphere_unfolding(problem, mass, v, use).run(visitor);
  };
  const auto is_good = [](const Unfolded_sphere& sphere) {
    return sphere.is_good(tolerance::good_cross_ratio);
  };
  Unfolded_sphere best = unfolded(vertices.front());
  if(problem.is_measured() || (best.is_certified() && problem.may_gain_digits()))
    return best; // lengths of the exact surface follow
  if(!is_good(best) && problem.complete())
    best = unfolded(vertices.front());
  // Vertices with distant ranks in the order of areas are most likely distant on the surface. After
  // these vertices, their successors follow.
  const std::size_t stride = 1 + vertices.size() / (4 * distant_vertices),
                    end = (std::min)(maximum_number_of_trials, distant_vertices * stride);
  for(std::size_t trial = 1; !is_good(best) && problem.work().left() > 0 && trial < end; ++trial)
    if(const std::size_t rank = trial % distant_vertices * stride + trial / distant_vertices;
       rank < vertices.size())
      if(Unfolded_sphere next = unfolded(vertices[rank]); next < best)
        best = std::move(next);
  return best;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_BEST_UNFOLDING_H
