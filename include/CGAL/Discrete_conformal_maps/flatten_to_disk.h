// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_DISK_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_DISK_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/map_functions.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>

#include <utility>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// maps every component of a surface to a disk, discretely conformally: its boundary vertices lie
/// on a circle.
///
/// The exterior angles of a polygon in a circle depend on the lengths of its edges, which depend on
/// the angles. So the surface is flattened in rounds. Each round takes its angles from the lengths
/// of the previous round, until angles change by at most \f$10^{-10}\f$. Anderson's method
/// \cgalCite{And65} accelerates the rounds. The `minimization()` of the result is the last one. If
/// scale factors are far apart, the search starts from `map_to_sphere()`; a disk without inner
/// vertices then needs no search. If no edge of \f$T_2\f$ and \f$T_3\f$ crosses the boundary, both
/// images of a disk without cones agree up to a Moebius transformation.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param g a manifold triangle mesh whose components have one boundary loop each; isolated
///   vertices are allowed
/// \param np the parameters of `flatten()`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_condition_map}
///     \cgalParamDescription{the condition at each inner vertex}
///     \cgalParamType{a readable property map with a vertex of `g` as key and `Vertex_condition` as
///       value}
///     \cgalParamDefault{curvature zero}
///   \cgalParamNEnd
///   \cgalParamNBegin{cones}
///     \cgalParamDescription{as for `flatten()`; no boundary vertex becomes a cone}
///     \cgalParamType{`Cones`}
///     \cgalParamDefault{`Cones::automatic`: yes if there is a `maximum_log_scale` or
///       `maximum_area_distortion`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the greatest number of rounds}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: usually about ten times the complexity of `flatten()`.
/// \returns a map with one of the statuses of `flatten()`, or `Map_status::not_circular` if the
///   boundary is not a circle after the last round. If a minimization fails, its map is returned
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not such a mesh, or as `flatten()`
///   does: a component with handles has no disk without cones inside. It is also thrown if there
///   are circles at the vertices
/// \throws Intrinsic_triangulations::Numerical_error, Intrinsic_triangulations::Overflow_error,
///   Intrinsic_triangulations::Flip_limit_exceeded as `flatten()` does
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Planar_conformal_map flatten_to_disk(const Graph& g,
                                     const NamedParameters& np = CGAL::parameters::default_values())
{
  Intrinsic_triangulations::Intrinsic_triangulation<> input(g, np);
  internal::Map_parameters parameters =
    internal::map_parameters(g, input.mesh(), np, Vertex_condition());
  return internal::flattened_to<internal::Circular_boundary>(std::move(input),
                                                             std::move(parameters), np);
}

} // namespace CGAL::Discrete_conformal_maps

// The compiled library contains the definitions of these headers.
#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Discrete_conformal_maps/internal/maps/Repeated_flattening.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Circular_boundary.h>
#endif

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_TO_DISK_H
