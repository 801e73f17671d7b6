// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_PLANAR_ERRORS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_PLANAR_ERRORS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_predicates.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the number of faces in the plane that are turned over or have no area, exactly.
inline std::size_t number_of_collapsed_faces(const Planar_conformal_map& map)
{
  const auto point = [&](Halfedge_index h) {
    const std::complex<double> z = map.position(h);
    return Plane_predicates<double>::Point{z.real(), z.imag()};
  };
  const Delta_complex& mesh = map.ideal().mesh();
  const auto has_collapsed = [&](Face_index f) {
    const auto side = sides(f, mesh);
    return map.is_laid_out(f) && Plane_predicates<double>().orientation(
                                   point(side[0]), point(side[1]), point(side[2])) <= 0;
  };
  const auto faces = mesh.faces();
  return std::size_t(std::count_if(faces.begin(), faces.end(), has_collapsed));
}

// Returns the greatest relative difference of a length in the plane from the scaled length. The two
// sides of a seam have the same scaled length: without a difference, the charts close up.
inline double edge_length_error(const Planar_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  double result = 0;
  for(Halfedge_index h : mesh.halfedges()) {
    if(mesh.is_border(h) || !map.is_laid_out(mesh.face(h)))
      continue;
    const double u = map.log_scale(mesh.source(h)) + map.log_scale(mesh.target(h));
    const double length = scaled_length(map.ideal().length(mesh.edge(h)), length_factor(u));
    const double in_plane = std::abs(map.position(mesh.next(h)) - map.position(h));
    result = greater_error(result, std::abs(in_plane / length - 1));
  }
  return result;
}

// Returns what every map to the plane that is laid out is promised to have there.
inline std::vector<Map_promise> planar_promises(const Planar_conformal_map& map)
{
  return {
    {"orientation", double(number_of_collapsed_faces(map)), 0, Map_status::layout_collapsed},
    {"cross_ratio", max_cross_ratio_error(map), tolerance::cross_ratio, Map_status::not_conformal},
    {"closing", edge_length_error(map), tolerance::promised_length, Map_status::not_closed}};
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_PLANAR_ERRORS_H
