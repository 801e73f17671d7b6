// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SOUP_REPAIR_H
#define INTRINSIC_SOUP_REPAIR_H

#include "reading/Polygon_soup.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// What a repair did, each thing with the number of times it was done; never a zero.
using Repair_report = std::vector<std::pair<std::string, std::size_t>>;

// Mends what CGAL can mend in a polygon soup: points at most `distance` apart are merged, broken
// and duplicate faces and isolated points removed, faces oriented, points where the surface is not
// manifold duplicated. Indices may change. Corners keep their data; points get those of the first
// of the points of the file that have become one. Precondition: all coordinates are finite and all
// indices in range.
Repair_report repair(Polygon_soup& soup, double distance = 0);

#endif // INTRINSIC_SOUP_REPAIR_H
