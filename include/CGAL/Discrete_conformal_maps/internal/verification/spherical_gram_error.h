// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_SPHERICAL_GRAM_ERROR_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_SPHERICAL_GRAM_ERROR_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Intrinsic_triangulations/Decorated_length.h>

#include <array>
#include <cmath>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the relative error of the Gram coordinate of two circles on the sphere. `edge` has scaled
// radii tan R, and `square` is the squared chord L^2 between the centers. The coordinate is
// c L^2 / 2 - (c - 1), where c is the product of both 1 / cos R.
template <typename FT>
double spherical_gram_error(const Intrinsic_triangulations::Decorated_length<FT>& edge,
                            const FT& square)
{
  using std::sqrt;
  const FT r = edge.source_radius * edge.source_radius, s = edge.target_radius * edge.target_radius,
           c = sqrt(FT((1 + r) * (1 + s))), gram = c * square / 2 - (r + s + r * s) / (c + 1);
  return std::abs(static_cast<double>(gram / edge.gram()) - 1);
}

// Returns the square of the distance of two points in space.
template <typename Distance, typename FT>
Distance squared_chord(const std::array<FT, 3>& p, const std::array<FT, 3>& q)
{
  Distance result(0);
  for(std::size_t c = 0; c < 3; ++c) {
    const Distance x = converted<Distance>(FT(q[c] - p[c]));
    result += x * x;
  }
  return result;
}

// Returns the square of the norm of a vector in the plane.
template <typename FT>
FT squared_norm(const std::array<Double_double, 2>& p)
{
  const FT x = p[0].high(), y = p[1].high();
  return x * x + y * y;
}

// Returns the square of the distance of two points of the unit sphere, from their stereographic
// projections.
template <typename FT>
FT squared_chord_from_plane(const std::array<Double_double, 2>& p,
                            const std::array<Double_double, 2>& q)
{
  return 4 * squared_norm<FT>({p[0] - q[0], p[1] - q[1]}) /
         ((1 + squared_norm<FT>(p)) * (1 + squared_norm<FT>(q)));
}

// Returns the square of the distance of the image of infinity.
template <typename FT>
FT squared_chord_to_infinity(const std::array<Double_double, 2>& p)
{
  return 4 / (1 + squared_norm<FT>(p));
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_SPHERICAL_GRAM_ERROR_H
