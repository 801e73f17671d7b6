// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DECIMAL_FLOAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DECIMAL_FLOAT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/number_type_basic.h>

#ifdef CGAL_USE_MPFR
#include <mpfr.h>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {

#if defined(CGAL_USE_MPFR) || defined(DOXYGEN_RUNNING)

/// \ingroup PkgIntrinsicTriangulationsOperators
/// a floating-point number with at least `Digits` decimal digits, whose exponent has no limit in
/// practice. It has the operators and comparisons of `double`, and functions such as `sqrt()`.
/// Results are rounded to the nearest number.
///
/// It is a number of MPFR, or a slower one of Boost.Multiprecision if CGAL does not use MPFR. MPFR
/// is called directly, because the headers of Boost.Multiprecision would add much to the time
/// that a program takes to compile.
template <unsigned int Digits>
class Decimal_float
{
public:
#ifndef DOXYGEN_RUNNING
  // A decimal digit has less than 1000 / 301 binary digits. One more bit is needed, because the
  // first decimal digit need not begin at a bit.
  static constexpr mpfr_prec_t precision = Digits * 1000 / 301 + (Digits * 1000 % 301 == 0 ? 1 : 2);

  Decimal_float() { mpfr_custom_init_set(m_value, MPFR_ZERO_KIND, 0, precision, initialized()); }
  Decimal_float(const Decimal_float& x) : Decimal_float() { mpfr_set(m_value, x.m_value, nearest); }
  template <typename Arithmetic, typename = std::enable_if_t<std::is_arithmetic_v<Arithmetic>>>
  Decimal_float(Arithmetic x) : Decimal_float()
  {
    if constexpr(std::is_floating_point_v<Arithmetic>)
      mpfr_set_d(m_value, x, nearest);
    else if constexpr(std::is_signed_v<Arithmetic>)
      mpfr_set_si(m_value, x, nearest);
    else
      mpfr_set_ui(m_value, x, nearest);
  }
  template <unsigned int Other>
  explicit Decimal_float(const Decimal_float<Other>& x) : Decimal_float()
  {
    mpfr_set(m_value, x.value(), nearest);
  }
  explicit Decimal_float(const std::string& text) : Decimal_float()
  {
    mpfr_set_str(m_value, text.c_str(), 10, nearest);
  }
  Decimal_float& operator=(const Decimal_float& x)
  {
    mpfr_set(m_value, x.m_value, nearest);
    return *this;
  }
#endif

  /// returns the nearest number of type `double`.
  explicit operator double() const { return mpfr_get_d(m_value, nearest); }

  /// returns the number as text with at most this number of decimal digits.
  std::string str(int digits) const
  {
    const int size = mpfr_snprintf(nullptr, 0, "%.*Rg", digits, m_value);
    std::string result(std::size_t(size) + 1, '\0'); // with the zero at the end of a text
    mpfr_snprintf(result.data(), result.size(), "%.*Rg", digits, m_value);
    result.pop_back();
    return result;
  }

  /// returns the number for functions of MPFR.
  mpfr_srcptr value() const { return m_value; }

#ifndef DOXYGEN_RUNNING
  Decimal_float& operator+=(const Decimal_float& x) { return set(mpfr_add, *this, x); }
  Decimal_float& operator-=(const Decimal_float& x) { return set(mpfr_sub, *this, x); }
  Decimal_float& operator*=(const Decimal_float& x) { return set(mpfr_mul, *this, x); }
  Decimal_float& operator/=(const Decimal_float& x) { return set(mpfr_div, *this, x); }

  friend Decimal_float operator+(Decimal_float x, const Decimal_float& y) { return x += y; }
  friend Decimal_float operator-(Decimal_float x, const Decimal_float& y) { return x -= y; }
  friend Decimal_float operator*(Decimal_float x, const Decimal_float& y) { return x *= y; }
  friend Decimal_float operator/(Decimal_float x, const Decimal_float& y) { return x /= y; }
  friend Decimal_float operator-(const Decimal_float& x) { return of(mpfr_neg, x); }
  friend Decimal_float operator+(const Decimal_float& x) { return x; }

  friend bool operator==(const Decimal_float& x, const Decimal_float& y)
  {
    return mpfr_equal_p(x.m_value, y.m_value) != 0;
  }
  friend bool operator!=(const Decimal_float& x, const Decimal_float& y) { return !(x == y); }
  friend bool operator<(const Decimal_float& x, const Decimal_float& y)
  {
    return mpfr_less_p(x.m_value, y.m_value) != 0;
  }
  friend bool operator>(const Decimal_float& x, const Decimal_float& y) { return y < x; }
  friend bool operator<=(const Decimal_float& x, const Decimal_float& y)
  {
    return mpfr_lessequal_p(x.m_value, y.m_value) != 0;
  }
  friend bool operator>=(const Decimal_float& x, const Decimal_float& y) { return y <= x; }

  friend Decimal_float abs(const Decimal_float& x) { return of(mpfr_abs, x); }
  friend Decimal_float fabs(const Decimal_float& x) { return of(mpfr_abs, x); }
  friend Decimal_float sqrt(const Decimal_float& x) { return of(mpfr_sqrt, x); }
  friend Decimal_float exp(const Decimal_float& x) { return of(mpfr_exp, x); }
  friend Decimal_float log(const Decimal_float& x) { return of(mpfr_log, x); }
  friend Decimal_float cos(const Decimal_float& x) { return of(mpfr_cos, x); }
  friend Decimal_float sin(const Decimal_float& x) { return of(mpfr_sin, x); }
  friend Decimal_float atan2(const Decimal_float& y, const Decimal_float& x)
  {
    return Decimal_float().set(mpfr_atan2, y, x);
  }
  friend Decimal_float ldexp(const Decimal_float& x, long exponent)
  {
    Decimal_float result;
    mpfr_mul_2si(result.m_value, x.m_value, exponent, nearest);
    return result;
  }
  friend Decimal_float frexp(const Decimal_float& x, int* exponent)
  {
    Decimal_float result;
    mpfr_exp_t e = 0;
    mpfr_frexp(&e, result.m_value, x.m_value, nearest);
    *exponent = static_cast<int>(e);
    return result;
  }
  friend bool isfinite(const Decimal_float& x) { return mpfr_number_p(x.m_value) != 0; }
  friend bool isnan(const Decimal_float& x) { return mpfr_nan_p(x.m_value) != 0; }
  friend std::ostream& operator<<(std::ostream& out, const Decimal_float& x)
  {
    return out << static_cast<double>(x);
  }
#endif

private:
  static constexpr mpfr_rnd_t nearest = MPFR_RNDN;
  static constexpr std::size_t number_of_limbs = (precision - 1) / GMP_NUMB_BITS + 1;

  mp_limb_t* initialized()
  {
    mpfr_custom_init(m_limb, precision);
    return m_limb;
  }

  // Sets the number to the value of a function of MPFR.
  template <typename Function>
  Decimal_float& set(const Function& function, const Decimal_float& x, const Decimal_float& y)
  {
    function(m_value, x.m_value, y.m_value, nearest);
    return *this;
  }
  template <typename Function>
  static Decimal_float of(const Function& function, const Decimal_float& x)
  {
    Decimal_float result;
    function(result.m_value, x.m_value, nearest);
    return result;
  }

  mpfr_t m_value;
  mp_limb_t m_limb[number_of_limbs];
};

#else

template <unsigned int Digits>
using Decimal_float = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>,
                                                    boost::multiprecision::et_off>;

#endif

namespace internal {

// Numbers are enclosed with at most this number of binary digits.
constexpr int most_digits = 1024;

// The type has 309 decimal digits, which are at least `most_digits` binary digits.
typedef Decimal_float<309> Long_float;

// Stores the unit of roundoff u of a number type.
template <typename N>
struct Rounding
{
  static constexpr double unit() { return std::numeric_limits<N>::epsilon() / 2; }
};

// The unit is zero if it is below the range of `double`.
template <unsigned int Digits>
struct Rounding<Decimal_float<Digits>>
{
  static double unit()
  {
    return std::ldexp(1.0, -std::numeric_limits<Decimal_float<Digits>>::digits);
  }
};

template <typename Type_>
class Decimal_float_structure : public Algebraic_structure_traits_base<Type_, Field_with_sqrt_tag>
{
public:
  typedef Tag_false Is_exact;
  typedef Tag_true Is_numerical_sensitive;

  struct Sqrt
  {
    typedef Type_ result_type;
    Type_ operator()(const Type_& x) const { return sqrt(x); }
  };
};

template <typename Type_>
class Decimal_float_embedding : public INTERN_RET::Real_embeddable_traits_base<Type_, Tag_true>
{
public:
  struct Is_finite
  {
    typedef bool result_type;
    bool operator()(const Type_& x) const { return bool(isfinite(x)); }
  };
  struct To_double
  {
    typedef double result_type;
    double operator()(const Type_& x) const { return static_cast<double>(x); }
  };
  struct To_interval
  {
    typedef std::pair<double, double> result_type;
    result_type operator()(const Type_& x) const
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      const double nearest = static_cast<double>(x);
      return {nearest > x ? std::nextafter(nearest, -infinity) : nearest,
              nearest < x ? std::nextafter(nearest, infinity) : nearest};
    }
  };
};

} // namespace internal
} // namespace Intrinsic_triangulations

template <unsigned int Digits>
class Algebraic_structure_traits<Intrinsic_triangulations::Decimal_float<Digits>>
  : public Intrinsic_triangulations::internal::Decimal_float_structure<
      Intrinsic_triangulations::Decimal_float<Digits>>
{};

template <unsigned int Digits>
class Real_embeddable_traits<Intrinsic_triangulations::Decimal_float<Digits>>
  : public Intrinsic_triangulations::internal::Decimal_float_embedding<
      Intrinsic_triangulations::Decimal_float<Digits>>
{};

} // namespace CGAL

#if defined(CGAL_USE_MPFR) && !defined(DOXYGEN_RUNNING)
template <unsigned int Digits>
class std::numeric_limits<CGAL::Intrinsic_triangulations::Decimal_float<Digits>>
{
  typedef CGAL::Intrinsic_triangulations::Decimal_float<Digits> Number;

public:
  static constexpr bool is_specialized = true, is_signed = true, is_integer = false,
                        is_exact = false, has_infinity = true, has_quiet_NaN = true;
  static constexpr int radix = 2, digits = int(Number::precision), digits10 = int(Digits),
                       max_digits10 = digits10 + 3,
                       min_exponent = (std::numeric_limits<int>::min)(),
                       max_exponent = (std::numeric_limits<int>::max)();
  static Number(min)() { return ldexp(Number(0.5), mpfr_get_emin()); }
  static Number(max)() { return ldexp(1 - epsilon() / 2, mpfr_get_emax()); }
  static Number epsilon() { return ldexp(Number(1), 1 - digits); }
  static Number infinity() { return Number(std::numeric_limits<double>::infinity()); }
  static Number quiet_NaN() { return Number(std::numeric_limits<double>::quiet_NaN()); }
};
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DECIMAL_FLOAT_H
