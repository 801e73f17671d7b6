// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MESH_READER_H
#define INTRINSIC_MESH_READER_H

#include "reading/Polygon_soup.h"

#include <filesystem>

// Reads a file of one of the formats of file_format(). Corners of .stl files with the same
// coordinates become one vertex. The data are, as far as the format has them, colors (red, green
// and blue, in .ply and .off alpha), normals (nx, ny and nz, or "normal" if corners at a vertex
// differ), the texture coordinates of corners ("texcoord"), and all properties of vertices in .ply
// and .vtp. In .ply s and t, u and v without w, or texture_u and texture_v are texture
// coordinates, too. What only some vertices have is left out. Throws Program_error if the file
// cannot be read or has no face, naming the line where it is known. Files of points alone, .xyz
// too, are allowed if that is said.
Polygon_soup read_mesh(const std::filesystem::path& path, bool are_points_allowed = false);

#endif // INTRINSIC_MESH_READER_H
