// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_TOLERANCES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_TOLERANCES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// All tolerances of the package. None depends on the unit of length: they are angles, logarithms
// of ratios of lengths, or relative to compared numbers. Bounds of rounding errors that follow
// from a formula are next to that formula.
namespace tolerance {

constexpr double unit = std::numeric_limits<double>::epsilon();

// Angles, in radians. Rounding of a sum of angles leaves 1e-14 on good meshes. Ten times this
// error is reached everywhere. A thousand times this error is the limit from which on more digits
// are used.
constexpr double gradient = 1e-13, curvature = 1e-11;
// The minimum of the spherical energy in 32 digits: scale factors have an error of at most its
// root where bounds are active.
constexpr double extended_gradient = 1e-22;
// The greatest change of an angle by rounding of the lengths of the input, all of them in the
// worst way. Beyond it, lengths of the exact surface are used, with more digits.
constexpr double known_input_angle = 1e-9;
// A gradient with a greater rounding error determines nothing: steps do not go to such a point.
constexpr double known_angle = 1;
// The greatest error of a curvature or exterior angle that a successful map may have.
constexpr double promised_angle = 1e-10;
// Straight boundaries that need too many digits are bent by that at each vertex, or less.
constexpr double bend = 1e-13;
// Curvatures on the exact surface, after scale factors have been rounded to `double`.
constexpr double promised_rounded_angle = 1e-8;
// The greatest relative error of cross ratios, of lengths in the plane, and of the shape of a
// boundary that a successful map may have.
constexpr double promised_length = 1e-8;
// The relative error of lengths of rounded surfaces, against the exact surface.
constexpr double promised_exact_length = 1e-9;
// Positions on the unit sphere: some roundings.
constexpr double inscribed = 1e-14;
// A face with an angle that is off by more cannot be laid out in the plane.
constexpr double layout_angle = 1e-9;
// Prescribed curvatures come from files with some ten digits, and are summed up.
constexpr double curvature_sum = 1e-8;

// Products of motions that must be the identity.
constexpr double gluing = 1e-9;
// The factor by which 32 digits instead of 16 reduce such an error.
constexpr double extended_gain = 1e-15;

// Two faces count as disjoint if they overlap by at most this part of the smaller one: lengths in
// the plane have such errors.
constexpr double overlap = 1e-9;

// Length cross ratios, relative: the allowed error, and the error from which on more digits are
// used.
constexpr double cross_ratio = 1e-8, good_cross_ratio = 1e-9;
// Logarithmic scale factors at their bounds: lengths with the error that cross ratios may have.
constexpr double bound = 1e-8;
// Translations along seams of a flat surface, relative to the longest: closed curves without
// length, or parallel ones.
constexpr double translation = 1e-8;

// Sums that cancel, relative to the sum of the absolute values of thousands of terms.
constexpr double cancellation = 1e-12;
// The factor by which one minimization can reduce a gradient. The rounding of a variable in
// `double` is four digits smaller.
constexpr double reduction = 1e-12;
// The gradient that rounding of a number type leaves: its unit times the number of roundings.
constexpr double roundings_of_gradient = 1e4;
template <typename FT>
double rounding_of_gradient()
{
  return roundings_of_gradient * static_cast<double>(std::numeric_limits<FT>::epsilon());
}
// By what a step must reduce a gradient, for its factorization to be used again.
constexpr double contraction = 0.25;
constexpr std::size_t corrections = 3;
// The same for a start, which needs few digits, and how far, as logarithms of lengths, its
// factorization is used.
constexpr double contraction_at_start = 0.5, step_at_start = 1;
// The greatest numbers of exchanges of cones, of cones that one exchange tries to replace, and of
// cones that are exchanged. A move must reduce the greatest scale factor by this factor.
constexpr std::size_t exchanges_of_cones = 100, replaced_cones = 16, exchanged_cones = 200;
constexpr double gain_of_move = 0.99;
// Some roundings of one variable. Smaller steps, or distances from a bound, count as zero.
constexpr double roundings_of_variable = 64, variable = roundings_of_variable * unit;
// The greatest rounding error of squared lengths and quotients of them, in units: ties are not
// decided by less.
constexpr double roundings_of_squares = 16;

// Rounding of positions: the error of a distance of two points, in units of their coordinates.
// Then the size below which they may be one point.
constexpr double roundings_of_position = 8;
// The greatest coordinate in the plane that is stored: squares have the range of `double`. Then
// the least distance of two positions, relative to their coordinates, that `Extended` resolves
// with ten digits.
constexpr double greatest_position = 0x1p480, least_known_distance = 0x1p-70;
// The range of logarithmic scale factors up to which squares of lengths, and products of four of
// them, have the range of `double`.
constexpr double narrow_log_scales = 100;

// The center of mass. The first number is a hundred roundings of the sum of masses. The second is
// the distance below which Newton's method converges quadratically, so that a step that gains
// little is rounding. The third is the curvature that masses in two points lack along the line
// through both.
constexpr double center = 1e-14, near_center = 1e-6, least_curvature = 1e-12;
// The range of distances whose products have all digits of `Extended`.
constexpr double least_distance = 1e-270;
// The relative growth of an energy below which slopes decide: values have rounding errors of this
// size.
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
// The number of steps that are taken with more digits, on the exact surface.
constexpr std::size_t steps_with_more_digits = 300;
// All searches for a map that may fail measure so many faces and flip so many edges, with 32
// digits. One of several searches has this part of the rest.
constexpr std::size_t work_for_map = 15000000, parts_of_work = 5;
// A minimization that has not converged after so many steps is given up.
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
// The least entry of a damped diagonal, relative to the greatest.
constexpr double damping = 1e-10;
// A diagonal is lifted against rounding in a factorization by a hundred units, then more and more.
// A matrix that needs more than a thousandth is no Laplacian.
constexpr double greatest_lift = 1, greatest_Laplacian_lift = 1e-3;
inline double next_lift(double lift) { return lift == 0 ? 1e-14 : 100 * lift; }

// The change of the exterior angles of a circle, in radians, below which its repetition has
// converged: ten times what a minimization may leave.
constexpr double circle_angle = 1e-10;

} // namespace tolerance
} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_TOLERANCES_H
