// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CROSS_RATIOS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CROSS_RATIOS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/length_cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/spherical_gram_error.h>
#include <CGAL/Intrinsic_triangulations/Decorated_length.h>

#include <algorithm>
#include <array>
#include <cmath>
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

// Returns whether the stored positions of the ends of an edge determine its length.
inline bool has_known_length(Edge_index e, const Spherical_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  const Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
  return v == map.vertex_at_infinity() || w == map.vertex_at_infinity() ||
         has_known_distance(map.stereographic_position(v), map.stereographic_position(w));
}

// Returns the square of the distance of the ends of an edge of T_3 on the sphere.
template <typename FT>
FT squared_length(Edge_index e, const Spherical_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  const Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
  const auto &p = map.stereographic_position(v), &q = map.stereographic_position(w);
  return v == map.vertex_at_infinity()   ? squared_chord_to_infinity<FT>(q)
         : w == map.vertex_at_infinity() ? squared_chord_to_infinity<FT>(p)
                                         : squared_chord_from_plane<FT>(p, q);
}

// Returns the greatest relative error of a Gram coordinate of T_3, measured on the sphere.
template <typename FT>
double max_inversive_distance_error(const Spherical_conformal_map& map)
{
  using Intrinsic_triangulations::internal::with_numbers;
  const Delta_complex& mesh = map.ideal().mesh();
  const auto decorated_length = Intrinsic_triangulations::internal::decorated_lengths(
    map.ideal().traits(), map.ideal().length_map(), mesh);
  double result = 0;
  for(Edge_index e : mesh.edges())
    if(has_known_length(e, map)) {
      const Halfedge_index h = mesh.halfedge(e);
      const auto edge =
        scaled(with_numbers<FT>(decorated_length(h)), FT(map.log_scale(mesh.source(h))),
               FT(map.log_scale(mesh.target(h))));
      result = greater_error(result, spherical_gram_error(edge, squared_length<FT>(e, map)));
    }
  return result;
}

// Returns whether squares of lengths on the sphere can exceed the range of `double`.
inline bool has_wide_lengths(const Spherical_conformal_map& map)
{
  const auto vertices = map.ideal().mesh().vertices();
  return std::any_of(vertices.begin(), vertices.end(), [&](Vertex_index v) {
    return std::abs(map.log_scale(v)) > tolerance::narrow_log_scales;
  });
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsSphere
/// returns the greatest relative error of a length cross ratio of an edge of \f$T_3\f$ of `map`.
/// Ratios of lengths on the sphere are compared with ratios of the ideal polyhedron. Positions have
/// the digits of `Spherical_conformal_map::stereographic_position()`. Edges do not count if these
/// digits do not determine the length of a side of their faces. If there are circles, inversive
/// distances of edges with known lengths are compared instead. The result is infinite if the sphere
/// is not laid out. Complexity: linear.
inline double max_cross_ratio_error(const Spherical_conformal_map& map)
{
  if(!map.is_laid_out())
    return std::numeric_limits<double>::infinity();
  if(map.has_radii())
    return internal::has_wide_lengths(map)
             ? internal::max_inversive_distance_error<internal::Wide_number<double>>(map)
             : internal::max_inversive_distance_error<double>(map);
  const Delta_complex& mesh = map.ideal().mesh();
  std::vector<std::array<Spherical_conformal_map::Double_double, 2>> position;
  for(Vertex_index v : mesh.vertices())
    position.push_back(map.stereographic_position(v));
  const auto is_known = [&](Edge_index e) { return internal::has_known_length(e, map); };
  return internal::max_stereographic_cross_ratio_error(
    mesh, [&](Edge_index e) { return map.ideal().length(e); }, position, map.vertex_at_infinity(),
    is_known);
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CROSS_RATIOS_H
