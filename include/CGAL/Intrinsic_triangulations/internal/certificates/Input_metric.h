// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_INPUT_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_INPUT_METRIC_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

template <typename FT, typename Integer>
class Euclidean_geometry_traits;

/// \ingroup PkgIntrinsicTriangulationsRef
/// the exact metric of \f$T_1\f$. It has positions of its vertices, or squared lengths in a field
/// `K` with exact signs (or of type `double`). If it has neither, its lengths count as exact.
template <typename K>
struct Input_metric
{
  /// the type of squared lengths.
  typedef K Number;

  std::vector<std::array<double, 3>> points; ///< of the vertices, or empty
  std::vector<K> squared_lengths;            ///< of the edges, or empty
};

namespace internal {

// Represents the surface of T1 for exact decisions.
template <typename K>
struct Exact_surface : Surface_view<Delta_complex::Property_map<Edge_index, double>>
{
  const Input_metric<K>& metric;
};

// Replaces the metric if the geometry is not Euclidean or the numbers of the traits are exact.
struct No_metric
{};

// Determines whether decisions are exact although lengths are of type `double`. If lengths do not
// decide, the metric of T1 does.
template <typename Traits, typename = void>
struct Is_exact : std::false_type
{};

template <typename Traits>
struct Is_exact<Traits, std::void_t<typename Traits::Exact_number>> : std::true_type
{};

// Determines whether points inside faces have distances in this geometry, so that vertices can be
// inserted.
template <typename Traits, typename = void>
struct Has_distance : std::false_type
{};

template <typename Traits>
struct Has_distance<Traits, std::void_t<decltype(std::declval<Traits>().compute_distance_object())>>
  : std::true_type
{};

// Finds the default traits that equal `Traits` or are its base class. The result is void without
// such traits.
template <typename Integer>
Euclidean_geometry_traits<double, Integer>
default_traits(const Euclidean_geometry_traits<double, Integer>&);
void default_traits(...);

template <typename Traits>
using Default_traits_of = decltype(default_traits(std::declval<const Traits&>()));

// Determines whether the function objects that measure belong to the default traits, whose geometry
// exact decisions know. It also determines this for the function objects that decide about flips.
template <typename Traits, typename Default = Default_traits_of<Traits>>
struct Inherited
{
  static constexpr bool geometry =
    std::is_same_v<typename Traits::FT, double> &&
    std::is_same_v<typename Traits::Geodesic_strip, typename Default::Geodesic_strip> &&
    std::is_same_v<typename Traits::Compute_distance, typename Default::Compute_distance> &&
    std::is_same_v<typename Traits::Compute_flipped_length,
                   typename Default::Compute_flipped_length>;
  static constexpr bool decisions =
    geometry &&
    std::is_same_v<typename Traits::Is_locally_Delaunay, typename Default::Is_locally_Delaunay> &&
    std::is_same_v<typename Traits::Is_convex, typename Default::Is_convex>;
};

template <typename Traits>
struct Inherited<Traits, void>
{
  static constexpr bool geometry = false, decisions = false;
};

// Selects the type of the metric of T1, which exact decisions use if `double` does not decide.
template <typename Traits, typename = void>
struct Metric_of
{
  typedef std::conditional_t<Inherited<Traits>::geometry, Input_metric<double>, No_metric> type;
};

template <typename Traits>
struct Metric_of<Traits, std::void_t<typename Traits::Exact_number>>
{
  typedef Input_metric<typename Traits::Exact_number> type;
};

template <typename Traits>
using Input_metric_of = typename Metric_of<Traits>::type;

// Returns whether the metric of T1 is stored, so that certificates are possible.
template <typename Traits>
constexpr bool has_metric()
{
  return !std::is_same_v<Input_metric_of<Traits>, No_metric>;
}

// Returns whether exact decisions can continue flips. They cannot if the traits have conditions of
// their own.
template <typename Traits>
constexpr bool has_exact_decisions()
{
  return Is_exact<Traits>::value || Inherited<Traits>::decisions;
}

template <typename N>
std::array<N, 3> vector_between(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return {N(q[0]) - N(p[0]), N(q[1]) - N(p[1]), N(q[2]) - N(p[2])};
}

template <typename N>
N dot(const std::array<N, 3>& u, const std::array<N, 3>& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

template <typename N>
N cross_coordinate(const std::array<N, 3>& u, const std::array<N, 3>& v, std::size_t c)
{
  const std::size_t a = (c + 1) % 3, b = (c + 2) % 3;
  return u[a] * v[b] - u[b] * v[a];
}

template <typename N>
std::array<N, 3> cross(const std::array<N, 3>& u, const std::array<N, 3>& v)
{
  return {cross_coordinate(u, v, 0), cross_coordinate(u, v, 1), cross_coordinate(u, v, 2)};
}

} // namespace internal
} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_INPUT_METRIC_H
