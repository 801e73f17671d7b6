// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_TRIANGLE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_TRIANGLE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Extended.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the sides in a unit, a power of two, that keeps fourth powers in the range of the number
// type.
template <typename FT>
std::array<FT, 3> in_range(const std::array<FT, 3>& side)
{
  using std::ldexp;
  const int exponent = exponent_of((std::max)({side[0], side[1], side[2]}));
  if(std::abs(exponent) < std::numeric_limits<double>::max_exponent / 8)
    return side;
  return {ldexp(side[0], -exponent), ldexp(side[1], -exponent), ldexp(side[2], -exponent)};
}

// The angles of a Euclidean triangle. Side s leads from corner s to the next. Lengths that violate
// the triangle inequality have the limits of angles: pi opposite to the longest, zero elsewhere.
template <typename FT>
class Flat_triangle
{
public:
  // whether scaling changes no angles
  static constexpr bool has_similar_ones = true;

  explicit Flat_triangle(const std::array<FT, 3>& lengths)
  {
    using std::sqrt;
    const std::array<FT, 3> side = in_range(lengths);
    const FT area =
      sqrt(Intrinsic_triangulations::squared_quadrupled_area(side[0], side[1], side[2]));
    m_is_flat = !(area > 0);
    const FT squares = side[0] * side[0] + side[1] * side[1] + side[2] * side[2];
    const FT least = std::numeric_limits<FT>::epsilon() * squares;
    for(std::size_t s = 0; s < 3; ++s) {
      const FT product = Intrinsic_triangulations::doubled_corner_product(
        side[(s + 1) % 3], side[(s + 2) % 3], side[s]);
      m_corner[s] = {product, area};
      // cotangents only lead the way to a minimum: those of a flat triangle may be any large number
      m_cotangent[s] = product / (area > least ? area : least);
    }
    // A relative error e of sides moves an angle by 2 e times the sum of the cotangents or less.
    m_error = 8 * std::numeric_limits<FT>::epsilon() * squares / (area > least ? area : least);
    // It moves a cosine by at most 2 e times that of the squares of the sides by the product of the
    // two at the corner, and an angle near zero or pi by no more than the root of twice that.
    if(area * area < 2 * least * squares)
      m_error = (std::min)(m_error, root_error(side, least));
  }

  // at the source of side s
  const Corner<FT>& corner(std::size_t s) const { return m_corner[s]; }
  FT angle(std::size_t s) const { return m_corner[s].angle(); }
  // between the opposite side and the circle through the corners
  FT circle_angle(std::size_t s) const { return angle(s); }
  const FT& cotangent(std::size_t s) const { return m_cotangent[s]; }
  // half of pi less the sum of angles
  FT half_defect() const { return FT(0); }
  // of half a side in proportion to the radius of curvature
  static FT squared_tanh(const FT& /* length */) { return FT(0); }
  // the derivative of the angle at corner s by a logarithmic scale factor there, which multiplies
  // both its sides by e^(u/2); by one at another corner, it is half the cotangent at the third
  FT angle_derivative(std::size_t s) const
  {
    return -(m_cotangent[(s + 1) % 3] + m_cotangent[(s + 2) % 3]) / 2;
  }

  // whether there is no triangle inside its longest side
  bool is_flat() const { return m_is_flat; }

  // a bound for the rounding error of an angle, if the sides have an error of a few units in the
  // last place
  const FT& angle_error() const { return m_error; }

private:
  static FT root_error(const std::array<FT, 3>& side, const FT& least)
  {
    using std::sqrt;
    const FT longest = (std::max)({side[0], side[1], side[2]});
    return sqrt(FT(32 * least / (side[0] * side[1] * side[2] / longest)));
  }

  std::array<Corner<FT>, 3> m_corner;
  std::array<FT, 3> m_cotangent;
  FT m_error;
  bool m_is_flat;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_TRIANGLE_H
