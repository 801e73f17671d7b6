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

// An intrinsic triangulation from which a page develops the intrinsic faces over each face of the
// input while it draws, without the common subdivision. Halfedges 3 f, 3 f + 1 and 3 f + 2 are
// those of face f, the first its longest. Plane vectors are complex numbers.
struct Developed_faces
{
  // Empty edges and attributes; the first corner of each face is where its development starts.
  Output_mesh input;
  std::array<std::size_t, 2> number_of_edges{}; // of the input, and intrinsic ones
  // For each halfedge the other one of its edge, -1 on the boundary.
  std::vector<std::int64_t> opposites;
  // For each halfedge the vertex at which it starts.
  std::vector<std::int64_t> sources;
  std::vector<Attribute> vertex_data; // real, and linear on the intrinsic faces
  // For each intrinsic face its third corner, if its first halfedge goes from 0 to 1.
  std::vector<double> shapes;
  // For each face of the input, at its first corner: the intrinsic halfedge from which its first
  // edge starts in counterclockwise direction, as 2 h + 1, or 2 h if this edge starts along that
  // halfedge with the length that it has.
  std::vector<std::int64_t> starts;
  // For each odd start the first edge, if that halfedge goes from 0 to 1.
  std::vector<double> first_edges;
};

#endif // INTRINSIC_DEVELOPED_FACES_H
