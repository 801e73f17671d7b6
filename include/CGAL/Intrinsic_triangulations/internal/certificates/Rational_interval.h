// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_RATIONAL_INTERVAL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_RATIONAL_INTERVAL_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>

namespace CGAL::Intrinsic_triangulations::internal {

// An interval with rational ends. Only square roots are rounded, to so many binary digits after the
// point that what is not zero has a sign, as a rule.
class Rational_interval
{
  typedef Exact_rational Rational;

public:
  Rational_interval(double x = 0) : m_lower(x), m_upper(x) {}
  Rational_interval(const Rational& x) : m_lower(x), m_upper(x) {}
  Rational_interval(const Rational& lower, const Rational& upper) : m_lower(lower), m_upper(upper)
  {}

  friend Rational_interval operator+(const Rational_interval& a, const Rational_interval& b)
  {
    return {Rational(a.m_lower + b.m_lower), Rational(a.m_upper + b.m_upper)};
  }
  friend Rational_interval operator-(const Rational_interval& a, const Rational_interval& b)
  {
    return {Rational(a.m_lower - b.m_upper), Rational(a.m_upper - b.m_lower)};
  }
  friend Rational_interval operator*(const Rational_interval& a, const Rational_interval& b)
  {
    const auto ends =
      std::minmax({Rational(a.m_lower * b.m_lower), Rational(a.m_lower * b.m_upper),
                   Rational(a.m_upper * b.m_lower), Rational(a.m_upper * b.m_upper)});
    return {ends.first, ends.second};
  }

  // \pre `b` is positive
  friend Rational_interval operator/(const Rational_interval& a, const Rational_interval& b)
  {
    return a * Rational_interval(Rational(1 / b.m_upper), Rational(1 / b.m_lower));
  }

  // \throws Numerical_error if a number in `a` is negative
  friend Rational_interval sqrt(const Rational_interval& a)
  {
    if(a.m_lower < 0)
      throw Numerical_error("the root of a negative number is asked for");
    return {root(a.m_lower).m_lower, root(a.m_upper).m_upper};
  }

  friend Uncertain<Sign> sign(const Rational_interval& a)
  {
    return Uncertain<Sign>(CGAL::sign(a.m_lower), CGAL::sign(a.m_upper));
  }

private:
  static constexpr int digits = 512;

  // that of n / d is that of n d, divided by d
  static Rational_interval root(const Rational& x)
  {
    typedef Fraction_traits<Rational> Fraction;
    typedef Fraction::Numerator_type Integer;
    Integer numerator, denominator;
    Fraction::Decompose()(x, numerator, denominator);
    const Integer scale = ipower(Integer(2), digits);
    const Integer root(sqrt(Integer(numerator * denominator * scale * scale))); // rounded down
    Fraction::Compose over;
    denominator *= scale;
    return {over(root, denominator), over(Integer(root + 1), denominator)};
  }

  Rational m_lower, m_upper;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_RATIONAL_INTERVAL_H
