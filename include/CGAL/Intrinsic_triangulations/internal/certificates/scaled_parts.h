// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_SCALED_PARTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_SCALED_PARTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents a number of type `double` times a power of two, whose exponent is a multiple of 256.
// Numbers beyond the range of `double` are sums of such parts.
struct Scaled_part
{
  double factor;
  int exponent;
};

// Returns `x` rounded to some 52 bits, whatever its size.
template <typename K>
Scaled_part leading_part(K x)
{
  Scaled_part part{CGAL::to_double(x), 0};
  const auto multiply = [&](double power, int exponent) {
    x *= K(power);
    part = {CGAL::to_double(x), part.exponent - exponent};
  };
  while(!(std::abs(part.factor) < 0x1p600))
    multiply(0x1p-512, -512);
  while(std::abs(part.factor) < 0x1p-600 && x != K(0))
    multiply(0x1p512, 512);
  return part;
}

template <typename N>
N number_of(const Scaled_part& part)
{
  N x(part.factor);
  for(int e = part.exponent; e != 0; e += e > 0 ? -256 : 256)
    x *= N(e > 0 ? 0x1p256 : 0x1p-256);
  return x;
}

// Calls `use(part)` for parts of `x`, each much smaller than the one before, until they add up to
// `x` or there are `maximum`. Returns whether they add up.
template <typename K, typename Use>
bool for_each_part(K x, std::size_t maximum, const Use& use)
{
  for(; maximum > 0 && x != K(0); --maximum) {
    const Scaled_part part = leading_part(x);
    use(part);
    x -= number_of<K>(part);
  }
  return x == K(0);
}

// Returns the nearest whole number. A part with many digits is a whole number already.
inline Scaled_part whole_part(Scaled_part part)
{
  for(; part.exponent > 0 && std::abs(part.factor) < 0x1p300; part.exponent -= 256)
    part.factor *= 0x1p256;
  for(; part.exponent < 0; part.exponent += 256)
    part.factor *= 0x1p-256;
  return part.exponent == 0 ? Scaled_part{std::nearbyint(part.factor), 0} : part;
}

// Returns the root of `x` > 0, if it is a whole number. Each step finds as many digits as `double`
// has.
template <typename R>
std::optional<R> whole_root(const R& x)
{
  const Scaled_part square = leading_part(x);
  const Scaled_part rounded{std::sqrt(square.factor), square.exponent / 2};
  const auto size = [](const Scaled_part& p) { return std::log2(std::abs(p.factor)) + p.exponent; };
  Scaled_part step = whole_part(rounded);
  R root(0);
  for(double last = std::numeric_limits<double>::infinity(); size(step) < last;) {
    last = size(step);
    root += number_of<R>(step);
    const R rest = x - root * root;
    if(rest == R(0))
      return root;
    step = leading_part(rest);
    step = whole_part({step.factor / (2 * rounded.factor), step.exponent - rounded.exponent});
  }
  return {};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_SCALED_PARTS_H
