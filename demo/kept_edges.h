// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SHARP_EDGES_H
#define INTRINSIC_SHARP_EDGES_H

#include "Polygon_soup.h"

// Marks the edges at which the normals of the two faces differ by at least `degrees`.
// A face without area has no normal and makes no edge sharp.
Mesh::Property_map<Mesh::Edge_index, bool> mark_sharp_edges(Mesh& mesh, double degrees);

#endif // INTRINSIC_SHARP_EDGES_H
