// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MULTIPRECISION_FLOAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MULTIPRECISION_FLOAT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/certificates/Long_float.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Mixed_Cholesky.h>

#include <boost/multiprecision/eigen.hpp>

#include <complex>
#include <type_traits>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators
/// a floating point number with 2560 binary digits. Coordinates of type `double` are multiples of
/// \f$2^{-1074}\f$: the height of a triangle with sides of about one is zero or at least as much,
/// and lengths with so many digits determine it.
typedef internal::Binary_float<2560> Multiprecision_float;

namespace internal {

// Errors are below the range of `double`.
template <>
struct Rounding<Multiprecision_float>
{
  static double unit() { return 0; }
};

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

// Four times the area of a face of no area, divided by the square of its perimeter, is less.
template <>
inline Multiprecision_float flat_face_ratio<Multiprecision_float>()
{
  return ldexp(Multiprecision_float(1), -1200);
}

} // namespace internal
} // namespace Intrinsic_triangulations

template <>
class Algebraic_structure_traits<Intrinsic_triangulations::Multiprecision_float>
  : public Intrinsic_triangulations::internal::Binary_float_structure<
      Intrinsic_triangulations::Multiprecision_float>
{};

template <>
class Real_embeddable_traits<Intrinsic_triangulations::Multiprecision_float>
  : public Intrinsic_triangulations::internal::Binary_float_embedding<
      Intrinsic_triangulations::Multiprecision_float>
{};

} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MULTIPRECISION_FLOAT_H
