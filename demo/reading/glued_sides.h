// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GLUED_SIDES_H
#define INTRINSIC_GLUED_SIDES_H

#include "reading/Polygon_soup.h"

#include <string>
#include <utility>
#include <vector>

// Reads lines "a b c d", which glue the side from vertex a to b to the side from c to d. Words
// after # are comments. Returns pairs of halfedges for `glue_boundary()`; none without a line.
// Throws Program_error, with the line, if such sides are not on the boundary, or a side is glued
// twice or to one of another length. Also throws it if the surface would not be oriented.
std::vector<std::pair<Mesh::Halfedge_index, Mesh::Halfedge_index>>
read_glued_sides(const std::string& path, const Mesh& mesh,
                 const Mesh::Property_map<Mesh::Edge_index, double>& length);

#endif // INTRINSIC_GLUED_SIDES_H
