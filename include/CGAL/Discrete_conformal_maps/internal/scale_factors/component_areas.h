// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_COMPONENT_AREAS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_COMPONENT_AREAS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the area of each component of the double in one of its triangulations, for these
// lengths of halfedges.
template <typename Length>
auto component_areas(const Doubled_problem& problem, const Delta_complex& complex,
                     const Length& length)
{
  using std::sqrt;
  typedef std::decay_t<decltype(length(Halfedge_index()))> FT;
  std::vector<FT> result(problem.components().size(), FT(0));
  for(Face_index f : complex.faces()) {
    const auto h = sides(f, complex);
    const std::size_t c = problem.component(complex.target(h[0]));
    const FT quadrupled = sqrt(
      Intrinsic_triangulations::squared_quadrupled_area(length(h[0]), length(h[1]), length(h[2])));
    result[c] += quadrupled / 4 * problem.part(f) * (problem.has_boundary(c) ? 2 : 1);
  }
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_COMPONENT_AREAS_H
