// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GLUED_SIDES_H
#define INTRINSIC_GLUED_SIDES_H

#include "reading/Polygon_soup.h"

#include <string>
#include <utility>
#include <vector>

// Stores pairs of halfedges with a face on their left, on the boundary of a mesh, that become
// opposite.
struct Glued_sides
{
  std::vector<std::pair<Mesh::Halfedge_index, Mesh::Halfedge_index>> pairs;
};

// Reads lines "a b c d", which glue the side from vertex a to b to the side from c to d. Words
// after # are comments. Throws Program_error, with the line, if such sides are not on the boundary,
// or a side is glued twice or to one of another length. Also throws it if the surface would not be
// oriented.
Glued_sides read_glued_sides(const std::string& path, const Mesh& mesh);

#endif // INTRINSIC_GLUED_SIDES_H
