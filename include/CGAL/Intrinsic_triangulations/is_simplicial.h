// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IS_SIMPLICIAL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IS_SIMPLICIAL_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <algorithm>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns whether the ends of the edge of `h` are two vertices, and no other edge of `mesh` has
/// these ends.
/// Complexity: linear in the degree of the source.
inline bool is_simplicial(Halfedge_index h, const Delta_complex& mesh)
{
  int edges = 0;
  for_each_outgoing_halfedge(mesh.source(h), mesh, [&](Halfedge_index outgoing) {
    edges += mesh.target(outgoing) == mesh.target(h);
  });
  return edges == 1 && mesh.source(h) != mesh.target(h);
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns whether the three sides of the face `f` are simplicial, and no other face of `mesh` has
/// the same corners. Complexity: linear in the degrees of the corners.
inline bool is_simplicial(Face_index f, const Delta_complex& mesh)
{
  const auto side = sides(f, mesh);
  const Face_index beyond = mesh.face(mesh.opposite(side[0]));
  const auto leads_there = [&](Halfedge_index h) { return mesh.face(mesh.opposite(h)) == beyond; };
  return std::all_of(side.begin(), side.end(),
                     [&](Halfedge_index h) { return is_simplicial(h, mesh); }) &&
         !(beyond.is_valid() && std::all_of(side.begin(), side.end(), leads_there));
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns whether `mesh` is a simplicial complex: its faces have three corners each, and vertices
/// determine edges and faces. Other programs can read such a mesh. Complexity: linear in the sum of
/// the squared degrees.
inline bool is_simplicial(const Delta_complex& mesh)
{
  return std::all_of(mesh.faces_begin(), mesh.faces_end(),
                     [&](Face_index f) { return is_simplicial(f, mesh); });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IS_SIMPLICIAL_H
