// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MESH_WRITER_H
#define INTRINSIC_MESH_WRITER_H

#include "commands/options.h"
#include "writing/Output_mesh.h"
#include "writing/Text.h"

#include <string>

// All formats but one are text. PLY and VTP contain the attributes. All but OFF contain the texture
// and the corner data. PLY has the edges, VTP the lines. In VTP, lines come before polygons, and
// data of only one kind are -1 for the other. OBJ has colors and normals of points. The texture and
// the corner data are written
// - in OBJ as vt, one texture, and vn, at the corners of faces;
// - in PLY as a property of faces, a list "texcoord" with two numbers for each corner, or
//   "homogeneous_texcoord" or "normal" with three; missing numbers are zeros;
// - in VTP as a property of points with these names; if corners at a point differ, the point is
//   repeated after all others.
enum class Mesh_format
{
  OFF,
  OBJ,
  PLY,
  VTP,
  BINARY_PLY
};

// States the data of a file beside polygons.
enum class Carried
{
  NOTHING,
  DISTANCES, // attributes
  TEXTURE,
  LINES
};

// Returns the format of the file `path`, by its extension, or the requested one for standard output
// (-). Throws Program_error if the format is unknown, cannot be binary as requested, or cannot
// contain the data.
Mesh_format output_format(const std::string& path, const Output_options& options,
                          Carried what = Carried::NOTHING);

// Returns whether a file contains a texture.
bool has_texture(Mesh_format format);

// Adds the mesh. Coordinates are the shortest texts that are read back as the same numbers.
void write(Text& text, const Output_mesh& mesh, Mesh_format format);

#endif // INTRINSIC_MESH_WRITER_H
