// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_DECORATED_DIAMOND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_DECORATED_DIAMOND_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>

#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Determines whether this geometry can have circles at the vertices.
template <typename Traits, typename = void>
struct Has_radii : std::false_type
{};

template <typename Traits>
struct Has_radii<Traits, std::void_t<decltype(std::declval<const Traits&>().has_radii())>>
  : std::true_type
{};

// Returns a function that returns the decorated length of a halfedge, from a map of tangents.
// `traits` has the radii of vertices.
template <typename Traits, typename LengthMap>
auto decorated_lengths(const Traits& traits, const LengthMap& tangent, const Delta_complex& mesh)
{
  return [&traits, tangent, &mesh](Halfedge_index h) {
    return Decorated_length<typename Traits::FT>{
      get(tangent, mesh.edge(h)), traits.radius(mesh.source(h)), traits.radius(mesh.target(h))};
  };
}

// Returns the values of `of` on the halfedge `h` and the four other sides of its faces.
template <typename Function>
auto diamond_of(const Function& of, Halfedge_index h, const Delta_complex& mesh)
{
  const Halfedge_index o = opposite(h);
  return Diamond<decltype(of(h))>{of(h), of(mesh.next(h)), of(mesh.prev(h)), of(mesh.next(o)),
                                  of(mesh.prev(o))};
}

// Calls a function object of `traits` with the diamond of the halfedge `h`: with radii if they
// exist, otherwise with lengths.
template <typename Function, typename Traits, typename LengthMap>
auto of_diamond(const Function& function, [[maybe_unused]] const Traits& traits,
                const LengthMap& length, Halfedge_index h, const Delta_complex& mesh)
{
  if constexpr(Has_radii<Traits>::value)
    if(traits.has_radii())
      return function(diamond_of(decorated_lengths(traits, length, mesh), h, mesh));
  return function(diamond(length, h, mesh));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_DECORATED_DIAMOND_H
