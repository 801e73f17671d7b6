// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LONG_FLOAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LONG_FLOAT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/number_type_basic.h>

#ifdef CGAL_USE_MPFR
#include <CGAL/Gmpfr.h>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations::internal {

// The number of binary digits with which numbers are enclosed in the end.
constexpr int most_digits = 1024;

// A floating point number with the digits of the `Long_float_precision` that lives. Without MPFR
// it always has as many as can be asked for.
#ifdef CGAL_USE_MPFR

typedef Gmpfr Long_float;

class Long_float_precision
{
public:
  explicit Long_float_precision(long bits) : m_before(Gmpfr::set_default_precision(bits)) {}
  ~Long_float_precision() { Gmpfr::set_default_precision(m_before); }
  Long_float_precision(const Long_float_precision&) = delete;
  Long_float_precision& operator=(const Long_float_precision&) = delete;

  static double unit()
  {
    return std::ldexp(1.0, -static_cast<int>(Gmpfr::get_default_precision()));
  }

private:
  Gmpfr::Precision_type m_before;
};

#else

typedef boost::multiprecision::number<
  boost::multiprecision::cpp_bin_float<most_digits, boost::multiprecision::digit_base_2>,
  boost::multiprecision::et_off>
  Long_float;

struct Long_float_precision
{
  explicit Long_float_precision(long /* bits */) {}
  static double unit() { return std::ldexp(1.0, -most_digits); }
};

#endif // CGAL_USE_MPFR

// the roundoff u of a number type
template <typename N>
struct Rounding
{
  static constexpr double unit() { return std::numeric_limits<N>::epsilon() / 2; }
};

template <>
struct Rounding<Long_float> : Long_float_precision
{};

} // namespace Intrinsic_triangulations::internal

#ifndef CGAL_USE_MPFR

template <>
class Algebraic_structure_traits<Intrinsic_triangulations::internal::Long_float>
  : public Algebraic_structure_traits_base<Intrinsic_triangulations::internal::Long_float,
                                           Field_with_sqrt_tag>
{
public:
  typedef Tag_false Is_exact;
  typedef Tag_true Is_numerical_sensitive;

  struct Sqrt
  {
    typedef Type result_type;
    Type operator()(const Type& x) const { return boost::multiprecision::sqrt(x); }
  };
};

template <>
class Real_embeddable_traits<Intrinsic_triangulations::internal::Long_float>
  : public INTERN_RET::Real_embeddable_traits_base<Intrinsic_triangulations::internal::Long_float,
                                                   Tag_true>
{
public:
  struct To_double
  {
    typedef double result_type;
    double operator()(const Type& x) const { return x.convert_to<double>(); }
  };
  struct To_interval
  {
    typedef std::pair<double, double> result_type;
    result_type operator()(const Type& x) const
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      const double rounded = x.convert_to<double>();
      return {std::nextafter(rounded, -infinity), std::nextafter(rounded, infinity)};
    }
  };
};

#endif // CGAL_USE_MPFR

} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LONG_FLOAT_H
