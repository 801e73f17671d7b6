// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_MULTIPLY_COVERED_AREA_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_MULTIPLY_COVERED_AREA_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/layout/Convex_polygons.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_predicates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the area that at least two convex polygons cover. The boundary of this area consists of
// the parts of sides that exactly one other polygon covers. The area is an integral over these
// parts.
//
// Exact predicates decide which parts these are. For points on lines through sides, they decide as
// if polygon i were moved by i (e, e^2) for an infinitely small e. So all decisions belong to one
// arrangement. Two sides meet in one computed point, so parts of the boundary form closed curves,
// however acute the angle between the sides is.
class Multiply_covered_area
{
public:
  typedef std::pair<std::size_t, std::size_t> Pair;

  // `pairs` contains the pairs of polygons that overlap. Other pairs do not count.
  Multiply_covered_area(const std::vector<Convex_polygon>& polygons, const std::vector<Pair>& pairs)
    : m_polygons(polygons), m_partners(polygons.size())
  {
    for(const auto& [i, j] : pairs) {
      m_partners[i].push_back(j);
      m_partners[j].push_back(i);
    }
  }

  // Returns the area. Complexity: O(n + k log k) for n polygons and k pairs.
  double operator()() const
  {
    double sum = 0;
    for(std::size_t i = 0; i < m_polygons.size(); ++i)
      if(!m_partners[i].empty())
        sum += integral_along(i);
    return sum / 2;
  }

private:
  typedef std::complex<double> Complex;

  struct Side
  {
    std::size_t polygon;
    Complex source, target;
  };

  // Stores a crossing of a side with the boundary of another polygon.
  struct Crossing
  {
    double position; // along the side
    Complex point;
    int change; // of the number of polygons that cover the side
  };

  Side side(std::size_t i, std::size_t n) const
  {
    const Convex_polygon& polygon = m_polygons[i];
    return {i, polygon[n], polygon[(n + 1) % polygon.size()]};
  }

  template <typename Visit>
  void for_each_side(std::size_t i, const Visit& visit) const
  {
    for(std::size_t n = 0; n < m_polygons[i].size(); ++n)
      visit(side(i, n));
  }

  // Returns twice the integral along the parts of the boundary of polygon `i` that exactly one
  // partner covers.
  double integral_along(std::size_t i) const
  {
    double result = 0;
    int number = 0; // of the partners that cover the boundary
    for(const std::size_t j : m_partners[i])
      number += contains(j, i, m_polygons[i][0]);
    for_each_side(i, [&](const Side& s) {
      Complex last = s.source;
      const auto go_to = [&](const Complex& point) {
        if(number == 1)
          result += cross(last, point);
        last = point;
      };
      for(const Crossing& c : crossings(s)) {
        go_to(c.point);
        number += c.change;
      }
      go_to(s.target);
    });
    return result;
  }

  // Returns the crossings of a side with partners, in order.
  std::vector<Crossing> crossings(const Side& s) const
  {
    std::vector<Crossing> result;
    const Complex along = s.target - s.source;
    for(const std::size_t j : m_partners[s.polygon])
      for_each_side(j, [&](const Side& other) {
        const int at_source = orientation(other, s.polygon, s.source);
        if(at_source == orientation(other, s.polygon, s.target) ||
           orientation(s, j, other.source) == orientation(s, j, other.target))
          return;
        const Complex point = s.polygon < j ? crossing(s, other) : crossing(other, s);
        result.push_back({(std::conj(along) * (point - s.source)).real(), point, -at_source});
      });
    std::sort(result.begin(), result.end(),
              [](const Crossing& a, const Crossing& b) { return a.position < b.position; });
    return result;
  }

  // Returns the point in which two sides cross. It depends on the order of the sides.
  static Complex crossing(const Side& s, const Side& other)
  {
    const Complex line = other.target - other.source;
    const double at_source = cross(line, s.source - other.source),
                 at_target = cross(line, s.target - other.source),
                 part = at_source / (at_source - at_target);
    return s.source + (std::isnan(part) ? 0.5 : std::clamp(part, 0., 1.)) * (s.target - s.source);
  }

  // Returns 1 if a point of polygon `i` lies on the left of a side, and -1 if it lies on its right.
  static int orientation(const Side& s, std::size_t i, const Complex& point)
  {
    const auto coordinates = [](const Complex& z) { return std::array{z.real(), z.imag()}; };
    if(const int sign = Plane_predicates<double>().orientation(
         coordinates(s.source), coordinates(s.target), coordinates(point));
       sign != 0)
      return sign;
    const Complex along = s.target - s.source;
    const bool is_left = along.imag() != 0 ? along.imag() < 0 : along.real() > 0;
    return is_left == (s.polygon < i) ? 1 : -1;
  }

  // Returns whether polygon `j` contains a point of polygon `i`. It counts the sides on the right.
  bool contains(std::size_t j, std::size_t i, const Complex& point) const
  {
    const auto is_below = [&](const Complex& z) {
      return z.imag() < point.imag() || (z.imag() == point.imag() && j < i);
    };
    bool result = false;
    for_each_side(j, [&](const Side& s) {
      if(is_below(s.source) != is_below(s.target))
        result ^= is_below(s.source) == (orientation(s, i, point) > 0);
    });
    return result;
  }

  const std::vector<Convex_polygon>& m_polygons;
  std::vector<std::vector<std::size_t>> m_partners; // the polygons that each one overlaps
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_MULTIPLY_COVERED_AREA_H
