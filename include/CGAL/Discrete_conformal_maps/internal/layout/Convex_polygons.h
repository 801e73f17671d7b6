// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONVEX_POLYGONS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONVEX_POLYGONS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// The corners of a convex polygon in the plane, counterclockwise.
typedef std::vector<std::complex<double>> Convex_polygon;

inline double cross_product(const std::complex<double>& a, const std::complex<double>& b)
{
  return a.real() * b.imag() - a.imag() * b.real();
}

// negative if it is clockwise
inline double signed_area(const Convex_polygon& polygon)
{
  double sum = 0;
  for(std::size_t n = 2; n < polygon.size(); ++n)
    sum += cross_product(polygon[n - 1] - polygon[0], polygon[n] - polygon[0]);
  return sum / 2;
}

// whether the line through a side of `a` separates it from `b`
inline bool separates(const Convex_polygon& a, const Convex_polygon& b)
{
  for(std::size_t n = 0; n < a.size(); ++n) {
    const std::complex<double> p = a[n], side = a[(n + 1) % a.size()] - p;
    if(std::all_of(b.begin(), b.end(),
                   [&](const std::complex<double>& z) { return cross_product(side, z - p) <= 0; }))
      return true;
  }
  return false;
}

// the part of a polygon on the left of the line from `p` to `q` (Sutherland and Hodgman)
inline Convex_polygon left_part(const Convex_polygon& polygon, const std::complex<double>& p,
                                const std::complex<double>& q)
{
  Convex_polygon result;
  const auto height = [&](const std::complex<double>& x) { return cross_product(q - p, x - p); };
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

// empty if they do not meet
inline Convex_polygon intersection(Convex_polygon a, const Convex_polygon& b)
{
  for(std::size_t n = 0; n < b.size() && a.size() > 2; ++n)
    a = left_part(a, b[n], b[(n + 1) % b.size()]);
  return a.size() > 2 ? a : Convex_polygon();
}

// The area that at least one of some convex polygons covers: they are cut into vertical slabs at
// all corners and crossings. Inside a slab the covered height is linear. Complexity: O(n^3) for n
// corners.
class Covered_area
{
  typedef std::complex<double> Complex;
  typedef std::pair<double, double> Interval;

public:
  explicit Covered_area(const std::vector<Convex_polygon>& polygons) : m_polygons(polygons) {}

  double operator()() const
  {
    if(m_polygons.size() == 1)
      return signed_area(m_polygons[0]);
    std::vector<double> x = bounds_of_slabs();
    double sum = 0;
    for(std::size_t n = 1; n < x.size(); ++n)
      if(x[n] > x[n - 1])
        sum += (x[n] - x[n - 1]) * covered_height((x[n] + x[n - 1]) / 2);
    return sum;
  }

private:
  template <typename Visit>
  static void for_each_side(const Convex_polygon& polygon, const Visit& visit)
  {
    for(std::size_t n = 0; n < polygon.size(); ++n)
      visit(polygon[n], polygon[(n + 1) % polygon.size()]);
  }

  std::vector<double> bounds_of_slabs() const
  {
    std::vector<double> result;
    for(std::size_t i = 0; i < m_polygons.size(); ++i)
      for_each_side(m_polygons[i], [&](const Complex& a, const Complex& b) {
        result.push_back(a.real());
        for(std::size_t j = 0; j < i; ++j)
          for_each_side(m_polygons[j], [&](const Complex& c, const Complex& d) {
            add_crossing(a, b, c, d, result);
          });
      });
    std::sort(result.begin(), result.end());
    return result;
  }

  static void add_crossing(const Complex& a, const Complex& b, const Complex& c, const Complex& d,
                           std::vector<double>& x)
  {
    const double at_a = cross_product(d - c, a - c), at_b = cross_product(d - c, b - c),
                 at_c = cross_product(b - a, c - a), at_d = cross_product(b - a, d - a);
    if(((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) &&
       ((at_c > 0 && at_d < 0) || (at_c < 0 && at_d > 0)))
      x.push_back((a + at_a / (at_a - at_b) * (b - a)).real());
  }

  // of a vertical line
  double covered_height(double x) const
  {
    std::vector<Interval> intervals;
    for(const Convex_polygon& polygon : m_polygons)
      add_interval(polygon, x, intervals);
    std::sort(intervals.begin(), intervals.end());
    double sum = 0, top = -std::numeric_limits<double>::infinity();
    for(const auto& [low, high] : intervals)
      if(high > top) {
        sum += high - (std::max)(low, top);
        top = high;
      }
    return sum;
  }

  static void add_interval(const Convex_polygon& polygon, double x, std::vector<Interval>& result)
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for_each_side(polygon, [&](const Complex& a, const Complex& b) {
      if((a.real() < x) == (b.real() < x))
        return;
      const double y = a.imag() + (x - a.real()) / (b.real() - a.real()) * (b.imag() - a.imag());
      low = (std::min)(low, y);
      high = (std::max)(high, y);
    });
    if(low < high)
      result.emplace_back(low, high);
  }

  const std::vector<Convex_polygon>& m_polygons;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONVEX_POLYGONS_H
