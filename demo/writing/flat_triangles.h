// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FLAT_TRIANGLES_H
#define INTRINSIC_FLAT_TRIANGLES_H

#include "commands/Statistics.h"
#include "writing/Output_mesh.h"

#include <cstdint>
#include <vector>

// The polygons that have a triangle that is flipped in the plane, as `describe_triangles()` counts
// them.
std::vector<std::int64_t> flipped_polygons(const Output_mesh& mesh);

// Adds how many triangles are flipped in the plane or have no area there, with linear texture
// coordinates. Polygons are cut into triangles from their first corners. Of slivers, triangles of
// which rounding of their points may have taken all area in space, both are counted apart.
void describe_triangles(Statistics& statistics, const Output_mesh& mesh);

#endif // INTRINSIC_FLAT_TRIANGLES_H
