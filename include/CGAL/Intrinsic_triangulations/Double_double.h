// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOUBLE_DOUBLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOUBLE_DOUBLE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <cmath>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents the sum of two numbers of type `double`. The first one is the sum rounded to `double`.
// It has some 106 binary digits, with the exponents of `double`. Arithmetic is by Joldes, Muller
// and Popescu (2017), and the square root by Lefevre et al. (2023). Let u = 2^-53 be the rounding
// unit of `double`. Relative errors are at most 3 u^2 for sums, 7 u^2 for products, 16 u^2 for
// quotients and 4 u^2 for roots. These bounds hold if products of first parts are in the range of
// `numeric_limits`. Beyond it digits are lost, and infinity becomes NaN.
//
// Operations on `double` must round to nearest, without additional digits.
class Double_double
{
  typedef Double_double Self;

public:
  constexpr Double_double(double x = 0) : m_high(x), m_low(0) {}

  constexpr double high() const { return m_high; }
  constexpr double low() const { return m_low; }
  explicit constexpr operator double() const { return m_high; }

  // Returns the sum of two numbers and its rounding error (Knuth).
  static constexpr Self exact_sum(double x, double y)
  {
    const double s = x + y, t = s - x;
    return {s, (x - (s - t)) + (y - t)};
  }

  // Returns a product and its rounding error, unless the error underflows.
  static Self exact_product(double x, double y)
  {
    const double p = x * y;
#ifdef FP_FAST_FMA
    return {p, std::fma(x, y, -p)};
#else // Dekker's: halves have exact products
    const Self a = halves(x), b = halves(y);
    return {p, ((a.m_high * b.m_high - p) + a.m_high * b.m_low + a.m_low * b.m_high) +
                 a.m_low * b.m_low};
#endif
  }

  friend Self operator-(Self x) { return {-x.m_high, -x.m_low}; }

  friend Self operator+(Self x, Self y)
  {
    const Self s = exact_sum(x.m_high, y.m_high), t = exact_sum(x.m_low, y.m_low),
               v = ordered_sum(s.m_high, s.m_low + t.m_high);
    return ordered_sum(v.m_high, t.m_low + v.m_low);
  }
  friend Self operator-(Self x, Self y) { return x + -y; }

  friend Self operator*(Self x, Self y)
  {
    const Self p = exact_product(x.m_high, y.m_high);
    return ordered_sum(p.m_high, p.m_low + (x.m_high * y.m_low + x.m_low * y.m_high));
  }

  friend Self operator/(Self x, Self y)
  {
    const double quotient = x.m_high / y.m_high;
    const Self r = y * Self(quotient);
    return ordered_sum(quotient, ((x.m_high - r.m_high) + (x.m_low - r.m_low)) / y.m_high);
  }

  friend Self sqrt(Self x)
  {
    const double root = std::sqrt(x.m_high);
    if(!(root > 0))
      return root;
    const Self square = exact_product(root, root);
    return ordered_sum(root, ((x.m_high - square.m_high) - square.m_low + x.m_low) / (2 * root));
  }

  Self& operator+=(Self y) { return *this = *this + y; }
  Self& operator-=(Self y) { return *this = *this - y; }
  Self& operator*=(Self y) { return *this = *this * y; }
  Self& operator/=(Self y) { return *this = *this / y; }

  friend bool operator<(Self x, Self y)
  {
    return x.m_high < y.m_high || (x.m_high == y.m_high && x.m_low < y.m_low);
  }
  friend bool operator==(Self x, Self y) { return x.m_high == y.m_high && x.m_low == y.m_low; }
  friend bool operator!=(Self x, Self y) { return !(x == y); }
  friend bool operator>(Self x, Self y) { return y < x; }
  friend bool operator<=(Self x, Self y) { return x < y || x == y; }
  friend bool operator>=(Self x, Self y) { return y <= x; }

  friend Self abs(Self x) { return x.m_high < 0 ? -x : x; }

  friend double to_double(Self x) { return x.m_high; }

  friend Self ldexp(Self x, int exponent)
  {
    if(std::abs(exponent) > 1000)
      return {std::ldexp(x.m_high, exponent), std::ldexp(x.m_low, exponent)};
    const double factor = std::ldexp(1., exponent);
    return {factor * x.m_high, factor * x.m_low};
  }

private:
  constexpr Double_double(double high, double low) : m_high(high), m_low(low) {}

  // Returns the sum and its rounding error (Dekker).
  // \pre the absolute value of `y` does not exceed the absolute value of `x`
  static Self ordered_sum(double x, double y)
  {
    const double s = x + y;
    return {s, y - (s - x)};
  }

  static Self halves(double x)
  {
    const double t = 134217729 * x, high = t - (t - x); // 2^27 + 1
    return {high, x - high};
  }

  double m_high, m_low;
};

} // namespace CGAL::Intrinsic_triangulations::internal

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsFormulas
/// a number with twice the digits of `double`, and its exponents: the sum of two `double`. Relative
/// errors of operations are at most \f$2^{-102}\f$.
typedef internal::Double_double Double_double;

} // namespace CGAL::Intrinsic_triangulations

/// \cond
// Every sum and product of numbers in this range has a relative error of at most `epsilon()`.
// Products of two roots lose no digits.
template <>
class std::numeric_limits<CGAL::Intrinsic_triangulations::Double_double>
  : public std::numeric_limits<double>
{
  typedef CGAL::Intrinsic_triangulations::Double_double Number;

public:
  static constexpr bool is_iec559 = false;
  static constexpr int digits = 104, digits10 = 31, max_digits10 = 33;
  static constexpr Number epsilon() { return 0x1p-103; }
  static constexpr Number(min)() { return 0x1p-916; }
  static constexpr Number(max)() { return 0x1p996; }
  static constexpr Number lowest() { return -0x1p996; }
  static constexpr Number infinity() { return std::numeric_limits<double>::infinity(); }
  static constexpr Number quiet_NaN() { return std::numeric_limits<double>::quiet_NaN(); }
};
/// \endcond

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOUBLE_DOUBLE_H
