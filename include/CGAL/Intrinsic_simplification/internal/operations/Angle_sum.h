// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_ANGLE_SUM_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_ANGLE_SUM_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <cmath>

namespace CGAL {
namespace Intrinsic_simplification {
namespace internal {

using Intrinsic_triangulations::pi;

// The sum of angles between 0 and pi, given by their cosines and sines: a product of complex
// numbers, with the quadrants counted that it passes. One arc tangent is needed for all.
class Angle_sum
{
public:
  // adds the angle with a cosine and a sine that is not negative
  void add(double cosine, double sine)
  {
    const double c = m_cosine * cosine - m_sine * sine;
    m_sine = m_cosine * sine + m_sine * cosine;
    m_cosine = c;
    // The sum is in the first of two quadrants or the second; where it is seen in another, by
    // rounding, the nearer of the two counts.
    const int first = m_quadrant + (cosine < 0 ? 1 : 0);
    const int beyond = (seen_quadrant() - first) & 3;
    m_quadrant = first + (beyond == 1 || beyond == 2 ? 1 : 0);
  }

  // the sum minus `angle`, a multiple of pi, without the rounding of a large sum
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

} // namespace internal
} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_ANGLE_SUM_H
