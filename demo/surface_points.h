// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SURFACE_POINTS_H
#define INTRINSIC_SURFACE_POINTS_H

#include "Polygon_soup.h"

#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <string>

using Surface_location = CGAL::Intrinsic_triangulations::Face_location<double>;

// The point of the mesh that `text` stands for: a vertex by its number, "face:a,b,c" with
// barycentric coordinates in the order of the corners of the face, or "x,y,z", the nearest point of
// the mesh. Throws Program_error if it stands for none.
Surface_location surface_point(const std::string& text, const Mesh& mesh);

// The vertex at `p`. Throws Program_error, which names the point `text`, if there is none.
CGAL::Intrinsic_triangulations::Vertex_index vertex_at(const Surface_location& p,
                                                       const std::string& text, const Mesh& mesh);

Point position(const Surface_location& p, const Mesh& mesh);

#endif // INTRINSIC_SURFACE_POINTS_H
