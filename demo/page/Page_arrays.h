// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PAGE_ARRAYS_H
#define INTRINSIC_PAGE_ARRAYS_H

#include "commands/Statistics.h"
#include "writing/Text.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Stores the arrays of numbers of a page, in one sequence of bytes. JSON describes the position and
// the encoding of each array. arrays.js reads them.
class Page_arrays
{
public:
  // Adds numbers in single precision, or with 16 bits between the least and the greatest of each
  // component in long arrays. NaN is preserved.
  Statistics add_reals(const std::vector<double>& values, std::size_t components = 1);

  // Adds numbers in single precision.
  Statistics add_singles(const std::vector<double>& values);

  // Adds differences of successive integers, in as few bytes as they need.
  Statistics add_integers(const std::vector<std::int64_t>& values);

  // Writes all bytes as base64.
  void write(Text& text) const;

private:
  // Aligns numbers of this size, because the page reads them without a copy.
  void align(std::size_t size) { m_bytes.resize((m_bytes.size() + size - 1) / size * size); }

  void add_varint(std::int64_t x);
  Statistics add_quantized(const std::vector<double>& values, std::size_t components);

  std::string m_bytes;
};

#endif // INTRINSIC_PAGE_ARRAYS_H
