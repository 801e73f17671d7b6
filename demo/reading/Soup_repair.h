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

// Lists the repairs with their positive numbers.
using Repair_report = std::vector<std::pair<std::string, std::size_t>>;

// Repairs a polygon soup as far as CGAL can. Points at most `distance` apart are merged, broken and
// duplicate faces and isolated points removed, faces oriented, and non-manifold points duplicated.
// Indices may change. Corners keep their data. Merged points get the data of the first point in the
// file. Precondition: all coordinates are finite and all indices in range.
Repair_report repair(Polygon_soup& soup, double distance = 0);

#endif // INTRINSIC_SOUP_REPAIR_H
