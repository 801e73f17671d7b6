// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TOLERANCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TOLERANCES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/number_type_basic.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns whether operations on numbers of this type are rounded.
template <typename FT>
constexpr bool is_rounded()
{
  return std::numeric_limits<FT>::is_specialized && !std::numeric_limits<FT>::is_exact;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns the relative error of each length that a decision allows. It is 0 for exact number
/// types, and 16 units in the last digit for floating point. A length comes from fewer than ten
/// roundings.
///
/// All decisions about lengths and directions use it:
/// - whether an edge is Delaunay or can be flipped;
/// - whether lengths obey the triangle inequality;
/// - whether a geodesic hits a vertex;
/// - whether barycentric coordinates sum up to 1.
///
/// It is relative: to the lengths that are compared, to a full turn or angle sum, or to 1. No other
/// tolerance in this header affects decisions about Delaunay edges. Bounds of rounding errors that
/// follow from a formula are next to that formula. Complexity: constant.
template <typename FT>
constexpr FT rounding_unit()
{
  if constexpr(internal::is_rounded<FT>())
    return 16 * std::numeric_limits<FT>::epsilon();
  else
    return FT(0);
}

namespace internal {

// Returns the relative error of the lengths that exact traits store, in `double`. It allows a strip
// of about a hundred triangles before more digits are needed. It is small enough for lengths to
// decide about nearly all edges.
constexpr double certified_length_error() { return 1.0 / (std::int64_t(1) << 40); }

// Returns the allowed difference from one of the sum of barycentric coordinates that a user gives.
template <typename FT>
FT coordinates_tolerance()
{
  return is_rounded<FT>() ? FT(0x1p-20) : FT(0);
}

// Returns the possible error of a corner in radians that is nearly flat or nearly zero. Its cosine
// is rounded, so its error is the square root of the rounding error. For `double` it is 2^-20. The
// removal of a vertex flips no edge whose diamond exceeds a flat angle by more.
template <typename FT>
FT flat_angle_tolerance()
{
  return 16 * CGAL::sqrt(rounding_unit<FT>());
}

// Returns the difference, in radians, of the rounded angle sum of a fan from pi beyond which it
// decides. It is far greater than its error.
constexpr double fan_tolerance() { return 1e-6; }

// Returns the error of angles whose sum is only compared with multiples of pi.
constexpr double counted_angle_error() { return 1e-6; }

// Returns the angle, in radians, within which a fan with lengths in `double` counts as flat. A path
// would get shorter by its square, and a decision could need any number of digits.
constexpr double flat_fan_tolerance() { return 1e-24; }

// Returns the distance by which a circumcenter may be moved onto an edge, in circumradii. For
// `double` it is 2^-20. It is far greater than the rounding error of a walk, so that no piece is as
// short as rounding errors. It changes angles by at most the error of nearly flat corners.
template <typename FT>
FT circumcenter_tolerance()
{
  return flat_angle_tolerance<FT>();
}

// Returns the relative error of the length of a path that has been developed over many faces. A
// search for shortest paths discards only paths that are longer by more than this error. For
// `double` it is 2^-40.
template <typename FT>
constexpr FT path_tolerance()
{
  return 256 * rounding_unit<FT>();
}

// Returns the least product of heights for which rounded lengths determine crossings. They displace
// crossings by about `rounding_unit()`, divided by the height of faces of T1 and by the squared
// height of faces of T2. All are relative to longest sides. For `double`, this is less than 1e-8
// from 2^-20 on.
constexpr float least_product_of_heights() { return 0x1p-20f; }

// Returns the distance from a region, in barycentric coordinates of a face of T1, up to which a
// point counts as inside. A line through the face passes many edges, each with the rounding error
// of its crossing. For `double` it is 2^-40. Beyond it, all regions of the face are searched.
template <typename FT>
constexpr FT region_tolerance()
{
  return 256 * rounding_unit<FT>();
}

// Returns the least relative error of lengths in `double` that decides flips, if certificates
// follow. A greater error leaves more edges undecided if coordinates have been rounded to few
// digits. A smaller error needs more strips.
constexpr double flipping_length_error() { return 0x1p-34; }

// Returns the relative error of lengths with more digits, from which scale factors are computed. It
// is 2^13 roundings of a number of their type.
template <typename Length>
double precise_length_error()
{
  return std::ldexp(1., 14 - std::numeric_limits<Length>::digits);
}

// Returns the least ratio of four times the area of a face to its squared perimeter for which
// lengths in `double` determine its angles. Errors of angles are the roundoff divided by this
// ratio, small enough for flips.
constexpr double resolved_angle_ratio() { return 0x1p-24; }

// Returns the least slack of the triangle inequality, divided by the perimeter, for which lengths
// determine the area of a face to eight digits. Lengths may have an error of half a
// `rounding_unit()`.
constexpr double resolved_area_slack() { return 0x1p-22; }

// Contains functions that depend on the digits of a number type.
template <typename FT>
struct Digits
{
  // Returns a number on which all results depend, with few digits, so that results do not get many
  // digits from it.
  static FT few(const FT& x) { return x; }

  // Returns whether a face has zero area, which only lengths with many digits determine.
  static bool is_flat(const FT& /* quadrupled_area */, const FT& /* perimeter */) { return false; }
};

// Returns the greatest diagonal entry of a matrix with cotangents whose row is eliminated in
// `double`. Numbers that are added to it lose as many bits.
constexpr double greatest_rounded_weight() { return 0x1p20; }

// Returns the relative difference of two distances up to which an exact test decides whether faces
// lie in one plane.
constexpr double plane_tolerance() { return 1e-6; }

// Returns the distance of a vertex that was inserted on an edge from this edge in another
// triangulation, because locations are rounded. It is relative to the longest side of the face in
// that triangulation.
constexpr double inserted_edge_tolerance() { return 1e-6; }

// Consecutive segments of a curve count as connected inside a face if their barycentric coordinates
// differ by less.
constexpr double curve_gap() { return 1e-9; }

// The first width is requested for intervals that enclose a crossing along its edges. The second
// one is the greatest width that counts as success. If edges almost run along each other, more
// digits do not help.
constexpr double crossing_width() { return 0x1p-50; }
constexpr double greatest_crossing_width() { return 0x1p-40; }

// If rounding moves a point out of its region, the point is moved towards the center of its face.
// These amounts in barycentric coordinates are tried one after the other. After the first amounts,
// points may still be on an edge.
constexpr double inward_moves[] = {0., 0x1p-30, 0x1p-15, 0x1p-8, 0x1p-4, 0x1p-2};
constexpr double greatest_move_on_edge() { return 0x1p-15; }

// Returns the relative residual below which the residual that conjugate gradients update may differ
// from the true one. It results from about a hundred updates.
template <typename FT>
constexpr FT residual_rounding()
{
  return 1000 * std::numeric_limits<FT>::epsilon();
}

// Returns the greatest norm of the differences of means over parts of a curve, divided by the
// greatest distance. Iterations stop at the first bound. Beyond the second one, which is far below
// the error of distances, signed distances count as failed.
constexpr double mean_tolerance() { return 0x1p-40; }
constexpr double greatest_mean_difference() { return 0x1p-20; }

// ---- Limits of effort ----

// Returns the maximal number of iterations that make the means over parts of a curve equal. Parts
// all over a square or along a circle need about five times the square root of their number.
inline std::size_t greatest_number_of_mean_iterations(std::size_t parts)
{
  return 200 + static_cast<std::size_t>(50 * std::sqrt(static_cast<double>(parts)));
}

// Returns the shorter time for which normals of a curve flow, in squared mean edge lengths. Times
// from a half to one have almost the same errors on plane sections of real meshes.
constexpr double time_step_factor_of_normals() { return 0.7; }

// Returns the factor by which the heat flow may exceed its default time, before distances count as
// out of range.
constexpr double greatest_time_step_factor() { return 1e12; }

// The first number of rounds of flips shows that rounding of lengths prevents a Delaunay
// triangulation. If exact decisions can follow, they begin after the second number of rounds.
constexpr int rounds_of_flips() { return 100; }
constexpr int rounds_before_exact_flips() { return 2; }

// Limits the steps on strips of triangles in two attempts at certain flips. Lengths from strips
// have the relative error `kept_error`. With a greater error, fewer strips are needed.
struct Flipping_effort
{
  double first, second, kept_error;
};

// If flips in the exact metric or certain flips of a refinement exceed these numbers of steps,
// lengths decide instead.
constexpr Flipping_effort exact_metric_effort() { return {1e7, 1e9, 0x1p-30}; }
constexpr Flipping_effort refinement_effort() { return {1e9, 1e11, 0x1p-30}; }

// Exact flips take this effort before stored lengths decide, which are then checked.
constexpr double no_limit = std::numeric_limits<double>::infinity();
constexpr Flipping_effort exact_effort() { return {2e8, no_limit, certified_length_error()}; }
constexpr Flipping_effort unlimited_effort()
{
  return {no_limit, no_limit, certified_length_error()};
}

// Returns the maximal number of crossings of all lengths that are recomputed with limited effort.
constexpr double greatest_number_of_crossings(double edges) { return 1e6 + 100 * edges; }

// Returns the maximal number of crossings of all lengths that are recomputed without this limit,
// which take a gigabyte.
constexpr double greatest_number_of_crossings() { return 0x1p28; }

} // namespace internal
} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TOLERANCES_H
