// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONVEX_POLYGONS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONVEX_POLYGONS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the corners of a convex polygon in the plane, counterclockwise.
typedef std::vector<std::complex<double>> Convex_polygon;

inline double cross_product(const std::complex<double>& a, const std::complex<double>& b)
{
  return a.real() * b.imag() - a.imag() * b.real();
}

// Returns the area, which is negative if the polygon is clockwise.
inline double signed_area(const Convex_polygon& polygon)
{
  double sum = 0;
  for(std::size_t n = 2; n < polygon.size(); ++n)
    sum += cross_product(polygon[n - 1] - polygon[0], polygon[n] - polygon[0]);
  return sum / 2;
}

// Returns whether the line through a side of `a` separates it from `b`.
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

// Returns the part of a polygon on the left of the line from `p` to `q` (Sutherland and Hodgman
// 1974).
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

// Computes the area of the union of convex polygons. A vertical line sweeps over slabs between
// consecutive corners and crossings. In a slab, the covered height is a linear function.
// Complexity: O(n log n) for n corners and crossings, plus the number k of polygons at the line
// for each of them, times log k.
class Covered_area
{
  typedef std::complex<double> Complex;
  typedef std::pair<double, double> Interval;

public:
  explicit Covered_area(const std::vector<Convex_polygon>& polygons) : m_polygons(polygons)
  {
    for(std::size_t i = 0; i < polygons.size(); ++i)
      if(!polygons[i].empty())
        m_boxes.emplace_back(bounding_box(polygons[i]), i);
  }

  double operator()() const
  {
    if(m_polygons.size() == 1)
      return signed_area(m_polygons[0]);
    std::vector<Box> waiting = m_boxes; // sorted such that the leftmost box is last
    std::sort(waiting.begin(), waiting.end(), [](const Box& a, const Box& b) {
      return std::pair(a.bbox().xmin(), a.info()) > std::pair(b.bbox().xmin(), b.info());
    });
    std::vector<Box> met; // the boxes that the line meets
    const std::vector<double> x = bounds_of_slabs();
    double sum = 0;
    for(std::size_t n = 1; n < x.size(); ++n) {
      if(!(x[n] > x[n - 1]))
        continue;
      for(; !waiting.empty() && waiting.back().bbox().xmin() <= x[n - 1]; waiting.pop_back())
        met.push_back(waiting.back());
      const auto is_left = [&](const Box& box) { return box.bbox().xmax() <= x[n - 1]; };
      met.erase(std::remove_if(met.begin(), met.end(), is_left), met.end());
      sum += (x[n] - x[n - 1]) * covered_height(met, (x[n] + x[n - 1]) / 2);
    }
    return sum;
  }

private:
  typedef Box_intersection_d::Box_with_info_d<double, 2, std::size_t> Box;

  template <typename Visit>
  static void for_each_side(const Convex_polygon& polygon, const Visit& visit)
  {
    for(std::size_t n = 0; n < polygon.size(); ++n)
      visit(polygon[n], polygon[(n + 1) % polygon.size()]);
  }

  std::vector<double> bounds_of_slabs() const
  {
    std::vector<double> result;
    for(const Convex_polygon& polygon : m_polygons)
      for(const Complex& z : polygon)
        result.push_back(z.real());
    std::vector<Box> boxes = m_boxes;
    box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      const Convex_polygon &first = m_polygons[(std::min)(a.info(), b.info())],
                           &second = m_polygons[(std::max)(a.info(), b.info())];
      for_each_side(second, [&](const Complex& p, const Complex& q) {
        for_each_side(
          first, [&](const Complex& r, const Complex& s) { add_crossing(p, q, r, s, result); });
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

  // Returns the length of the part of a vertical line that some polygons cover.
  double covered_height(const std::vector<Box>& met, double x) const
  {
    std::vector<Interval> intervals;
    for(const Box& box : met)
      add_interval(m_polygons[box.info()], x, intervals);
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
  std::vector<Box> m_boxes; // the boxes of polygons that are not empty
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONVEX_POLYGONS_H
