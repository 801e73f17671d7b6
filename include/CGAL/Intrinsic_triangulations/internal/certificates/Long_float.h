// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LONG_FLOAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LONG_FLOAT_H

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
namespace Intrinsic_triangulations::internal {

// A floating-point number with as many binary digits. With 1024, numbers of MPFR take 0.08 us for
// a product and 0.4 us for a root. Numbers of Boost alone take 0.4 us and 50 us.
template <int Digits>
using Binary_float = boost::multiprecision::number<
#ifdef CGAL_USE_MPFR
  boost::multiprecision::mpfr_float_backend<Digits * 302 / 1000,
                                            boost::multiprecision::allocate_stack>,
#else
  boost::multiprecision::cpp_bin_float<Digits, boost::multiprecision::digit_base_2>,
#endif
  boost::multiprecision::et_off>;

// The number of binary digits with which numbers are enclosed in the end.
constexpr int most_digits = 1024;

typedef Binary_float<most_digits> Long_float;

// the roundoff u of a number type
template <typename N>
struct Rounding
{
  static constexpr double unit() { return std::numeric_limits<N>::epsilon() / 2; }
};

template <>
struct Rounding<Long_float>
{
  static double unit() { return std::ldexp(1.0, -most_digits); }
};

template <typename Type_>
class Binary_float_structure : public Algebraic_structure_traits_base<Type_, Field_with_sqrt_tag>
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
class Binary_float_embedding : public INTERN_RET::Real_embeddable_traits_base<Type_, Tag_true>
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

} // namespace Intrinsic_triangulations::internal

template <>
class Algebraic_structure_traits<Intrinsic_triangulations::internal::Long_float>
  : public Intrinsic_triangulations::internal::Binary_float_structure<
      Intrinsic_triangulations::internal::Long_float>
{};

template <>
class Real_embeddable_traits<Intrinsic_triangulations::internal::Long_float>
  : public Intrinsic_triangulations::internal::Binary_float_embedding<
      Intrinsic_triangulations::internal::Long_float>
{};

} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LONG_FLOAT_H
