// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TEXT_H
#define INTRINSIC_TEXT_H

#include "writing/byte_order.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

// Builds a text. Numbers are the shortest that are read back as the same numbers. Large pieces are
// passed to a stream, if one exists.
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
    std::copy(s.begin(), s.end(), room(s.size()));
    m_size += s.size();
    return *this;
  }

  Text& operator<<(char c) { return *this << std::string_view(&c, 1); }

  Text& operator<<(double x) { return add_number(x); }
  Text& operator<<(std::size_t n) { return add_number(n); }
  Text& operator<<(std::int64_t n) { return add_number(n); }
  Text& operator<<(std::uint32_t n) { return add_number(n); }

  // Adds the bytes of a number, the least significant one first.
  template <class Number>
  void add_bytes(Number x)
  {
    const Bytes_of<Number> bytes = bytes_of(x, false);
    *this << std::string_view(bytes.data(), bytes.size());
  }

  // Returns the text, and leaves an empty one. Precondition: no stream exists.
  std::string take()
  {
    m_buffer.resize(std::exchange(m_size, 0));
    return std::exchange(m_buffer, {});
  }

private:
  template <class Number>
  Text& add_number(Number x)
  {
    constexpr std::size_t most = 32;
    char* const digits = room(most);
    m_size += static_cast<std::size_t>(std::to_chars(digits, digits + most, x).ptr - digits);
    return *this;
  }

  // Returns memory for `n` more characters.
  char* room(std::size_t n)
  {
    if(m_buffer.size() - m_size < n)
      make_room(n);
    return m_buffer.data() + m_size;
  }

  void make_room(std::size_t n)
  {
    if(m_size >= piece)
      flush();
    m_buffer.resize((std::max)({2 * m_size, m_size + n, m_stream == nullptr ? n : 2 * piece}));
  }

  void flush()
  {
    if(m_stream == nullptr)
      return;
    m_stream->write(m_buffer.data(), static_cast<std::streamsize>(m_size));
    m_size = 0;
  }

  static constexpr std::size_t piece = std::size_t(1) << 16;

  std::ostream* m_stream = nullptr;
  std::string m_buffer;
  std::size_t m_size = 0; // of it is the text
};

#endif // INTRINSIC_TEXT_H
