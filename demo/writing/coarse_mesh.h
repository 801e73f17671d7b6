// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COARSE_MESH_H
#define INTRINSIC_COARSE_MESH_H

#include "writing/Fine_level.h"
#include "writing/Output_mesh.h"

#include <CGAL/Intrinsic_simplification/Surface_subdivision.h>

using Coarse_subdivision = CGAL::Intrinsic_simplification::Surface_subdivision<Point>;

// Returns a subdivision, whose mesh has its points, with the origin of its elements, where -1 means
// none:
// - a vertex has its kind (0 for a vertex of the input, 1 for a crossing, 2 for an inserted vertex,
//   3 for a bend of a coarse edge), and the number of the coarse vertex;
// - an edge has the edges of the input and of the coarse level that contain it;
// - a face has the faces of both that contain it, and a color by which adjacent coarse faces
//   differ.
// Faces with two sides, which have no area, are omitted. The lines are the coarse edges, with their
// indices, in black.
Output_mesh coarse_mesh(const Coarse_subdivision& subdivision, const Fine_level& fine);

// Returns the data of that mesh, from the data of the fine level.
Mesh_data data_of_coarse_mesh(const Triangle_data& fine, const Output_mesh& mesh);

#endif // INTRINSIC_COARSE_MESH_H
