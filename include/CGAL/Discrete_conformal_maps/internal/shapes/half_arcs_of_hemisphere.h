// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_HALF_ARCS_OF_HEMISPHERE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_HALF_ARCS_OF_HEMISPHERE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/layout/Inscribed_polygon.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Sphere_unfolding.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/vertex_areas.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Maps a disk to a half plane, with a vertex of its boundary at infinity.
template <typename Visitor>
Unfolded_sphere unfold_to_half_plane(Doubled_problem& problem, Visitor& visitor)
{
  const std::vector<double> area = vertex_areas(problem);
  const Vertex_index infinity = vertices_at_infinity(problem, area).front();
  if(has_vertices_inside(problem))
    return Sphere_unfolding(problem, area, infinity).run(visitor);
  const Unfolded_sphere result =
    Inscribed_polygon<Extended>(problem, area, infinity, visitor).result();
  return result.is_good(tolerance::cross_ratio)
           ? result
           : Inscribed_polygon<Long_number>(problem, area, infinity, visitor).result();
}

// Returns half of the angles under which the center of the unit disk, the image of the half plane,
// sees the sides of its boundary, from each vertex of `boundary` to the next; nothing if these do
// not sum up to half a turn. Sides that are too short for their positions have the angle zero.
inline std::optional<std::vector<double>> half_arcs(const Spherical_layout& layout,
                                                    const std::vector<Vertex_index>& boundary)
{
  constexpr double pi = boost::math::constants::pi<double>();
  const auto at = [&](std::size_t i) {
    return layout.in_plane[boundary[i % boundary.size()].idx()][0];
  };
  const auto is_infinite = [&](std::size_t i) {
    return boundary[i % boundary.size()] == layout.at_infinity;
  };
  for(const int sign : {1, -1}) { // of the direction in which the boundary runs along the line
    std::vector<double> result;
    for(std::size_t i = 0; i < boundary.size(); ++i) {
      const Extended x = sign * at(i), y = sign * at(i + 1);
      const Extended sine = is_infinite(i) || is_infinite(i + 1) ? Extended(1) : y - x,
                     cosine = is_infinite(i)       ? -y
                              : is_infinite(i + 1) ? x
                                                   : 1 + x * y;
      result.push_back(std::atan2(static_cast<double>(sine), static_cast<double>(cosine)));
    }
    if(std::abs(std::accumulate(result.begin(), result.end(), -pi)) < 1e-6)
      return result;
  }
  return std::nullopt;
}

// Maps a disk to a hemisphere, the boundary to the equator, and returns half of the angles under
// which the center sees its sides; nothing if there is no such map in numbers of type `double`.
// \pre the surface is a disk; `boundary` are the vertices of its boundary in cyclic order
template <typename Visitor>
std::optional<std::vector<double>>
half_arcs_of_hemisphere(Doubled_problem& problem, const std::vector<Vertex_index>& boundary,
                        Visitor& visitor)
{
  try {
    const Unfolded_sphere half_plane = unfold_to_half_plane(problem, visitor);
    return half_plane.layout.exists ? half_arcs(half_plane.layout, boundary) : std::nullopt;
  } catch(const Intrinsic_triangulations::Numerical_error&) {
    return std::nullopt;
  }
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_HALF_ARCS_OF_HEMISPHERE_H
