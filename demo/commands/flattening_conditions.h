// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FLATTENING_CONDITIONS_H
#define INTRINSIC_FLATTENING_CONDITIONS_H

#include "commands/commands.h"
#include "reading/Polygon_soup.h"

#include <CGAL/Discrete_conformal_maps/Vertex_condition.h>

#include <string>
#include <vector>

using Conditions = std::vector<CGAL::Discrete_conformal_maps::Vertex_condition>;

// What the options prescribe at each vertex of the mesh; zero on the boundary where it is to have a
// shape. Throws Program_error if the files are wrong.
Conditions flattening_conditions(const Flatten_options& options, const Mesh& mesh);

// Curvatures from a file, zero where it says nothing.
// Throws Program_error if the file is wrong.
Conditions prescribed_curvatures(const std::string& path, const Mesh& mesh);

// Whether the word after --boundary names a shape, which the library finds the angles for.
bool is_shape(const std::string& boundary);

// Throws Program_error if --boundary and --boundary-values make no sense.
void check_boundary(const Flatten_options& options);

#endif // INTRINSIC_FLATTENING_CONDITIONS_H
