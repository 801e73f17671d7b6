// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_PATH_ON_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_PATH_ON_INPUT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/trace.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns the source of the halfedge `h` of T2 as a point of T1.
template <typename Traits>
Surface_point<typename Traits::FT> start_on_input(Halfedge_index h,
                                                  const Triangulation_pair<Traits>& pair)
{
  const Vertex_index v = pair.mesh().source(h);
  const Halfedge_index outgoing = pair.input_outgoing_before(h);
  if(!pair.is_inserted(v))
    return Vertex_location{outgoing};
  if(outgoing.is_valid())
    return pair.on_input_edge(outgoing, v);
  return pair.inserted_vertex(v);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPaths
/// follows a path along edges of \f$T_2\f$ over \f$T_1\f$.
///
/// \param tri the triangulations
/// \param halfedges the halfedges of \f$T_2\f$ along the path; each starts where the one before
///   ends
/// \returns its length and its points on \f$T_1\f$, from the source of the first halfedge to the
///   target of the last one. If it crosses an edge, it leaves a face through the halfedge;
///   rounding never moves a crossing to a vertex. From a vertex of \f$T_1\f$ the path continues
///   along the halfedge, or through the face on its left. The sequence of crossed edges is exact.
///
/// Complexity: the complexity of `trace_intrinsic_edge()` for each halfedge.
/// \throws Numerical_error if a layout has no positive finite length
template <typename Traits>
Surface_path<typename Traits::FT> path_on_input(const Intrinsic_triangulation<Traits>& tri,
                                                const std::vector<Halfedge_index>& halfedges)
{
  typedef typename Traits::FT FT;
  const Delta_complex& mesh = tri.mesh();
  Surface_path<FT> result{FT(0), {}};
  for(Halfedge_index h : halfedges) {
    const auto trace = trace_intrinsic_edge(tri, h);
    result.length += tri.length(mesh.edge(h));
    result.places.push_back(internal::start_on_input(h, tri));
    for(std::size_t m = 1; m + 1 < trace.size(); ++m)
      result.places.push_back(internal::crossing_on(trace[m].on_input));
  }
  if(!halfedges.empty()) {
    const Halfedge_index o = mesh.opposite(halfedges.back());
    result.places.push_back(internal::start_on_input(o, tri));
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PATH_ON_INPUT_H
