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

// The arrays of numbers of a page, in one sequence of bytes. Where each lies there, and how it is
// coded, is described in JSON; arrays.js reads them.
class Page_arrays
{
public:
  // Single precision, or 16 bits between the least and the greatest of each component in long
  // arrays. NaN stays.
  Statistics add_reals(const std::vector<double>& values, std::size_t components = 1);

  // Single precision.
  Statistics add_singles(const std::vector<double>& values);

  // Differences of one to the one before, in as few bytes as they need.
  Statistics add_integers(const std::vector<std::int64_t>& values);

  // Adds all bytes as base64.
  void write(Text& text) const;

private:
  // Numbers of this size begin at a multiple of it: the page reads them where they are.
  void align(std::size_t size) { m_bytes.resize((m_bytes.size() + size - 1) / size * size); }

  void add_varint(std::int64_t x);
  Statistics add_quantized(const std::vector<double>& values, std::size_t components);

  std::string m_bytes;
};

#endif // INTRINSIC_PAGE_ARRAYS_H
