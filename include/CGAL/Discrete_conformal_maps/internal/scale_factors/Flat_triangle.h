// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_TRIANGLE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_TRIANGLE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>
#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the exponent of a unit for numbers as great as `size`. The unit is a power of two that
// keeps fourth powers in the range of the number type. It is zero for usual numbers.
template <typename FT>
int exponent_of_unit(const FT& size)
{
  const int exponent = exponent_of(size);
  return std::abs(exponent) < std::numeric_limits<double>::max_exponent / 8 ? 0 : exponent;
}

// Returns the sides in a unit that keeps fourth powers in range.
template <typename FT>
std::array<FT, 3> in_range(const std::array<FT, 3>& side)
{
  using std::ldexp;
  const int exponent = exponent_of_unit(FT((std::max)({side[0], side[1], side[2]})));
  if(exponent == 0)
    return side;
  return {ldexp(side[0], -exponent), ldexp(side[1], -exponent), ldexp(side[2], -exponent)};
}
template <typename FT>
std::array<Intrinsic_triangulations::Decorated_length<FT>, 3>
in_range(std::array<Intrinsic_triangulations::Decorated_length<FT>, 3> side)
{
  using std::ldexp;
  const int exponent =
    exponent_of_unit(FT((std::max)({side[0].length(), side[1].length(), side[2].length()})));
  if(exponent != 0)
    for(auto& s : side)
      s = {ldexp(s.tangent, -exponent), ldexp(s.source_radius, -exponent),
           ldexp(s.target_radius, -exponent)};
  return side;
}

// Computes the angles of a Euclidean triangle. Side s leads from corner s to the next. Lengths that
// violate the triangle inequality have the limits of angles: pi opposite to the longest, zero
// elsewhere. With circles at the corners, the cotangents are twice the heights of the power center
// over the opposite sides, divided by these sides. They are the derivatives of angles by scale
// factors.
template <typename FT>
class Flat_triangle
{
  typedef Intrinsic_triangulations::Decorated_length<FT> Decorated_length;

public:
  // States whether scaling preserves all angles.
  static constexpr bool has_similar_ones = true;

  // Returns the logarithmic scale factor of a circle of this radius, for a variable of the energy.
  static const FT& log_scale(const FT& variable, const FT& /* radius */) { return variable; }

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
      // Cotangents only lead to a minimum, so cotangents of a flat triangle may be any large
      // number.
      m_cotangent[s] = product / (area > least ? area : least);
    }
    // A relative error e of sides moves an angle by at most 2 e times the sum of the cotangents.
    m_error = 8 * std::numeric_limits<FT>::epsilon() * squares / (area > least ? area : least);
    // An error e moves a cosine by at most 2 e times a quotient. The quotient is the sum of squares
    // of the sides over the product of the two sides at the corner. It moves an angle near zero or
    // pi by at most the root of twice this value.
    if(area * area < 2 * least * squares)
      m_error = (std::min)(m_error, root_error(side, least));
  }

  Flat_triangle(const Decorated_length& ij, const Decorated_length& jk, const Decorated_length& ki)
  {
    using std::sqrt;
    const std::array<Decorated_length, 3> side = in_range(std::array{ij, jk, ki});
    const std::array<FT, 3> length{side[0].length(), side[1].length(), side[2].length()};
    const std::array<FT, 3> slack{slack_at(0, side, length), slack_at(1, side, length),
                                  slack_at(2, side, length)};
    const FT perimeter = length[0] + length[1] + length[2];
    const FT area = sqrt(FT((perimeter * slack[0]) * (slack[1] * slack[2])));
    m_is_flat = !(area > 0);
    const FT squares = length[0] * length[0] + length[1] * length[1] + length[2] * length[2];
    const FT least = std::numeric_limits<FT>::epsilon() * squares;
    const FT divisor = area > least ? area : least;
    for(std::size_t s = 0; s < 3; ++s) {
      const std::size_t i = (s + 1) % 3, j = (s + 2) % 3;
      m_corner[s] = {(perimeter * slack[s] - slack[i] * slack[j]) / 2, area};
      const FT height =
        Intrinsic_triangulations::internal::height_over(side[i], side[s].gram(), side[j].gram()) -
        side[i].determinant();
      m_cotangent[s] = 4 * height / (length[i] * length[i]) / divisor;
    }
    m_error = 8 * std::numeric_limits<FT>::epsilon() * squares / divisor;
    if(area * area < 2 * least * squares)
      m_error = (std::min)(m_error, root_error(length, least));
  }

  // Returns the distance between the centers of circles.
  static FT length(const Decorated_length& edge) { return edge.length(); }

  // Returns the corner at the source of side s.
  const Corner<FT>& corner(std::size_t s) const { return m_corner[s]; }
  FT angle(std::size_t s) const { return m_corner[s].angle(); }
  // Returns the angle between the opposite side and the circle through the corners.
  FT circle_angle(std::size_t s) const { return angle(s); }
  const FT& cotangent(std::size_t s) const { return m_cotangent[s]; }
  // Returns half of pi minus the sum of angles.
  FT half_defect() const { return FT(0); }
  // Returns the squared hyperbolic tangent of half a side, relative to the radius of curvature.
  static FT squared_tanh(const FT& /* length */) { return FT(0); }

  // Returns whether the triangle is contained in its longest side.
  bool is_flat() const { return m_is_flat; }

  // Returns a bound for the rounding error of an angle, if the sides have an error of a few units
  // in the last place.
  const FT& angle_error() const { return m_error; }

private:
  // Returns the excess of the sum of both sides at corner s over the third, or zero if it is
  // negative. The two other radii cancel: only the excesses of sides over the sums of their radii
  // count.
  static FT slack_at(std::size_t s, const std::array<Decorated_length, 3>& side,
                     const std::array<FT, 3>& length)
  {
    const auto excess = [&](std::size_t a) {
      const FT& t = side[a].tangent;
      return t == 0 ? FT(0)
                    : FT(t * (t / (length[a] + (side[a].source_radius + side[a].target_radius))));
    };
    const FT a = excess(s), b = excess((s + 2) % 3), facing = excess((s + 1) % 3);
    const FT slack = 2 * side[s].source_radius + ((std::min)(a, b) + ((std::max)(a, b) - facing));
    return slack > 0 ? slack : FT(0);
  }

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
