// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_DISK_RADIUS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_DISK_RADIUS_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/operations/angles.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Returns the angle at the center of the sides of a polygon that are chords of a circle.
inline double central_angle(const std::vector<double>& sides, double radius)
{
  double sum = 0;
  for(double s : sides)
    sum += 2 * std::asin((std::min)(1., s / (2 * radius)));
  return sum;
}

// Returns the radius of the circle in which a polygon with these sides is inscribed. No side may be
// longer than the side of an equilateral triangle in this circle. If one is, returns the radius of
// the circle in which it is such a side. The central angle decreases with the radius. Since asin(x)
// is at most pi x / 2, it is at most 2 pi at a fourth of the perimeter.
inline double disk_radius(const std::vector<double>& sides)
{
  double perimeter = 0, longest = 0;
  for(double s : sides) {
    perimeter += s;
    longest = (std::max)(longest, s);
  }
  double low = longest / std::sqrt(3.), high = (std::max)(low, perimeter / 4);
  if(central_angle(sides, low) <= 2 * pi<double>())
    return low;
  for(double middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2)
    (central_angle(sides, middle) > 2 * pi<double>() ? low : high) = middle;
  return high;
}

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_DISK_RADIUS_H
