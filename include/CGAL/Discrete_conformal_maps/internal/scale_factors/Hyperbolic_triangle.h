// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_HYPERBOLIC_TRIANGLE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_HYPERBOLIC_TRIANGLE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the angles of a hyperbolic triangle with sides x, given as l = sinh(x/2). Side s leads
// from corner s to the next.
//
// The law of cosines holds at the corner between sides b and c:
//
//   2 l_b l_c cosh(x_b/2) cosh(x_c/2) cos(angle) = p + 2 l_b^2 l_c^2,   p = l_b^2 + l_c^2 - l_a^2,
//
// With the sine instead of the cosine, the left side is d. Here d^2 is 16 times the squared area of
// the Euclidean triangle with sides l, plus 4 (l_a l_b l_c)^2. No term cancels more than in that
// triangle, which is the limit for short sides. Between centers of circles, this triangle need not
// exist.
//
// With circles at the corners, sides join their centers. A circle of hyperbolic radius R has the
// scaled radius r with tanh R = 2 r. Angles are not a gradient with respect to scale factors u, but
// with respect to w, where dw = cosh R du. This yields w = log tanh(R/2) up to a constant, and w =
// u if r = 0. Consider the side l_c = sinh(x_c/2) from corner i to j, and the third corner k. Let C
// be cosh R - 1, and q = p + 2 l_a^2 l_b^2, proportional to the cosine at the corner. The
// derivative of the angle at i by w_j is cot_k / (2 cosh^2(x_c/2)) for this number:
//
//   cot_k = (p_k + (C_i q_j + C_j q_i) / (2 l_c^2) - C_k (1 + l_c^2)) / d.
//
// Its derivative by w_i is minus the sum, over both sides at i, of cosh x times this derivative.
template <typename FT>
class Hyperbolic_triangle
{
  typedef Intrinsic_triangulations::Decorated_length<FT> Decorated_length;

public:
  // States whether scaling preserves all angles.
  static constexpr bool has_similar_ones = false;

  explicit Hyperbolic_triangle(const std::array<FT, 3>& l)
    : m_squares(l[0] * l[0] + l[1] * l[1] + l[2] * l[2])
  {
    using std::sqrt;
    const FT sine = sqrt(squared_sine(l));
    for(std::size_t s = 0; s < 3; ++s) {
      const FT &b = l[s], &c = l[(s + 2) % 3], bc = b * c;
      m_product[s] = Intrinsic_triangulations::doubled_corner_product(l[(s + 1) % 3], b, c);
      m_corner[s] = {m_product[s] + 2 * bc * bc, sine};
    }
  }

  Hyperbolic_triangle(const Decorated_length& ij, const Decorated_length& jk,
                      const Decorated_length& ki)
    : Hyperbolic_triangle({length(ij), length(jk), length(ki)})
  {
    const std::array<FT, 3> excess{cosh_excess(ij.source_radius), cosh_excess(jk.source_radius),
                                   cosh_excess(ki.source_radius)};
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const Decorated_length& side = k == 0 ? jk : k == 1 ? ki : ij;
      const FT l = length(side), square = l * l;
      m_product[k] +=
        (excess[i] * m_corner[j].cosine + excess[j] * m_corner[i].cosine) / (2 * square) -
        excess[k] * (1 + square);
    }
  }

  // Returns the length between the centers of circles.
  static FT length(const Decorated_length& edge) { return edge.hyperbolic_length(); }

  // Returns the logarithmic scale factor u for a variable w of the energy, of a circle of this
  // radius. It is NaN if no circle is that large.
  static FT log_scale(const FT& variable, const FT& radius)
  {
    using std::exp;
    using std::log;
    const FT tanh = radius * exp(variable); // of R/2
    return tanh < 1 ? FT(variable - log(FT(1 + tanh * tanh)))
                    : FT(std::numeric_limits<double>::quiet_NaN());
  }

  // Returns the variable, by the inverse of log_scale().
  static FT variable(const FT& log_scale, const FT& radius)
  {
    using std::exp;
    using std::log;
    using std::sqrt;
    const FT r = radius * exp(log_scale);
    return log_scale - log(FT((1 + sqrt(FT((1 - 2 * r) * (1 + 2 * r)))) / 2));
  }

  // Returns the corner at the source of side s.
  const Corner<FT>& corner(std::size_t s) const { return m_corner[s]; }
  FT angle(std::size_t s) const { return m_corner[s].angle(); }

  // Returns the angle between the opposite side and the circle through the corners. It is (pi + a_s
  // - a_t - a_u) / 2 for angles a.
  FT circle_angle(std::size_t s) const { return Corner<FT>{m_product[s], sine()}.angle(); }

  // Returns the cotangent of the circle angle. It only leads to a minimum: for a flat triangle it
  // may be any large number.
  FT cotangent(std::size_t s) const { return m_product[s] / divisor(); }

  // Returns the squared hyperbolic tangent of half of a side given as l.
  static FT squared_tanh(const FT& l) { return l * l / (1 + l * l); }

  // Returns half of pi minus the sum of angles, which is the area.
  FT half_defect() const { return Corner<FT>{2 + m_squares, sine()}.angle(); }

  // Returns whether the triangle is contained in its longest side.
  bool is_flat() const { return !(sine() > 0); }

  // Returns a bound for the rounding error of an angle, if the sides have an error of a few units
  // in the last place. It is twice the bound of a flat triangle, because derivatives have the
  // additional factor 1 + tanh^2(x/2).
  FT angle_error() const
  {
    return 16 * std::numeric_limits<FT>::epsilon() * (1 + m_squares / divisor());
  }

private:
  // Returns d^2, or zero if the triangle inequality is violated.
  static FT squared_sine(const std::array<FT, 3>& l)
  {
    const FT squared_area = Intrinsic_triangulations::squared_quadrupled_area(l[0], l[1], l[2]),
             volume = 2 * l[0] * l[1] * l[2];
    return squared_area > 0 ? FT(squared_area + volume * volume)
                            : squared_sine_without_Euclidean_triangle(l);
  }

  // Returns d^2 by the hyperbolic formula of Heron, the product of sinh s, sinh(s - x_a), sinh(s -
  // x_b) and sinh(s - x_c) for half the perimeter s. The first factor is multiplied with the third,
  // and the second with the fourth.
  static FT squared_sine_without_Euclidean_triangle(std::array<FT, 3> l)
  {
    using std::sqrt;
    std::sort(l.begin(), l.end());
    const auto& [b, c, a] = l;
    const FT sum = a * sqrt(FT(1 + c * c)) + c * sqrt(FT(1 + a * a)), // sinh((x_a + x_c) / 2)
      difference = (a - c) * ((a + c) / sum),                         // sinh((x_a - x_c) / 2)
      slack = b - difference;
    return slack > 0 ? FT((sum - b) * (sum + b) * slack * (b + difference)) : FT(0);
  }

  // Returns cosh R - 1 for a scaled radius r with 2 r = tanh R.
  static FT cosh_excess(const FT& r)
  {
    using std::sqrt;
    const FT inverse = sqrt(FT((1 - 2 * r) * (1 + 2 * r)));
    return 4 * (r * r) / (inverse * (1 + inverse));
  }

  const FT& sine() const { return m_corner[0].sine; }

  FT divisor() const
  {
    return (std::max)(sine(), FT(std::numeric_limits<FT>::epsilon() * m_squares));
  }

  std::array<Corner<FT>, 3> m_corner;
  std::array<FT, 3> m_product; // p, or with circles the product of d with the derivatives cot
  FT m_squares;                // the sum of all l^2
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_HYPERBOLIC_TRIANGLE_H
