// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/Page_arrays.h"

#include "writing/byte_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {

constexpr std::size_t long_array = 400000;
constexpr std::uint16_t not_finite = 65535; // and the greatest number is one less

template <class Number>
void add_bytes(std::string& bytes, Number x)
{
  const Bytes_of<Number> b = bytes_of(x, false);
  bytes.append(b.data(), b.size());
}

struct Range
{
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double x)
  {
    if(std::isfinite(x)) {
      low = (std::min)(low, x);
      high = (std::max)(high, x);
    }
  }

  std::uint16_t quantized(double x) const
  {
    if(!std::isfinite(x))
      return not_finite;
    return static_cast<std::uint16_t>(
      high > low ? std::lround((x - low) / (high - low) * (not_finite - 1)) : 0);
  }
};

} // namespace

Statistics Page_arrays::add_reals(const std::vector<double>& values, std::size_t components)
{
  return values.size() > long_array ? add_quantized(values, components) : add_singles(values);
}

Statistics Page_arrays::add_singles(const std::vector<double>& values)
{
  align(sizeof(float));
  Statistics result{{"at", m_bytes.size()}, {"size", values.size()}, {"code", "single"}};
  for(const double x : values)
    add_bytes(m_bytes, static_cast<float>(x));
  return result;
}

Statistics Page_arrays::add_quantized(const std::vector<double>& values, std::size_t components)
{
  align(sizeof(std::uint16_t));
  Statistics result{{"at", m_bytes.size()},
                    {"size", values.size()},
                    {"components", components},
                    {"code", "quantized"}};
  std::vector<Range> ranges(components);
  for(std::size_t i = 0; i < values.size(); ++i)
    ranges[i % components].add(values[i]);
  for(std::size_t i = 0; i < values.size(); ++i)
    add_bytes(m_bytes, ranges[i % components].quantized(values[i]));
  for(const Range& r : ranges)
    result["ranges"].push_back({r.low, r.high});
  return result;
}

Statistics Page_arrays::add_integers(const std::vector<std::int64_t>& values)
{
  Statistics result{{"at", m_bytes.size()}, {"size", values.size()}, {"code", "differences"}};
  std::int64_t last = 0;
  for(const std::int64_t x : values) {
    add_varint(x - last);
    last = x;
  }
  return result;
}

// Adds a number with seven bits in each byte, the sign last. The highest bit states that more bytes
// follow.
void Page_arrays::add_varint(std::int64_t x)
{
  std::uint64_t rest =
    x < 0 ? 2 * static_cast<std::uint64_t>(-(x + 1)) + 1 : 2 * static_cast<std::uint64_t>(x);
  for(; rest >= 128; rest /= 128)
    m_bytes.push_back(static_cast<char>(128 + rest % 128));
  m_bytes.push_back(static_cast<char>(rest));
}

void Page_arrays::write(Text& text) const
{
  constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for(std::size_t i = 0; i < m_bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for(std::size_t k = 0; k < 3; ++k)
      bits = 256 * bits + (i + k < m_bytes.size() ? std::uint8_t(m_bytes[i + k]) : 0);
    std::array<char, 4> word;
    for(std::size_t k = 0; k < 4; ++k)
      word[k] = i + k <= m_bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    text << std::string_view(word.data(), word.size());
  }
}
