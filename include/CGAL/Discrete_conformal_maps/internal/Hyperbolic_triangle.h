// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_HYPERBOLIC_TRIANGLE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_HYPERBOLIC_TRIANGLE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

// The corners of a hyperbolic triangle with sides x, given as l = sinh(x/2). Side s leads from corner s to the
// next.
//
// With the law of cosines, at the corner between sides b and c
//   2 l_b l_c cosh(x_b/2) cosh(x_c/2) cos(angle) = p + 2 l_b^2 l_c^2,   p = l_b^2 + l_c^2 - l_a^2,
// and the same with the sine is d, where d^2 is 16 times the squared area of the Euclidean triangle with sides
// l plus 4 (l_a l_b l_c)^2. No term cancels beyond what it does in that triangle, to which all tends where
// the sides are short.
template <typename FT>
struct Hyperbolic_corners
{
  explicit Hyperbolic_corners(const std::array<FT, 3>& l)
  {
    using std::sqrt;
    const FT volume = 2 * l[0] * l[1] * l[2];
    sine =
      sqrt(Intrinsic_triangulations::squared_quadrupled_area(l[0], l[1], l[2]) + volume * volume);
    for(std::size_t s = 0; s < 3; ++s) {
      const FT &b = l[s], &c = l[(s + 2) % 3], bc = b * c;
      product[s] = Intrinsic_triangulations::doubled_corner_product(l[(s + 1) % 3], b, c);
      cosine[s] = product[s] + 2 * bc * bc;
    }
  }

  FT sine;                   // d, the same at all corners
  std::array<FT, 3> product, // p
    cosine;                  // p + 2 l_b^2 l_c^2
};

// The angles of such a triangle.
template <typename FT>
class Hyperbolic_triangle
{
public:
  // whether scaling changes no angles
  static constexpr bool has_similar_ones = false;

  explicit Hyperbolic_triangle(const std::array<FT, 3>& l)
  {
    using std::atan2;
    const Hyperbolic_corners<FT> corner(l);
    const FT squares = l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
    const FT least = std::numeric_limits<FT>::epsilon() * squares;
    const FT divisor = corner.sine > least ? corner.sine : least;
    for(std::size_t s = 0; s < 3; ++s) {
      m_angle[s] = atan2(corner.sine, corner.cosine[s]);
      m_circle_angle[s] = atan2(corner.sine, corner.product[s]);
      m_cotangent[s] = corner.product[s] / divisor;
    }
    m_half_defect = atan2(corner.sine, FT(2 + squares));
    // twice that of a flat triangle: the derivatives have the additional factor 1 + tanh^2(x/2)
    m_error = 16 * std::numeric_limits<FT>::epsilon() * (1 + squares / divisor);
  }

  // at the source of side s
  const FT& angle(std::size_t s) const { return m_angle[s]; }

  // between the opposite side and the circle through the corners: (pi + a_s - a_t - a_u) / 2 for angles a
  const FT& circle_angle(std::size_t s) const { return m_circle_angle[s]; }

  // of the circle angle
  const FT& cotangent(std::size_t s) const { return m_cotangent[s]; }

  // of half of a side given as l
  static FT squared_tanh(const FT& l) { return l * l / (1 + l * l); }

  // half of pi less the sum of angles, which is the area
  const FT& half_defect() const { return m_half_defect; }

  // a bound for the rounding error of an angle, if the sides have an error of a few units in the last place
  const FT& angle_error() const { return m_error; }

private:
  std::array<FT, 3> m_angle, m_circle_angle, m_cotangent;
  FT m_half_defect, m_error;
};

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_HYPERBOLIC_TRIANGLE_H
