// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_NAMED_PARAMETERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_NAMED_PARAMETERS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal_np {
enum edge_length_map_t
{
  edge_length_map
};
enum time_step_factor_t
{
  time_step_factor
};
enum minimum_angle_t
{
  minimum_angle
};
enum maximum_circumradius_t
{
  maximum_circumradius
};
enum face_predicate_t
{
  face_predicate
};
enum maximum_number_of_insertions_t
{
  maximum_number_of_insertions
};
} // namespace internal_np

namespace parameters {

/// \ingroup PkgIntrinsicTriangulationsRef
/// names a readable property map from the edges of the input to their lengths; it takes the place
/// of vertex positions.
template <typename Map>
auto edge_length_map(const Map& map)
{
  return CGAL::Named_function_parameters<Map, internal_np::edge_length_map_t>(map);
}

/// \ingroup PkgIntrinsicTriangulationsRef
/// the same, after the parameters `np`.
template <typename Map, typename NamedParameters>
auto edge_length_map(const Map& map, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Map, internal_np::edge_length_map_t, NamedParameters>(map,
                                                                                               np);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// names the time for which heat flows, in squared mean edge lengths of the component. Less follows
/// the surface more closely, more is smoother.
template <typename Number>
auto time_step_factor(const Number& factor)
{
  return CGAL::Named_function_parameters<Number, internal_np::time_step_factor_t>(factor);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// the same, after the parameters `np`.
template <typename Number, typename NamedParameters>
auto time_step_factor(const Number& factor, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Number, internal_np::time_step_factor_t, NamedParameters>(
    factor, np);
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// names the least angle that faces shall have, in degrees.
template <typename Number>
auto minimum_angle(const Number& value)
{
  return CGAL::Named_function_parameters<Number, internal_np::minimum_angle_t>(value);
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// the same, after the parameters `np`.
template <typename Number, typename NamedParameters>
auto minimum_angle(const Number& value, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Number, internal_np::minimum_angle_t, NamedParameters>(
    value, np);
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// names the greatest circumradius that faces shall have.
template <typename Number>
auto maximum_circumradius(const Number& value)
{
  return CGAL::Named_function_parameters<Number, internal_np::maximum_circumradius_t>(value);
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// the same, after the parameters `np`.
template <typename Number, typename NamedParameters>
auto maximum_circumradius(const Number& value, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Number, internal_np::maximum_circumradius_t,
                                         NamedParameters>(value, np);
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// names a function that says of a face of \f$T_2\f$ whether it shall be refined.
template <typename Predicate>
auto face_predicate(const Predicate& value)
{
  return CGAL::Named_function_parameters<Predicate, internal_np::face_predicate_t>(value);
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// the same, after the parameters `np`.
template <typename Predicate, typename NamedParameters>
auto face_predicate(const Predicate& value, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Predicate, internal_np::face_predicate_t, NamedParameters>(
    value, np);
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// names the number of vertices that may be inserted.
template <typename Number>
auto maximum_number_of_insertions(const Number& value)
{
  return CGAL::Named_function_parameters<Number, internal_np::maximum_number_of_insertions_t>(
    value);
}

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// the same, after the parameters `np`.
template <typename Number, typename NamedParameters>
auto maximum_number_of_insertions(const Number& value, const NamedParameters& np)
{
  return CGAL::Named_function_parameters<Number, internal_np::maximum_number_of_insertions_t,
                                         NamedParameters>(value, np);
}

} // namespace parameters

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_NAMED_PARAMETERS_H
