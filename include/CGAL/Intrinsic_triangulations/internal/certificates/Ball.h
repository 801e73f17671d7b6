// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_BALL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_BALL_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact_numbers.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// The bound for quotients is the largest.
template <>
struct Rounding<Double_double>
{
  static constexpr double unit() { return 0x1p-102; }
};

// A ball is a disk that contains a complex number. Operations round to nearest and add their
// rounding error to the radius. The radius is rounded, too, so it is enlarged. If it underflows,
// the least positive number replaces it.
template <typename N>
struct Ball
{
  N x{0}, y{0};
  double radius{0};

  // The bound must be tight, because products raise its excess to the power of the number of
  // factors. The added term covers squares that underflow.
  double norm() const
  {
    const double u = to_double(x), v = to_double(y);
    return std::sqrt(u * u + v * v) + 1e-150;
  }

  // Adds `error` units of roundoff, relative to the midpoint, to the radius.
  Ball with_error(int error) const
  {
    return {x, y, grown(radius + error * Rounding<N>::unit() * norm())};
  }

  friend Ball operator-(const Ball& a) { return {-a.x, -a.y, a.radius}; }
  friend Ball operator+(const Ball& a, const Ball& b)
  {
    return Ball{a.x + b.x, a.y + b.y, a.radius + b.radius}.with_error(2);
  }
  friend Ball operator-(const Ball& a, const Ball& b) { return a + -b; }
  friend Ball operator*(const Ball& a, const Ball& b)
  {
    const double norm_a = a.norm(), norm_b = b.norm();
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x,
            grown(norm_a * b.radius + a.radius * (norm_b + b.radius) +
                  3 * Rounding<N>::unit() * (norm_a * norm_b))};
  }
  friend Ball conj(const Ball& a) { return {a.x, -a.y, a.radius}; }

private:
  static double grown(double radius)
  {
    return radius * (1 + 32 * std::numeric_limits<double>::epsilon()) +
           (std::numeric_limits<double>::min)();
  }
};

// Returns the sign of a coordinate of a ball.
template <typename N>
Uncertain<Sign> certain_sign(const N& coordinate, double radius)
{
  if(coordinate > radius)
    return POSITIVE;
  if(coordinate < -radius)
    return NEGATIVE;
  return Uncertain<Sign>::indeterminate();
}

template <typename N>
Uncertain<Sign> sign_of_real(const Ball<N>& a)
{
  return certain_sign(a.x, a.radius);
}

template <typename N>
Uncertain<Sign> sign_of_imaginary(const Ball<N>& a)
{
  return certain_sign(a.y, a.radius);
}

template <typename N>
Uncertain<Sign> sign_of_imaginary(const Ball<N>& a, const Ball<N>& b)
{
  return sign_of_imaginary(a * b);
}

template <typename N>
Ball<N> real_part(const Ball<N>& a)
{
  return {a.x, N(0), a.radius};
}

// Returns the imaginary part, as a real number.
template <typename N>
Ball<N> imaginary_part(const Ball<N>& a)
{
  return {a.y, N(0), a.radius};
}

template <typename N>
Ball<N> root(const Ball<N>& a)
{
  if(!(a.x > a.radius))
    return {N(0), N(0), std::sqrt(to_double(a.x) + a.radius) * (1 + Rounding<float>::unit())};
  const N root = sqrt(a.x);
  return Ball<N>{root, N(0), a.radius / to_double(root)}.with_error(4);
}

// Returns `value` up to an error. Numbers of type `double` are subtracted from it one after the
// other. The loop ends if the remainder is negligible, or intervals get no smaller.
template <typename N, typename K>
Ball<N> to_ball(K value)
{
  if constexpr(Is_extension<K>::value) {
    const Ball<N> a = to_ball<N>(value.a0());
    return value.is_extended() ? a + to_ball<N>(value.a1()) * root(to_ball<N>(value.root())) : a;
  } else {
    Ball<N> ball{N(0), N(0), std::numeric_limits<double>::infinity()};
    for(;;) {
      const auto before = CGAL::to_interval(value);
      const double part = before.first + (before.second - before.first) / 2;
      value -= K(part);
      const auto rest = CGAL::to_interval(value);
      const double error = (std::max)(-rest.first, rest.second);
      if(!(error < ball.radius))
        return ball.with_error(1);
      ball = {N(ball.x + N(part)), N(0), error};
      if(!(error > Rounding<N>::unit() * ball.norm()))
        return ball.with_error(1);
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_BALL_H
