// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSED_SEGMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSED_SEGMENT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the place between two places on an edge, with weights that are not negative; the middle
// if both are zero.
template <typename FT>
FT place_between(const FT& a, const FT& b, const FT& weight_of_a, const FT& weight_of_b)
{
  const FT sum = weight_of_a + weight_of_b, t = sum > 0 ? FT(weight_of_b / sum) : FT(0.5);
  return (1 - t) * a + t * b;
}

// A straight segment in a face, in barycentric coordinates, and where it crosses others on the way
// to its end.
template <typename FT>
class Crossed_segment
{
  typedef Barycentric_coordinates<FT> Coordinates;

public:
  Crossed_segment(const Coordinates& from, const Coordinates& to) : m_from(from), m_to(to) {}

  // Returns where it crosses the segment from `a` to `b`, from 0 to 1. Crossings are in order: if
  // the two segments are on one line up to rounding, it is next to the crossing before.
  FT next_crossing_on(const Coordinates& a, const Coordinates& b)
  {
    const FT t = place_between(FT(0), FT(1), CGAL::abs(left(b)), CGAL::abs(left(a))),
             s = along(point_between(a, b, t));
    if(m_from != m_to && m_passed <= s && s <= 1) {
      m_passed = s;
      return t;
    }
    m_passed = (std::min)((std::max)(s, m_passed), FT(1));
    return closest_between(a, b, point_between(m_from, m_to, m_passed));
  }

  // Returns whether it comes within `width` of the segment from `a` to `b`.
  bool meets(const Coordinates& a, const Coordinates& b, const FT& width) const
  {
    const auto is_near = [&](const Coordinates& p, const Coordinates& from, const Coordinates& to) {
      return squared_distance(from, to, p) <= CGAL::square(width);
    };
    const Crossed_segment other(a, b);
    if((left(a) < 0) != (left(b) < 0) && (other.left(m_from) < 0) != (other.left(m_to) < 0))
      return true;
    return is_near(a, m_from, m_to) || is_near(b, m_from, m_to) || is_near(m_from, a, b) ||
           is_near(m_to, a, b);
  }

private:
  // Returns twice the signed area of the triangle with its ends and `p`, which is positive on its
  // left. What is near to its start loses no digits.
  FT left(const Coordinates& p) const
  {
    const auto greatest =
      static_cast<std::size_t>(std::max_element(m_from.begin(), m_from.end()) - m_from.begin());
    const std::size_t x = (greatest + 1) % 3, y = (greatest + 2) % 3;
    return (m_to[x] - m_from[x]) * (p[y] - m_from[y]) - (m_to[y] - m_from[y]) * (p[x] - m_from[x]);
  }

  // Returns the place of the projection of `p` on the line, from 0 to 1 between the ends.
  FT along(const Coordinates& p) const
  {
    const FT square = dot(m_from, m_to, m_from, m_to);
    return square > 0 ? FT(dot(m_from, m_to, m_from, p) / square) : FT(0);
  }

  Coordinates m_from, m_to;
  FT m_passed = FT(0); // the place of the last crossing along the segment
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSED_SEGMENT_H
