// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_ANGLE_SUM_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_ANGLE_SUM_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <cmath>

namespace CGAL {
namespace Intrinsic_simplification {
namespace internal {

// The sum of angles between 0 and pi, given by their cosines and sines: a product of complex numbers, with
// its full turns counted. One arc tangent is needed for all.
class Angle_sum
{
public:
  // adds the angle with a cosine and a sine that are not negative
  void add(double cosine, double sine)
  {
    const bool was_upper = m_sine >= 0;
    const double c = m_cosine * cosine - m_sine * sine;
    double s = m_cosine * sine + m_sine * cosine;
    // rounding must not turn a very small angle back beyond the start of the turn
    if(was_upper && s < 0 && c > 0 && cosine > 0)
      s = 0;
    if(!was_upper && s >= 0)
      m_turns += 1;
    m_cosine = c;
    m_sine = s;
  }

  // the sum minus `angle`, a multiple of pi, without the rounding of a large sum
  double minus(double angle) const
  {
    constexpr double pi = 3.14159265358979323846;
    const double turns = m_sine < 0 ? m_turns + 1 : m_turns;
    return (2 * pi * turns - angle) + std::atan2(m_sine, m_cosine);
  }

private:
  double m_cosine = 1, m_sine = 0;
  double m_turns = 0;
};

} // namespace internal
} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_ANGLE_SUM_H
