// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FILE_FORMAT_H
#define INTRINSIC_FILE_FORMAT_H

#include "reading/Scanner.h"

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

#endif // INTRINSIC_FILE_FORMAT_H
