// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MULTIPRECISION_FLOAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MULTIPRECISION_FLOAT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Mixed_Cholesky.h>

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <ostream>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {
class Multiprecision_float;
}

#ifndef DOXYGEN_RUNNING
// The range is the range of `double`, in which most numbers are stored.
template <>
class std::numeric_limits<CGAL::Intrinsic_triangulations::Multiprecision_float>
  : public std::numeric_limits<double>
{};
#endif

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators
/// a floating-point number of type `double`, or with at least 2560 binary digits. A result has many
/// digits if an operand has them. So only numbers that depend on such operands take the time of
/// many digits. It has the operators, comparisons and functions of `double`, such as `sqrt()`.
///
/// Coordinates of type `double` are multiples of \f$2^{-1074}\f$. So the height of a triangle with
/// sides of about one is zero or at least as large. Lengths with this number of digits determine
/// it.
class Multiprecision_float
{
public:
  /// the type of numbers with many digits.
  typedef Decimal_float<773> Long;

  /// constructs a number with the digits of `double`.
  template <typename Arithmetic = int,
            typename = std::enable_if_t<std::is_arithmetic_v<Arithmetic>>>
  Multiprecision_float(Arithmetic x = 0) : m_short(static_cast<double>(x))
  {}

  /// constructs a number with many digits.
  explicit Multiprecision_float(const Long& x) : m_short(0), m_long(std::make_shared<Long>(x)) {}

  /// returns whether the number has many digits.
  bool is_long() const { return m_long != nullptr; }

  /// returns the number with many digits.
  Long long_value() const { return m_long ? *m_long : Long(m_short); }

  /// returns the number, rounded.
  explicit operator double() const { return m_long ? static_cast<double>(*m_long) : m_short; }

#ifndef DOXYGEN_RUNNING
  friend Multiprecision_float operator+(const Multiprecision_float& x,
                                        const Multiprecision_float& y)
  {
    return combined(x, y, [](const auto& a, const auto& b) { return a + b; });
  }
  friend Multiprecision_float operator-(const Multiprecision_float& x,
                                        const Multiprecision_float& y)
  {
    return combined(x, y, [](const auto& a, const auto& b) { return a - b; });
  }
  friend Multiprecision_float operator*(const Multiprecision_float& x,
                                        const Multiprecision_float& y)
  {
    return combined(x, y, [](const auto& a, const auto& b) { return a * b; });
  }
  friend Multiprecision_float operator/(const Multiprecision_float& x,
                                        const Multiprecision_float& y)
  {
    return combined(x, y, [](const auto& a, const auto& b) { return a / b; });
  }
  friend Multiprecision_float operator-(const Multiprecision_float& x)
  {
    return of(x, [](const auto& a) { return -a; });
  }
  Multiprecision_float& operator+=(const Multiprecision_float& x) { return *this = *this + x; }
  Multiprecision_float& operator-=(const Multiprecision_float& x) { return *this = *this - x; }
  Multiprecision_float& operator*=(const Multiprecision_float& x) { return *this = *this * x; }
  Multiprecision_float& operator/=(const Multiprecision_float& x) { return *this = *this / x; }

  friend bool operator==(const Multiprecision_float& x, const Multiprecision_float& y)
  {
    return with_equal_digits(x, y, [](const auto& a, const auto& b) { return a == b; });
  }
  friend bool operator<(const Multiprecision_float& x, const Multiprecision_float& y)
  {
    return with_equal_digits(x, y, [](const auto& a, const auto& b) { return a < b; });
  }
  friend bool operator<=(const Multiprecision_float& x, const Multiprecision_float& y)
  {
    return with_equal_digits(x, y, [](const auto& a, const auto& b) { return a <= b; });
  }
  friend bool operator!=(const Multiprecision_float& x, const Multiprecision_float& y)
  {
    return !(x == y);
  }
  friend bool operator>(const Multiprecision_float& x, const Multiprecision_float& y)
  {
    return y < x;
  }
  friend bool operator>=(const Multiprecision_float& x, const Multiprecision_float& y)
  {
    return y <= x;
  }

  friend Multiprecision_float abs(const Multiprecision_float& x) { return x < 0 ? -x : x; }
  friend Multiprecision_float fabs(const Multiprecision_float& x) { return x < 0 ? -x : x; }
  friend Multiprecision_float sqrt(const Multiprecision_float& x)
  {
    using std::sqrt;
    return of(x, [](const auto& a) { return sqrt(a); });
  }
  friend Multiprecision_float cos(const Multiprecision_float& x)
  {
    using std::cos;
    return of(x, [](const auto& a) { return cos(a); });
  }
  friend Multiprecision_float sin(const Multiprecision_float& x)
  {
    using std::sin;
    return of(x, [](const auto& a) { return sin(a); });
  }
  friend Multiprecision_float atan2(const Multiprecision_float& y, const Multiprecision_float& x)
  {
    using std::atan2;
    return combined(y, x, [](const auto& a, const auto& b) { return atan2(a, b); });
  }
  friend Multiprecision_float hypot(const Multiprecision_float& x, const Multiprecision_float& y)
  {
    return combined(x, y, [](const auto& a, const auto& b) {
      if constexpr(std::is_same_v<decltype(a), const double&>)
        return std::hypot(a, b);
      else
        return sqrt(a * a + b * b); // the exponents have room for squares
    });
  }
  friend Multiprecision_float hypot(const Multiprecision_float& x, const Multiprecision_float& y,
                                    const Multiprecision_float& z)
  {
    return hypot(x, hypot(y, z));
  }
  friend Multiprecision_float ldexp(const Multiprecision_float& x, int exponent)
  {
    using std::ldexp;
    return of(x, [exponent](const auto& a) { return ldexp(a, exponent); });
  }
  friend bool isfinite(const Multiprecision_float& x)
  {
    using std::isfinite;
    return x.m_long ? bool(isfinite(*x.m_long)) : isfinite(x.m_short);
  }
  friend std::ostream& operator<<(std::ostream& out, const Multiprecision_float& x)
  {
    return out << static_cast<double>(x);
  }
#endif

private:
  template <typename Function>
  static Multiprecision_float of(const Multiprecision_float& x, const Function& f)
  {
    return x.m_long ? Multiprecision_float(Long(f(*x.m_long))) : Multiprecision_float(f(x.m_short));
  }

  // Calls `f` with two numbers of type `double` or `Long`.
  template <typename Function>
  static auto with_equal_digits(const Multiprecision_float& x, const Multiprecision_float& y,
                                const Function& f) -> decltype(f(0., 0.))
  {
    return x.m_long || y.m_long ? f(x.long_value(), y.long_value()) : f(x.m_short, y.m_short);
  }

  template <typename Function>
  static Multiprecision_float combined(const Multiprecision_float& x, const Multiprecision_float& y,
                                       const Function& f)
  {
    return with_equal_digits(
      x, y, [&](const auto& a, const auto& b) { return Multiprecision_float(f(a, b)); });
  }

  double m_short;
  std::shared_ptr<const Long> m_long; // null if `m_short` is the number
};

namespace internal {

template <>
struct Cholesky_of<Multiprecision_float>
{
  typedef Mixed_Cholesky<Multiprecision_float, double> type;
};

template <>
struct Cholesky_of<std::complex<Multiprecision_float>>
{
  typedef Mixed_Cholesky<std::complex<Multiprecision_float>, std::complex<double>> type;
};

template <>
struct Digits<Multiprecision_float>
{
  static Multiprecision_float few(const Multiprecision_float& x) { return static_cast<double>(x); }

  static bool is_flat(const Multiprecision_float& quadrupled_area,
                      const Multiprecision_float& perimeter)
  {
    constexpr int least_exponent = -1200; // of an area that is not zero
    return quadrupled_area.is_long() &&
           !(quadrupled_area > ldexp(perimeter * perimeter, least_exponent));
  }
};

} // namespace internal
} // namespace Intrinsic_triangulations

template <>
class Algebraic_structure_traits<Intrinsic_triangulations::Multiprecision_float>
  : public Intrinsic_triangulations::internal::Decimal_float_structure<
      Intrinsic_triangulations::Multiprecision_float>
{};

template <>
class Real_embeddable_traits<Intrinsic_triangulations::Multiprecision_float>
  : public Intrinsic_triangulations::internal::Decimal_float_embedding<
      Intrinsic_triangulations::Multiprecision_float>
{};

} // namespace CGAL

#ifndef DOXYGEN_RUNNING
template <>
struct Eigen::NumTraits<CGAL::Intrinsic_triangulations::Multiprecision_float>
  : public Eigen::GenericNumTraits<CGAL::Intrinsic_triangulations::Multiprecision_float>
{
  enum
  {
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 4,
    MulCost = 4
  };
};
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MULTIPRECISION_FLOAT_H
