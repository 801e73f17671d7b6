// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_NAMED_PARAMETERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_NAMED_PARAMETERS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

#ifndef DOXYGEN_RUNNING

namespace internal_np {
using namespace CGAL::internal_np;
typedef CGAL::internal_np::vertex_point_t vertex_point_map_t;
typedef CGAL::internal_np::edge_is_constrained_t edge_is_constrained_map_t;
} // namespace internal_np

#define CGAL_NAMED_PARAMETERS                                                                      \
<CGAL/Intrinsic_triangulations/internal/input/list_of_named_parameters.h>
#include <CGAL/Intrinsic_triangulations/internal/input/define_named_parameters.h>

#else

namespace parameters {

/// \ingroup PkgIntrinsicTriangulationsRef
/// names a readable property map from the edges of the input to their lengths; it replaces vertex
/// positions.
template <typename Map>
auto edge_length_map(const Map& map);

/// \ingroup PkgIntrinsicTriangulationsRef
/// names a readable property map from the edges of the input to their squared lengths, which exact
/// traits take as exact numbers. It replaces vertex positions.
template <typename Map>
auto squared_edge_length_map(const Map& map);

/// \ingroup PkgIntrinsicTriangulationsRef
/// names the slack that `mollify()` gives to all triangle inequalities of the input, relative to
/// the mean edge length.
template <typename Number>
auto mollification(const Number& epsilon);

/// \ingroup PkgIntrinsicTriangulationsRef
/// names a `value` of type `bool`: whether all decisions about Delaunay edges are exact.
auto exact_decisions(bool value);

/// \ingroup PkgIntrinsicTriangulationsRef
/// names by `tag` whether several threads are used: `CGAL::Sequential_tag`, which is the default
/// everywhere, `CGAL::Parallel_tag`, or `CGAL::Parallel_if_available_tag`. Results are bitwise the
/// same with each of them, and with any number of threads.
template <typename ConcurrencyTag>
auto concurrency_tag(const ConcurrencyTag& tag);

/// \ingroup PkgIntrinsicTriangulationsOperators
/// names the time for which heat flows: `factor` squared mean edge lengths of the component. A
/// shorter time follows the surface more closely; a longer time gives smoother distances.
template <typename Number>
auto time_step_factor(const Number& factor);

/// \ingroup PkgIntrinsicTriangulationsOperators
/// names the `Distance_method` of `geodesic_distances()`.
auto distance_method(Distance_method method);

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// names the least angle of faces, in degrees.
template <typename Number>
auto minimum_angle(const Number& value);

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// names the greatest circumradius of faces.
template <typename Number>
auto maximum_circumradius(const Number& value);

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// names a `value` of type `bool`: whether the triangulation becomes simplicial.
auto simplicial(bool value);

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// names a function that determines whether a face of \f$T_2\f$ is refined.
template <typename Predicate>
auto face_predicate(const Predicate& value);

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// names the number of vertices that may be inserted.
template <typename Number>
auto maximum_number_of_insertions(const Number& value);

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// names a readable property map from the vertices of the input, as `Vertex_index`, to points.
template <typename Map>
auto input_point_map(const Map& map);

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// names a writable property map for the vertices that the vertices of a subdivision copy.
template <typename Map>
auto parent_vertex_map(const Map& map);

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// names a writable property map for the edges that contain the edges of a subdivision.
template <typename Map>
auto parent_edge_map(const Map& map);

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// names a writable property map for the faces that contain the faces of a subdivision.
template <typename Map>
auto parent_face_map(const Map& map);

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// names the curvature, in radians, up to which vertices count as flat.
template <typename Number>
auto curvature_tolerance(const Number& value);

} // namespace parameters

#endif // DOXYGEN_RUNNING

namespace internal {

// Returns whether named parameters have a value for `Tag`.
template <typename NamedParameters, typename Tag>
constexpr bool has_parameter()
{
  return !CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value;
}

// Returns the positions of vertices of `g`, from the named parameter or from `g` itself.
template <typename Graph, typename NamedParameters>
auto vertex_points(const Graph& g, const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
    get_const_property_map(CGAL::vertex_point, g));
}

// Returns the visitor of named parameters: a reference to the argument of `std::ref()`, or else a
// copy, whose functions need not be constant. Without a visitor, returns `silent`.
template <typename NamedParameters, typename Visitor>
decltype(auto) visitor_of(const NamedParameters& np, Visitor& silent)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter_reference;
  using Reference =
    decltype(choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), silent));
  if constexpr(std::is_const_v<std::remove_reference_t<Reference>>)
    return std::decay_t<Reference>(
      choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), silent));
  else
    return choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), silent);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_NAMED_PARAMETERS_H
