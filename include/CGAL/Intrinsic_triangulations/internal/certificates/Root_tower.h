// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_TOWER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_TOWER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Intrinsic_triangulations/exact_numbers.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Square_classes.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>
#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns whether numbers of type `K` are rational: fractions, or dyadic numbers.
template <typename K>
constexpr bool is_rational()
{
  return std::is_same_v<K, Exact_ring> || is_fraction<K>();
}

// Returns the root of `x` >= 0, if it is in `K` and can be found. For fractions this is decided by
// roots of integers, rounded down. For dyadic numbers whole roots are found. In other fields only
// the roots 0 and 1 are found.
template <typename K>
std::optional<K> root_in(const K& x)
{
  typedef Fraction_traits<K> Fraction;
  if(x == K(0) || x == K(1))
    return x;
  if constexpr(std::is_same_v<K, Exact_ring>)
    return whole_root(x);
  else if constexpr(std::is_same_v<typename Fraction::Is_fraction, Tag_true>) {
    typename Fraction::Numerator_type numerator;
    typename Fraction::Denominator_type denominator;
    typename Fraction::Decompose()(x, numerator, denominator);
    const typename Fraction::Numerator_type root_n = sqrt(numerator);
    const typename Fraction::Denominator_type root_d = sqrt(denominator);
    if(root_n * root_n == numerator && root_d * root_d == denominator)
      return typename Fraction::Compose()(root_n, root_d);
  }
  return {};
}

// Returns the primes modulo which the rational number `x` > 0 is not a square. A fraction is a
// square if the product of its numerator and denominator is.
template <typename K>
std::optional<std::uint64_t> characters_of(const K& x)
{
  if constexpr(std::is_same_v<K, Exact_ring>)
    return quadratic_characters(x);
  else {
    typedef Fraction_traits<K> Fraction;
    typename Fraction::Numerator_type numerator;
    typename Fraction::Denominator_type denominator;
    typename Fraction::Decompose()(x, numerator, denominator);
    return quadratic_characters(
      K(x * typename Fraction::Compose()(denominator * denominator,
                                         typename Fraction::Denominator_type(1))));
  }
}

// Represents the ring that arises from an ordered ring `K` by adding square roots. An element
// stores the coefficients of the products of roots: bit b of the index stands for root b. If `K` is
// rational, no root is a multiple of a product of others. Signs are correct even if one is.
template <typename K>
class Root_tower
{
public:
  typedef boost::container::small_vector<K, 2> Element;

  explicit Root_tower(std::size_t maximum = 0) : m_maximum(maximum) {}

  // Stores a root and a positive factor of this root, which avoids divisions.
  struct Multiple
  {
    Element root;
    K factor;
  };

  // Returns a multiple of the root of `square`, and adds the root to the ring. The root is not
  // added if it is a multiple of an existing root, or of a product of existing roots. Returns
  // nothing if the ring has too many roots.
  std::optional<Multiple> root(const K& square)
  {
    if(const auto r = root_in(square))
      return Multiple{Element{*r}, K(1)};
    const std::size_t size = m_squares.size();
    for(std::size_t place = 1; place < size; place *= 2)
      if(square == m_squares[place])
        return Multiple{multiple_of_root(place, K(1)), K(1)};
    if(const auto multiple =
         size <= small_size ? multiple_by_trial(square) : multiple_by_characters(square))
      return multiple;
    if(size == std::size_t(1) << m_maximum)
      return {};
    for(std::size_t i = 0; i < size; ++i)
      m_squares.push_back(m_squares[i] * square);
    return Multiple{multiple_of_root(size, K(1)), K(1)};
  }

  static void add(const Element& a, Element& sum)
  {
    if(sum.size() < a.size())
      sum.resize(a.size(), K(0));
    for(std::size_t i = 0; i < a.size(); ++i)
      sum[i] += a[i];
  }

  static void negate(Element& a)
  {
    for(K& x : a)
      x = -x;
  }

  static void multiply(Element& a, const K& factor)
  {
    for(K& x : a)
      x *= factor;
  }

  // Adds a product to `sum`, or subtracts it.
  void add_product(const Element& a, const Element& b, Sign sign, Element& sum) const
  {
    const std::size_t size = (std::max)(a.size(), b.size());
    if(sum.size() < size)
      sum.resize(size, K(0));
    if(size > small_size && (std::min)(a.size(), b.size()) > 1) {
      Element x = a, y = b;
      x.resize(size, K(0));
      y.resize(size, K(0));
      add_large_product(x.data(), y.data(), size, sign, sum.data());
    } else
      add_products(a.data(), a.size(), b.data(), b.size(), sign, sum.data());
  }

  // Returns the sign of a + b sqrt(c). If an element has several roots and is not zero, its sign is
  // found in floating point as a rule; otherwise by recursion.
  Sign sign(const Element& e) const
  {
    if(e.size() == 1)
      return CGAL::sign(e[0]);
    if(e.size() > small_size) {
      if(is_zero(e))
        return ZERO;
      if(const Sign rounded = rounded_sign([&] { return approximation(e); }); rounded != ZERO)
        return rounded;
    }
    const auto middle = e.begin() + (e.end() - e.begin()) / 2;
    const Element a(e.begin(), middle), b(middle, e.end());
    const Sign sign_a = sign(a), sign_b = sign(b);
    if(sign_a == sign_b || sign_b == ZERO)
      return sign_a;
    if(sign_a == ZERO)
      return sign_b;
    Element norm;
    add_product(b, b, POSITIVE, norm);
    multiply(norm, -m_squares[a.size()]);
    add_product(a, a, POSITIVE, norm);
    return sign_a * sign(norm);
  }

  // Returns the sign of a x + b y.
  Sign sign_of_products(const Element& a, const Element& x, const Element& b,
                        const Element& y) const
  {
    if((std::max)({a.size(), x.size(), b.size(), y.size()}) > small_size) {
      const Sign rounded = rounded_sign(
        [&] { return approximation(a) * approximation(x) + approximation(b) * approximation(y); });
      if(rounded != ZERO)
        return rounded;
    }
    Element sum;
    add_product(a, x, POSITIVE, sum);
    add_product(b, y, POSITIVE, sum);
    return sign(sum);
  }

  // Returns the inverse of an element that is not zero, over a field `K`. The inverse of
  // a + b sqrt(c) is (a - b sqrt(c)) / (a^2 - b^2 c).
  Element inverse(const Element& e) const
  {
    if(e.size() == 1)
      return Element{K(K(1) / e[0])};
    const auto middle = e.begin() + (e.end() - e.begin()) / 2;
    const Element a(e.begin(), middle), b(middle, e.end());
    if(is_zero(b))
      return inverse(a);
    Element norm, conjugate = e, result;
    add_product(b, b, POSITIVE, norm);
    multiply(norm, -m_squares[a.size()]);
    add_product(a, a, POSITIVE, norm);
    for(std::size_t i = a.size(); i < e.size(); ++i)
      conjugate[i] = -conjugate[i];
    add_product(conjugate, inverse(norm), POSITIVE, result);
    return result;
  }

  static bool is_zero(const Element& e)
  {
    return std::all_of(e.begin(), e.end(), [](const K& x) { return x == K(0); });
  }

private:
  // Elements of this size have two roots. Larger elements are multiplied by fewer products.
  static constexpr std::size_t small_size = 4;

  static Element multiple_of_root(std::size_t place, const K& factor)
  {
    std::size_t size = 2;
    while(size <= place)
      size *= 2;
    Element e(size, K(0));
    e[place] = factor;
    return e;
  }

  // ---- Multiples of roots ----

  std::optional<Multiple> multiple_of(std::size_t place, const K& square) const
  {
    if(const auto r = root_in(K(square * m_squares[place])))
      return Multiple{multiple_of_root(place, *r), m_squares[place]};
    return {};
  }

  std::optional<Multiple> multiple_by_trial(const K& square) const
  {
    for(std::size_t place = 1; place < m_squares.size(); ++place)
      if(const auto multiple = multiple_of(place, square))
        return multiple;
    return {};
  }

  BOOST_NOINLINE std::optional<Multiple> multiple_by_characters(const K& square)
  {
    if constexpr(is_rational<K>()) {
      for(std::size_t place = std::size_t(1) << m_classes.size(); place < m_squares.size();
          place *= 2)
        m_classes.add(characters_of(m_squares[place]));
      const auto place = m_classes.product_like(characters_of(square));
      return place ? multiple_of(*place, square) : std::nullopt;
    } else {
      for(std::size_t place = 1; place < m_squares.size(); place *= 2)
        if(const auto multiple = multiple_of(place, square))
          return multiple;
      return {};
    }
  }

  // ---- Products ----

  // A root that both factors have contributes its square.
  void add_products(const K* a, std::size_t size_a, const K* b, std::size_t size_b, Sign sign,
                    K* sum) const
  {
    for(std::size_t i = 0; i < size_a; ++i)
      for(std::size_t j = 0; j < size_b && a[i] != K(0); ++j)
        if(b[j] != K(0)) {
          K term = a[i] * b[j];
          if((i & j) != 0)
            term *= m_squares[i & j];
          sign == POSITIVE ? sum[i ^ j] += term : sum[i ^ j] -= term;
        }
  }

  // Multiplies by three products of halves instead of four (Karatsuba), unless there are few terms.
  BOOST_NOINLINE void add_large_product(const K* a, const K* b, std::size_t size, Sign sign,
                                        K* sum) const
  {
    const auto count = [&](const K* x) {
      return size - std::size_t(std::count(x, x + size, K(0)));
    };
    std::size_t products = 1;
    for(std::size_t n = size; n > 1; n /= 2)
      products *= 3;
    if(size <= small_size || count(a) * count(b) <= products)
      return add_products(a, size, b, size, sign, sum);
    const std::size_t half = size / 2;
    Element low(half, K(0)), high(half, K(0)), x(a, a + half), y(b, b + half);
    add_large_product(a, b, half, sign, low.data());
    add_large_product(a + half, b + half, half, sign, high.data());
    for(std::size_t i = 0; i < half; ++i) {
      x[i] += a[half + i];
      y[i] += b[half + i];
    }
    add_large_product(x.data(), y.data(), half, sign, sum + half);
    for(std::size_t i = 0; i < half; ++i) {
      sum[half + i] -= low[i] + high[i];
      sum[i] += low[i] + high[i] * m_squares[half];
    }
  }

  // ---- Floating point ----

  // Stores a number and the sum of the absolute values of its terms.
  struct Approximation
  {
    Long_float value, magnitude;

    friend Approximation operator+(const Approximation& a, const Approximation& b)
    {
      return {Long_float(a.value + b.value), Long_float(a.magnitude + b.magnitude)};
    }
    friend Approximation operator*(const Approximation& a, const Approximation& b)
    {
      return {Long_float(a.value * b.value), Long_float(a.magnitude * b.magnitude)};
    }
  };

  // Returns the sign of the result of `approximate()`; ZERO if `most_digits` do not determine it.
  // Each root of a term adds some 16 units of roundoff, so that all but 24 bits hold.
  template <typename Approximate>
  Sign rounded_sign(const Approximate& approximate) const
  {
    if(!is_rational<K>())
      return ZERO;
    const Approximation a = approximate();
    const Long_float error = a.magnitude * Long_float(std::ldexp(1., 24 - most_digits));
    return a.value > error ? POSITIVE : -a.value > error ? NEGATIVE : ZERO;
  }

  Approximation approximation(const Element& e) const
  {
    if constexpr(is_rational<K>()) {
      for(std::size_t place = std::size_t(1) << m_roots.size(); place < e.size(); place *= 2)
        m_roots.push_back(sqrt(to_long_float(m_squares[place])));
      return approximation(e.data(), m_roots.data() + std::ilogb(double(e.size())));
    } else
      return {};
  }

  // Returns the approximation of an element with the roots before `end`.
  Approximation approximation(const K* e, const Long_float* end) const
  {
    const auto roots = std::size_t(end - m_roots.data());
    if(roots == 0) {
      const Long_float value = to_long_float(*e);
      return {value, value < 0 ? Long_float(-value) : value};
    }
    const Long_float& root = end[-1];
    return approximation(e, end - 1) +
           approximation(e + (std::size_t(1) << (roots - 1)), end - 1) * Approximation{root, root};
  }

  static Long_float to_long_float(const K& x)
  {
    Long_float sum(0);
    for_each_part(x, 24, [&](const Scaled_part& part) { sum += number_of<Long_float>(part); });
    return sum;
  }

  std::size_t m_maximum;
  std::vector<K> m_squares{K(1)}; // of all products of roots
  Square_classes m_classes;       // of the roots
  mutable std::vector<Long_float> m_roots;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_TOWER_H
