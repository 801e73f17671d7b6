// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MESH_READER_H
#define INTRINSIC_MESH_READER_H

#include "reading/Polygon_soup.h"

#include <filesystem>

// Reads a file of one of the formats of file_format(). Corners of .stl files with the same
// coordinates become one vertex. If the format has them, the data are
// - colors (red, green and blue, in .ply and .off alpha),
// - normals (nx, ny and nz, or "normal" if corners at a vertex differ),
// - texture coordinates of corners ("texcoord"; in .ply also s and t, u and v without w, or
//   texture_u and texture_v),
// - all properties of vertices in .ply and .vtp.
// Data of only some vertices are dropped. Files of points alone, also .xyz, are allowed if
// `are_points_allowed`. Throws Program_error if the file cannot be read or has no face, naming the
// line if it is known.
Polygon_soup read_mesh(const std::filesystem::path& path, bool are_points_allowed = false);

#endif // INTRINSIC_MESH_READER_H
