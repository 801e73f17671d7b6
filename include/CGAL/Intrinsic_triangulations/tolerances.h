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
/// other tolerances in this header decide nothing about Delaunay edges. They choose where vertices
/// are inserted, which edges are flipped to remove them, and which computations are repeated with
/// more digits. They also choose when a search visits all regions of a face. Bounds of rounding
/// errors that follow from a formula are next to that formula.
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
// about a hundred triangles before more digits are needed, and is small enough for lengths to
// decide about nearly all edges.
constexpr double certified_length_error() { return 1.0 / (std::int64_t(1) << 40); }

// The angle in radians by which a corner that is nearly flat or nearly zero can be wrong: its
// cosine is rounded, and so it is uncertain by the square root of that. For `double` it is 2^-20.
// Removing a vertex flips no edge whose diamond exceeds a flat angle by more.
template <typename FT>
FT flat_angle_tolerance()
{
  return 16 * CGAL::sqrt(rounding_unit<FT>());
}

// By how much, in radians, the sum of the angles of a fan, each of them rounded, differs from pi
// where it decides: far more than its error.
constexpr double fan_tolerance() { return 1e-6; }

// The error of angles that are only counted: their sum is compared with whole and half turns.
constexpr double counted_angle_error() { return 1e-6; }

// Where a fan with lengths in `double` is so nearly flat, it counts as flat: a path would get
// shorter by the square of this, and a decision could take any number of digits.
constexpr double flat_fan_tolerance() { return 1e-24; }

// How far a circumcenter may be moved onto an edge, in circumradii. For `double` it is 2^-20: far
// more than the rounding of a walk, so that no piece is left whose length is rounding, and so
// little that angles change by no more than nearly flat corners are uncertain anyway.
template <typename FT>
FT circumcenter_tolerance()
{
  return flat_angle_tolerance<FT>();
}

// The relative error of the length of a path that has been developed over many faces: what is cut
// off in a search for shortest paths is longer by more than this. For `double` it is 2^-40.
template <typename FT>
constexpr FT path_tolerance()
{
  return 256 * rounding_unit<FT>();
}

// Lengths that are rounded displace crossings by about `rounding_unit()`, divided by the height of
// faces of T1, and by the square of that of faces of T2, all relative to longest sides. For
// `double`, from 2^-20 on this is less than 1e-8.
constexpr float least_product_of_heights() { return 0x1p-20f; }

// The distance from a region, in barycentric coordinates of a face of T1, up to which a point
// counts as in it. A line through the face passes many edges, each with the rounding of its
// crossing; for `double` this is 2^-40. Beyond it, all regions of the face are looked at.
template <typename FT>
constexpr FT region_tolerance()
{
  return 256 * rounding_unit<FT>();
}

// The greatest relative error of lengths in `double` that decide flips, where certificates follow.
// More leaves more edges in doubt where coordinates have been rounded to few digits, less more to
// strips; with limited effort, fewer strips can be laid out.
constexpr double flipping_length_error(bool is_limited) { return is_limited ? 0x1p-30 : 0x1p-34; }

// The relative error of lengths with more digits, of which scale factors are computed: 2^13
// roundings of a number of their type.
template <typename Length>
double precise_length_error()
{
  return std::ldexp(1., 14 - std::numeric_limits<Length>::digits);
}

// Four times the area of a face, divided by the square of its perimeter, from which on its lengths
// in `double` determine its angles well enough for flips: these are wrong by the roundoff, divided
// by the quotient.
constexpr double resolved_angle_ratio() { return 0x1p-24; }

// The slack of the triangle inequality, divided by the perimeter, from which on lengths with an
// error of half a `rounding_unit()` determine the area of a face to eight digits.
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

// The diagonal entry of a matrix with cotangents beyond which a row is not eliminated in `double`:
// what is added to it loses as many bits.
constexpr double greatest_rounded_weight() { return 0x1p20; }

// An angle of T1 whose rounding error is not less than this, in radians, is taken for unknown.
constexpr double known_angle_error() { return 1e-9; }

// The relative difference of two distances up to which it is worth deciding exactly whether faces
// lie in one plane.
constexpr double plane_tolerance() { return 1e-6; }

// The distance of a vertex that was inserted on an edge from this edge in another triangulation,
// relative to the longest side of the face there: locations are rounded.
constexpr double inserted_edge_tolerance() { return 1e-6; }

// The width of intervals that enclose a crossing along its edges, and the width up to which they
// are said to do so: where edges almost run along each other, no number of digits does.
constexpr double crossing_width() { return 0x1p-50; }
constexpr double greatest_crossing_width() { return 0x1p-40; }

// By how much, in barycentric coordinates, points whose rounding is outside of their region are
// moved to the center of their face, one after the other. The first ones may still be on an edge.
constexpr double inward_moves[] = {0., 0x1p-30, 0x1p-15, 0x1p-8, 0x1p-4, 0x1p-2};
constexpr double greatest_move_on_edge() { return 0x1p-15; }

// ---- Limits of effort ----

// By how much heat may flow longer than by default, before distances count as out of range.
constexpr double greatest_time_step_factor() { return 1e12; }

// The number of rounds of flips after which rounding of lengths is said to keep a triangulation
// from being Delaunay; with exact decisions to come, the number after which they begin.
constexpr int rounds_of_flips() { return 100; }
constexpr int rounds_before_exact_flips() { return 2; }

// How many steps on strips of triangles a refinement may take to flip with certainty.
constexpr double refinement_effort() { return 1e9; }

// How many such steps flips in the exact metric may take before lengths decide instead.
constexpr double exact_metric_effort() { return 1e7; }

// How many crossings all lengths together may have that are computed afresh with limited effort.
constexpr double greatest_number_of_crossings(double edges) { return 1e6 + 100 * edges; }

} // namespace internal
} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TOLERANCES_H
