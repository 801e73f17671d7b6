// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FLATTENING_CONDITIONS_H
#define INTRINSIC_FLATTENING_CONDITIONS_H

#include "Polygon_soup.h"
#include "commands.h"

#include <CGAL/Discrete_conformal_maps/Vertex_condition.h>

#include <vector>

using Conditions = std::vector<CGAL::Discrete_conformal_maps::Vertex_condition>;

// What the options prescribe at each vertex of the mesh, as far as it does not depend on the
// result: the boundary of a disk has the exterior angles of a circle with the lengths that edges
// have in space. Throws Program_error if the files are wrong, or the mesh is not for this boundary;
// names `path`.
Conditions flattening_conditions(const Flatten_options& options, const Mesh& mesh,
                                 const std::string& path);

// Curvatures from a file, zero where it says nothing.
// Throws Program_error if the file is wrong.
Conditions prescribed_curvatures(const std::string& path, const Mesh& mesh);

// Makes the exterior angles of each component those of a polygon in a circle whose edges have these
// lengths; each belongs to the vertex at the start of the edge. Returns the greatest change of an
// angle. Precondition: each component has one boundary loop.
double set_circle(Conditions& conditions, const Mesh& mesh, const std::vector<double>& length);

// Throws Program_error if the words after --boundary make no sense.
void check_boundary(const std::vector<std::string>& words);

#endif // INTRINSIC_FLATTENING_CONDITIONS_H
