// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUBDIVISION_MESH_H
#define INTRINSIC_SUBDIVISION_MESH_H

#include "writing/Output_mesh.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>

using Subdivision = CGAL::Intrinsic_triangulations::Common_subdivision<
  CGAL::Intrinsic_triangulations::Euclidean_geometry_traits<double>, Point>;

// The subdivision with the origin of its elements, where -1 stands for none:
// - of a vertex: its kind (0 for a vertex of the input, 1 for a crossing, 2 for an inserted
//   vertex), the number of the input vertex, and the edges of the input and of the intrinsic
//   triangulation inside which it lies, with its place on the first halfedge of each;
// - of an edge: the edges of both triangulations of which it is a part;
// - of a face: the faces of both triangulations of which it is a part.
// These are computed when they are asked for: the subdivision must live as long.
Output_mesh subdivision_mesh(const Subdivision& subdivision);

// A function that is linear on the faces of one side, at the vertices of the subdivision.
std::vector<double> interpolated(CGAL::Intrinsic_triangulations::Side side,
                                 const std::vector<double>& values, const Subdivision& subdivision);

#endif // INTRINSIC_SUBDIVISION_MESH_H
