// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGLE_FORMULAS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGLE_FORMULAS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <typename FT>
constexpr FT power_of_two(int exponent)
{
  FT result(1);
  for(int i = 0; i < exponent; ++i)
    result *= 2;
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns 16 times the squared area of the triangle with sides `a`, `b`, `c`. It uses Kahan's
/// form of Heron's formula, which loses no digits on needles. If rounded lengths violate the
/// triangle inequality, the result is zero.
template <typename FT>
inline FT squared_quadrupled_area(const FT& a, const FT& b, const FT& c)
{
  const FT p = (std::max)(a, b), q = (std::min)(a, b), r = (std::min)(p, c);
  const FT greatest = (std::max)(p, c), middle = (std::max)(q, r), least = (std::min)(q, r);
  const FT slack = least - (greatest - middle);
  return (greatest + (middle + least)) * (slack > 0 ? slack : FT(0)) *
         (least + (greatest - middle)) * (greatest + (middle - least));
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns four times the area of the triangle with sides `a`, `b`, `c`.
template <typename FT>
FT quadrupled_area(const FT& a, const FT& b, const FT& c)
{
  using CGAL::sqrt; // or the one of `FT`
  return sqrt(squared_quadrupled_area(a, b, c));
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns the position of the foot of the height over a side \f$ij\f$, times twice the length of
/// the side. It is measured from the midpoint of that side towards \f$j\f$. The height times twice
/// the length is `quadrupled_area()`.
template <typename FT>
FT scaled_foot(const FT& jk, const FT& ki)
{
  return (ki - jk) * (ki + jk);
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns the length of a vector in a triangle whose side `s` leads from corner `s` to the next
/// and has length `side[s]`. The vector has barycentric coordinates `w`, whose sum is zero. This is
/// Equation 3.7, evaluated along the longest side and across it, so that thin triangles lose no
/// digits.
template <typename FT>
FT vector_length(const std::array<FT, 3>& side, const std::array<FT, 3>& w)
{
  const std::size_t a =
    static_cast<std::size_t>(std::max_element(side.begin(), side.end()) - side.begin());
  const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
  const FT doubled_foot = side[a] + scaled_foot(side[b], side[c]) / side[a];
  const FT along = w[b] * side[a] + w[c] * doubled_foot / 2;
  const FT across = w[c] * quadrupled_area(side[0], side[1], side[2]) / (2 * side[a]);
  return CGAL::sqrt(along * along + across * across);
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns twice the scalar product of the two sides at the corner opposite to side `a` of a
/// triangle. This is \f$b^2 + c^2 - a^2\f$ without its cancellation.
template <typename FT>
FT doubled_corner_product(const FT& a, const FT& b, const FT& c)
{
  const FT shorter = (std::min)(b, c);
  return shorter * shorter + scaled_foot(a, (std::max)(b, c));
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns the cosine of the corner opposite to side `a` of the triangle with sides `a`, `b`, `c`.
/// If rounding violates the triangle inequality, the corner is flat or zero.
template <typename FT>
FT corner_cosine(const FT& a, const FT& b, const FT& c)
{
  const FT cosine = doubled_corner_product(a, b, c) / (2 * b * c);
  return cosine < -1 ? FT(-1) : cosine > 1 ? FT(1) : cosine;
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns the sine of the corner opposite to side `a` of the triangle with sides `a`, `b`, `c`.
template <typename FT>
FT corner_sine(const FT& a, const FT& b, const FT& c)
{
  return quadrupled_area(b, c, a) / (2 * b * c);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGLE_FORMULAS_H
