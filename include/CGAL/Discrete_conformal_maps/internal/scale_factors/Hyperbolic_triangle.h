// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_HYPERBOLIC_TRIANGLE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_HYPERBOLIC_TRIANGLE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// A hyperbolic triangle with sides x, given as l = sinh(x/2). Side s leads from corner s to the
// next.
//
// With the law of cosines, at the corner between sides b and c:
//
//   2 l_b l_c cosh(x_b/2) cosh(x_c/2) cos(angle) = p + 2 l_b^2 l_c^2,   p = l_b^2 + l_c^2 - l_a^2,
//
// With the sine in place of the cosine, the left side is d. Here d^2 is 16 times the squared area
// of the Euclidean triangle with sides l, plus 4 (l_a l_b l_c)^2. No term cancels more than in that
// triangle, which is the limit for short sides.
template <typename FT>
class Hyperbolic_triangle
{
public:
  // whether scaling changes no angles
  static constexpr bool has_similar_ones = false;

  explicit Hyperbolic_triangle(const std::array<FT, 3>& l)
    : m_squares(l[0] * l[0] + l[1] * l[1] + l[2] * l[2])
  {
    using std::sqrt;
    const FT volume = 2 * l[0] * l[1] * l[2];
    const FT sine =
      sqrt(Intrinsic_triangulations::squared_quadrupled_area(l[0], l[1], l[2]) + volume * volume);
    for(std::size_t s = 0; s < 3; ++s) {
      const FT &b = l[s], &c = l[(s + 2) % 3], bc = b * c;
      m_product[s] = Intrinsic_triangulations::doubled_corner_product(l[(s + 1) % 3], b, c);
      m_corner[s] = {m_product[s] + 2 * bc * bc, sine};
    }
  }

  // at the source of side s
  const Corner<FT>& corner(std::size_t s) const { return m_corner[s]; }
  FT angle(std::size_t s) const { return m_corner[s].angle(); }

  // between the opposite side and the circle through the corners: (pi + a_s - a_t - a_u) / 2 for
  // angles a
  FT circle_angle(std::size_t s) const { return Corner<FT>{m_product[s], sine()}.angle(); }

  // Of the circle angle. It only leads to a minimum: for a flat triangle it may be any large
  // number
  FT cotangent(std::size_t s) const { return m_product[s] / divisor(); }

  // of half of a side given as l
  static FT squared_tanh(const FT& l) { return l * l / (1 + l * l); }

  // half of pi less the sum of angles, which is the area
  FT half_defect() const { return Corner<FT>{2 + m_squares, sine()}.angle(); }

  // whether there is no triangle inside its longest side
  bool is_flat() const { return !(sine() > 0); }

  // A bound for the rounding error of an angle, if the sides have an error of a few units in the
  // last place. It is twice the bound of a flat triangle, since derivatives have the additional
  // factor 1 + tanh^2(x/2).
  FT angle_error() const
  {
    return 16 * std::numeric_limits<FT>::epsilon() * (1 + m_squares / divisor());
  }

private:
  const FT& sine() const { return m_corner[0].sine; }

  FT divisor() const
  {
    return (std::max)(sine(), FT(std::numeric_limits<FT>::epsilon() * m_squares));
  }

  std::array<Corner<FT>, 3> m_corner;
  std::array<FT, 3> m_product; // p
  FT m_squares;                // the sum of all l^2
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_HYPERBOLIC_TRIANGLE_H
