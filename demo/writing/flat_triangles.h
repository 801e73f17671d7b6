// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FLAT_TRIANGLES_H
#define INTRINSIC_FLAT_TRIANGLES_H

#include "commands/Statistics.h"
#include "writing/Output_mesh.h"

#include <cstdint>
#include <string>
#include <vector>

// The polygons that have a triangle that is flipped in the plane, as `describe_triangles()` counts
// them.
std::vector<std::int64_t> flipped_polygons(const Output_mesh& mesh);

// Adds how many triangles are flipped in the plane or have no area there, with the texture
// coordinates as they are. Polygons are cut into triangles from their first corners. Of slivers,
// triangles of which rounding of their points may have taken all area in space, both are counted
// apart. The first faces of the input with triangles or slivers that are flipped are named.
void describe_triangles(Statistics& statistics, const Output_mesh& mesh);

// Adds how many triangles, cut off in the same way, are flipped on the sphere as seen from its
// center, and names their first faces; nothing without any.
void describe_triangles_on_sphere(Statistics& statistics, const Output_mesh& mesh);

// Returns where the first flipped triangle is, as these functions have noted; empty without any.
std::string first_flipped_face(const Statistics& statistics);

#endif // INTRINSIC_FLAT_TRIANGLES_H
