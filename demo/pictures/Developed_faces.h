// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_DEVELOPED_FACES_H
#define INTRINSIC_DEVELOPED_FACES_H

#include "writing/Output_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// Stores an intrinsic triangulation. A page draws it without the common subdivision: it develops
// the intrinsic faces over each face of the input. Halfedges 3 f, 3 f + 1 and 3 f + 2 belong to
// face f, the longest one first. Plane vectors are complex numbers.
struct Developed_faces
{
  // The input has no edges and attributes. The first corner of each face is the start of its
  // development.
  Output_mesh input;
  std::array<std::size_t, 2> number_of_edges{}; // of the input, and intrinsic ones
  // Stores for each halfedge the other one of its edge, or -1 on the boundary.
  std::vector<std::int64_t> opposites;
  // Stores for each halfedge its source.
  std::vector<std::int64_t> sources;
  std::vector<Attribute> vertex_data; // real, and linear on the intrinsic faces
  // Stores for each intrinsic face its third corner, if its first halfedge leads from 0 to 1.
  std::vector<double> shapes;
  // Stores a start for each face of the input, at its first corner. It is 2 h + 1 for the intrinsic
  // halfedge h from which its first edge starts in counterclockwise direction. It is 2 h if this
  // edge starts along h with the same length.
  std::vector<std::int64_t> starts;
  // Stores for each odd start the first edge, if that halfedge leads from 0 to 1.
  std::vector<double> first_edges;
};

#endif // INTRINSIC_DEVELOPED_FACES_H
