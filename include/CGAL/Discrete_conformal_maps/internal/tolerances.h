// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_TOLERANCES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_TOLERANCES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// This file contains all tolerances of the package. No tolerance depends on the unit of length.
// Each is an angle, a logarithm of a ratio of lengths, or relative to the compared numbers. Bounds
// of rounding errors that follow from a formula stand next to the formula.
namespace tolerance {

constexpr double unit = std::numeric_limits<double>::epsilon();

// These are angles in radians. On good meshes, rounding leaves an error of 1e-14 in a sum of
// angles. Every minimization reaches ten times this error. Beyond a thousand times this error,
// more digits are used.
constexpr double gradient = 1e-13, curvature = 1e-11;
// The spherical energy can be minimized to the first gradient with 32 digits, and with more digits
// to the second one. If bounds are active, the error of scale factors is at most the square root of
// this number.
constexpr double extended_gradient = 1e-22, most_precise_gradient = 1e-45;
// If vertices are not close to each other, such a gradient does not change positions in `double`.
constexpr double invisible_gradient = 1e-17;
// This is the greatest allowed change of an angle if all input lengths change by rounding in the
// worst way. If the change is greater, the computation uses lengths of the exact surface with more
// digits.
constexpr double known_input_angle = 1e-9;
// A gradient whose rounding error exceeds this angle determines nothing, so no step goes to such a
// point.
constexpr double known_angle = 1;
// This is the greatest error of a curvature or exterior angle of a successful map.
constexpr double promised_angle = 1e-10;
// If straight boundaries need too many digits, they are bent by at most this angle at each vertex.
constexpr double bend = 1e-13;
// This is the greatest error of curvatures on the exact surface after scale factors have been
// rounded to `double`.
constexpr double promised_rounded_angle = 1e-8;
// This is the greatest relative error of a successful map in cross ratios, in lengths in the
// plane, and in the shape of a boundary.
constexpr double promised_length = 1e-8;
// Two circles count as touching if they overlap by at most this fraction of the distance of their
// centers. Circles of maps and packings are computed: they touch with an error of layouts, which
// exceeds rounding errors of lengths. The fraction is the promised error of lengths in the plane.
constexpr double overlap_of_circles = promised_length;
// This is the greatest relative error of lengths of rounded surfaces, compared with the exact
// surface.
constexpr double promised_exact_length = 1e-9;
// Positions differ from the unit sphere by a few rounding errors.
constexpr double inscribed = 1e-14;
// A face cannot be laid out in the plane if the error of an angle is greater.
constexpr double layout_angle = 1e-9;
// Prescribed curvatures may come from files with ten digits, and are summed up.
constexpr double curvature_sum = 1e-8;

// A product of motions that must be the identity differs from it by at most this value.
constexpr double gluing = 1e-9;
// Using 32 instead of 16 digits reduces such an error by this factor.
constexpr double extended_gain = 1e-15;

// Two faces count as disjoint if they overlap by at most this fraction of the smaller face. The
// fraction is an error of lengths in the plane.
constexpr double overlap = 1e-9;

// The first number is the allowed relative error of a length cross ratio. Beyond the second
// number, more digits are used.
constexpr double cross_ratio = 1e-8, good_cross_ratio = 1e-9;
// This is the greatest error of logarithmic scale factors at their bounds. It equals the allowed
// error of cross ratios.
constexpr double bound = 1e-8;
// A translation along seams of a flat surface counts as zero, or as parallel to another
// translation, up to this fraction of the longest translation.
constexpr double translation = 1e-8;

// A sum with cancellation has this error, relative to the sum of the absolute values of thousands
// of terms.
constexpr double cancellation = 1e-12;
// One minimization can reduce a gradient by this factor. The rounding error of a variable in
// `double` is smaller by four digits.
constexpr double reduction = 1e-12;
// Rounding of a number type leaves a gradient of this many units.
constexpr double roundings_of_gradient = 1e4;
template <typename FT>
double rounding_of_gradient()
{
  return roundings_of_gradient * static_cast<double>(std::numeric_limits<FT>::epsilon());
}
// A factorization is used again if a step reduces the gradient at least by this factor.
constexpr double contraction = 0.25;
constexpr std::size_t corrections = 3;
// A start needs few digits. The second number is the greatest change of logarithmic lengths for
// which its factorization is used again.
constexpr double contraction_at_start = 0.5, step_at_start = 1;
// The first number limits the exchanges of cones. The second is the number of cones that one
// exchange tries to replace, and the third the number of cones that are exchanged. A move must
// reduce the greatest scale factor by the factor `gain_of_move`.
constexpr std::size_t exchanges_of_cones = 100, replaced_cones = 16, exchanged_cones = 200;
constexpr double gain_of_move = 0.99;
// Edges of a double between the same vertices, or their copies, are mirror images if their lengths
// have at most this relative difference.
constexpr double mirrored_length = 1e-12;
// A step, or a distance from a bound, counts as zero if it is smaller than a few rounding errors
// of a variable.
constexpr double roundings_of_variable = 64, variable = roundings_of_variable * unit;
// This is the greatest rounding error of squared lengths and their quotients, in units. Smaller
// differences count as ties.
constexpr double roundings_of_squares = 16;

// This is the rounding error of the distance between two points, in units of their coordinates.
// Points at a smaller distance may coincide.
constexpr double roundings_of_position = 8;
// Coordinates in the plane beyond the first number are not stored, because their squares exceed
// the range of `double`. The second number is a distance of two positions relative to their
// coordinates. At this distance or a greater one, `Double_double` resolves the distance with ten
// digits.
constexpr double greatest_position = 0x1p480, least_known_distance = 0x1p-70;
// Close to the image of infinity on the sphere, the square of the distance from it determines the
// stereographic projection with more digits. This is the greatest such square.
constexpr double near_infinity = 1e-12;
// Up to this size of logarithmic scale factors, squares of lengths and products of four lengths
// are in the range of `double`.
constexpr double narrow_log_scales = 100;

// These numbers concern the center of mass. The first number is a hundred rounding errors of the
// sum of masses. Below the second number, Newton's method converges quadratically, so a step
// without progress is rounding. If all masses lie in two points, the third number replaces the
// missing curvature along the line through both.
constexpr double center = 1e-14, near_center = 1e-6, least_curvature = 1e-12;
// Products of distances beyond this number have all digits of `Double_double`.
constexpr double least_distance = 1e-270;
// If the relative growth of an energy is less than this number, slopes decide. Energies have
// rounding errors of this size.
constexpr double growth = 1e-9;

// A Laplacian is not factorized by subtraction if its diagonal entries differ by more than the
// inverse of the first number. Negative weights of cocircular faces are no greater than the second
// number.
constexpr double stiffness = 1e-10, negative_weight = 1e-6;
// Two vertices are near if their distance is less than `near_vertices` times an adjacent edge.
// Scale factors in `double` do not determine their angles. Variables of a Laplacian move as a
// group if the weights between them exceed the weights to all others by the factor `group_ratio`.
// Within bounds, a group moves only if its weights to others exceed `weight_of_group`.
constexpr double near_vertices = 1e-8;
constexpr double group_ratio = 30, weight_of_group = 100;
// This is the greatest number of steps on the exact surface with more digits.
constexpr std::size_t steps_with_more_digits = 300;
// These numbers limit the work of all searches for a map: measured faces and flipped edges with 32
// digits. If several searches follow, each one gets the remaining work divided by the second
// number. On a large surface, all searches together may measure every face as often as the third
// number says. A sphere is searched from several vertices, with several types of numbers. Each of
// these searches gets the remaining work divided by the fourth number. A start of a caller, and a
// flat start of a sphere, get the work divided by the fifth number. If this is not enough, the
// start is far away, and the search restarts without it.
constexpr double work_for_map = 1.7e7, parts_of_work = 2, sure_measurements = 200,
                 parts_of_work_for_sphere = 4, parts_of_work_from_start = 8;
// A minimization that has not converged after this number of steps ends.
constexpr std::size_t steps_to_lose_the_way = 250;
// A search with bounded differences ends after this number of steps.
constexpr std::size_t steps_with_bounded_differences = 1000;
// A greater error of curvatures is not a rounding error.
constexpr double lost_curvature = 1e-3;
// A search with most digits continues from a point with at most this error.
constexpr double curvature_near_minimum = 1e-2;
// A start needs few digits and few steps. This is the error at which it ends.
constexpr double curvature_at_start = 1e-3;
constexpr std::size_t steps_to_start = 300;
// These errors are allowed for a sphere without circles that is a rough start. Its circles change
// angles by more.
constexpr double gradient_without_circles = 1e-2, curvature_without_circles = 3e-2;
// No entry of a damped diagonal is less than this fraction of the greatest entry.
constexpr double damping = 1e-10;
// To compensate rounding errors in a factorization, a diagonal is raised by a hundred units, and
// then by more and more. A matrix that needs more than the second number is no Laplacian.
constexpr double greatest_lift = 1, greatest_Laplacian_lift = 1e-3;
inline double next_lift(double lift) { return lift == 0 ? 1e-14 : 100 * lift; }

// The iteration for the exterior angles of a circle has converged if they change by less than this
// number of radians. It is ten times the error that a minimization may leave.
constexpr double circle_angle = 1e-10;

// Images keep this distance from the sides of the unit square, relative to its width.
constexpr double margin_of_square = 0x1p-46;

} // namespace tolerance
} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_TOLERANCES_H
