// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DELAUNAY_FILTER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DELAUNAY_FILTER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns a quotient of two numbers. It is NaN, zero or infinite beyond the range of `double`.
template <typename FT>
double rounded_quotient(const FT& x, const FT& y)
{
  return static_cast<double>(x) / static_cast<double>(y);
}

// Decides in `double` whether an edge satisfies the local ideal Delaunay condition for lengths with
// more digits, see `Ideal_geometry_traits::Is_locally_Delaunay`. Each side of the condition has a
// relative error of a few units. The filter fails if both sides are closer than 10^-14, or if
// quotients of lengths may exceed the range of `double`.
template <typename FT>
class Delaunay_filter
{
  template <typename Number>
  using Decorated_length = Intrinsic_triangulations::Decorated_length<Number>;

public:
  // States whether the number type has more digits than `double`.
  static constexpr bool is_useful =
    std::numeric_limits<FT>::is_specialized && !std::numeric_limits<FT>::is_exact &&
    std::numeric_limits<FT>::digits > std::numeric_limits<double>::digits;

  static Uncertain<bool> is_Delaunay(const Intrinsic_triangulations::Diamond<FT>& length)
  {
    const double jk = rounded_quotient(length.jk, length.ij),
                 ki = rounded_quotient(length.ki, length.ij),
                 il = rounded_quotient(length.il, length.ij),
                 lj = rounded_quotient(length.lj, length.ij);
    const auto [least, greatest] = std::minmax({jk, ki, il, lj});
    if(!(least > 1 / greatest_quotient && greatest < greatest_quotient))
      return Uncertain<bool>::indeterminate();
    return is_not_greater(1 / (jk * ki) + 1 / (il * lj), jk / ki + ki / jk + il / lj + lj / il);
  }

  // Decides the weighted condition, see `Hyperideal_geometry_traits::Is_locally_Delaunay`. Both
  // sides are sums of positive terms of degree seven. Bounds on the Gram coordinates exclude that
  // the greatest terms leave the range of `double`.
  static Uncertain<bool>
  is_Delaunay(const Intrinsic_triangulations::Diamond<Decorated_length<FT>>& edges)
  {
    const FT unit = edges.ij.tangent + (edges.ij.source_radius + edges.ij.target_radius);
    const auto rounded = [&unit](const Decorated_length<FT>& edge) {
      return Decorated_length<double>{rounded_quotient(edge.tangent, unit),
                                      rounded_quotient(edge.source_radius, unit),
                                      rounded_quotient(edge.target_radius, unit)};
    };
    const Intrinsic_triangulations::Diamond<Decorated_length<double>> quotients{
      rounded(edges.ij), rounded(edges.jk), rounded(edges.ki), rounded(edges.il),
      rounded(edges.lj)};
    for(const auto& edge : {quotients.jk, quotients.ki, quotients.il, quotients.lj})
      if(!(edge.gram() > 1 / greatest_gram && edge.excess() < greatest_gram &&
           edge.source_radius + edge.target_radius < greatest_gram))
        return Uncertain<bool>::indeterminate();
    const auto condition =
      Intrinsic_triangulations::internal::Decorated_diamond<double>(quotients).condition();
    return is_not_greater(condition.inner, condition.outer);
  }

private:
  static constexpr double greatest_quotient = 0x1p250, greatest_gram = 0x1p40, error = 1e-14;

  static Uncertain<bool> is_not_greater(double inner, double outer)
  {
    return inner < outer * (1 - error)   ? Uncertain<bool>(true)
           : inner > outer * (1 + error) ? Uncertain<bool>(false)
                                         : Uncertain<bool>::indeterminate();
  }
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DELAUNAY_FILTER_H
