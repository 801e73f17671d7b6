// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLIPPED_LENGTH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLIPPED_LENGTH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// The relative error of the length of an edge of T1: it comes from less than ten roundings.
constexpr double input_length_error() { return 4 * std::numeric_limits<double>::epsilon(); }

// a length with a bound for its relative error
struct Bounded_length
{
  double length, error;

  bool is_good() const { return error <= certified_length_error(); }
};

// The perimeter of a triangle over its least slack in the triangle inequality: by this many relative
// errors of its sides its squared area can change, at most three times.
inline double thinness(double a, double b, double c)
{
  const double perimeter = a + b + c;
  return perimeter / (perimeter - 2 * (std::max)({a, b, c}));
}

// Returns the length of the other diagonal of a diamond whose sides have relative errors of at most
// `error`; the bound is infinite if that may not be small.
//
// For four points of the plane with the affine dependency a_i p_i + ... = 0, the products a_i a_j are
// an equilibrium stress, so that the sum of a_i a_j l_ij dl_ij over all six distances is zero, and that
// of a_i a_j l_ij^2 is zero, too. Only the products of the two diagonals are positive: hence l_kl has
// at most 1 + 2 a_i a_j l_ij^2 / (a_k a_l l_kl^2) times the relative error. Here a_k and a_l are the
// areas of the two triangles, and a_i a_j is at most a quarter of their squared sum. As the areas change
// by less than a hundredth, so does the factor, by a sixteenth. What is rounded in the formula itself
// is small changes of the distance of the feet and of both heights.
inline Bounded_length flipped_length(const Diamond<double>& length, double error)
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const auto [ij, jk, ki, il, lj] = length;
  const double flipped = Euclidean_geometry_traits<double>::Compute_flipped_length()(length);
  const double thin_k = thinness(ij, jk, ki), thin_l = thinness(ij, lj, il);
  const double height_k = squared_quadrupled_area(ij, jk, ki),
               height_l = squared_quadrupled_area(ij, lj, il);
  const double root = std::sqrt(height_k * height_l), heights = height_k + height_l + 2 * root;
  const double square = 4 * (ij * ij) * (flipped * flipped);
  if(!(256 * (error + 4 * epsilon) * (std::max)(thin_k, thin_l) <= 1) || !(root * square > 0))
    return {flipped, std::numeric_limits<double>::infinity()};
  const double factor = 1 + 2 * heights * (ij * ij) * (ij * ij) / (root * square);
  const double rounding =
    4 + 1.5 * (jk + ki + il + lj) / (std::max)(ij, flipped) +
    ((height_k + root) * (thin_k + 4) + (height_l + root) * (thin_l + 4)) / square;
  return {flipped, (17. / 16) * error * factor + rounding * epsilon};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLIPPED_LENGTH_H
