// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_ANGLE_SUM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_ANGLE_SUM_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <cmath>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores a sum of angles with twice the digits of `double`. A small sum, and a small difference to
// a full turn, have small relative errors. Angles are multiplied as complex numbers.
class Angle_sum
{
public:
  // Adds the angle of the vector (x, y).
  void add(const Double_double& x, const Double_double& y)
  {
    const double scale = 1 / std::hypot(x.high(), y.high());
    const Double_double c = x * scale, s = y * scale, real = m_x * c - m_y * s;
    m_y = m_x * s + m_y * c;
    m_x = real;
    m_sum += std::atan2(s.high(), c.high());
  }

  // Returns the sum minus a number of turns and an angle, whose rounded sine and cosine represent
  // it. A small difference has a small relative error.
  double minus(int turns, double angle) const
  {
    const double turn = 2 * pi<double>();
    const Double_double c = std::cos(angle), s = std::sin(angle);
    const double rest = std::atan2((m_y * c - m_x * s).high(), (m_x * c + m_y * s).high());
    return rest + turn * std::round((m_sum - angle - rest) / turn - turns);
  }

private:
  Double_double m_x = 1, m_y = 0; // the product
  double m_sum = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_ANGLE_SUM_H
