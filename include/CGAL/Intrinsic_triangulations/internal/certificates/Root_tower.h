// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_TOWER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_TOWER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the root of `x` >= 0, if it is a whole number that can be found: `x` has to be in the
// range of `double`. Each step finds as many digits as that has.
template <typename R>
std::optional<R> whole_root(const R& x)
{
  const double rounded = std::sqrt(CGAL::to_double(x));
  R root(0), rest = x;
  double last = std::numeric_limits<double>::infinity();
  for(double step = std::nearbyint(rounded); std::abs(step) < last;
      step = std::nearbyint(CGAL::to_double(rest) / (2 * rounded))) {
    root = root + R(step);
    rest = x - root * root;
    if(rest == R(0))
      return root;
    last = std::abs(step);
  }
  return {};
}

// Returns the root of `x` >= 0, if it is in `K` and can be found: of fractions this is decided, by
// roots of integers, which are rounded down; of dyadic numbers whole roots are found; in other
// fields only 0 and 1 are.
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

// The ring that arises from an ordered ring `K` by adding square roots. An element is given by the
// coefficients of the products of roots: bit b of the index stands for root b. Signs are right even
// if a root is in the ring of those before it.
template <typename K>
class Root_tower
{
public:
  typedef boost::container::small_vector<K, 2> Element;

  explicit Root_tower(std::size_t maximum = 0) : m_maximum(maximum) {}

  // A root and a positive number by which it is multiplied, so that nothing has to be divided.
  struct Multiple
  {
    Element root;
    K factor;
  };

  // Returns a multiple of the root of `square`, which is added to the ring unless it is a multiple
  // of one that is there; nothing if there are too many.
  std::optional<Multiple> root(const K& square)
  {
    if(const auto r = root_in(square))
      return Multiple{Element{*r}, K(1)};
    const std::size_t size = m_squares.size();
    for(std::size_t place = 1; place < size; place *= 2) {
      if(square == m_squares[place])
        return Multiple{multiple_of_root(place, K(1)), K(1)};
      if(const auto r = root_in(K(square * m_squares[place])))
        return Multiple{multiple_of_root(place, *r), m_squares[place]};
    }
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

  // Adds a product to `sum`, or subtracts it. Roots that both factors have make their squares.
  void add_product(const Element& a, const Element& b, Sign sign, Element& sum) const
  {
    if(const std::size_t size = (std::max)(a.size(), b.size()); sum.size() < size)
      sum.resize(size, K(0));
    for(std::size_t i = 0; i < a.size(); ++i)
      for(std::size_t j = 0; j < b.size() && a[i] != K(0); ++j)
        if(b[j] != K(0)) {
          K term = a[i] * b[j];
          if((i & j) != 0)
            term *= m_squares[i & j];
          sign == POSITIVE ? sum[i ^ j] += term : sum[i ^ j] -= term;
        }
  }

  // the sign of a + b sqrt(c), by recursion
  Sign sign(const Element& e) const
  {
    if(e.size() == 1)
      return CGAL::sign(e[0]);
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

private:
  static Element multiple_of_root(std::size_t place, const K& factor)
  {
    Element e(2 * place, K(0));
    e[place] = factor;
    return e;
  }

  std::size_t m_maximum;
  std::vector<K> m_squares{K(1)}; // of all products of roots
};

// a complex number over such a ring
template <typename K>
struct Root_complex
{
  typedef typename Root_tower<K>::Element Element;

  const Root_tower<K>* tower;
  Element x, y;

  bool is_zero() const
  {
    const auto is_zero = [](const K& a) { return a == K(0); };
    return std::all_of(x.begin(), x.end(), is_zero) && std::all_of(y.begin(), y.end(), is_zero);
  }

  friend Root_complex operator-(Root_complex a)
  {
    Root_tower<K>::negate(a.x);
    Root_tower<K>::negate(a.y);
    return a;
  }
  friend Root_complex operator+(Root_complex a, const Root_complex& b)
  {
    Root_tower<K>::add(b.x, a.x);
    Root_tower<K>::add(b.y, a.y);
    return a;
  }
  friend Root_complex operator-(Root_complex a, Root_complex b)
  {
    return std::move(a) + -std::move(b);
  }
  friend Root_complex operator*(const Root_complex& a, const Root_complex& b)
  {
    Root_complex result{a.tower, {}, imaginary_product(a, b)};
    a.tower->add_product(a.x, b.x, POSITIVE, result.x);
    a.tower->add_product(a.y, b.y, NEGATIVE, result.x);
    return result;
  }
  friend Root_complex operator*(Root_complex a, const K& factor)
  {
    Root_tower<K>::multiply(a.x, factor);
    Root_tower<K>::multiply(a.y, factor);
    return a;
  }
  friend Root_complex conj(Root_complex a)
  {
    Root_tower<K>::negate(a.y);
    return a;
  }
  friend Element imaginary_product(const Root_complex& a, const Root_complex& b)
  {
    Element result;
    a.tower->add_product(a.x, b.y, POSITIVE, result);
    a.tower->add_product(a.y, b.x, POSITIVE, result);
    return result;
  }
};

template <typename K>
Uncertain<Sign> sign_of_real(const Root_complex<K>& a)
{
  return a.tower->sign(a.x);
}

template <typename K>
Uncertain<Sign> sign_of_imaginary(const Root_complex<K>& a)
{
  return a.tower->sign(a.y);
}

// the sign of the imaginary part of a product
template <typename K>
Uncertain<Sign> sign_of_imaginary(const Root_complex<K>& a, const Root_complex<K>& b)
{
  return a.tower->sign(imaginary_product(a, b));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_TOWER_H
