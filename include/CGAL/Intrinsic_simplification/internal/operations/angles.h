// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_ANGLES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_ANGLES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <cmath>
#include <complex>

namespace CGAL::Intrinsic_simplification::internal {

using Intrinsic_triangulations::pi;

// Stores the sum of angles between 0 and pi, given by their cosines and sines. It is a product of
// complex numbers, and counts the quadrants that the product passes. One arc tangent suffices for
// all.
class Angle_sum
{
public:
  // Adds the angle with a cosine and a sine that is not negative.
  void add(double cosine, double sine)
  {
    const double c = m_cosine * cosine - m_sine * sine;
    m_sine = m_cosine * sine + m_sine * cosine;
    m_cosine = c;
    // The sum is in the first of two quadrants or the second. If rounding moves it to another
    // quadrant, the nearer of the two counts.
    const int first = m_quadrant + (cosine < 0 ? 1 : 0);
    const int beyond = (seen_quadrant() - first) & 3;
    m_quadrant = first + (beyond == 1 || beyond == 2 ? 1 : 0);
  }

  // Returns the sum minus `angle`, a multiple of pi, without the rounding error of a large sum.
  double minus(double angle) const
  {
    const double rest = std::atan2(m_sine, m_cosine);
    const double turns = std::round((m_quadrant + 0.5) / 4 - rest / (2 * pi<double>()));
    return (2 * pi<double>() * turns - angle) + rest;
  }

private:
  int seen_quadrant() const
  {
    return m_sine >= 0 ? (m_cosine >= 0 ? 0 : 1) : (m_cosine < 0 ? 2 : 3);
  }

  double m_cosine = 1, m_sine = 0;
  int m_quadrant = 0;
};

// Stores the sides of a triangle and four times its area.
struct Angle_at_ab
{
  double a, b, c, area;
};

// Returns a complex number whose argument is the change of the angle between the sides a and b.
inline std::complex<double> turn(const Angle_at_ab& before, const Angle_at_ab& after)
{
  using Intrinsic_triangulations::doubled_corner_product;
  const double x = doubled_corner_product(before.c, before.a, before.b);
  const double new_x = doubled_corner_product(after.c, after.a, after.b);
  return {x * new_x + before.area * after.area, after.area * x - new_x * before.area};
}

// Returns the argument. Near zero, it is computed by a series up to rounding, which is faster.
inline double argument(const std::complex<double>& z)
{
  const double t = z.imag() / z.real(), s = t * t;
  if(!(z.real() > 0) || s > greatest_squared_tangent)
    return std::arg(z);
  return t * (1 - s * (1 / 3. - s * (1 / 5. - s * (1 / 7. - s * (1 / 9. - s / 11)))));
}

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_ANGLES_H
