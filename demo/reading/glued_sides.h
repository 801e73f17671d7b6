// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GLUED_SIDES_H
#define INTRINSIC_GLUED_SIDES_H

#include "reading/Polygon_soup.h"

#include <string>
#include <utility>
#include <vector>

// Pairs of halfedges with a face on their left, on the boundary of a mesh, that become opposite.
struct Glued_sides
{
  std::vector<std::pair<Mesh::Halfedge_index, Mesh::Halfedge_index>> pairs;
};

// Reads lines "a b c d": the side from vertex a to b is glued to that from c to d. Words after #
// are comments. Throws Program_error, with the line, if there are no such sides on the boundary, a
// side is glued twice or to one of another length, or the surface would not be oriented.
Glued_sides read_glued_sides(const std::string& path, const Mesh& mesh);

#endif // INTRINSIC_GLUED_SIDES_H
