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

// Returns the length of the other diagonal of a diamond whose sides have relative errors of at
// most `error`; the bound is infinite if that may not be small.
//
// For four points of the plane with the affine dependency a_i p_i + ... = 0, the products a_i a_j
// are an equilibrium stress, so that the sum of a_i a_j l_ij dl_ij over all six distances is zero,
// and that of a_i a_j l_ij^2 is zero, too. Only the products of the two diagonals are positive:
// hence l_kl has at most 1 + 2 a_i a_j l_ij^2 / (a_k a_l l_kl^2) times the relative error. Here
// a_k and a_l are the areas of the two triangles; a_i and a_j are the parts of their sum on either
// side of kl. The squared area of a triangle changes by at most three errors of its perimeter over
// its least slack in the triangle inequality, here a hundredth. The place where kl cuts ij divides
// the distance of the feet in the ratio of the heights: it changes by the error of the feet and by
// that of this ratio times their distance. If this can bring it outside of ij, one of a_i and a_j
// becomes negative, and its products with a_k and a_l count twice. What is rounded in the formula
// itself is small changes of the distance of the feet and of both heights.
inline Bounded_length flipped_length(const Diamond<double>& length, double error)
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const auto [ij, jk, ki, il, lj] = length;
  const double flipped = Euclidean_geometry_traits<double>::Compute_flipped_length()(length);
  const double round_k = ij + jk + ki, slack_k = round_k - 2 * (std::max)({ij, jk, ki});
  const double round_l = ij + lj + il, slack_l = round_l - 2 * (std::max)({ij, lj, il});
  const double height_k = squared_quadrupled_area(ij, jk, ki),
               height_l = squared_quadrupled_area(ij, lj, il);
  const double root = std::sqrt(height_k * height_l), heights = height_k + height_l + 2 * root;
  const double square = 4 * (ij * ij) * (flipped * flipped);
  const double change = error + 4 * epsilon;
  const double squares = jk * jk + ki * ki + il * il + lj * lj;
  if(!(256 * change * round_k <= slack_k && 256 * change * round_l <= slack_l &&
       32 * change * squares <= ij * ij && root * square > 0))
    return {flipped, std::numeric_limits<double>::infinity()};
  // few quotients: this stands in the loop of flips
  const double inverse = 1 / (root * square), inverse_slack = 1 / (slack_k * slack_l);
  const double sides = (jk + ki + il + lj) * (std::min)(ij, flipped);
  const double thin_k = round_k * slack_l * inverse_slack,
               thin_l = round_l * slack_k * inverse_slack;
  const double rounding =
    8 + ((height_k + root) * (thin_k + 4) + (height_l + root) * (thin_l + 4) + sides * sides) *
          (root * inverse);
  const double foot_k = scaled_foot(jk, ki), foot_l = scaled_foot(lj, il);
  // from the midpoint of ij, times its length
  const double cut = std::abs(foot_k * root + foot_l * height_k) / (2 * (height_k + root));
  const double shift =
    4 * change * (squares + (thin_k + thin_l) * std::abs(foot_k - foot_l) * root / heights);
  const double end = ij * ij / 2, outside = (std::max)(cut + shift - end, 0.);
  const double parts = (end + shift - cut) * (end + shift + cut) + outside * squares;
  const double factor = 1 + 8 * heights * parts * inverse;
  return {flipped, cut > end ? std::numeric_limits<double>::infinity()
                             : 1.25 * error * factor + rounding * epsilon};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLIPPED_LENGTH_H
