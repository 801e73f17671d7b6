// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_CHECK_LENGTHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_CHECK_LENGTHS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

[[noreturn]] inline void fail_at_length(Edge_index e, const Delta_complex& mesh)
{
  throw Invalid_input("the length of edge " + std::to_string(e.idx()) + " between vertices " +
                      std::to_string(mesh.vertex(e, 0).idx()) + " and " +
                      std::to_string(mesh.vertex(e, 1).idx()) +
                      " is zero, not finite, or beyond the range of its number type");
}

template <typename Surface, typename Traits>
void check_length(Edge_index e, const Surface& surface, const Traits& traits)
{
  if(!traits.is_length_object()(get(surface.length_map(), e)))
    fail_at_length(e, surface.mesh());
}

template <typename Surface, typename Traits>
void check_triangles(const Surface& surface, const Traits& traits)
{
  const auto is_triangle = traits.is_triangle_object();
  const Delta_complex& mesh = surface.mesh();
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    const auto length = [&](Halfedge_index x) -> decltype(auto) {
      return get(surface.length_map(), mesh.edge(x));
    };
    if(!is_triangle(length(h), length(mesh.next(h)), length(mesh.prev(h))))
      throw Invalid_input("the triangle inequality fails in face " + std::to_string(f.idx()));
  }
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_CHECK_LENGTHS_H
