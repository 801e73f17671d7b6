// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_POLYGON_ORIENTATIONS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_POLYGON_ORIENTATIONS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/layout/Number_lists.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_predicates.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Determines at which corners polygons turn left and right. Points are in the plane, or vectors in
// space as seen from the origin.
template <std::size_t dimension>
class Polygon_orientations
{
public:
  typedef std::array<double, dimension> Point;

  // Counts the triples of corners that turn right, and the collinear triples. The corners of a
  // triple are in the order of the boundary.
  struct Defects
  {
    std::size_t reversed = 0, flat = 0;

    void operator+=(const Defects& d)
    {
      reversed += d.reversed;
      flat += d.flat;
    }
  };

  // `polygons` contains the indices of the points that are the corners of each polygon.
  Polygon_orientations(const std::vector<Point>& points, const Number_lists& polygons)
    : m_points(points), m_polygons(polygons)
  {}

  // Returns the exact defects of polygon `i`.
  Defects defects(std::size_t i) const
  {
    Defects result;
    if(!is_strictly_convex(i))
      for_each_triple(i, [&](const Point& p, const Point& q, const Point& r) {
        const int turn = orientation(p, q, r);
        result.reversed += turn < 0;
        result.flat += turn == 0;
      });
    return result;
  }

  bool is_reversed(std::size_t i) const { return defects(i).reversed > 0; }

  // Returns the sum of the least heights of all triangles of corners that turn right, in units in
  // the last place.
  double depth(std::size_t i) const
  {
    double result = 0;
    for_each_triple(i, [&](const Point& p, const Point& q, const Point& r) {
      result += (std::max)(0., -height(p, q, r) / unit(p));
    });
    return result;
  }

  // Returns the unit in the last place of the greatest coordinate.
  static double unit(const Point& p)
  {
    double greatest = 0;
    for(const double x : p)
      greatest = (std::max)(greatest, std::abs(x));
    return greatest > 0 ? std::ldexp(1., std::ilogb(greatest) - 52) : 0;
  }

private:
  typedef Plane_predicates<double> Predicates;

  static int orientation(const std::array<double, 2>& p, const std::array<double, 2>& q,
                         const std::array<double, 2>& r)
  {
    return Predicates().orientation(p, q, r);
  }
  static int orientation(const std::array<double, 3>& p, const std::array<double, 3>& q,
                         const std::array<double, 3>& r)
  {
    return Predicates().orientation(p, q, r, {0, 0, 0});
  }

  const Point& at(std::size_t i, std::size_t k) const { return m_points[m_polygons(i, k)]; }

  // Returns whether the polygon turns left at each corner, and the first corner sees all others.
  bool is_strictly_convex(std::size_t i) const
  {
    const std::size_t n = m_polygons.size(i);
    for(std::size_t k = 2; k < n; ++k)
      if(orientation(at(i, 0), at(i, k - 1), at(i, k)) <= 0)
        return false;
    for(std::size_t k = 1; n > 3 && k < n; ++k)
      if(orientation(at(i, k), at(i, (k + 1) % n), at(i, (k + 2) % n)) <= 0)
        return false;
    return true;
  }

  template <typename Function>
  void for_each_triple(std::size_t i, const Function& f) const
  {
    const std::size_t n = m_polygons.size(i);
    for(std::size_t a = 0; a < n; ++a)
      for(std::size_t b = a + 1; b < n; ++b)
        for(std::size_t c = b + 1; c < n; ++c)
          f(at(i, a), at(i, b), at(i, c));
  }

  // Returns the least height of the triangle with the sides q - p and r - p, from its doubled area.
  static double height(const std::array<double, 2>& p, const std::array<double, 2>& q,
                       const std::array<double, 2>& r)
  {
    const auto minus = [](double x, double y) { return Double_double::exact_sum(x, -y); };
    const Double_double area =
      minus(q[0], p[0]) * minus(r[1], p[1]) - minus(q[1], p[1]) * minus(r[0], p[0]);
    return over_longest_side(static_cast<double>(area), p, q, r);
  }

  // Returns the least height of a triangle on the sphere.
  static double height(const std::array<double, 3>& p, const std::array<double, 3>& q,
                       const std::array<double, 3>& r)
  {
    const auto product = [](double x, double y) { return Double_double::exact_product(x, y); };
    Double_double volume(0);
    for(std::size_t c = 0, d = 1, e = 2; c < 3; d = e, e = c++)
      volume += p[c] * (product(q[d], r[e]) - product(q[e], r[d]));
    return over_longest_side(static_cast<double>(volume) / (norm(p) * norm(q) * norm(r)),
                             normalized(p), normalized(q), normalized(r));
  }

  static double norm(const std::array<double, 3>& p) { return std::hypot(p[0], p[1], p[2]); }
  static std::array<double, 3> normalized(const std::array<double, 3>& p)
  {
    return {p[0] / norm(p), p[1] / norm(p), p[2] / norm(p)};
  }

  static double over_longest_side(double area, const Point& p, const Point& q, const Point& r)
  {
    double square = 0;
    for(const auto& [x, y] : {std::pair(p, q), std::pair(q, r), std::pair(r, p)}) {
      double sum = 0;
      for(std::size_t c = 0; c < dimension; ++c)
        sum += (x[c] - y[c]) * (x[c] - y[c]);
      square = (std::max)(square, sum);
    }
    return square > 0 ? area / std::sqrt(square) : 0;
  }

  const std::vector<Point>& m_points;
  const Number_lists& m_polygons;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_POLYGON_ORIENTATIONS_H
