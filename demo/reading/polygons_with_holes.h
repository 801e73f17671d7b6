// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_POLYGONS_WITH_HOLES_H
#define INTRINSIC_POLYGONS_WITH_HOLES_H

#include "reading/Polygon_soup.h"

#include <array>
#include <cstddef>
#include <vector>

// Returns the triangles of a polygon with holes, as positions in `vertices`. Its outer boundary and
// its holes have common vertices, or are joined by sides that run in both directions. Returns
// nothing if the polygon has no holes, or if its boundaries cross each other, seen along the axis
// of its largest projection. `points` has the point of each corner.
std::vector<std::array<std::size_t, 3>>
triangles_of_keyhole(const std::vector<std::size_t>& vertices, const std::vector<Point>& points);

#endif // INTRINSIC_POLYGONS_WITH_HOLES_H
