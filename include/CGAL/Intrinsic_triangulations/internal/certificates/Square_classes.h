// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_SQUARE_CLASSES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_SQUARE_CLASSES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents a number of type `double` times a power of two, whose exponent is a multiple of 256.
// Numbers beyond the range of `double` are sums of such parts.
struct Scaled_part
{
  double factor;
  int exponent;
};

// Returns `x` rounded to about 52 bits, for any size.
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

// Returns one of the 64 greatest primes below 2^31.
inline std::uint64_t character_prime(std::size_t i)
{
  static constexpr std::array<std::uint16_t, 64> distance{
    1,    19,   61,   69,   85,   99,   105,  151,  159,  171,  225,  249,  295,  325,  379,  399,
    411,  469,  477,  511,  525,  571,  579,  589,  595,  615,  619,  697,  699,  705,  711,  727,
    771,  775,  781,  789,  829,  831,  837,  847,  885,  909,  951,  955,  967,  985,  987,  1027,
    1057, 1065, 1071, 1141, 1147, 1167, 1231, 1239, 1281, 1287, 1299, 1305, 1321, 1357, 1375, 1411};
  return (std::uint64_t(1) << 31) - distance[i];
}

inline std::uint64_t power(std::uint64_t x, std::uint64_t exponent, std::uint64_t modulus)
{
  std::uint64_t result = 1;
  for(; exponent > 0; exponent /= 2) {
    if(exponent % 2 == 1)
      result = result * x % modulus;
    x = x * x % modulus;
  }
  return result;
}

// Returns the residue of a number m 2^e with a whole number m of 53 bits.
inline std::uint64_t residue(const Scaled_part& part, std::uint64_t prime)
{
  int exponent;
  constexpr int digits = std::numeric_limits<double>::digits;
  const auto mantissa =
    static_cast<std::int64_t>(std::ldexp(std::frexp(part.factor, &exponent), digits));
  const std::int64_t m = mantissa % std::int64_t(prime),
                     e = (exponent - digits + part.exponent) % std::int64_t(prime - 1);
  return std::uint64_t(m < 0 ? m + std::int64_t(prime) : m) *
         power(2, std::uint64_t(e < 0 ? e + std::int64_t(prime - 1) : e), prime) % prime;
}

// Returns for each of the primes, as a bit, whether the dyadic number `x` is no square modulo it
// (Euler's criterion). Returns nothing if it is zero modulo one of them. Squares have no bits, and
// the bits of a product are the exclusive or of the bits of its factors.
template <typename K>
std::optional<std::uint64_t> quadratic_characters(const K& x)
{
  std::array<std::uint64_t, 64> sum{};
  for_each_part(x, (std::numeric_limits<std::size_t>::max)(), [&](const Scaled_part& part) {
    for(std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += residue(part, character_prime(i));
  });
  std::uint64_t bits = 0;
  for(std::size_t i = 0; i < sum.size(); ++i) {
    const std::uint64_t p = character_prime(i), criterion = power(sum[i] % p, (p - 1) / 2, p);
    if(criterion == 0)
      return {};
    if(criterion != 1)
      bits |= std::uint64_t(1) << i;
  }
  return bits;
}

// Stores products of numbers that are not squares. Determines whether one more number times such a
// product can be a square. Independent characters prove that it cannot. Gaussian elimination over
// two elements finds the only product for which it may.
class Square_classes
{
public:
  std::size_t size() const { return m_size; }

  // Adds a number with the given quadratic characters.
  void add(std::optional<std::uint64_t> characters)
  {
    const std::size_t bit = std::size_t(1) << m_size++;
    if(const Row row = reduced({characters.value_or(0), bit}); row.characters != 0)
      m_rows.push_back(row);
  }

  // Returns the factors of the product as bits of a number, 0 if it has none. Returns nothing if
  // `x` times any product is not a square.
  std::optional<std::size_t> product_like(std::optional<std::uint64_t> characters) const
  {
    const Row row = reduced({characters.value_or(0), 0});
    return characters && row.characters == 0 ? std::optional<std::size_t>(row.factors)
                                             : std::nullopt;
  }

private:
  struct Row
  {
    std::uint64_t characters;
    std::size_t factors;
  };

  Row reduced(Row row) const
  {
    for(const Row& pivot : m_rows)
      if((row.characters & pivot.characters & (~pivot.characters + 1)) != 0)
        row = {row.characters ^ pivot.characters, row.factors ^ pivot.factors};
    return row;
  }

  std::size_t m_size = 0;
  std::vector<Row> m_rows; // the last bits of earlier rows are eliminated from each
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_SQUARE_CLASSES_H
