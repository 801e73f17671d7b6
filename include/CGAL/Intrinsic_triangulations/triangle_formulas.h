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
/// the one tolerance of the package: the relative error that a decision grants to every length. Zero for
/// exact number types; for floating point 16 units in the last place, while a length comes from fewer
/// than ten roundings.
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
/// \param extra is added to the slack \f$b + c - a\f$ of each of the three triangle inequalities
template <typename FT>
FT quadrupled_area(FT a, FT b, FT c, const FT& extra = FT(0))
{
  using std::swap;
  if(a < b)
    swap(a, b);
  if(b < c)
    swap(b, c);
  if(a < b)
    swap(a, b);
  const FT slack_a = c - (a - b) + extra, slack_b = c + (a - b) + extra,
           slack_c = a + (b - c) + extra;
  if(!(slack_a > 0) || !(slack_b > 0))
    return FT(0);
  return CGAL::sqrt((a + (b + c)) * slack_a * slack_b * slack_c);
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
