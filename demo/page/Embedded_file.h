// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_EMBEDDED_FILE_H
#define INTRINSIC_EMBEDDED_FILE_H

#include <string_view>
#include <vector>

// Stores a text file that is part of the program, in pieces.
struct Embedded_file
{
  std::string_view name;
  std::vector<std::string_view> pieces;
};

// These files are the parts of pages. The list is empty if three.js could not be fetched when the
// program was configured. CMake writes the source.
extern const std::vector<Embedded_file> embedded_files;

#endif // INTRINSIC_EMBEDDED_FILE_H
