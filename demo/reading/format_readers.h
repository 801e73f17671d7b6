// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FORMAT_READERS_H
#define INTRINSIC_FORMAT_READERS_H

#include "reading/Mesh_reader.h"
#include "reading/Scanner.h"

#include <string_view>

// What can be read.
enum class File_format
{
  OFF,
  OBJ,
  PLY,
  STL,
  VTP,
  XYZ
};

// The format that the content begins with or, if it begins with none, that the extension names.
// Throws Program_error, which says what to do, if that is no format that can be read.
File_format file_format(const Scanner& in);

// Whether the extension names another format, or none.
bool is_misnamed(const Scanner& in, File_format format);

const char* name_of(File_format format);

// Whether the number of facets of a binary .stl file fits to its size.
bool is_binary_stl(std::string_view bytes);

// The readers of the formats add what the scanner has to the soup. They throw Program_error if the
// file does not follow the format. Memory is taken for what was read, not for what a file
// announces.

// With polylines, of .ply the edges, unless `lines` is null.
void read_obj(Scanner& in, Polygon_soup& soup, Polygons* lines = nullptr);
void read_ply(Scanner& in, Polygon_soup& soup, Polygons* lines = nullptr);
void read_vtp(Scanner& in, Polygon_soup& soup, Polygons* lines = nullptr);

void read_xyz(Scanner& in, Polygon_soup& soup);
void read_stl(Scanner& in, Polygon_soup& soup);
void read_off(Scanner& in, Polygon_soup& soup);

#endif // INTRINSIC_FORMAT_READERS_H
