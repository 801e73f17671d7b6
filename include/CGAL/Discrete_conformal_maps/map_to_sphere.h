// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_MAP_TO_SPHERE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_MAP_TO_SPHERE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/map_functions.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>

#include <utility>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsSphere
/// maps a surface of genus zero to the unit sphere, discretely conformally, or a disk to a
/// hemisphere (Section 4.4). A disk without inner vertices becomes a polygon inscribed in the
/// equator, see `Spherical_conformal_map::is_flat()`.
///
/// `Bounded_Newton_minimizer` finds scale factors, at first in `double`. Exact predicates decide
/// whether the result is a convex polyhedron. If not, or if length cross ratios are wrong, it is
/// computed with 106 binary digits. If no minimum has been found, this search starts from a metric
/// that is flat far from the vertex at infinity. If these digits do not suffice, it is computed
/// with 115 decimal digits. Its positions then have 1500 decimal digits. Up to 15 other vertices at
/// infinity are tried next. The best result is returned. `Spherical_conformal_map::status()` is
/// `Map_status::success` only if it is convex and its length cross ratios have errors of at most
/// \f$10^{-8}\f$ (see \ref dcm_status). A map that is not a success may have no positions: see
/// `Spherical_conformal_map::is_laid_out()`. The polygon of a disk without inner vertices needs no
/// minimization. Its positions have 106 binary or 1500 decimal digits. Its status is
/// `Map_status::layout_collapsed` if even these do not distinguish its vertices. The map of a long
/// strip is a success. Positions of type `double` do not distinguish the vertices at its ends,
/// whose faces are `Discrete_conformal_map::crowded_faces()`.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param g a connected manifold triangle mesh, a sphere or a disk; isolated vertices are ignored
/// \param np the parameters of `Intrinsic_triangulations::Intrinsic_triangulation`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_radius_map}
///     \cgalParamDescription{the radii of circles around the vertices, as for `flatten()`; the map
///       is a decorated discrete conformal map, see \ref dcm_spherical_circles}
///     \cgalParamType{a readable property map with a vertex of `g` as key and `double` as value}
///     \cgalParamDefault{there are no circles}
///   \cgalParamNEnd
///   \cgalParamNBegin{concurrency_tag}
///     \cgalParamDescription{whether several threads are used; see \ref dcm_parallel}
///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
///                    `CGAL::Parallel_if_available_tag`}
///     \cgalParamDefault{`CGAL::Sequential_tag`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is notified of the progress; an exception that it throws stops the
///       work}
///     \cgalParamType{a model of `FlatteningVisitor`; it is copied unless
///       `std::ref()` refers to it}
///     \cgalParamDefault{`Default_flattening_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: a few sparse Cholesky factorizations for each step of the minimization, plus \f$O(n
/// \log n)\f$ in the vertices, flips and crossings.
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not a valid input, or neither a sphere
///   nor a disk. Other reasons are circles that meet, and a disk with circles but without a vertex
///   inside
/// \throws Intrinsic_triangulations::Numerical_error if \f$T_2\f$ cannot be computed
/// \throws Intrinsic_triangulations::Overflow_error if integers have too few digits
/// \throws Intrinsic_triangulations::Flip_limit_exceeded if rounding prevents flips from
///   terminating
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Spherical_conformal_map
map_to_sphere(const Graph& g, const NamedParameters& np = CGAL::parameters::default_values())
{
  Default_flattening_visitor silent;
  auto&& visitor = Intrinsic_triangulations::internal::visitor_of(np, silent);
  Intrinsic_triangulations::Intrinsic_triangulation<> input(g, np);
  const internal::Map_parameters parameters =
    internal::map_parameters(g, input.mesh(), np, Vertex_condition());
  return internal::mapped_to_sphere(std::move(input), parameters,
                                    internal::Any_visitor::of(visitor));
}

} // namespace CGAL::Discrete_conformal_maps

// The compiled library contains the definitions of these headers.
#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Discrete_conformal_maps/internal/maps/Sphere_mapping.h>
#endif

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_MAP_TO_SPHERE_H
