// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_INFLATE_H
#define INTRINSIC_INFLATE_H

#include <cstdint>
#include <string>

#ifdef INTRINSIC_USE_ZLIB
#include <zlib.h>
#endif

// Decompresses data by zlib, if the program has been built with it.

#ifdef INTRINSIC_USE_ZLIB

constexpr bool can_inflate = true;

// Returns the `size` bytes that a zlib stream contains. Returns nothing if the stream is damaged,
// or contains another number of bytes.
inline std::string inflated(const std::string& stream, std::uint64_t size)
{
  constexpr std::uint64_t greatest_ratio = 1032; // of the sizes of data and stream
  if(size / greatest_ratio > stream.size())
    return {};
  std::string result(size, '\0');
  uLongf length = result.size();
  const int status =
    uncompress(reinterpret_cast<Bytef*>(result.data()), &length,
               reinterpret_cast<const Bytef*>(stream.data()), static_cast<uLong>(stream.size()));
  return status == Z_OK && length == size ? result : std::string();
}

#else

constexpr bool can_inflate = false;

inline std::string inflated(const std::string&, std::uint64_t) { return {}; }

#endif

#endif // INTRINSIC_INFLATE_H
