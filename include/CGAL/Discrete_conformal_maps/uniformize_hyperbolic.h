// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_UNIFORMIZE_HYPERBOLIC_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_UNIFORMIZE_HYPERBOLIC_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/Hyperbolic_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/map_functions.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// gives a surface the discretely conformal metric of curvature -1, and maps it to the hyperbolic
/// plane.
///
/// Every component must allow such a metric: a surface without boundary and cones needs a genus of
/// two or more. A component with boundary is doubled; its boundary is a geodesic, unless exterior
/// angles are prescribed.
///
/// `Hyperbolic_conformal_map::status()` is the outcome, measured on the result (see \ref
/// dcm_status). A map that is not a success has the best scale factors found, and a layout if
/// `Hyperbolic_conformal_map::is_laid_out()`.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param g a manifold triangle mesh, with any number of components
/// \param np the parameters of `Intrinsic_triangulations::Intrinsic_triangulation`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_condition_map}
///     \cgalParamDescription{the condition at each vertex: a curvature, \f$2\pi\f$ minus the angle
///       of a cone, or a logarithmic scale factor}
///     \cgalParamType{a readable property map with a vertex of `g` as key and `Vertex_condition` as
///       value}
///     \cgalParamDefault{curvature zero everywhere}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_radius_map}
///     \cgalParamDescription{the radii of circles around the vertices, as for `flatten()`; the map
///       is a decorated discrete conformal map, see \ref dcm_circles}
///     \cgalParamType{a readable property map with a vertex of `g` as key and `double` as value}
///     \cgalParamDefault{there are no circles}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimizer}
///     \cgalParamDescription{the minimizer of the energy}
///     \cgalParamType{a model of `ConvexMinimizer`}
///     \cgalParamDefault{`Newton_minimizer`}
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
/// Complexity: a sparse Cholesky factorization for each step of the minimization, plus \f$O(n \log
/// n)\f$ in the vertices and crossings.
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not a valid input, or a component
///   cannot be hyperbolic with these conditions. Another reason is circles that meet
/// \throws Intrinsic_triangulations::Numerical_error if \f$T_2\f$ cannot be computed
/// \throws Intrinsic_triangulations::Overflow_error if integers have too few digits
/// \throws Intrinsic_triangulations::Flip_limit_exceeded if rounding prevents flips from
///   terminating
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Hyperbolic_conformal_map
uniformize_hyperbolic(const Graph& g,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  Default_flattening_visitor silent;
  auto&& visitor = Intrinsic_triangulations::internal::visitor_of(np, silent);
  const Intrinsic_triangulations::Intrinsic_triangulation<> input(g, np);
  return internal::uniformized(
    input, internal::map_parameters(g, input.mesh(), np, Vertex_condition::curvature(0)),
    internal::Any_visitor::of(visitor));
}

} // namespace CGAL::Discrete_conformal_maps

// The compiled library contains the definitions of these headers.
#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Discrete_conformal_maps/internal/maps/Hyperbolic_uniformization.h>
#endif

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_UNIFORMIZE_HYPERBOLIC_H
