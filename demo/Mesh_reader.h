// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MESH_READER_H
#define INTRINSIC_MESH_READER_H

#include "Polygon_soup.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

// A number for each vertex, by the name of the function.
using Vertex_functions = std::map<std::string, std::vector<double>>;

// Reads a file in the format that its extension names: .off, .obj, .ply or .stl.
// Corners of .stl files with the same coordinates become one vertex.
// The functions become, unless they are null, those of the vertices in the file: the properties in
// .ply; red, green and blue in .off, if all vertices have a color.
// Throws Program_error if the file cannot be read or has no face, naming the line where it is
// known.
// Files of points alone are allowed if that is said, then .xyz too.
Polygon_soup read_mesh(const std::filesystem::path& path, Vertex_functions* functions = nullptr,
                       bool are_points_allowed = false);

#endif // INTRINSIC_MESH_READER_H
