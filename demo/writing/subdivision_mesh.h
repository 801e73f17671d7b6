// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUBDIVISION_MESH_H
#define INTRINSIC_SUBDIVISION_MESH_H

#include "writing/Output_mesh.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>

using Subdivision = CGAL::Intrinsic_triangulations::Common_subdivision<
  CGAL::Intrinsic_triangulations::Euclidean_geometry_traits<double>, Point>;

// Returns the subdivision with the origin of its elements, where -1 means none:
// - a vertex has its kind (0 for a vertex of the input, 1 for a crossing, 2 for an inserted
//   vertex), and the number of the input vertex;
// - it also has the edges of both triangulations that contain it inside, with its position on the
//   first halfedge of each;
// - an edge has the edges of both triangulations that contain it;
// - a face has the faces of both triangulations that contain it.
// These are computed on request: the subdivision must outlive the result.
Output_mesh subdivision_mesh(const Subdivision& subdivision);

// Returns a function that is linear on the faces of one side, at the vertices of the subdivision.
std::vector<double> interpolated(CGAL::Intrinsic_triangulations::Side side,
                                 const std::vector<double>& values, const Subdivision& subdivision);

#endif // INTRINSIC_SUBDIVISION_MESH_H
