// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DECIMAL_FLOAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DECIMAL_FLOAT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/number_type_basic.h>

#ifdef CGAL_USE_MPFR
#include <boost/multiprecision/mpfr.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators a floating-point number with at least `Digits`
/// decimal digits, whose exponent has no limit in practice. It is a number of Boost.Multiprecision,
/// with MPFR if CGAL uses MPFR. Numbers of MPFR are faster than numbers of Boost alone.
template <unsigned int Digits>
using Decimal_float = boost::multiprecision::number<
#ifdef CGAL_USE_MPFR
  boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
#else
  boost::multiprecision::cpp_bin_float<Digits>,
#endif
  boost::multiprecision::et_off>;

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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DECIMAL_FLOAT_H
