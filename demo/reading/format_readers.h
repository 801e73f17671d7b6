// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FORMAT_READERS_H
#define INTRINSIC_FORMAT_READERS_H

#include "reading/Mesh_reader.h"
#include "reading/Scanner.h"

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
