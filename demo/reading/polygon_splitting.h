// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_POLYGON_SPLITTING_H
#define INTRINSIC_POLYGON_SPLITTING_H

#include "reading/Polygon_soup.h"

#include <string>

struct Polygon_tolerance
{
  bool may_share_edges = false; // any number of faces may have an edge
  bool may_touch_themselves = false;
};

// Splits faces of more than three corners into triangles without new corners, and sets the polygon
// of each triangle. Corners of a triangle are in the order of the polygon. A polygon need be
// neither convex nor planar. If it is simple in its projection along a coordinate axis, the
// triangulation is constrained Delaunay in this projection. Otherwise it crosses or touches itself,
// and gets CGAL's triangulation of a hole if this is allowed. Unless edges may be shared, no
// triangle gets an edge of another face.
// Throws Program_error, which names the file and the face, if a polygon cannot be split.
// Precondition: coordinates are finite, indices are in range, no face has a corner twice.
void split_polygons(const std::string& path, Polygon_soup& soup,
                    const Polygon_tolerance& tolerance);

#endif // INTRINSIC_POLYGON_SPLITTING_H
