// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_TOWER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_TOWER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the root of `x` >= 0, if it is in the field. Of fractions this is decided, by roots of
// integers, which are rounded down; in other fields only 0 and 1 are found.
template <typename K>
std::optional<K> root_in_field(const K& x)
{
  typedef Fraction_traits<K> Fraction;
  if(x == K(0) || x == K(1))
    return x;
  if constexpr(std::is_same_v<typename Fraction::Is_fraction, Tag_true>) {
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

// The field that arises from an ordered field `K` by adding square roots. An element is given by
// the coefficients of the products of roots: bit b of the index stands for root b.
template <typename K>
class Root_tower
{
public:
  typedef std::vector<K> Element;

  explicit Root_tower(std::size_t maximum = 0) : m_maximum(maximum) {}

  // Returns the root of `square`, which is added to the field unless it is a multiple in `K` of one
  // that is there; nothing if there are too many.
  std::optional<Element> root(const K& square)
  {
    if(const auto r = root_in_field(square))
      return Element{*r};
    std::size_t b = 0;
    for(; b < m_squares.size(); ++b)
      if(const auto r = root_in_field(K(square / m_squares[b])))
        return multiple_of_root(b, *r);
    if(b == m_maximum)
      return {};
    m_squares.push_back(square);
    return multiple_of_root(b, K(1));
  }

  static Element sum(const Element& a, const Element& b)
  {
    if(a.size() < b.size())
      return sum(b, a);
    Element result(a);
    for(std::size_t i = 0; i < b.size(); ++i)
      result[i] += b[i];
    return result;
  }

  static Element negative(Element a)
  {
    for(K& x : a)
      x = -x;
    return a;
  }

  static Element multiple(const Element& a, const K& factor)
  {
    if(factor == K(0))
      return {factor};
    Element result(a);
    for(K& x : result)
      x *= factor;
    return result;
  }

  Element product(const Element& a, const Element& b) const
  {
    if(a.size() == 1)
      return multiple(b, a[0]);
    if(b.size() == 1)
      return multiple(a, b[0]);
    const auto [a0, a1] = parts(a);
    const auto [b0, b1] = parts(b);
    if(a.size() != b.size()) // the longer has the last root
      return a.size() > b.size() ? joined(product(a0, b), product(a1, b))
                                 : joined(product(a, b0), product(a, b1));
    const std::size_t last = a0.size();
    return joined(sum(product(a0, b0), multiple(product(a1, b1), square_at(last))),
                  sum(product(a0, b1), product(a1, b0)));
  }

  // the sign of a + b sqrt(c), by recursion
  Sign sign(const Element& e) const
  {
    if(e.size() == 1)
      return CGAL::sign(e[0]);
    const auto [a, b] = parts(e);
    const Sign sign_a = sign(a), sign_b = sign(b);
    if(sign_a == sign_b || sign_b == ZERO)
      return sign_a;
    if(sign_a == ZERO)
      return sign_b;
    return sign_a *
           sign(sum(product(a, a), negative(multiple(product(b, b), square_at(a.size())))));
  }

private:
  static Element multiple_of_root(std::size_t b, const K& factor)
  {
    Element e(std::size_t(2) << b, K(0));
    e[std::size_t(1) << b] = factor;
    return e;
  }

  // the parts without and with the last root
  static std::pair<Element, Element> parts(const Element& e)
  {
    const auto middle = e.begin() + static_cast<std::ptrdiff_t>(e.size() / 2);
    return {Element(e.begin(), middle), Element(middle, e.end())};
  }

  static Element joined(Element a, Element b)
  {
    const std::size_t n = (std::max)(a.size(), b.size());
    a.resize(n, K(0));
    b.resize(n, K(0));
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  // of the root whose bit is `place`
  const K& square_at(std::size_t place) const
  {
    std::size_t b = 0;
    while((std::size_t(1) << b) < place)
      ++b;
    return m_squares[b];
  }

  std::size_t m_maximum;
  std::vector<K> m_squares;
};

// a complex number over such a field
template <typename K>
struct Root_complex
{
  typedef typename Root_tower<K>::Element Element;

  const Root_tower<K>* tower;
  Element x, y;

  friend Root_complex operator-(const Root_complex& a)
  {
    return {a.tower, Root_tower<K>::negative(a.x), Root_tower<K>::negative(a.y)};
  }
  friend Root_complex operator+(const Root_complex& a, const Root_complex& b)
  {
    return {a.tower, Root_tower<K>::sum(a.x, b.x), Root_tower<K>::sum(a.y, b.y)};
  }
  friend Root_complex operator-(const Root_complex& a, const Root_complex& b) { return a + -b; }
  friend Root_complex operator*(const Root_complex& a, const Root_complex& b)
  {
    const auto times = [&](const Element& p, const Element& q) { return a.tower->product(p, q); };
    return {a.tower, Root_tower<K>::sum(times(a.x, b.x), Root_tower<K>::negative(times(a.y, b.y))),
            Root_tower<K>::sum(times(a.x, b.y), times(a.y, b.x))};
  }
  friend Root_complex operator*(const Root_complex& a, const K& factor)
  {
    return {a.tower, Root_tower<K>::multiple(a.x, factor), Root_tower<K>::multiple(a.y, factor)};
  }
  friend Root_complex conj(const Root_complex& a)
  {
    return {a.tower, a.x, Root_tower<K>::negative(a.y)};
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_TOWER_H
