// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORNER_FORMULAS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORNER_FORMULAS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace CGAL::Intrinsic_triangulations {

/// the number \f$\pi\f$: `pi<FT>()`.
using boost::math::constants::pi;

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// returns the angle at the corner opposite to side `a` of the triangle with sides `a`, `b`, `c`; 0
/// or \f$\pi\f$ in a flat triangle.
/// \tparam FT a floating point type
template <typename FT>
FT corner_angle(const FT& a, const FT& b, const FT& c)
{
  return std::atan2(quadrupled_area(a, b, c), doubled_corner_product(a, b, c));
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

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORNER_FORMULAS_H
