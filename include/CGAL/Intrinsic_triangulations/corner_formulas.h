// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORNER_FORMULAS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORNER_FORMULAS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/// returns the number \f$\pi\f$ with the digits of `FT`.
template <typename FT>
constexpr FT pi()
{
  if constexpr(std::is_floating_point_v<FT>)
    return FT(3.14159265358979323846264338327950288L);
  else
    return atan2(FT(0), FT(-1));
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns the angle at the corner opposite to side `a` of the triangle with sides `a`, `b`, `c`; 0
/// or \f$\pi\f$ in a flat triangle.
/// \tparam FT a floating point type
template <typename FT>
FT corner_angle(const FT& a, const FT& b, const FT& c)
{
  using std::atan2;
  return atan2(quadrupled_area(a, b, c), doubled_corner_product(a, b, c));
}

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns the cotangent of the angle at the corner opposite to side `a` of the triangle with sides
/// `a`, `b`, `c`.
/// \pre the triangle is not flat
template <typename FT>
FT corner_cotangent(const FT& a, const FT& b, const FT& c)
{
  return doubled_corner_product(a, b, c) / quadrupled_area(a, b, c);
}

namespace internal {

// Returns the smallest angle in degrees, opposite to the shortest side (Kahan's formula, stable for
// needles).
inline double smallest_angle(std::array<double, 3> sides)
{
  std::sort(sides.begin(), sides.end(), std::greater<double>());
  const auto [a, b, c] = sides;
  const double t = ((a - b) + c) / (a + (b + c)) * ((c - (a - b)) / ((a - c) + b));
  constexpr double degrees_per_radian = 57.295779513082320877;
  return t > 0 ? degrees_per_radian * 2 * std::atan(std::sqrt(t)) : 0;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORNER_FORMULAS_H
