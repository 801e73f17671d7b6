// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLIPPED_LENGTH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLIPPED_LENGTH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Bounds the relative error of the length of an edge of T1, which results from less than ten
// roundings.
constexpr double input_length_error() { return 4 * std::numeric_limits<double>::epsilon(); }

// Stores a length with a bound for its relative error.
struct Bounded_length
{
  double length, error;

  bool is_good() const { return error <= certified_length_error(); }
};

// Stores a triangle of a diamond over the diagonal ij, with the corner k.
struct Half_diamond
{
  double perimeter, slack; // the least slack of the triangle inequalities
  double height, foot;     // the squared height over ij, and its foot, both scaled

  Half_diamond(double ij, double jk, double ki)
    : perimeter(ij + jk + ki),
      slack(perimeter - 2 * (std::max)({ij, jk, ki})),
      height(squared_quadrupled_area(ij, jk, ki)),
      foot(scaled_foot(jk, ki))
  {}
};

// Computes the error of the other diagonal kl of a diamond whose lengths have relative errors of at
// most `error`.
//
// Consider four points of the plane with the affine dependency a_i p_i + ... = 0. The products a_i
// a_j are an equilibrium stress. So the sum of a_i a_j l_ij dl_ij over all six distances is zero.
// All terms except a_k a_l l_kl dl_kl are bounded by the errors of their lengths. Their sum,
// divided by a_k a_l l_kl^2, bounds the relative error of l_kl. The crossing of the diagonals cuts
// ij in the ratio of a_j to a_i. It cuts kl in the ratio of a_l to a_k, which is the ratio of the
// heights over ij.
class Flipped_diagonal
{
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();

public:
  Flipped_diagonal(const Diamond<double>& length, const Diamond<double>& error)
    : m_length(length),
      m_flipped(Euclidean_geometry_traits<double>::Compute_flipped_length()(length)),
      m_error(error),
      m_change((std::max)({error.ij, error.jk, error.ki, error.il, error.lj}) + 4 * epsilon),
      m_k(length.ij, length.jk, length.ki),
      m_l(length.ij, length.lj, length.il),
      m_root(std::sqrt(m_k.height * m_l.height)),
      m_squares(length.jk * length.jk + length.ki * length.ki + length.il * length.il +
                length.lj * length.lj),
      m_inverse_slack(1 / (m_k.slack * m_l.slack)),
      m_cut((m_k.foot * m_root + m_l.foot * m_k.height) / (2 * (m_k.height + m_root)))
  {}

  // Returns whether the angle of the diamond at j is less than pi: kl crosses ij before j.
  Uncertain<bool> is_convex_at_target() const
  {
    const double rest = end() - m_cut, bound = shift();
    return !has_certain_areas() ? Uncertain<bool>::indeterminate()
           : rest > bound       ? Uncertain<bool>(true)
           : rest < -bound      ? Uncertain<bool>(false)
                                : Uncertain<bool>::indeterminate();
  }

  // Returns the length of the other diagonal. The bound is infinite if the error may not be small.
  // This function has few quotients, because the loop of flips calls it.
  Bounded_length operator()() const
  {
    const double square = 4 * (m_length.ij * m_length.ij) * (m_flipped * m_flipped);
    if(!(has_certain_areas() && m_root * square > 0))
      return {m_flipped, std::numeric_limits<double>::infinity()};
    const double inverse = 1 / (m_root * square);
    return {m_flipped, 5 * propagated_errors() * inverse + rounding(inverse) * epsilon};
  }

private:
  // The squared area of a triangle changes by at most three errors of its perimeter over its slack,
  // here a hundredth.
  bool has_certain_areas() const
  {
    return 256 * m_change * m_k.perimeter <= m_k.slack &&
           256 * m_change * m_l.perimeter <= m_l.slack &&
           32 * m_change * m_squares <= m_length.ij * m_length.ij;
  }

  double heights() const { return m_k.height + m_l.height + 2 * m_root; }
  double thinness_of_k() const { return m_k.perimeter * m_l.slack * m_inverse_slack; }
  double thinness_of_l() const { return m_l.perimeter * m_k.slack * m_inverse_slack; }

  // Returns the position of j, from the midpoint of ij, times the length of ij.
  double end() const { return m_length.ij * m_length.ij / 2; }

  // Returns a bound for the change of the position where kl cuts ij. It divides the distance of the
  // feet in the ratio of the heights. It changes by the error of the feet and by the error of this
  // ratio times their distance.
  double shift() const
  {
    const double thinness = thinness_of_k() + thinness_of_l();
    return 4 * m_change *
           (m_squares + thinness * std::abs(m_k.foot - m_l.foot) * m_root / heights());
  }

  // Returns a bound for the sum of the five products, times the product of the heights.
  double propagated_errors() const
  {
    if(std::abs(m_cut) > end())
      return std::numeric_limits<double>::infinity();
    const double bound = shift(), i = end() - m_cut + bound, j = end() + m_cut + bound;
    const auto product = [](double length, double error) { return length * length * error; };
    return heights() * i * j * m_error.ij +
           (m_root + m_l.height) *
             (j * product(m_length.jk, m_error.jk) + i * product(m_length.ki, m_error.ki)) +
           (m_root + m_k.height) *
             (i * product(m_length.il, m_error.il) + j * product(m_length.lj, m_error.lj));
  }

  // Rounding errors of the formula itself are small changes of the distance of the feet and of
  // both heights.
  double rounding(double inverse) const
  {
    const double sides =
      (m_length.jk + m_length.ki + m_length.il + m_length.lj) * (std::min)(m_length.ij, m_flipped);
    return 8 + ((m_k.height + m_root) * (thinness_of_k() + 4) +
                (m_l.height + m_root) * (thinness_of_l() + 4) + sides * sides) *
                 (m_root * inverse);
  }

  Diamond<double> m_length;
  double m_flipped;
  Diamond<double> m_error;
  double m_change;
  Half_diamond m_k, m_l;
  double m_root, m_squares, m_inverse_slack;
  double m_cut; // where kl crosses ij, from its midpoint, times its length
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLIPPED_LENGTH_H
