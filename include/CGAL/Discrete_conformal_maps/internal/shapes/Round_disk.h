// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_ROUND_DISK_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_ROUND_DISK_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Inscribed_polygon.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Sphere_unfolding.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/vertex_masses.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/defect_errors.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the stereographic projection of a hemisphere from the pole of the other hemisphere. The
// image lies in the plane of the equator, which is the unit circle.
struct Round_disk
{
  // `half_arc` contains half of the angle of each boundary side as seen from the center.
  std::vector<double> half_arc;
  // `log_scale` contains the factors of lengths in the plane, at the vertices of the surface.
  std::vector<Decimal_115> log_scale;
};

// Stores a round disk without interior vertices. Its corners are cocircular, so every triangulation
// is Delaunay. The disk has all data of a map.
struct Round_polygon : Round_disk
{
  std::vector<Halfedge_index> flips; // from T_2 to T_3
  std::vector<double> side_length;   // in the plane, of each edge on the boundary of the surface
};

// Returns half of the angle of each boundary side as seen from the center of the unit disk, the
// image of the half plane. Sides lead from each vertex of `boundary` to the next. Returns nothing
// if the sum is not pi, or if an angle is negative. A side that is too short for its positions has
// the angle zero.
inline std::optional<std::vector<double>> half_arcs(const Spherical_layout& layout,
                                                    const std::vector<Vertex_index>& boundary)
{
  constexpr double pi = CGAL_PI;
  const auto at = [&](std::size_t i) {
    return layout.in_plane[boundary[i % boundary.size()].idx()][0];
  };
  const auto is_infinite = [&](std::size_t i) {
    return boundary[i % boundary.size()] == layout.at_infinity;
  };
  for(const int sign : {1, -1}) { // of the direction in which the boundary runs along the line
    std::vector<double> result;
    for(std::size_t i = 0; i < boundary.size(); ++i) {
      const Double_double x = sign * at(i), y = sign * at(i + 1);
      const Double_double sine = is_infinite(i) || is_infinite(i + 1) ? Double_double(1) : y - x,
                          cosine = is_infinite(i)       ? -y
                                   : is_infinite(i + 1) ? x
                                                        : 1 + x * y;
      result.push_back(std::atan2(static_cast<double>(sine), static_cast<double>(cosine)));
    }
    // Against the direction of the boundary, angles between finite vertices are negative.
    if(*std::min_element(result.begin(), result.end()) >= 0 &&
       std::abs(std::accumulate(result.begin(), result.end(), -pi)) < 1e-6)
      return result;
  }
  return std::nullopt;
}

// Returns the logarithmic scale factors of the image of a half plane in the unit disk. The factors
// of the hemisphere are `on_sphere`; the factor of the projection is one on the equator.
inline std::vector<Decimal_115> log_scales_in_disk(const Spherical_layout& half_plane,
                                                   const std::vector<double>& on_sphere)
{
  std::vector<Decimal_115> result(on_sphere.begin(), on_sphere.end());
  for(std::size_t v = 0; v < result.size(); ++v) {
    const Double_double x = half_plane.in_plane[v][0], height = half_plane.in_plane[v][1],
                        y = height < 0 ? -height : height;
    const Double_double from_origin = 1 + x * x + y * y;
    if(v != half_plane.at_infinity.idx())
      result[v] += std::log(static_cast<double>(from_origin / (from_origin + 2 * y)));
  }
  return result;
}

// Returns the result of `find()`, or nothing if it throws a numerical error.
template <typename Find>
auto unless_numbers_fail(const Find& find) -> decltype(find())
{
  try {
    return find();
  } catch(const Intrinsic_triangulations::Numerical_error&) {
    return std::nullopt;
  }
}

// Maps a disk without interior vertices to an inscribed polygon, in numbers of type `FT`. Returns
// nothing if these numbers have too few digits.
template <typename FT>
std::optional<Round_polygon> round_polygon(Doubled_problem& problem,
                                           const std::vector<Vertex_index>& boundary)
{
  return unless_numbers_fail([&]() -> std::optional<Round_polygon> {
    const std::vector<double> mass = vertex_masses(problem);
    Default_flattening_visitor silent;
    Any_visitor visitor = Any_visitor::of(silent);
    const Inscribed_polygon<FT> polygon(problem, mass, vertices_at_infinity(problem, mass).front(),
                                        visitor);
    if(!polygon.result().is_good(tolerance::cross_ratio))
      return std::nullopt;
    auto arcs = half_arcs(polygon.result().layout, boundary);
    if(!arcs)
      return std::nullopt;
    return Round_polygon{{std::move(*arcs), polygon.log_scales_in_disk()},
                         polygon.result().flips,
                         polygon.side_lengths_in_disk()};
  });
}

// Returns the greatest error of an exterior angle of a polygon, compared with the prescribed
// angles, on both sides of the double. Rounding makes lengths on both sides different. The
// difference is great if the surface has needles.
inline std::optional<double> exterior_angle_error(const Doubled_problem& problem,
                                                  const Round_polygon& polygon)
{
  return unless_numbers_fail([&]() -> std::optional<double> {
    const Doubled_problem::Triangulation& t = problem.triangulation();
    Ptolemy_surface<Decimal_115> surface(t.mesh(), problem.lengths<Decimal_115>(t));
    surface.replay(polygon.flips);
    const Delta_complex& mesh = surface.mesh();
    const auto u = [&](Edge_index e, unsigned int end) {
      return polygon.log_scale[problem.original(mesh.vertex(e, end)).idx()];
    };
    std::vector<Decimal_115> length;
    for(Edge_index e : mesh.edges())
      length.push_back(
        scaled_length(surface.length(e), length_factor(Decimal_115(u(e, 0) + u(e, 1)))));
    return defect_errors<Flat_triangle<Decimal_115>>(problem, mesh, length).greatest();
  });
}

// Maps a disk with interior vertices to a hemisphere, and its boundary to the equator. Returns
// nothing if no such map exists.
// \pre the surface is a disk; `boundary` are the vertices of its boundary in cyclic order
inline std::optional<Round_disk> round_hemisphere(Doubled_problem& problem,
                                                  const std::vector<Vertex_index>& boundary,
                                                  Any_visitor& visitor)
{
  return unless_numbers_fail([&]() -> std::optional<Round_disk> {
    const std::vector<double> mass = vertex_masses(problem);
    const Unfolded_sphere half_plane =
      Sphere_unfolding(problem, mass, vertices_at_infinity(problem, mass).front()).run(visitor);
    if(!half_plane.layout.exists)
      return std::nullopt;
    auto arcs = half_arcs(half_plane.layout, boundary);
    if(!arcs)
      return std::nullopt;
    return Round_disk{std::move(*arcs),
                      log_scales_in_disk(half_plane.layout, half_plane.log_scale)};
  });
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_ROUND_DISK_H
