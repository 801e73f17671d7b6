// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_TOLERANCES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_TOLERANCES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// This file contains all tolerances of the package. None depends on the unit of length: they are
// angles, logarithms of ratios of lengths, or relative to compared numbers. Bounds of rounding
// errors that follow from a formula are next to that formula.
namespace tolerance {

constexpr double unit = std::numeric_limits<double>::epsilon();

// These angles are in radians. Rounding of a sum of angles leaves an error of 1e-14 on good meshes.
// Every minimization reaches ten times this error. More digits are used beyond a thousand times
// this error.
constexpr double gradient = 1e-13, curvature = 1e-11;
// This is enough for the minimum of the spherical energy in 32 digits. At active bounds, scale
// factors have an error of at most its root.
constexpr double extended_gradient = 1e-22;
// This is the greatest allowed change of an angle if rounding changes all lengths of the input in
// the worst way. Beyond it, lengths of the exact surface are used, with more digits.
constexpr double known_input_angle = 1e-9;
// A gradient with a greater rounding error determines nothing: steps do not go to such a point.
constexpr double known_angle = 1;
// A successful map has no greater error of a curvature or exterior angle.
constexpr double promised_angle = 1e-10;
// Straight boundaries that need too many digits are bent by at most this angle at each vertex.
constexpr double bend = 1e-13;
// Curvatures on the exact surface have no greater error after scale factors have been rounded to
// `double`.
constexpr double promised_rounded_angle = 1e-8;
// A successful map has no greater relative error of cross ratios, of lengths in the plane, and of
// the shape of a boundary.
constexpr double promised_length = 1e-8;
// Lengths of rounded surfaces have no greater relative error, compared with the exact surface.
constexpr double promised_exact_length = 1e-9;
// Positions differ from the unit sphere by some roundings.
constexpr double inscribed = 1e-14;
// A face cannot be laid out in the plane if the error of an angle is greater.
constexpr double layout_angle = 1e-9;
// Prescribed curvatures come from files with some ten digits, and are summed up.
constexpr double curvature_sum = 1e-8;

// Products of motions that must be the identity differ from it by at most this value.
constexpr double gluing = 1e-9;
// 32 digits instead of 16 reduce such an error by this factor.
constexpr double extended_gain = 1e-15;

// Two faces count as disjoint if they overlap by at most this part of the smaller one: lengths in
// the plane have such errors.
constexpr double overlap = 1e-9;

// These are the allowed relative error of a length cross ratio, and the error beyond which more
// digits are used.
constexpr double cross_ratio = 1e-8, good_cross_ratio = 1e-9;
// Logarithmic scale factors at their bounds have at most this error, which is the error that cross
// ratios may have.
constexpr double bound = 1e-8;
// A translation along seams of a flat surface counts as zero, or as parallel to another one, up to
// this part of the longest one.
constexpr double translation = 1e-8;

// Sums that cancel have this error, relative to the sum of the absolute values of thousands of
// terms.
constexpr double cancellation = 1e-12;
// One minimization can reduce a gradient by this factor. The rounding of a variable in `double` is
// four digits smaller.
constexpr double reduction = 1e-12;
// Rounding of a number type leaves a gradient of its unit times this number of roundings.
constexpr double roundings_of_gradient = 1e4;
template <typename FT>
double rounding_of_gradient()
{
  return roundings_of_gradient * static_cast<double>(std::numeric_limits<FT>::epsilon());
}
// A factorization is used again if a step reduces the gradient at least by this factor.
constexpr double contraction = 0.25;
constexpr std::size_t corrections = 3;
// A start needs few digits. The second number is the greatest change of logarithms of lengths for
// which its factorization is used.
constexpr double contraction_at_start = 0.5, step_at_start = 1;
// These are the greatest numbers of exchanges of cones, of cones that one exchange tries to
// replace, and of cones that are exchanged. A move must reduce the greatest scale factor by the
// factor `gain_of_move`.
constexpr std::size_t exchanges_of_cones = 100, replaced_cones = 16, exchanged_cones = 200;
constexpr double gain_of_move = 0.99;
// Steps, or distances from a bound, count as zero if they are smaller than some roundings of a
// variable.
constexpr double roundings_of_variable = 64, variable = roundings_of_variable * unit;
// This is the greatest rounding error of squared lengths and their quotients, in units. A smaller
// difference does not decide a tie.
constexpr double roundings_of_squares = 16;

// This is the rounding error of the distance of two points, in units of their coordinates. Below
// this distance they may be one point.
constexpr double roundings_of_position = 8;
// Squares of greater coordinates in the plane leave the range of `double`, so they are not stored.
// `Extended` resolves a distance of two positions, relative to their coordinates, with ten digits
// if it is not less than the second number.
constexpr double greatest_position = 0x1p480, least_known_distance = 0x1p-70;
// Up to this range of logarithmic scale factors, squares of lengths and products of four lengths
// are in the range of `double`.
constexpr double narrow_log_scales = 100;

// These numbers concern the center of mass. The first number is a hundred roundings of the sum of
// masses. The second is the distance below which Newton's method converges quadratically, so that a
// step that gains little is rounding. The third is the curvature that masses in two points lack
// along the line through both.
constexpr double center = 1e-14, near_center = 1e-6, least_curvature = 1e-12;
// Products of greater distances have all digits of `Extended`.
constexpr double least_distance = 1e-270;
// Slopes decide if the relative growth of an energy is less, because values have rounding errors of
// this size.
constexpr double growth = 1e-9;

// If diagonal entries of a Laplacian differ by more than this factor, it is not factorized by
// subtracting. Negative weights of cocircular faces are no greater than this.
constexpr double stiffness = 1e-10, negative_weight = 1e-6;
// Variables of a Laplacian can move as one if they are tied to each other by that many times the
// weights to others. They cannot move alone if they are not tied to others by more than a weight.
// Consider vertices with a distance that is shorter in proportion to other edges. Scale factors in
// `double` do not determine their angles.
constexpr double near_vertices = 1e-8;
constexpr double group_ratio = 30, weight_of_group = 100;
// At most this number of steps are taken with more digits, on the exact surface.
constexpr std::size_t steps_with_more_digits = 300;
// All searches for a map that may fail measure so many faces and flip so many edges, with 32
// digits. One of several searches has this part of the rest. On a large surface, they may
// measure every face so many times.
constexpr double work_for_map = 1.4e7, parts_of_work = 2, sure_measurements = 200;
// A minimization that has not converged after so many steps ends.
constexpr std::size_t steps_to_lose_the_way = 250;
// A search with bounded differences ends after so many steps.
constexpr std::size_t steps_with_bounded_differences = 1000;
// Errors of curvatures beyond this are no rounding errors.
constexpr double lost_curvature = 1e-3;
// A start needs few digits, and few steps.
constexpr double curvature_at_start = 1e-3;
constexpr std::size_t steps_to_start = 300;
// Circles change angles by more than these errors of a sphere without circles.
constexpr double gradient_without_circles = 1e-2, curvature_without_circles = 3e-2;
// No entry of a damped diagonal is less than this part of the greatest one.
constexpr double damping = 1e-10;
// To compensate rounding in a factorization, a diagonal is lifted by a hundred units, and then more
// and more. A matrix that needs more than a thousandth is no Laplacian.
constexpr double greatest_lift = 1, greatest_Laplacian_lift = 1e-3;
inline double next_lift(double lift) { return lift == 0 ? 1e-14 : 100 * lift; }

// The iteration for the exterior angles of a circle has converged if they change by less, in
// radians. This is ten times the error that a minimization may leave.
constexpr double circle_angle = 1e-10;

} // namespace tolerance
} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_TOLERANCES_H
