// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_LAY_OUT_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_LAY_OUT_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>
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

// Lays out the triangles of `mesh` along a line that leaves a face through each of the halfedges
// `exits`, at least one. `length` returns the argument of `strip` for a halfedge. The line starts
// at the corner opposite to the first exit and ends at the corner beyond the last. If `ends` is a
// pair of barycentric coordinates, it starts and ends at points with these coordinates in the same
// triangles. They begin with the corner.
template <typename Strip, typename Length, typename Exits, typename... Ends>
void lay_out_strip_with(Strip& strip, const Delta_complex& mesh, const Length& length,
                        const Exits& exits, const Ends&... ends)
{
  Halfedge_index ij = exits[0];
  strip.start(length(mesh.prev(ij)), length(ij), length(mesh.next(ij)), ends.first...);
  for(std::size_t m = 1; m < exits.size(); ++m) {
    const Halfedge_index ji = mesh.opposite(ij), il = mesh.next(ji), lj = mesh.prev(ji);
    if((ij = exits[m]) == il)
      strip.turn_around_source(length(ji), length(lj), length(il));
    else
      strip.turn_around_target(length(ji), length(lj), length(il));
  }
  const Halfedge_index ji = mesh.opposite(ij);
  strip.finish(length(ji), length(mesh.prev(ji)), length(mesh.next(ji)), ends.second...);
}

// Lays out the triangles along a line like `lay_out_strip_with()`, for the lengths of `surface`.
template <typename Strip, typename Surface, typename Exits, typename... Ends>
void lay_out_strip(Strip& strip, const Surface& surface, const Exits& exits, const Ends&... ends)
{
  const Delta_complex& mesh = surface.mesh();
  const auto& length_map = surface.length_map();
  lay_out_strip_with(
    strip, mesh, [&](Halfedge_index h) -> decltype(auto) { return length_map[mesh.edge(h)]; },
    exits, ends...);
}

// Lays out the triangles along a line like `lay_out_strip()`, with the radii of `traits` if they
// exist.
template <typename Traits, typename Strip, typename Surface, typename Exits>
void lay_out_strip_of(const Traits& traits, Strip& strip, const Surface& surface,
                      const Exits& exits)
{
  if constexpr(Has_radii<Traits>::value && std::is_same_v<Strip, typename Traits::Geodesic_strip>)
    if(traits.has_radii())
      return lay_out_strip_with(strip, surface.mesh(),
                                decorated_lengths(traits, surface.length_map(), surface.mesh()),
                                exits);
  lay_out_strip(strip, surface, exits);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_LAY_OUT_STRIP_H
