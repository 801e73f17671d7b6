// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BOUNDARY_SHAPES_H
#define INTRINSIC_BOUNDARY_SHAPES_H

#include "Polygon_soup.h"

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>

#include <array>
#include <string>
#include <vector>

// The vertices of a boundary, in their order along it.
using Boundary_loop = std::vector<Mesh::Vertex_index>;

// The boundary of each component.
// Throws Program_error, which names `path`, unless every component has one loop.
std::vector<Boundary_loop> single_boundary_loops(const Mesh& mesh, const std::string& path);

// The four vertices of a loop that are to be corners: as far apart along it as is possible while
// the sum of their exterior angles is nine tenths of that of the four sharpest, or more.
// Precondition: the loop has four vertices.
std::array<Mesh::Vertex_index, 4> rectangle_corners(const Mesh& mesh, const Boundary_loop& loop);

// The exterior angles of the polygon in a circle whose edges have these lengths: at the start of
// each edge. Precondition: no length is zero, none is greater than the others together.
std::vector<double> circle_angles(const std::vector<double>& length);

// The length in space of the edge of the boundary that starts at each vertex, in the order of
// loops.
std::vector<double> boundary_lengths(const Mesh& mesh);

// The same in the plane.
std::vector<double>
boundary_lengths(const CGAL::Discrete_conformal_maps::Planar_conformal_map& map);

#endif // INTRINSIC_BOUNDARY_SHAPES_H
