// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MESH_WRITER_H
#define INTRINSIC_MESH_WRITER_H

#include "commands/options.h"
#include "writing/Output_mesh.h"
#include "writing/Text.h"

#include <string>

// All but one are text. PLY and VTP carry the attributes, all but OFF the texture and the corner
// data. PLY has the edges, VTP the lines; in VTP, lines come before polygons, and what only one
// kind has is -1 for the other. OBJ has colors and normals of points. The texture and the corner
// data:
// - OBJ as vt, one texture, and vn, at the corners of faces;
// - PLY as a property of faces, a list "texcoord" with two numbers for each corner, or
//   "homogeneous_texcoord" or "normal" with three; zeros where there are none;
// - VTP as a property of points with these names; where corners at a point differ, the point is
//   repeated after all others.
enum class Mesh_format
{
  OFF,
  OBJ,
  PLY,
  VTP,
  BINARY_PLY
};

// What a file has beside polygons.
enum class Carried
{
  NOTHING,
  DISTANCES, // attributes
  TEXTURE,
  LINES
};

// The format of the file `path`, by its extension; on standard output (-) the one that is wanted
// there. Throws Program_error if there is none, it shall be binary and cannot, or it cannot carry
// what it shall.
Mesh_format output_format(const std::string& path, const Output_options& options,
                          Carried what = Carried::NOTHING);

// Whether a file carries a texture.
bool has_texture(Mesh_format format);

// Adds the mesh; coordinates are the shortest that are read back as the same numbers.
void write(Text& text, const Output_mesh& mesh, Mesh_format format);

#endif // INTRINSIC_MESH_WRITER_H
