// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONVEX_POLYGONS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONVEX_POLYGONS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/Flat_face.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the corners of a convex polygon in the plane, counterclockwise.
typedef std::vector<std::complex<double>> Convex_polygon;

using Intrinsic_triangulations::internal::cross;

// Returns the area, which is negative if the polygon is clockwise.
inline double signed_area(const Convex_polygon& polygon)
{
  double sum = 0;
  for(std::size_t n = 2; n < polygon.size(); ++n)
    sum += cross(polygon[n - 1] - polygon[0], polygon[n] - polygon[0]);
  return sum / 2;
}

// Returns whether the line through a side of `a` separates it from `b`.
inline bool separates(const Convex_polygon& a, const Convex_polygon& b)
{
  for(std::size_t n = 0; n < a.size(); ++n) {
    const std::complex<double> p = a[n], side = a[(n + 1) % a.size()] - p;
    if(std::all_of(b.begin(), b.end(),
                   [&](const std::complex<double>& z) { return cross(side, z - p) <= 0; }))
      return true;
  }
  return false;
}

// Returns the part of a polygon on the left of the line from `p` to `q` (Sutherland and Hodgman
// 1974).
inline Convex_polygon left_part(const Convex_polygon& polygon, const std::complex<double>& p,
                                const std::complex<double>& q)
{
  Convex_polygon result;
  const auto height = [&](const std::complex<double>& x) { return cross(q - p, x - p); };
  for(std::size_t n = 0; n < polygon.size(); ++n) {
    const std::complex<double>&a = polygon[n], &b = polygon[(n + 1) % polygon.size()];
    const double at_a = height(a), at_b = height(b);
    if(at_a >= 0)
      result.push_back(a);
    if((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0))
      result.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return result;
}

// Returns the intersection, which is empty if the polygons are disjoint.
inline Convex_polygon intersection(Convex_polygon a, const Convex_polygon& b)
{
  for(std::size_t n = 0; n < b.size() && a.size() > 2; ++n)
    a = left_part(a, b[n], b[(n + 1) % b.size()]);
  return a.size() > 2 ? a : Convex_polygon();
}

inline Bbox_2 bounding_box(const Convex_polygon& polygon)
{
  Bbox_2 result;
  for(const std::complex<double>& z : polygon)
    result += Bbox_2(z.real(), z.imag(), z.real(), z.imag());
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONVEX_POLYGONS_H
