// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/map_functions.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>

#include <utility>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// maps a surface to the plane, discretely conformally (Section 4.3).
///
/// The faces of the result are flat. Its cones are the vertices with a curvature that is not zero.
/// A torus without conditions has no cones. Closed surfaces of other genus need cones, which are
/// prescribed or placed greedily.
///
/// `Planar_conformal_map::status()` is the outcome, measured on the result (see \ref dcm_status). A
/// map that is not a success has the best scale factors found, and a layout if one exists.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param g a manifold triangle mesh of any genus, with or without boundary, with any number of
///   components
/// \param np the parameters of `Intrinsic_triangulations::Intrinsic_triangulation`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_condition_map}
///     \cgalParamDescription{the condition at each vertex}
///     \cgalParamType{a readable property map with a vertex of `g` as key and `Vertex_condition` as
///       value}
///     \cgalParamDefault{curvature zero inside, a logarithmic scale factor of zero on the boundary}
///   \cgalParamNEnd
///   \cgalParamNBegin{cones}
///     \cgalParamDescription{whether cones without scaling are placed inside. A vertex with a
///                           prescribed exterior angle, or a prescribed curvature other than zero,
///                           does not become a cone}
///     \cgalParamType{`Cones`}
///     \cgalParamDefault{`Cones::automatic`: yes if there is no `vertex_condition_map`, or a
///                       `maximum_log_scale` or `maximum_area_distortion`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_log_scale}
///     \cgalParamDescription{the greatest absolute value of logarithmic scale factors inside. Cones
///       are placed until all are within this bound}
///     \cgalParamType{`double`}
///     \cgalParamDefault{5}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_area_distortion}
///     \cgalParamDescription{the same bound as a ratio of areas: the factor by which areas around
///       vertices inside may grow or shrink. A logarithmic scale factor \f$u\f$ changes areas by
///       \f$e^{2u}\f$. With `maximum_log_scale`, the stricter bound counts}
///     \cgalParamType{`double`, greater than 1}
///     \cgalParamDefault{no bound beside `maximum_log_scale`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_radius_map}
///     \cgalParamDescription{the radii of circles around the vertices; the map is a decorated
///       discrete conformal map, see \ref dcm_circles. Circles of neighbors in the weighted
///       Delaunay triangulation must not meet. Two circles of positive radius may touch,
///       and overlap by \f$10^{-8}\f$ of the distance of their centers. If all radii are zero,
///       there are no circles}
///     \cgalParamType{a readable property map with a vertex of `g` as key and `double` as value}
///     \cgalParamDefault{there are no circles}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimizer}
///     \cgalParamDescription{the minimizer of the energy}
///     \cgalParamType{a model of `ConvexMinimizer`}
///     \cgalParamDefault{`Newton_minimizer`}
///   \cgalParamNEnd
///   \cgalParamNBegin{initial_log_scale_map}
///     \cgalParamDescription{the start of the minimization; a start close to the result saves
///       steps. If no map is found from it, the minimization starts again from zero}
///     \cgalParamType{a readable property map with a vertex of `g` as key and `double` as value}
///     \cgalParamDefault{zero everywhere}
///   \cgalParamNEnd
///   \cgalParamNBegin{flipping}
///     \cgalParamDescription{whether triangulations follow the scale factors. Scale factors in a
///       fixed triangulation \cgalCite{SSP08} depend on the triangulation of the surface. They
///       exist only sometimes, see `Planar_conformal_map::status()`}
///     \cgalParamType{`Flipping`}
///     \cgalParamDefault{`Flipping::to_Delaunay`}
///   \cgalParamNEnd
///   \cgalParamNBegin{exact_decisions}
///     \cgalParamDescription{whether the flips to \f$T_2\f$, the intrinsic Delaunay triangulation,
///       are decided exactly on the surface of the positions. Its lengths and curvatures then have
///       32 digits; see \ref dcm_exact and \ref dcm_needles}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{layout}
///     \cgalParamDescription{the method that lays out flat faces}
///     \cgalParamType{`Layout`}
///     \cgalParamDefault{`Layout::least_squares`}
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
/// \throws Intrinsic_triangulations::Invalid_input if `g` is not a valid input, or a prescription
///   is impossible. The error names the element, and for curvatures the excess. Other reasons are
///   circles that meet, exact decisions with circles, and a `maximum_area_distortion` of at most 1
/// \throws Intrinsic_triangulations::Numerical_error if \f$T_2\f$ cannot be computed
/// \throws Intrinsic_triangulations::Overflow_error if integers have too few digits
/// \throws Intrinsic_triangulations::Flip_limit_exceeded if rounding prevents flips from
///   terminating
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Planar_conformal_map flatten(const Graph& g,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool is_free =
    CGAL::parameters::is_default_parameter<NamedParameters,
                                           internal_np::vertex_condition_map_t>::value;
  Intrinsic_triangulations::Intrinsic_triangulation<> input(g, np);
  internal::Map_parameters parameters =
    internal::map_parameters(g, input.mesh(), np, Vertex_condition::log_scale(0));
  parameters.cones = internal::cone_choice(is_free, np);
  return internal::flattened_to<internal::Free_shape>(std::move(input), std::move(parameters), np);
}

} // namespace CGAL::Discrete_conformal_maps

// The compiled library contains the definitions of these headers.
#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Discrete_conformal_maps/internal/maps/Repeated_flattening.h>
#include <CGAL/Discrete_conformal_maps/internal/shapes/Free_shape.h>
#endif

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_H
