// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BYTE_ORDER_H
#define INTRINSIC_BYTE_ORDER_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

template <class Number>
using Bytes_of = std::array<char, sizeof(Number)>;

inline bool is_machine_big_endian()
{
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

// Returns the bytes of a number, the least significant one first unless `is_big_endian`.
template <class Number>
Bytes_of<Number> bytes_of(Number x, bool is_big_endian)
{
  Bytes_of<Number> result;
  std::memcpy(result.data(), &x, sizeof(Number));
  if(is_big_endian != is_machine_big_endian())
    std::reverse(result.begin(), result.end());
  return result;
}

// Returns the number with these bytes.
template <class Number>
Number number_of_bytes(Bytes_of<Number> bytes, bool is_big_endian)
{
  if(is_big_endian != is_machine_big_endian())
    std::reverse(bytes.begin(), bytes.end());
  Number result;
  std::memcpy(&result, bytes.data(), sizeof(Number));
  return result;
}

#endif // INTRINSIC_BYTE_ORDER_H
