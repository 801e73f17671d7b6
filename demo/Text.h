// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TEXT_H
#define INTRINSIC_TEXT_H

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

// Text in the making; numbers are the shortest that are read back as the same numbers.
class Text
{
public:
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

  // Leaves nothing.
  std::string take() { return std::exchange(m_text, {}); }

private:
  template <class Number>
  Text& add_number(Number x)
  {
    std::array<char, 32> digits;
    const std::to_chars_result end = std::to_chars(digits.data(), digits.data() + 32, x);
    m_text.append(digits.data(), end.ptr);
    return *this;
  }

  std::string m_text;
};

#endif // INTRINSIC_TEXT_H
