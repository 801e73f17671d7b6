// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FORMAT_READERS_H
#define INTRINSIC_FORMAT_READERS_H

#include "reading/Mesh_reader.h"
#include "reading/Scanner.h"

#include <string_view>

// Lists the formats that can be read.
enum class File_format
{
  OFF,
  OBJ,
  PLY,
  STL,
  VTP,
  XYZ
};

// Returns the format with which the content begins or, if unknown, which the extension names.
// Throws Program_error, with advice, if this format cannot be read.
File_format file_format(const Scanner& in);

// Returns whether the extension names another format, or none.
bool is_misnamed(const Scanner& in, File_format format);

const char* name_of(File_format format);

// Returns whether the number of facets of a binary .stl file fits its size.
bool is_binary_stl(std::string_view bytes);

// The readers of the formats add the content of the scanner to the soup. They throw Program_error
// if the file violates the format. Memory is allocated for data that were read, not for data that a
// file announces.

// Reads a file. Polylines, or edges in .ply, are read unless `lines` is null.
void read_obj(Scanner& in, Polygon_soup& soup, Polygons* lines = nullptr);
void read_ply(Scanner& in, Polygon_soup& soup, Polygons* lines = nullptr);
void read_vtp(Scanner& in, Polygon_soup& soup, Polygons* lines = nullptr);

void read_xyz(Scanner& in, Polygon_soup& soup);
void read_stl(Scanner& in, Polygon_soup& soup);
void read_off(Scanner& in, Polygon_soup& soup);

#endif // INTRINSIC_FORMAT_READERS_H
