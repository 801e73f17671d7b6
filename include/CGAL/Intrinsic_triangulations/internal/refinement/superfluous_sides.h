// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_SUPERFLUOUS_SIDES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_SUPERFLUOUS_SIDES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/is_simplicial.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns whether the edge of `h` is a loop, or longer than another edge with the same ends.
template <typename Triangulation>
bool is_superfluous(Halfedge_index h, const Triangulation& tri)
{
  const Delta_complex& mesh = tri.mesh();
  const auto rank = [&](Halfedge_index x) {
    return std::make_pair(tri.length(mesh.edge(x)), mesh.edge(x));
  };
  bool result = mesh.source(h) == mesh.target(h);
  for_each_outgoing_halfedge(mesh.source(h), mesh, [&](Halfedge_index x) {
    result = result || (mesh.target(x) == mesh.target(h) && rank(x) < rank(h));
  });
  return result;
}

// Returns a loop among the sides of `f`, or else the shortest superfluous side, which runs around a
// thin part of the surface. If such sides are split, long sides along this part are simplicial.
// Without superfluous sides, returns a side if another face has the same corners, or null.
template <typename Triangulation>
Halfedge_index superfluous_side(Face_index f, const Triangulation& tri)
{
  const Delta_complex& mesh = tri.mesh();
  const auto rank = [&](Halfedge_index h) {
    return std::make_tuple(!is_superfluous(h, tri), mesh.source(h) != mesh.target(h),
                           tri.length(mesh.edge(h)));
  };
  const auto side = sides(f, mesh);
  const Halfedge_index first =
    *std::min_element(side.begin(), side.end(),
                      [&](Halfedge_index a, Halfedge_index b) { return rank(a) < rank(b); });
  const bool has_twin =
    std::all_of(side.begin(), side.end(), [&](Halfedge_index h) { return is_simplicial(h, mesh); });
  return has_twin || is_superfluous(first, tri) ? first : Halfedge_index();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_SUPERFLUOUS_SIDES_H
