// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Default_window_visitor.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Heat_error.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Precise_surface.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Exact_distances.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Straight_distances.h>
#include <CGAL/Intrinsic_triangulations/internal/input/copy_properties.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators
/// names how `geodesic_distances()` computes distances.
enum class Distance_method
{
  automatic, ///< exact if at most \f$2^{23}\f$ windows are expected, otherwise heat
  exact,     ///< as `Shortest_paths`, accurate to rounding
  heat       ///< as `heat_distance()`, with an estimate of the error
};

/// \ingroup PkgIntrinsicTriangulationsOperators
/// distances of all vertices, and how they were computed.
template <typename FT>
struct Geodesic_distances
{
  std::vector<FT> distance; ///< by the index of the vertex; infinite if no source can reach it
  Distance_method method;   ///< the method that was used, exact or heat

  /// \name With Heat
  /// @{
  FT time_step_factor = FT(0);                        ///< the time for which heat flowed
  std::optional<Heat_error<FT>> error = std::nullopt; ///< the estimate; none on a
                                                      ///< `Tufted_surface`
  std::size_t number_of_raised_vertices = 0; ///< how many values were below a bound and raised to
                                             ///< it: the distance in space if positions are known,
                                             ///< otherwise zero
  /// @}
};

namespace internal {

// The expected number takes about two seconds, at four million windows per second. Exact distances
// that need four times as many are abandoned.
constexpr std::size_t most_expected_windows() { return std::size_t(1) << 23; }
constexpr std::size_t most_windows() { return 4 * most_expected_windows(); }
// This number of windows is allowed for an estimate of errors.
constexpr std::size_t most_compared_windows() { return most_expected_windows() / 2; }

// Determines whether vertices have one vertex fan. Vertices with several fans have no exact
// distances.
template <typename Surface>
struct Has_one_fan : std::true_type
{};
template <typename FT>
struct Has_one_fan<Tufted_surface<FT>> : std::false_type
{};

template <typename NamedParameters>
Distance_method method_of(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, internal_np::distance_method), Distance_method::automatic);
}

template <typename FT>
using Positions = std::vector<std::array<FT, 3>>;

// Returns the positions of vertices if the named parameters have a map.
template <typename Surface, typename NamedParameters>
Positions<Length_of<Surface>> positions_of(const Surface& surface, const NamedParameters& np)
{
  Positions<Length_of<Surface>> result;
  if constexpr(has_parameter<NamedParameters, CGAL::internal_np::vertex_point_t>()) {
    const auto point = CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point);
    for(const Vertex_index v : surface.mesh().vertices())
      result.push_back(position_of<Length_of<Surface>>(get(point, v)));
  }
  return result;
}

// Returns the positions of vertices, unless lengths replace them.
template <typename Mesh, typename NamedParameters>
Positions<double> positions_in(const Mesh& mesh, const NamedParameters& np)
{
  Positions<double> result;
  if constexpr(!has_parameter<NamedParameters, internal_np::edge_length_map_t>() &&
               !has_parameter<NamedParameters, internal_np::squared_edge_length_map_t>()) {
    const auto point = vertex_points(mesh, np);
    for(const auto v : vertices(mesh))
      result.push_back(position_of<double>(get(point, v)));
  }
  return result;
}

// Raises values below the distance in space, and nonpositive values away from the sources.
template <typename Surface>
void raise_to_bounds(const Surface& surface, const Distance_sources<Surface>& sources,
                     const Positions<Length_of<Surface>>& positions,
                     Geodesic_distances<Length_of<Surface>>& result)
{
  typedef Length_of<Surface> FT;
  const std::vector<char> is_source = Access_to_sources::is_source(sources);
  std::optional<Straight_distances<FT>> straight;
  if(!positions.empty())
    straight.emplace(surface, sources, positions);
  for(const Vertex_index v : surface.mesh().vertices()) {
    if(is_source[v.idx()])
      continue;
    FT& d = result.distance[v.idx()];
    const FT least = straight ? (*straight)(positions[v.idx()]) : FT(0);
    if(d < least * (1 - path_tolerance<FT>()) || !(d > 0)) {
      d = least;
      ++result.number_of_raised_vertices;
    }
  }
}

// Returns the numbers `values_of(resolved)` at vertices, rounded to the number type of `surface`.
// `resolved` has more digits on a triangulation whose lengths do not determine all areas.
template <typename Surface, typename Values_of>
std::vector<Length_of<Surface>> resolved_values(const Surface& surface, const Values_of& values_of)
{
  typedef Length_of<Surface> FT;
  return with_resolved_areas(surface, [&](const auto& resolved) {
    const auto values = values_of(resolved);
    if constexpr(std::is_same_v<std::decay_t<decltype(values[0])>, FT>)
      return std::vector<FT>(values.begin(), values.end());
    else {
      const auto rounded = rounded_values(values);
      return std::vector<FT>(rounded.begin(), rounded.end());
    }
  });
}

// Returns the numbers `values_of(resolved, time)` at vertices, where `time` is a named parameter.
// Unless a time is given, the standard time is increased until heat reaches all vertices. It is too
// short if some edges are far shorter than others.
template <typename Surface, typename NamedParameters, typename Values_of>
Geodesic_distances<Length_of<Surface>>
values_by_heat(const Surface& surface, const NamedParameters& np, double standard_factor,
               const Values_of& values_of)
{
  typedef Length_of<Surface> FT;
  constexpr bool is_time_given = has_parameter<NamedParameters, internal_np::time_step_factor_t>();
  Geodesic_distances<FT> result{
    {}, Distance_method::heat, checked_time_step_factor<FT>(np, standard_factor)};
  for(;; result.time_step_factor *= 16)
    try {
      const auto time = parameters::time_step_factor(result.time_step_factor);
      result.distance =
        resolved_values(surface, [&](const auto& resolved) { return values_of(resolved, time); });
      return result;
    } catch(const Underflow_error&) {
      if(is_time_given || result.time_step_factor > FT(greatest_time_step_factor()))
        throw;
    }
}

template <typename Surface, typename NamedParameters>
Geodesic_distances<Length_of<Surface>>
distances_by_heat(const Surface& surface, const Distance_sources<Surface>& sources,
                  const Positions<Length_of<Surface>>& positions, const NamedParameters& np)
{
  auto result = values_by_heat(surface, np, 1, [&](const auto& resolved, const auto& time) {
    return heat_distance(resolved, sources, time);
  });
  raise_to_bounds(surface, sources, positions, result);
  return result;
}

// Returns distances `f(surface, sources)`.
template <typename Surface, typename Function>
Geodesic_distances<Length_of<Surface>>
least_distances(const Surface& surface, const Distance_sources<Surface>& sources, const Function& f)
{
  return f(surface, sources);
}

// Computes exact distances from vertices on T1 too if lengths of T2 do not determine its areas.
// Rounded directions can miss a path on either triangulation. So the lesser distances are taken.
template <typename Traits, typename Function>
Geodesic_distances<typename Traits::FT>
least_distances(const Intrinsic_triangulation<Traits>& tri,
                const Distance_sources<Intrinsic_triangulation<Traits>>& sources, const Function& f)
{
  auto result = f(tri, sources);
  if(result.method != Distance_method::exact || tri.number_of_inserted_vertices() > 0 ||
     !Access_to_sources::curve(sources).empty() || !has_unresolved_areas(tri.intrinsic()))
    return result;
  const auto input = tri.input();
  Distance_sources<std::decay_t<decltype(input)>> on_input(input);
  on_input.add(Access_to_sources::vertices(sources));
  const auto other = f(input, on_input);
  if(other.method == Distance_method::exact)
    for(std::size_t v = 0; v < result.distance.size(); ++v)
      result.distance[v] = (std::min)(result.distance[v], other.distance[v]);
  return result;
}

// Returns nothing if heat is to be used. `exact` then contains the distances found so far.
template <typename Surface, typename Visitor>
std::optional<Geodesic_distances<Length_of<Surface>>>
distances_by_windows(Exact_distances<Surface>& exact, Distance_method method, Visitor& visitor)
{
  const bool is_exact_wanted = method == Distance_method::exact;
  if(!is_exact_wanted && (method == Distance_method::heat ||
                          exact.expected_windows() > double(most_expected_windows())))
    return std::nullopt;
  if(!exact.run(is_exact_wanted ? (std::numeric_limits<std::size_t>::max)() : most_windows(),
                visitor))
    return std::nullopt;
  return Geodesic_distances<Length_of<Surface>>{exact.distances(), Distance_method::exact};
}

template <typename Surface, typename Distances, typename Visitor>
Heat_error<Length_of<Surface>> heat_error(Exact_distances<Surface>& exact,
                                          const Distances& distance, Visitor& visitor)
{
  if(!exact.has_run())
    exact.run(most_compared_windows(), visitor);
  return {distance, exact.distances(), exact.final_length()};
}

// Adds the sources of T1 as sources on T2.
template <typename Traits, typename Input, typename Surface>
void add_sources_across(const Intrinsic_triangulation<Traits>& tri,
                        const Distance_sources<Input>& sources, Distance_sources<Surface>& across)
{
  typedef typename Traits::FT FT;
  across.add(Access_to_sources::vertices(sources));
  if(Access_to_sources::curve(sources).empty())
    return;
  const Correspondence<Traits> correspondence(tri);
  Surface_curve<FT> curve;
  for(const Curve_segment<FT>& s : Access_to_sources::curve(sources))
    if(s.source == s.target)
      across.add(point_across(correspondence, Side::input, Face_location<FT>(s.face, s.source)));
    else
      curve.push_back(s);
  across.add(curve_across(correspondence, Side::input, curve));
}

template <typename T, typename = void>
struct Is_surface : std::false_type
{};
template <typename T>
struct Is_surface<T, std::void_t<Length_map_of<T>>> : std::true_type
{};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the geodesic distance of every vertex to the nearest source: exactly if that is cheap,
/// otherwise by heat, with an estimate of the error.
///
/// By default distances are exact, that is accurate to rounding, if they are expected to take no
/// more than \f$2^{23}\f$ windows. On a surface with \f$n\f$ vertices and \f$k\f$ sources,
/// \f$n/2 \sqrt{n / k}\f$ windows are expected, so heat begins at 65,000 vertices with one source.
/// A search that takes four times as many windows ends, and heat replaces it. The method does not
/// depend on the machine.
///
/// With heat, the estimate of the error compares distances with exact ones at the vertices nearest
/// to the sources. These are all vertices that \f$2^{22}\f$ windows reach. Values below the
/// distance in space, and values away from the sources that are not positive, are raised and
/// counted.
///
/// `Shortest_paths` and `Heat_distance` are for repeated use. Complexity: proportional to the
/// number of windows for exact distances, and one factorization for heat.
///
/// \param surface a model of `IntrinsicSurface` with floating-point lengths, an
///   `Intrinsic_triangulation`, or a `Tufted_surface`, which has heat alone. Lengths of an
///   `Intrinsic_triangulation` may not determine its areas (`has_unresolved_areas()`). Then heat
///   flows in the exact metric. Exact distances from vertices are then the lesser ones on
///   \f$T_1\f$ and \f$T_2\f$, unless vertices have been inserted
/// \param sources a vertex, an `Edge_point`, a `Face_location`, a `Surface_point`, a
///   `Curve_segment`, a range of one of these, such as a `Surface_curve`, or `Distance_sources`
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{distance_method}
///     \cgalParamDescription{how distances are computed}
///     \cgalParamType{`Distance_method`}
///     \cgalParamDefault{`Distance_method::automatic`}
///   \cgalParamNEnd
///   \cgalParamNBegin{time_step_factor}
///     \cgalParamDescription{the time for which heat flows, in squared mean edge lengths}
///     \cgalParamType{a number}
///     \cgalParamDefault{1, multiplied by 16 until heat reaches everything}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{positions of the vertices in space, which bound distances by heat}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the search for exact distances, and can stop it by an
///       exception}
///     \cgalParamType{a model of `WindowVisitor`; it is copied unless `std::ref()` refers to it}
///     \cgalParamDefault{`Default_window_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_input if exact distances of a `Tufted_surface` are requested, or the factor is
///   not positive and finite
/// \throws Numerical_error as `heat_distance()` if heat is used, or as `Shortest_paths::run()` if
///   exact distances are requested
/// \throws Underflow_error if heat underflows and `time_step_factor` is given, or would exceed
///   \f$10^{12}\f$
template <typename Surface, typename Sources,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto geodesic_distances(const Surface& surface, const Sources& sources,
                        const NamedParameters& np = CGAL::parameters::default_values())
  -> std::enable_if_t<internal::Is_surface<Surface>::value, Geodesic_distances<Length_of<Surface>>>
{
  Distance_sources<Surface> all(surface);
  all.add(sources);
  if constexpr(internal::Has_one_fan<Surface>::value) {
    Default_window_visitor silent;
    auto&& visitor = internal::visitor_of(np, silent);
    return internal::least_distances(surface, all, [&](const auto& where, const auto& on_it) {
      internal::Exact_distances<std::decay_t<decltype(where)>> exact(where, on_it);
      if(auto result = internal::distances_by_windows(exact, internal::method_of(np), visitor))
        return std::move(*result);
      auto result =
        internal::distances_by_heat(surface, all, internal::positions_of(surface, np), np);
      result.error = internal::heat_error(exact, result.distance, visitor);
      return result;
    });
  } else {
    if(internal::method_of(np) == Distance_method::exact)
      throw Invalid_input(
        "exact distances need a surface, in which every vertex has one vertex fan");
    return internal::distances_by_heat(surface, all, internal::positions_of(surface, np), np);
  }
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// compares distances of all vertices, however they were computed, with exact distances at the
/// vertices nearest to the sources, as `geodesic_distances()` does with heat.
/// \tparam Distances a vector of Eigen or of the standard library with numbers of the type of the
///         lengths
/// \param surface a model of `IntrinsicSurface` with floating point lengths
/// \param sources as for `geodesic_distances()`
/// \param distance the distances by the index of the vertex, such as the result of
///        `Heat_distance::distances()`
///
/// Complexity: an exact search of at most \f$2^{22}\f$ windows, see `Shortest_paths`.
template <typename Surface, typename Sources, typename Distances = std::vector<Length_of<Surface>>>
Heat_error<Length_of<Surface>> estimate_error(const Surface& surface, const Sources& sources,
                                              const Distances& distance)
{
  Distance_sources<Surface> all(surface);
  all.add(sources);
  internal::Exact_distances<Surface> exact(surface, all);
  Default_window_visitor silent;
  return internal::heat_error(exact, distance, silent);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the geodesic distance of every vertex of a mesh to the nearest source, like the
/// function for surfaces. It is exact on the mesh itself, or by heat on its intrinsic Delaunay
/// triangulation. Vertices, edges and faces have the indices of their order in the ranges of the
/// mesh.
/// \param mesh a model of `FaceListGraph` and `HalfedgeListGraph` with triangles
/// \param sources as for a surface
/// \param np as for a surface, and for `Intrinsic_triangulation`
/// \throws Invalid_input as `Intrinsic_triangulation` and as for a surface
/// \throws Numerical_error, Underflow_error as for a surface
/// \throws Flip_limit_exceeded, Numerical_error, Overflow_error as `make_Delaunay()`, and
///   `Correspondence` for sources that are no vertices, if heat is used
///
/// Complexity: linear in the size of the mesh, and the complexity of the function for surfaces.
template <typename Mesh, typename Sources,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto geodesic_distances(const Mesh& mesh, const Sources& sources,
                        const NamedParameters& np = CGAL::parameters::default_values())
  -> std::enable_if_t<!internal::Is_surface<Mesh>::value, Geodesic_distances<double>>
{
  Default_window_visitor silent;
  auto&& visitor = internal::visitor_of(np, silent);
  Intrinsic_triangulation<> tri(mesh, np);
  const auto input = tri.input();
  Distance_sources<std::decay_t<decltype(input)>> all(input);
  all.add(sources);
  internal::Exact_distances<std::decay_t<decltype(input)>> exact(input, all);
  if(auto result = internal::distances_by_windows(exact, internal::method_of(np), visitor))
    return std::move(*result);
  make_Delaunay(tri);
  Distance_sources<Intrinsic_triangulation<>> across(tri);
  internal::add_sources_across(tri, all, across);
  auto result = internal::distances_by_heat(tri, across, internal::positions_in(mesh, np), np);
  result.error = internal::heat_error(exact, result.distance, visitor);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_DISTANCES_H
