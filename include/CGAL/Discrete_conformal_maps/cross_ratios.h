// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CROSS_RATIOS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CROSS_RATIOS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/length_cross_ratios.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// returns how far a map is from being discretely conformal: the greatest relative error of a
/// length cross ratio \f$\ell_{jk}\ell_{im} / (\ell_{ki}\ell_{mj})\f$ of an edge \f$ij\f$ of
/// \f$T^C\f$ with faces
/// \f$ijk\f$ and \f$jim\f$, between the lengths in the plane and those of the ideal polyhedron,
/// which the scale factors do not change. Edges with a face that is not laid out do not count.
/// Complexity: linear.
inline double max_cross_ratio_error(const Planar_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  const auto in_plane = [&](Halfedge_index h) {
    return std::abs(map.position(mesh.next(h)) - map.position(h));
  };
  const auto ideal = [&](Halfedge_index h) { return map.ideal().length(mesh.edge(h)); };
  const auto counts = [&](Halfedge_index h) {
    return map.is_laid_out(mesh.face(h)) && map.is_laid_out(mesh.face(mesh.opposite(h)));
  };
  return internal::greatest_cross_ratio_error(mesh, counts, in_plane, ideal);
}

/// \ingroup PkgDiscreteConformalMapsSphere
/// returns the greatest relative error of a length cross ratio of an edge of \f$T^C\f$, between the
/// lengths on the sphere and those of the ideal polyhedron. Positions have all digits that the map
/// knows. Complexity: linear.
inline double max_cross_ratio_error(const Spherical_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  std::vector<std::array<Spherical_conformal_map::Extended, 2>> position;
  for(Vertex_index v : mesh.vertices())
    position.push_back(map.stereographic_position(v));
  return internal::max_stereographic_cross_ratio_error(
    mesh, [&](Edge_index e) { return map.ideal().length(e); }, position, map.vertex_at_infinity());
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CROSS_RATIOS_H
