// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TEXT_H
#define INTRINSIC_TEXT_H

#include "byte_order.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

// Text in the making; numbers are the shortest that are read back as the same numbers. It is handed
// on to a stream, if there is one, in large pieces.
class Text
{
public:
  Text() = default;
  explicit Text(std::ostream& stream) : m_stream(&stream) {}

  ~Text() { flush(); }

  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;

  Text& operator<<(std::string_view s)
  {
    m_text += s;
    return *this;
  }

  Text& operator<<(char c)
  {
    m_text += c;
    return *this;
  }

  Text& operator<<(double x) { return add_number(x); }
  Text& operator<<(std::size_t n) { return add_number(n); }
  Text& operator<<(std::int64_t n) { return add_number(n); }
  Text& operator<<(std::uint32_t n) { return add_number(n); }

  // The bytes of a number, the least significant one first.
  template <class Number>
  void add_bytes(Number x)
  {
    const Bytes_of<Number> bytes = bytes_of(x, false);
    m_text.append(bytes.data(), bytes.size());
    flush_if_large();
  }

  // Leaves nothing. Precondition: there is no stream.
  std::string take() { return std::exchange(m_text, {}); }

private:
  template <class Number>
  Text& add_number(Number x)
  {
    std::array<char, 32> digits;
    const std::to_chars_result end = std::to_chars(digits.data(), digits.data() + 32, x);
    m_text.append(digits.data(), end.ptr);
    flush_if_large();
    return *this;
  }

  void flush_if_large()
  {
    if(m_text.size() > (std::size_t(1) << 20) && m_stream != nullptr)
      flush();
  }

  void flush()
  {
    if(m_stream != nullptr)
      m_stream->write(m_text.data(), static_cast<std::streamsize>(m_text.size()));
    m_text.clear();
  }

  std::ostream* m_stream = nullptr;
  std::string m_text;
};

#endif // INTRINSIC_TEXT_H
