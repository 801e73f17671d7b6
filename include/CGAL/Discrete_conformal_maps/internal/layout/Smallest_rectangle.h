// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SMALLEST_RECTANGLE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SMALLEST_RECTANGLE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_predicates.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

// The smallest rectangle that holds points of the plane, by rotating calipers (Toussaint 1983).
// Orders of directions are exact. CGAL's `min_rectangle_2()` gives what this gives, but with an
// exact kernel that takes a tenth of the time in which `flatten()` compiles.
class Smallest_rectangle
{
  typedef Plane_predicates<double>::Point Point; // or a direction

public:
  explicit Smallest_rectangle(const std::vector<std::complex<double>>& points)
  {
    for(const std::complex<double>& z : points)
      m_hull.push_back({z.real(), z.imag()});
    find_hull();
    if(m_hull.size() > 2)
      turn();
  }

  // the direction of a side, of norm one; that of the x-axis if the points are on a line
  std::complex<double> direction() const
  {
    if(m_hull.size() <= 2)
      return 1;
    const Point low = corner(m_best.point[0]), high = corner(m_best.point[2]);
    const std::complex<double> side(high[0] - low[0], high[1] - low[1]);
    return std::abs(side) > 0 ? side / std::abs(side) : 1;
  }

private:
  // Its sides pass through these points, the first and the third along `d`.
  struct Rectangle
  {
    std::array<Point, 4> point;
    Point d;

    // times the square of `d`
    double area() const
    {
      const auto& p = point;
      return (d[0] * (p[2][1] - p[0][1]) + d[1] * (p[0][0] - p[2][0])) *
             (d[1] * (p[1][1] - p[3][1]) + d[0] * (p[1][0] - p[3][0]));
    }
    double square() const { return d[0] * d[0] + d[1] * d[1]; }

    bool operator<(const Rectangle& other) const
    {
      return area() * other.square() < square() * other.area();
    }
  };

  // by `i` right angles, clockwise
  static Point turned(const Point& p, std::size_t i)
  {
    const std::array<Point, 4> result{p, Point{p[1], -p[0]}, Point{-p[0], -p[1]},
                                      Point{-p[1], p[0]}};
    return result[i];
  }

  // Andrew's chains, without points on edges, counterclockwise
  void find_hull()
  {
    std::sort(m_hull.begin(), m_hull.end());
    m_hull.erase(std::unique(m_hull.begin(), m_hull.end()), m_hull.end());
    std::vector<Point> result;
    const auto add_chain = [&](auto first, auto last) {
      const std::size_t begin = result.size();
      for(; first != last; ++first) {
        while(result.size() >= begin + 2 &&
              m_predicates.orientation(result[result.size() - 2], result.back(), *first) <= 0)
          result.pop_back();
        result.push_back(*first);
      }
      result.pop_back(); // the other chain begins there
    };
    if(m_hull.size() <= 2)
      return;
    add_chain(m_hull.begin(), m_hull.end());
    add_chain(m_hull.rbegin(), m_hull.rend());
    m_hull = result;
  }

  std::size_t next(std::size_t i) const { return i + 1 < m_hull.size() ? i + 1 : 0; }

  // one of the points that are lowest after `i` turns
  std::size_t lowest(std::size_t i) const
  {
    const std::size_t y = 1 - i % 2, x = 1 - y;
    const auto is_before = [&](const Point& p, const Point& q) {
      return std::array{p[y], p[x]} < std::array{q[y], q[x]};
    };
    const auto [least, greatest] = std::minmax_element(m_hull.begin(), m_hull.end(), is_before);
    return std::size_t((i == 0 || i == 3 ? least : greatest) - m_hull.begin());
  }

  // of the edge of the hull after the point on side `i`, turned to that of the first side
  Point edge_direction(std::size_t i) const
  {
    const Point &p = m_hull[m_at[i]], &q = m_hull[next(m_at[i])];
    return turned({q[0] - p[0], q[1] - p[1]}, i);
  }

  static int quadrant(const Point& d)
  {
    return d[0] > 0 && d[1] >= 0 ? 0 : d[0] <= 0 && d[1] > 0 ? 1 : d[0] < 0 ? 2 : 3;
  }

  // by the angle with the x-axis
  bool is_before(std::size_t i, std::size_t j) const
  {
    const Point a = edge_direction(i), b = edge_direction(j);
    return quadrant(a) != quadrant(b) ? quadrant(a) < quadrant(b)
                                      : m_predicates.orientation({0, 0}, a, b) > 0;
  }

  // the side that meets an edge next
  std::size_t next_side() const
  {
    const std::size_t low = is_before(0, 1) ? 0 : 1, high = is_before(2, 3) ? 2 : 3;
    return is_before(low, high) ? low : high;
  }

  Rectangle rectangle(std::size_t side) const
  {
    return {{m_hull[m_at[0]], m_hull[m_at[1]], m_hull[m_at[2]], m_hull[m_at[3]]},
            edge_direction(side)};
  }

  // Turns the sides by a right angle; each passes the points up to where the next began.
  void turn()
  {
    for(std::size_t i = 0; i < 4; ++i)
      m_at[i] = lowest(i);
    const std::array<std::size_t, 4> end{m_at[1], m_at[2], m_at[3], m_at[0]};
    std::size_t side = next_side(), sides_on_the_way = 0;
    for(std::size_t i = 0; i < 4; ++i)
      sides_on_the_way += m_at[i] != end[i];
    m_best = rectangle(side);
    for(std::size_t count = 0; count < 2 * m_hull.size(); ++count) {
      m_at[side] = next(m_at[side]);
      if(m_at[side] == end[side] && --sides_on_the_way == 0)
        return;
      side = next_side();
      if(const Rectangle other = rectangle(side); other < m_best)
        m_best = other;
    }
  }

  // where the line through `p` along the rectangle meets the second side
  Point corner(const Point& p) const
  {
    const Point &d = m_best.d, &q = m_best.point[1];
    const double at_p = p[0] * d[1] - p[1] * d[0], at_q = -q[0] * d[0] - q[1] * d[1],
                 square = -d[1] * d[1] - d[0] * d[0];
    return {(d[0] * at_q - d[1] * at_p) / square, (d[0] * at_p - -d[1] * at_q) / square};
  }

  Plane_predicates<double> m_predicates;
  std::vector<Point> m_hull;
  std::array<std::size_t, 4> m_at{}; // the points of the hull on the sides
  Rectangle m_best{};
};

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SMALLEST_RECTANGLE_H
