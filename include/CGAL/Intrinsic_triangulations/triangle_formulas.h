// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGLE_FORMULAS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGLE_FORMULAS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/number_utils.h>

#include <limits>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// the one tolerance of the package: a bound, relative to the terms that are added up, for the rounding
/// of the formulas in a triangle. Zero for exact number types; for floating point 16 units in the last
/// place, while the formulas take fewer than ten roundings each.
template <typename FT>
constexpr FT rounding_unit()
{
  if constexpr(std::numeric_limits<FT>::is_specialized && !std::numeric_limits<FT>::is_exact)
    return 16 * std::numeric_limits<FT>::epsilon();
  else
    return FT(0);
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// four times the area of the triangle with sides `a`, `b`, `c`, by Kahan's form of Heron's formula,
/// which loses no digits on needles. A triangle that rounding has pressed beyond flat counts as flat.
template <typename FT>
FT quadrupled_area(FT a, FT b, FT c)
{
  using std::swap;
  if(a < b) swap(a, b);
  if(b < c) swap(b, c);
  if(a < b) swap(a, b);
  const FT slack = c - (a - b);
  if(!(slack > 0))
    return FT(0);
  return CGAL::sqrt((a + (b + c)) * slack * (c + (a - b)) * (a + (b - c)));
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// the position of the foot of the height over the side `ij`, measured from the midpoint of that side
/// towards \f$j\f$.
template <typename FT>
FT foot(const FT& ij, const FT& jk, const FT& ki)
{
  return (ki - jk) * (ki + jk) / (2 * ij);
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// the height of the triangle over its side `ij`.
template <typename FT>
FT height(const FT& ij, const FT& jk, const FT& ki)
{
  return quadrupled_area(ij, jk, ki) / (2 * ij);
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGLE_FORMULAS_H
