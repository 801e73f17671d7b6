// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MESH_READER_H
#define INTRINSIC_MESH_READER_H

#include "Polygon_soup.h"

#include <filesystem>

// Reads a file in the format that its extension names: .off, .obj, .ply or .stl.
// Corners of .stl files with the same coordinates become one vertex.
// Throws Program_error if the file cannot be read or has no face, naming the line where it is
// known.
Polygon_soup read_mesh(const std::filesystem::path& path);

#endif // INTRINSIC_MESH_READER_H
