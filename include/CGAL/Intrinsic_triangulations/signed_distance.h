// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SIGNED_DISTANCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SIGNED_DISTANCE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Default_window_visitor.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Curve_sides.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Exact_distances.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/signed_heat_distance.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns the segments that have a left and a right side.
// \throws Invalid_input if there are only others
template <typename FT>
Surface_curve<FT> segments_with_length(const Surface_curve<FT>& curve)
{
  Surface_curve<FT> result;
  std::copy_if(curve.begin(), curve.end(), std::back_inserter(result),
               [](const Curve_segment<FT>& s) { return s.source != s.target; });
  if(result.empty() && !curve.empty())
    throw Invalid_input("the curve has no length, so it has no left and no right side");
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the signed distance of every vertex to a curve: negative on its left, positive on its
/// right. It is exact if the curve separates the surface and exact distances are cheap. Otherwise
/// the signed heat method approximates it, with an estimate of the error.
///
/// A curve separates a component of the surface if each of its regions is on one side of all
/// segments around it. Loops around regions and lines from boundary to boundary are examples. Exact
/// distances are zero at vertices of the curve. They are cheap as in `geodesic_distances()`. All
/// distances are infinite on components without a segment of positive length.
///
/// By heat, gaps of a curve are bridged, and distances on the curve are zero on average. If the
/// curve does not separate the surface, no signed distance exists. Then the result is only smooth.
///
/// `Signed_heat_distance` is for repeated use. Complexity: as `geodesic_distances()` or this class.
///
/// \param surface a model of `IntrinsicSurface` with floating-point lengths, or an
///   `Intrinsic_triangulation`, on which heat flows in the exact metric if lengths do not determine
///   it (`with_resolved_areas()`). Errors of heat are smaller on Delaunay triangulations
/// \param given_curve segments, with the negative side on their left. Segments without length are
///   ignored
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{distance_method}
///     \cgalParamDescription{how distances are computed}
///     \cgalParamType{`Distance_method`}
///     \cgalParamDefault{`Distance_method::automatic`, or `Distance_method::heat` if
///       `time_step_factor` is given}
///   \cgalParamNEnd
///   \cgalParamNBegin{time_step_factor}
///     \cgalParamDescription{the shorter time for which heat flows, in squared mean edge lengths}
///     \cgalParamType{a number}
///     \cgalParamDefault{0.7, multiplied by 16 until normals reach all faces}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the search for exact distances, and can stop it by an
///       exception}
///     \cgalParamType{a model of `WindowVisitor`; it is copied unless `std::ref()` refers to it}
///     \cgalParamDefault{`Default_window_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_input if exact distances are requested and the curve does not separate a
///   component, or if no segment has a length. The factor must be positive, and at most
///   \f$1.6 \cdot 10^{13}\f$
/// \throws Numerical_error, Underflow_error as `Signed_heat_distance` if heat is used, or
///   `Numerical_error` as `Shortest_paths::run()` if exact distances are requested
template <typename Surface, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Geodesic_distances<Length_of<Surface>>
signed_distance(const Surface& surface, const Surface_curve<Length_of<Surface>>& given_curve,
                const NamedParameters& np = CGAL::parameters::default_values())
{
  using std::abs;
  typedef Length_of<Surface> FT;
  constexpr bool is_time_given =
    internal::has_parameter<NamedParameters, internal_np::time_step_factor_t>();
  Default_window_visitor silent;
  auto&& visitor = internal::visitor_of(np, silent);
  const Distance_method wanted = internal::method_of(np);
  const Surface_curve<FT> curve = internal::segments_with_length(given_curve);
  Distance_sources<Surface> sources(surface);
  sources.add(curve);
  internal::Exact_distances<Surface> exact(surface, sources);
  if(wanted == Distance_method::exact || (wanted == Distance_method::automatic && !is_time_given)) {
    const auto side = internal::Curve_sides<FT>(surface.mesh(), curve)();
    if(!side && wanted == Distance_method::exact)
      throw Invalid_input("the curve does not separate the surface into its left and its right");
    if(auto result = side ? internal::distances_by_windows(exact, wanted, visitor) : std::nullopt) {
      for(std::size_t v = 0; v < side->size(); ++v)
        if((*side)[v] < 0)
          result->distance[v] = -result->distance[v];
      return std::move(*result);
    }
  }
  const auto values_of = [&](const auto& resolved, const auto& time) {
    typedef Length_of<std::decay_t<decltype(resolved)>> Resolved;
    return signed_heat_distance(resolved, converted_curve<Resolved>(curve), time);
  };
  auto result =
    internal::values_by_heat(surface, np, internal::time_step_factor_of_normals(), values_of);
  std::vector<FT> lengths = result.distance;
  for(FT& d : lengths)
    d = abs(d);
  result.error = internal::heat_error(exact, lengths, visitor);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SIGNED_DISTANCE_H
