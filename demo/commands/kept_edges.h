// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_KEPT_EDGES_H
#define INTRINSIC_KEPT_EDGES_H

#include "reading/Polygon_soup.h"

using Edge_bool_map = Mesh::Property_map<Mesh::Edge_index, bool>;

// Marks the edges at which the normals of the two faces differ by at least `degrees`.
// A face without area has no normal and makes no edge sharp.
void mark_sharp_edges(const Mesh& mesh, double degrees, Edge_bool_map is_kept);

// Marks the edges at which the texture coordinates of the two faces differ. The data belong to the
// faces of the mesh.
void mark_seams(const Mesh_data& data, const Mesh& mesh, Edge_bool_map is_kept);

#endif // INTRINSIC_KEPT_EDGES_H
