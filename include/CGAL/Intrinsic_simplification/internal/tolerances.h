// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOLERANCES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOLERANCES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_simplification::internal {

// This file contains every tolerance of the package, with its reason. Each is an angle or a
// relative number, so none depends on the unit of length.

inline double rounding_unit() { return Intrinsic_triangulations::rounding_unit<double>(); }

// Returns the part of a homogeneous coordinate of type `FT` that may be rounding error if a point
// reaches a vertex or an edge. The coordinates of a crossing are sums of a few products.
template <typename FT = double>
double rounding()
{
  return 16 * static_cast<double>(Intrinsic_triangulations::rounding_unit<FT>());
}

// Returns the rounding error of the sum of this number of angles. Each angle is rounded to a unit
// of 2 pi.
inline double angle_rounding(std::size_t number_of_angles)
{
  return rounding_unit() * 2 * Intrinsic_triangulations::pi<double>() *
         static_cast<double>(number_of_angles);
}

// Rounding of lengths changes the excess of angles as much as a change of the scale factor by this
// number of rounding units. A length is the product of two rounded numbers with half of the factor.
constexpr double roundings_of_scale = 4;

// If the excess of angles is at most this number, one more step of Newton's method squares it, and
// leaves about half of all digits. This suffices for a cost, which only determines the order of
// removals.
constexpr double nearly_flat = 1e-4;

// The last step of Newton's method may change the scale factor by at most this value. If a small
// excess hardly depends on the scale factor, it vanishes only in the limit of length zero.
constexpr double greatest_last_step = 0.1;

// This is the greatest length of a step of Newton's method. A longer step would multiply lengths by
// more than e^2, and the linear model is useless at such distances.
constexpr double greatest_newton_step = 4;

// Up to this squared tangent, six terms of the series of the arc tangent are exact up to rounding.
// The next term is at most 0.0036^6 / 13, or 1.7e-16, of the result.
constexpr double greatest_squared_tangent = 0.0036;

// A sum of a Laplace matrix up to this value can be rounding error, relative to the sum of all
// absolute values. Each entry is a sum of about ten numbers.
constexpr double matrix_rounding = 10 * std::numeric_limits<double>::epsilon();

// Lengths that follow from others by flips and scalings have at most this relative rounding error
// in triangle inequalities.
constexpr double length_rounding = 1e-12;

// The sum of the areas of the pieces of a face differs from the area of the face by at most this
// value. Each area has the rounding error of a product of one matrix for each operation. Slivers
// lose half of all digits.
constexpr double tiling_rounding = 1e-6;

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOLERANCES_H
