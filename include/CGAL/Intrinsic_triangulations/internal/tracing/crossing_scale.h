// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_SCALE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_SCALE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Determines whether the crossings of this geometry have scales (see the concept `GeodesicStrip`).
template <typename Traits, typename = void>
struct Has_scale : std::false_type
{};

template <typename Traits>
struct Has_scale<
  Traits, std::void_t<decltype(std::declval<typename Traits::Geodesic_strip::Crossing>().scale)>>
  : std::true_type
{};

// Returns the scale of a crossing, or 1 if crossings have no scales.
template <typename Traits>
typename Traits::FT scale_of(const typename Traits::Geodesic_strip::Crossing& crossing)
{
  if constexpr(Has_scale<Traits>::value)
    return crossing.scale;
  else
    return typename Traits::FT(1);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_SCALE_H
