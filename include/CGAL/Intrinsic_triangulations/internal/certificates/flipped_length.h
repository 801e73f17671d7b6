// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLIPPED_LENGTH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLIPPED_LENGTH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// The relative error of the length of an edge of T1: it comes from less than ten roundings.
constexpr double input_length_error() { return 4 * std::numeric_limits<double>::epsilon(); }

// Returns how far the apex k of a triangle that is laid out along its side c is displaced if each
// side has a relative error of `error`, and infinity if that may not be small. A change of side a
// moves k along the circle around the end of b, by more than that change by the inverse of the sine
// of the angle at k, and so does a change of b or c. The bound is twice the sum, as the sine may
// change, too, and includes the rounding of the layout.
inline double apex_displacement(double a, double b, double c, double error)
{
  const double area = quadrupled_area(a, b, c), perimeter = a + b + c;
  const double change = error * perimeter;
  if(!(16 * change * (a + b) * a * b <= area * area))
    return std::numeric_limits<double>::infinity();
  return 4 * change * a * b / area + 32 * std::numeric_limits<double>::epsilon() * perimeter;
}

// a length with a bound for its relative error
struct Bounded_length
{
  double length, error;

  bool is_good() const { return error <= certified_length_error() / 2; }
};

// Returns the length of the other diagonal of a diamond whose sides have relative errors of at most
// `error`.
inline Bounded_length flipped_length(const Diamond<double>& length, double error)
{
  const double flipped = Euclidean_geometry_traits<double>::Compute_flipped_length()(length);
  return {flipped, (apex_displacement(length.jk, length.ki, length.ij, error) +
                    apex_displacement(length.il, length.lj, length.ij, error)) /
                     flipped};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_FLIPPED_LENGTH_H
