// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_COMPLEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_COMPLEX_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/certificates/Root_tower.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents a complex number whose parts are elements of a `Root_tower`.
template <typename K>
struct Root_complex
{
  typedef typename Root_tower<K>::Element Element;

  const Root_tower<K>* tower;
  Element x, y;

  bool is_zero() const { return Root_tower<K>::is_zero(x) && Root_tower<K>::is_zero(y); }

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
    Root_complex result{a.tower, {}, {}};
    a.tower->add_product(a.x, b.x, POSITIVE, result.x);
    a.tower->add_product(a.y, b.y, NEGATIVE, result.x);
    a.tower->add_product(a.x, b.y, POSITIVE, result.y);
    a.tower->add_product(a.y, b.x, POSITIVE, result.y);
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
};

// Returns the inverse of a real number that is not zero, over a field.
template <typename K>
Root_complex<K> inverse(const Root_complex<K>& a)
{
  return {a.tower, a.tower->inverse(a.x), typename Root_complex<K>::Element{K(0)}};
}

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

template <typename K>
Root_complex<K> real_part(const Root_complex<K>& a)
{
  return {a.tower, a.x, typename Root_complex<K>::Element{K(0)}};
}

// Returns the imaginary part, as a real number.
template <typename K>
Root_complex<K> imaginary_part(const Root_complex<K>& a)
{
  return {a.tower, a.y, typename Root_complex<K>::Element{K(0)}};
}

// Returns the sign of the imaginary part of a product.
template <typename K>
Uncertain<Sign> sign_of_imaginary(const Root_complex<K>& a, const Root_complex<K>& b)
{
  return a.tower->sign_of_products(a.x, b.y, a.y, b.x);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_ROOT_COMPLEX_H
