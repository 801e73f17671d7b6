// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_LARGEST_EAR_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_LARGEST_EAR_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Returns the signed area of a triangle as a part of its face, from barycentric coordinates.
inline double relative_area(const std::array<double, 3>& a, const std::array<double, 3>& b,
                            const std::array<double, 3>& c)
{
  return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

// Returns whether the triangle of three corners is counterclockwise, and contains no other corner.
inline bool is_ear(const std::array<std::size_t, 3>& triangle,
                   const std::vector<std::array<double, 3>>& corners)
{
  const auto &a = corners[triangle[0]], &b = corners[triangle[1]], &c = corners[triangle[2]];
  return relative_area(a, b, c) > 0 &&
         std::none_of(corners.begin(), corners.end(), [&](const std::array<double, 3>& p) {
           return p != a && p != b && p != c && relative_area(a, b, p) >= 0 &&
                  relative_area(b, c, p) >= 0 && relative_area(c, a, p) >= 0;
         });
}

// Returns the first corner of the largest ear of a polygon in a face. If rounding leaves no ear,
// the largest triangle of three consecutive corners counts.
inline std::size_t largest_ear(const std::vector<std::array<double, 3>>& corners)
{
  std::size_t result = 0;
  std::pair<bool, double> quality(false, -1);
  for(std::size_t n = 0; n < corners.size(); ++n) {
    const std::array<std::size_t, 3> ear{n, (n + 1) % corners.size(), (n + 2) % corners.size()};
    const std::pair<bool, double> here(
      is_ear(ear, corners), relative_area(corners[ear[0]], corners[ear[1]], corners[ear[2]]));
    if(here > quality) {
      quality = here;
      result = n;
    }
  }
  return result;
}

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_LARGEST_EAR_H
