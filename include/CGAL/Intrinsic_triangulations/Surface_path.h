// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_PATH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// a path over a triangulation that is straight in every face.
template <typename FT>
struct Surface_path
{
  FT length;                             ///< its length; infinite if there is no path
  std::vector<Surface_place<FT>> places; ///< where it starts, meets edges and vertices, and ends
};

namespace internal {

// The place of a point on a halfedge, or at its source; it is in the face of the opposite halfedge
// if this one has none.
template <typename FT>
Surface_place<FT> place_on(const Edge_point<FT>& p, const Delta_complex& mesh)
{
  return {p.halfedge, face_location(mesh.is_border(p.halfedge) ? reversed(p, mesh) : p, mesh)};
}

// The place of a point between the ends of a halfedge, where a path crosses it. Rounding does not
// move it to an end, where the path would pass a vertex.
template <typename FT>
Surface_place<FT> crossing_on(const Edge_point<FT>& p, const Delta_complex& mesh)
{
  const FT least = rounding_unit<FT>() / 16;
  return place_on(Edge_point<FT>{p.halfedge, (std::min)((std::max)(p.t, least), FT(1 - least))},
                  mesh);
}

template <typename FT>
bool is_at_vertex(const Surface_place<FT>& p)
{
  return is_corner(p.location.second);
}

// Returns the place of a point with its halfedge, if it lies on one or at a vertex.
template <typename FT, typename P>
Surface_place<FT> surface_place(const Face_location<FT>& p, const Surface_mesh<P>& mesh)
{
  for(std::size_t s = 0; s < 3; ++s)
    if(p.second[(s + 2) % 3] == 0 && p.second[s] != 0)
      return {sides(p.first, mesh)[s], p};
  return {Delta_complex::null_halfedge(), p};
}

// The vertex where `p` is; null if it is none.
template <typename FT>
Vertex_index vertex_at(const Face_location<FT>& p, const Delta_complex& mesh)
{
  return is_corner(p.second) ? mesh.source(surface_place(p, mesh).along)
                             : Delta_complex::null_vertex();
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_PATH_H
