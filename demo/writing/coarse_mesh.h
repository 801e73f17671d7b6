// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COARSE_MESH_H
#define INTRINSIC_COARSE_MESH_H

#include "writing/Fine_level.h"
#include "writing/Output_mesh.h"

#include <CGAL/Intrinsic_simplification/Surface_subdivision.h>

using Coarse_subdivision = CGAL::Intrinsic_simplification::Surface_subdivision<Point>;

// A subdivision whose mesh has its points, with the origin of its elements, where -1 stands for
// none:
// - of a vertex: its kind (0 for a vertex of the input, 1 for a crossing, 2 for an
//   inserted vertex, 3 for a bend of a coarse edge), and the number of the coarse vertex;
// - of an edge: the edges of the input and of the coarse level of which it is a part;
// - of a face: the faces of both of which it is a part, and a color by which adjacent coarse faces
// differ. Faces with two sides, which have no area, are left out. The lines are the coarse edges,
// with their indices, in black.
Output_mesh coarse_mesh(const Coarse_subdivision& subdivision, const Fine_level& fine);

// The data of that mesh, from those of the fine level.
Mesh_data data_of_coarse_mesh(const Triangle_data& fine, const Output_mesh& mesh);

#endif // INTRINSIC_COARSE_MESH_H
