// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_HEIGHTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_HEIGHTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns for each face its least height, relative to its longest side.
template <typename Surface>
std::vector<float> face_heights(const Surface& surface, Concurrency concurrency)
{
  const Delta_complex& mesh = surface.mesh();
  std::vector<float> result(mesh.num_faces());
  for_each_in_chunks<Face_index>(concurrency, mesh, [&](Face_index f) {
    const Halfedge_index h = mesh.halfedge(f);
    const auto length = [&](Halfedge_index x) {
      return CGAL::to_double(get(surface.length_map(), mesh.edge(x)));
    };
    const double a = length(h), b = length(mesh.next(h)), c = length(mesh.prev(h)),
                 longest = (std::max)({a, b, c});
    result[f.idx()] = static_cast<float>(quadrupled_area(a, b, c) / (2 * longest * longest));
  });
  return result;
}

// returns the least height of the faces at the edge of `h`
inline float height_around(Halfedge_index h, const Delta_complex& mesh,
                           const std::vector<float>& heights)
{
  float result = 1;
  for(const Halfedge_index x : {h, mesh.opposite(h)})
    if(!mesh.is_border(x))
      result = (std::min)(result, heights[mesh.face(x).idx()]);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FACE_HEIGHTS_H
