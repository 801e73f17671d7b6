// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TOLERANCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TOLERANCES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/number_type_basic.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// whether operations on numbers of this type are rounded
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
/// It is relative: to the lengths that are compared, to a full turn or angle sum, or to 1. The
/// other tolerances in this header decide nothing about Delaunay edges. Bounds of rounding errors
/// that follow from a formula are next to that formula.
template <typename FT>
constexpr FT rounding_unit()
{
  if constexpr(internal::is_rounded<FT>())
    return 16 * std::numeric_limits<FT>::epsilon();
  else
    return FT(0);
}

namespace internal {

// The relative error of the lengths that exact traits store, in `double`. It allows a strip of
// about a hundred triangles before more digits are needed. It is small enough for lengths to
// decide about nearly all edges.
constexpr double certified_length_error() { return 1.0 / (std::int64_t(1) << 40); }

// The possible error of a corner in radians that is nearly flat or nearly zero. Its cosine is
// rounded, so its error is the square root of the rounding error. For `double` it is 2^-20.
// Removing a vertex flips no edge whose diamond exceeds a flat angle by more.
template <typename FT>
FT flat_angle_tolerance()
{
  return 16 * CGAL::sqrt(rounding_unit<FT>());
}

// The greatest difference, in radians, of the sum of the rounded angles of a fan from pi at which
// it decides. It is far greater than its error.
constexpr double fan_tolerance() { return 1e-6; }

// The error of angles that are only counted: their sum is compared with whole and half turns.
constexpr double counted_angle_error() { return 1e-6; }

// A fan with lengths in `double` counts as flat within this angle, in radians. A path would get
// shorter by the square of it, and a decision could take any number of digits.
constexpr double flat_fan_tolerance() { return 1e-24; }

// How far a circumcenter may be moved onto an edge, in circumradii. For `double` it is 2^-20. It
// is far greater than the rounding of a walk, so that no piece is as short as rounding errors. It
// is so small that angles change by no more than the error of nearly flat corners.
template <typename FT>
FT circumcenter_tolerance()
{
  return flat_angle_tolerance<FT>();
}

// The relative error of the length of a path that has been developed over many faces. A search for
// shortest paths discards only longer paths, by more than this. For `double` it is 2^-40.
template <typename FT>
constexpr FT path_tolerance()
{
  return 256 * rounding_unit<FT>();
}

// Rounded lengths displace crossings by about `rounding_unit()`, divided by the height of faces of
// T1 and by the squared height of faces of T2. All are relative to longest sides. For `double`,
// this is less than 1e-8 from 2^-20 on.
constexpr float least_product_of_heights() { return 0x1p-20f; }

// The distance from a region, in barycentric coordinates of a face of T1, up to which a point
// counts as in it. A line through the face passes many edges, each with the rounding of its
// crossing; for `double` this is 2^-40. Beyond it, all regions of the face are looked at.
template <typename FT>
constexpr FT region_tolerance()
{
  return 256 * rounding_unit<FT>();
}

// The greatest relative error of lengths in `double` that decide flips, if certificates follow. A
// greater error leaves more edges undecided if coordinates have been rounded to few digits. A
// smaller error needs more strips, and with limited effort, fewer strips can be laid out.
constexpr double flipping_length_error(bool is_limited) { return is_limited ? 0x1p-30 : 0x1p-34; }

// The relative error of lengths with more digits, from which scale factors are computed: 2^13 times
// the `epsilon()` of their type.
template <typename Length>
double precise_length_error()
{
  return std::ldexp(1., 14 - std::numeric_limits<Length>::digits);
}

// Four times the area of a face, divided by the square of its perimeter. From this value on, its
// lengths in `double` determine its angles well enough for flips. Angles are wrong by the
// roundoff, divided by the quotient.
constexpr double resolved_angle_ratio() { return 0x1p-24; }

// The slack of the triangle inequality, divided by the perimeter. From this value on, lengths with
// an error of half a `rounding_unit()` determine the area of a face to eight digits.
constexpr double resolved_area_slack() { return 0x1p-22; }

// What depends on the digits of a number type.
template <typename FT>
struct Digits
{
  // Returns a number on which all results depend: they do not have many digits because of it.
  static FT few(const FT& x) { return x; }

  // Returns whether a face has no area. Only lengths with many digits determine that.
  static bool is_flat(const FT& /* quadrupled_area */, const FT& /* perimeter */) { return false; }
};

// The greatest diagonal entry of a matrix with cotangents whose row is eliminated in `double`.
// Numbers that are added to it lose as many bits.
constexpr double greatest_rounded_weight() { return 0x1p20; }

// An angle of T1 whose rounding error is not less than this, in radians, is taken for unknown.
constexpr double known_angle_error() { return 1e-9; }

// The relative difference of two distances up to which it is worth deciding exactly whether faces
// lie in one plane.
constexpr double plane_tolerance() { return 1e-6; }

// The distance of a vertex that was inserted on an edge from this edge in another triangulation:
// locations are rounded. It is relative to the longest side of the face in that triangulation.
constexpr double inserted_edge_tolerance() { return 1e-6; }

// The requested width of intervals that enclose a crossing along its edges, and the greatest width
// that counts as success. If edges almost run along each other, more digits do not help.
constexpr double crossing_width() { return 0x1p-50; }
constexpr double greatest_crossing_width() { return 0x1p-40; }

// By how much, in barycentric coordinates, points outside of their region by rounding are moved to
// the center of their face, one after the other. The first ones may still be on an edge.
constexpr double inward_moves[] = {0., 0x1p-30, 0x1p-15, 0x1p-8, 0x1p-4, 0x1p-2};
constexpr double greatest_move_on_edge() { return 0x1p-15; }

// ---- Limits of effort ----

// By how much heat may flow longer than by default, before distances count as out of range.
constexpr double greatest_time_step_factor() { return 1e12; }

// The number of rounds of flips after which rounding of lengths prevents a Delaunay triangulation.
// If exact decisions can follow, the number of rounds after which they begin.
constexpr int rounds_of_flips() { return 100; }
constexpr int rounds_before_exact_flips() { return 2; }

// How many steps on strips of triangles a refinement may take to flip with certainty.
constexpr double refinement_effort() { return 1e9; }

// How many such steps flips in the exact metric may take before lengths decide instead.
constexpr double exact_metric_effort() { return 1e7; }

// How many crossings all lengths together may have that are recomputed with limited effort.
constexpr double greatest_number_of_crossings(double edges) { return 1e6 + 100 * edges; }

} // namespace internal
} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TOLERANCES_H
