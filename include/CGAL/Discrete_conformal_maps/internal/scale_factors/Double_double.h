// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLE_DOUBLE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLE_DOUBLE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// The sum of two `double`, the first of which is the sum rounded to `double`: some 106 binary
// digits, with the exponents of `double`. Arithmetic is that of Joldes, Muller and Popescu (2017),
// and the square root that of Lefevre et al. (2023). With a rounding unit u = 2^-53 of `double`,
// relative errors are at most 3 u^2 for sums, 7 u^2 for products, 16 u^2 for quotients and 4 u^2
// for roots, while products of first parts are in the range of `numeric_limits`: beyond it digits
// are lost, and infinity becomes NaN. The exponential function and its relatives have an error of
// about 100 u^2, and times the argument if that is greater.
//
// `double` must be rounded to nearest, without additional digits.
class Double_double
{
  typedef Double_double Self;

public:
  constexpr Double_double(double x = 0) : m_high(x), m_low(0) {}

  constexpr double high() const { return m_high; }
  constexpr double low() const { return m_low; }
  explicit constexpr operator double() const { return m_high; }

  static constexpr Self ln_two() { return {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56}; }

  friend Self operator-(Self x) { return {-x.m_high, -x.m_low}; }

  friend Self operator+(Self x, Self y)
  {
    const Self s = sum(x.m_high, y.m_high), t = sum(x.m_low, y.m_low),
               v = ordered_sum(s.m_high, s.m_low + t.m_high);
    return ordered_sum(v.m_high, t.m_low + v.m_low);
  }
  friend Self operator-(Self x, Self y) { return x + -y; }

  friend Self operator*(Self x, Self y)
  {
    const Self p = product(x.m_high, y.m_high);
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
    const Self square = product(root, root);
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

  friend Self ldexp(Self x, int exponent)
  {
    return {std::ldexp(x.m_high, exponent), std::ldexp(x.m_low, exponent)};
  }

  friend Self exp(Self x)
  {
    if(!(std::abs(x.m_high) < 1000))
      return std::exp(x.m_high);
    const int exponent = static_cast<int>(std::round(x.m_high / ln_two().m_high));
    return ldexp(1 + exponential(x - exponent * ln_two(), 9), exponent);
  }

  // by a step of third order from the logarithm in `double`
  friend Self log(Self x)
  {
    const double first = std::log(x.m_high);
    if(!std::isfinite(first))
      return first;
    const Self rest = x * exp(Self(-first)) - 1;
    return first + (rest - rest * rest / 2);
  }

  friend Self cos(Self x) { return 1 + turn(x).x; }
  friend Self sin(Self x) { return turn(x).y; }

  // by a step of third order from the angle in `double`
  friend Self atan2(Self y, Self x)
  {
    const Self first = std::atan2(y.m_high, x.m_high);
    if(first == 0)
      return x > 0 ? y / x : first;
    const Self cosine = cos(first), sine = sin(first);
    return first + (y * cosine - x * sine) / (x * cosine + y * sine);
  }

private:
  constexpr Double_double(double high, double low) : m_high(high), m_low(low) {}

  // Knuth's sum of two numbers and its rounding error
  static Self sum(double x, double y)
  {
    const double s = x + y, t = s - x;
    return {s, (x - (s - t)) + (y - t)};
  }

  // Dekker's, if `y` is not greater than `x` by absolute value
  static Self ordered_sum(double x, double y)
  {
    const double s = x + y;
    return {s, y - (s - x)};
  }

  // a product and its rounding error
  static Self product(double x, double y)
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

  static Self halves(double x)
  {
    const double t = 134217729 * x, high = t - (t - x); // 2^27 + 1
    return {high, x - high};
  }

  // e^x - 1 of a number or complex number `x`: the series for 2^-n x, and n squarings. Squares of
  // e^x would lose more digits.
  template <typename Number>
  static Number exponential(const Number& x, int n)
  {
    const Number part = ldexp(Self(1), -n) * x;
    Number result = part;
    for(int k = 10; k > 1; --k)
      result = part + Self(1) / k * (part * result);
    for(; n > 0; --n)
      result = Self(2) * result + result * result;
    return result;
  }

  // e^(ix) - 1
  static Plane_vector<Self> turn(Self x)
  {
    return exponential(Plane_vector<Self>{0, x}, 10 + std::clamp(std::ilogb(x.m_high), 0, 60));
  }

  double m_high, m_low;
};

// takes over where double has too few digits
typedef Double_double Extended;

} // namespace CGAL::Discrete_conformal_maps::internal

// The digits for which every sum and product has a relative error of at most `epsilon()`, and the
// range in which products of two roots lose none.
template <>
class std::numeric_limits<CGAL::Discrete_conformal_maps::internal::Double_double>
  : public std::numeric_limits<double>
{
  typedef CGAL::Discrete_conformal_maps::internal::Double_double Number;

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

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLE_DOUBLE_H
