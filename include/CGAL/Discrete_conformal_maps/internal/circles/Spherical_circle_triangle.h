// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_SPHERICAL_CIRCLE_TRIANGLE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_SPHERICAL_CIRCLE_TRIANGLE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the angles of a spherical triangle with circles at its corners. A circle of angular
// radius R has the scaled radius r = tan R. Side s leads from corner s to the next corner. The
// formulas are the formulas of `Hyperbolic_triangle` with imaginary lengths. The notation is l =
// sin(x/2) for a side x, and D = 1 - cos R.
//
//   2 l_b l_c cos(x_b/2) cos(x_c/2) cos(angle) = q,
//   q = p - 2 l_b^2 l_c^2,   p = l_b^2 + l_c^2 - l_a^2.
//
// The same expression with the sine of the angle in place of the cosine is called d. Angles are a
// gradient with respect to w, where dw = cos R du. Consider the side l_c from corner i to j, and
// the third corner k. The derivative of the angle at i with respect to w_j is cot_k / (2
// cos^2(x_c/2)) for the number:
//
//   cot_k = (p_k + (D_i q_j + D_j q_i) / (2 l_c^2) - D_k (1 - l_c^2)) / d.
//
// The derivative with respect to w_i is minus the sum of cos x times this derivative over both
// sides at i.
template <typename FT>
class Spherical_circle_triangle
{
public:
  // `length` contains sin(x/2) for each side, and `depth` contains D for each corner.
  Spherical_circle_triangle(const std::array<FT, 3>& length, const std::array<FT, 3>& depth)
    : m_length(length), m_depth(depth)
  {
    using std::sqrt;
    const auto& l = m_length;
    const FT volume = 2 * l[0] * l[1] * l[2];
    const FT sine = sqrt(
      FT(Intrinsic_triangulations::squared_quadrupled_area(l[0], l[1], l[2]) - volume * volume));
    for(std::size_t s = 0; s < 3; ++s) {
      const FT &b = l[s], &c = l[(s + 2) % 3], bc = b * c;
      m_product[s] = Intrinsic_triangulations::doubled_corner_product(l[(s + 1) % 3], b, c);
      m_corner[s] = {m_product[s] - 2 * bc * bc, sine};
    }
  }

  // Returns whether the triangle has a positive area.
  bool exists() const { return m_corner[0].sine > 0; }

  // Returns sin(x/2) for side s.
  const FT& length(std::size_t s) const { return m_length[s]; }

  // Returns the corner at the source of side s.
  const Corner<FT>& corner(std::size_t s) const { return m_corner[s]; }

  // Returns the derivative of the angle at one end of side s with respect to the variable of the
  // other end.
  FT derivative(std::size_t s) const
  {
    const std::size_t j = (s + 1) % 3, k = (s + 2) % 3;
    const FT square = m_length[s] * m_length[s];
    const FT product =
      m_product[k] - m_depth[k] * (1 - square) +
      (m_depth[s] * m_corner[j].cosine + m_depth[j] * m_corner[s].cosine) / (2 * square);
    return product / (2 * (1 - square) * m_corner[0].sine);
  }

  // Returns cos x for side s.
  FT cosine_of_side(std::size_t s) const { return 1 - 2 * m_length[s] * m_length[s]; }

  // Returns 1 - cos R for a scaled radius tan R.
  static FT depth(const FT& r)
  {
    using std::sqrt;
    const FT inverse = sqrt(FT(1 + r * r)); // the inverse of the cosine
    return r * r / (inverse * (1 + inverse));
  }

private:
  std::array<FT, 3> m_length, m_depth, m_product;
  std::array<Corner<FT>, 3> m_corner;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_SPHERICAL_CIRCLE_TRIANGLE_H
