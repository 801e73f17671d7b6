// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CROSS_RATIOS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CROSS_RATIOS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/length_cross_ratios.h>
#include <CGAL/Intrinsic_triangulations/Decorated_length.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// returns the greatest relative error of a length cross ratio, which measures how conformal a map
/// is (\ref dcm_cross_ratio). The edge \f$ij\f$ of \f$T_3\f$ with faces \f$ijk\f$ and \f$jim\f$ has
/// the ratio \f$\ell_{jk}\ell_{im} / (\ell_{ki}\ell_{mj})\f$. Ratios of lengths in the plane are
/// compared with ratios of the ideal polyhedron. Edges with a face that is not laid out do not
/// count. Edges of crowded faces do not count either, see
/// `Discrete_conformal_map::crowded_faces()`. Complexity: linear.
inline double max_cross_ratio_error(const Planar_conformal_map& map)
{
  return map.picture().max_cross_ratio_error();
}

namespace internal {

// Returns the greatest relative error of a Gram coordinate of T_3, measured on the sphere. It is
// c L^2 / 2 - (c - 1) for a chord of length L between two centers. Here c is the product of both
// 1 / cos R, for scaled radii tan R.
inline double max_inversive_distance_error(const Spherical_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  const auto decorated_length = Intrinsic_triangulations::internal::decorated_lengths(
    map.ideal().traits(), map.ideal().length_map(), mesh);
  double result = 0;
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e);
    const Vertex_index v = mesh.source(h), w = mesh.target(h);
    const auto edge = scaled(decorated_length(h), map.log_scale(v), map.log_scale(w));
    const auto p = map.precise_position(v), q = map.precise_position(w);
    double square = 0;
    for(std::size_t i = 0; i < 3; ++i)
      square += (p[i] - q[i]).high() * (p[i] - q[i]).high();
    const double r = edge.source_radius * edge.source_radius,
                 s = edge.target_radius * edge.target_radius, c = std::sqrt((1 + r) * (1 + s)),
                 gram = c * square / 2 - (r + s + r * s) / (c + 1);
    result = greater_error(result, std::abs(gram / edge.gram() - 1));
  }
  return result;
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsSphere
/// returns the greatest relative error of a length cross ratio of an edge of \f$T_3\f$ of `map`.
/// Ratios of lengths on the sphere are compared with ratios of the ideal polyhedron. Positions have
/// the digits of `Spherical_conformal_map::stereographic_position()`. Edges do not count if these
/// digits do not determine the length of a side of their faces. If there are circles, inversive
/// distances are compared instead. The result is infinite if the sphere is not laid out.
/// Complexity: linear.
inline double max_cross_ratio_error(const Spherical_conformal_map& map)
{
  if(!map.is_laid_out())
    return std::numeric_limits<double>::infinity();
  if(map.has_radii())
    return internal::max_inversive_distance_error(map);
  const Delta_complex& mesh = map.ideal().mesh();
  std::vector<std::array<Spherical_conformal_map::Extended, 2>> position;
  for(Vertex_index v : mesh.vertices())
    position.push_back(map.stereographic_position(v));
  const auto is_known = [&](Edge_index e) {
    const Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    return v == map.vertex_at_infinity() || w == map.vertex_at_infinity() ||
           internal::has_known_distance(position[v.idx()], position[w.idx()]);
  };
  return internal::max_stereographic_cross_ratio_error(
    mesh, [&](Edge_index e) { return map.ideal().length(e); }, position, map.vertex_at_infinity(),
    is_known);
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CROSS_RATIOS_H
