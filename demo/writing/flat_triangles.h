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

// Returns the polygons with a triangle that is flipped in the plane, as `describe_triangles()`
// counts them.
std::vector<std::int64_t> flipped_polygons(const Output_mesh& mesh);

// Adds how many triangles are flipped in the plane or have no area there, with unchanged texture
// coordinates. Polygons are cut into triangles from their first corners. Slivers, whose area in
// space may be rounding errors of their points, are counted separately. The first faces of the
// input with flipped triangles or slivers are named.
void describe_triangles(Statistics& statistics, const Output_mesh& mesh);

// Adds how many triangles, cut off in the same way, are flipped on the sphere as seen from its
// center, and names their first faces. A flat mesh contains the center, so none is flipped.
void describe_triangles_on_sphere(Statistics& statistics, const Output_mesh& mesh, bool is_flat);

// Returns how many slivers are flipped in the plane, or an empty text.
std::string flipped_slivers(const Statistics& statistics);

// Returns the first flipped triangle that these functions have found, or an empty text.
std::string first_flipped_face(const Statistics& statistics);

#endif // INTRINSIC_FLAT_TRIANGLES_H
