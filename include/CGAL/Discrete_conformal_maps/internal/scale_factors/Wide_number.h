// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_WIDE_NUMBER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_WIDE_NUMBER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents a number with the digits of `Mantissa`, `double` or `Double_double`, and a separate
// exponent. The lengths of a strip that is mapped to a disk differ by a factor of e^n for n squares
// in a row. They are beyond the range of both types. Exponents are multiples of 512, so that most
// operations do not change them.
template <typename Mantissa>
class Wide_number
{
public:
  Wide_number(double x = 0) : m_mantissa(x), m_window(0) { normalize(); }
  Wide_number(const Double_double& x) : m_mantissa(static_cast<Mantissa>(x)), m_window(0)
  {
    normalize();
  }
  // Constructs `mantissa` times a power of two.
  explicit Wide_number(const Mantissa& mantissa, std::int64_t exponent)
    : m_mantissa(mantissa), m_window(exponent / window)
  {
    using std::ldexp;
    if(const int rest = static_cast<int>(exponent % window))
      m_mantissa = ldexp(m_mantissa, rest);
    normalize();
  }
  template <typename Other>
  explicit Wide_number(const Wide_number<Other>& x)
    : Wide_number(Mantissa(x.mantissa()), x.exponent())
  {}

  // Returns the mantissa, which is zero, not finite, or from 2^-256 to 2^256 by absolute value.
  const Mantissa& mantissa() const { return m_mantissa; }
  // Returns the exponent, which is zero if the mantissa is zero or not finite.
  std::int64_t exponent() const { return window * m_window; }
  bool is_finite() const { return std::isfinite(leading_part()); }
  // Returns a number with the same sign, which is zero or not finite if the number is.
  double leading_part() const { return static_cast<double>(m_mantissa); }

  explicit operator double() const { return static_cast<double>(in_range_of_mantissa()); }

  // Returns the number as `Mantissa`, or zero or infinity beyond its range.
  Mantissa in_range_of_mantissa() const
  {
    using std::ldexp;
    constexpr std::int64_t limit = 8;
    if(m_window == 0)
      return m_mantissa;
    return ldexp(m_mantissa, static_cast<int>(window * std::clamp(m_window, -limit, limit)));
  }

  friend Wide_number operator-(const Wide_number& x)
  {
    return in_window(-x.m_mantissa, x.m_window);
  }
  friend Wide_number operator+(const Wide_number& x, const Wide_number& y)
  {
    return x.m_window == y.m_window  ? in_window(x.m_mantissa + y.m_mantissa, x.m_window)
           : x.is_absorbed_by(y)     ? y
           : y.is_absorbed_by(x)     ? x
           : x.m_window > y.m_window ? in_window(x.m_mantissa + y.in_next_window(), x.m_window)
                                     : in_window(x.in_next_window() + y.m_mantissa, y.m_window);
  }
  friend Wide_number operator-(const Wide_number& x, const Wide_number& y) { return x + -y; }
  friend Wide_number operator*(const Wide_number& x, const Wide_number& y)
  {
    return in_window(x.m_mantissa * y.m_mantissa, x.m_window + y.m_window);
  }
  friend Wide_number operator/(const Wide_number& x, const Wide_number& y)
  {
    return in_window(x.m_mantissa / y.m_mantissa, x.m_window - y.m_window);
  }

  Wide_number& operator+=(const Wide_number& y) { return *this = *this + y; }
  Wide_number& operator-=(const Wide_number& y) { return *this = *this - y; }
  Wide_number& operator*=(const Wide_number& y) { return *this = *this * y; }
  Wide_number& operator/=(const Wide_number& y) { return *this = *this / y; }

  // Returns a quotient, which is zero or infinite beyond the range of `double`.
  friend double rounded_quotient(const Wide_number& x, const Wide_number& y)
  {
    const double quotient = x.leading_part() / y.leading_part();
    constexpr std::int64_t limit = 5; // beyond the range, whatever the mantissas are
    return x.m_window == y.m_window
             ? quotient
             : std::ldexp(quotient, static_cast<int>(
                                      window * std::clamp(x.m_window - y.m_window, -limit, limit)));
  }

  friend bool operator<(const Wide_number& x, const Wide_number& y) { return x.order(y) < 0; }
  friend bool operator>(const Wide_number& x, const Wide_number& y) { return x.order(y) > 0; }
  friend bool operator<=(const Wide_number& x, const Wide_number& y) { return x.order(y) <= 0; }
  friend bool operator>=(const Wide_number& x, const Wide_number& y) { return x.order(y) >= 0; }
  friend bool operator==(const Wide_number& x, const Wide_number& y) { return x.order(y) == 0; }
  friend bool operator!=(const Wide_number& x, const Wide_number& y) { return !(x == y); }

  friend Wide_number abs(const Wide_number& x) { return x.leading_part() < 0 ? -x : x; }
  friend Wide_number ldexp(const Wide_number& x, int exponent)
  {
    return Wide_number(x.m_mantissa, x.exponent() + exponent);
  }
  friend Wide_number sqrt(const Wide_number& x)
  {
    using std::ldexp;
    using std::sqrt;
    const int odd = static_cast<int>(x.m_window & 1);
    return in_window(sqrt(odd != 0 ? ldexp(x.m_mantissa, window) : x.m_mantissa),
                     (x.m_window - odd) / 2);
  }

  friend Wide_number exp(const Wide_number& x)
  {
    using std::exp;
    const Mantissa power = x.in_range_of_mantissa();
    const double quotient = std::round(static_cast<double>(power) / static_cast<double>(ln_two()));
    if(!(std::abs(quotient) < 0x1p52)) // nor are there such exponents
      return Wide_number(exp(power), 0);
    return Wide_number(exp(Mantissa(power - Mantissa(quotient) * ln_two())),
                       static_cast<std::int64_t>(quotient));
  }
  friend Wide_number log(const Wide_number& x)
  {
    using std::log;
    return Wide_number(log(x.m_mantissa) + Mantissa(static_cast<double>(x.exponent())) * ln_two(),
                       0);
  }
  friend Wide_number atan2(const Wide_number& y, const Wide_number& x)
  {
    using std::atan2;
    const auto [rise, run] = in_common_unit(y, x);
    return Wide_number(atan2(rise, run), 0);
  }

  // Returns both numbers, times a common power of two with which the greater one is in the range of
  // `Mantissa`. The other can become zero.
  friend std::array<Mantissa, 2> in_common_unit(const Wide_number& x, const Wide_number& y)
  {
    if(x.m_window == y.m_window)
      return {x.m_mantissa, y.m_mantissa};
    const std::int64_t last = x.leading_part() == 0   ? y.m_window
                              : y.leading_part() == 0 ? x.m_window
                                                      : (std::max)(x.m_window, y.m_window);
    const auto scaled = [&](const Wide_number& z) {
      return in_window(z.m_mantissa, z.m_window - last).in_range_of_mantissa();
    };
    return {scaled(x), scaled(y)};
  }

private:
  // Numbers in neighboring windows differ by this power of two. A mantissa is at least the root of
  // its inverse, and less than the root.
  static constexpr int window = 512;
  static constexpr double step_of_window = 0x1p512, least_mantissa = 0x1p-256;

  struct Window
  {
    std::int64_t index;
  };
  Wide_number(const Mantissa& mantissa, Window w) : m_mantissa(mantissa), m_window(w.index)
  {
    normalize();
  }

  static Mantissa ln_two()
  {
    return static_cast<Mantissa>(Intrinsic_triangulations::internal::ln_two());
  }

  // Returns `mantissa` times 2^(512 k).
  static Wide_number in_window(const Mantissa& mantissa, std::int64_t k)
  {
    return Wide_number(mantissa, Window{k});
  }

  // Normalizes the mantissa. Products and quotients of normalized mantissas are in their window or
  // in the next one.
  void normalize()
  {
    const double size = std::abs(leading_part());
    if(size >= least_mantissa && size < 1 / least_mantissa)
      return;
    if(size >= 1 / least_mantissa && size < step_of_window / least_mantissa) {
      m_mantissa = in_next_window();
      ++m_window;
    } else if(size >= least_mantissa / step_of_window && size < least_mantissa) {
      m_mantissa = m_mantissa * Mantissa(step_of_window);
      --m_window;
    } else
      move_far();
  }

  void move_far()
  {
    using std::ldexp;
    if(leading_part() == 0 || !is_finite()) {
      m_window = 0;
      return;
    }
    const int exponent = std::ilogb(leading_part()) + window / 2,
              step = (exponent - (exponent < 0 ? window - 1 : 0)) / window;
    m_mantissa = ldexp(m_mantissa, -window * step);
    m_window += step;
  }

  // Returns the mantissa for the window above.
  Mantissa in_next_window() const { return m_mantissa * Mantissa(1 / step_of_window); }

  // Returns whether a sum of both equals the other, in a different window.
  bool is_absorbed_by(const Wide_number& other) const
  {
    if(!other.is_finite() || leading_part() == 0)
      return true;
    return is_finite() && other.leading_part() != 0 && m_window < other.m_window - 1;
  }

  // Returns a number with the sign of the difference, or NaN if it is undefined. Numbers in
  // different windows differ in size, unless one is zero.
  double order(const Wide_number& other) const
  {
    if(!is_finite() || !other.is_finite())
      return leading_part() == other.leading_part() ? 0 : leading_part() - other.leading_part();
    if(m_window == other.m_window)
      return static_cast<double>(Mantissa(m_mantissa - other.m_mantissa));
    const bool is_greater =
      other.leading_part() == 0 || (leading_part() != 0 && m_window > other.m_window);
    return is_greater ? leading_part() : -other.leading_part();
  }

  Mantissa m_mantissa;
  std::int64_t m_window;
};

// Selects a number type for logarithms of numbers of type `FT`. They need no separate exponents.
template <typename FT>
struct Logarithm_of
{
  typedef FT type;
};
template <typename Mantissa>
struct Logarithm_of<Wide_number<Mantissa>>
{
  typedef Mantissa type;
};

template <typename Mantissa>
int exponent_of(const Wide_number<Mantissa>& x)
{
  constexpr std::int64_t limit = std::numeric_limits<int>::max();
  return static_cast<int>(std::clamp(x.exponent(), -limit, limit));
}

} // namespace CGAL::Discrete_conformal_maps::internal

// No computation can exceed the range of exponents.
template <typename Mantissa>
class std::numeric_limits<CGAL::Discrete_conformal_maps::internal::Wide_number<Mantissa>>
  : public std::numeric_limits<Mantissa>
{
  typedef CGAL::Discrete_conformal_maps::internal::Wide_number<Mantissa> Number;

public:
  static constexpr bool is_iec559 = false;
  static Number epsilon() { return Number(std::numeric_limits<Mantissa>::epsilon(), 0); }
  static Number(min)() { return Number(Mantissa(0.5), -(std::int64_t(1) << 52)); }
  static Number(max)() { return Number(Mantissa(0.5), std::int64_t(1) << 52); }
  static Number lowest() { return -(max)(); }
  static Number infinity() { return Number(std::numeric_limits<Mantissa>::infinity(), 0); }
  static Number quiet_NaN() { return Number(std::numeric_limits<Mantissa>::quiet_NaN(), 0); }
};

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_WIDE_NUMBER_H
