// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CHART_PACKING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CHART_PACKING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_predicates.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the corners of the convex hull by Andrew's algorithm. The first corner is the lowest of
// the leftmost points.
inline std::vector<std::complex<double>> convex_hull(std::vector<std::complex<double>> points)
{
  typedef std::complex<double> Complex;
  const auto turns_left = [](const Complex& p, const Complex& q, const Complex& r) {
    return Plane_predicates<double>().orientation({p.real(), p.imag()}, {q.real(), q.imag()},
                                                  {r.real(), r.imag()}) > 0;
  };
  std::sort(points.begin(), points.end(), [](const Complex& p, const Complex& q) {
    return p.real() < q.real() || (p.real() == q.real() && p.imag() < q.imag());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if(points.size() < 3)
    return points;
  std::vector<Complex> hull;
  for(int half = 0; half < 2; ++half) {
    const std::size_t first = hull.size();
    for(const Complex& p : points) {
      while(hull.size() >= first + 2 && !turns_left(*(hull.end() - 2), hull.back(), p))
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// Collects the points of a chart one by one. Most points inside their convex hull are dropped.
// Memory: linear in the number of corners of the hull.
class Hull_points
{
  typedef std::complex<double> Complex;

public:
  void add(const Complex& p)
  {
    m_points.push_back(p);
    if(m_points.size() < m_limit)
      return;
    m_points = convex_hull(std::move(m_points));
    m_limit = 2 * m_points.size() + 1024;
  }

  const std::vector<Complex>& points() const { return m_points; }

private:
  std::vector<Complex> m_points;
  std::size_t m_limit = 1024;
};

// Computes motions of the plane that arrange charts side by side. Each chart lies in its smallest
// enclosing rectangle, whose longer side is horizontal. Rectangles stand on shelves in the order
// of decreasing heights. Gaps are a hundredth of the total width. The first rectangle starts at
// the origin.
class Chart_packing
{
  typedef std::complex<double> Complex;

public:
  struct Motion
  {
    Complex turn = 1, shift = 0;

    Complex operator()(const Complex& z) const { return turn * z + shift; }
  };

  // Packs charts, given by their points. A chart may have no points.
  explicit Chart_packing(const std::vector<Hull_points>& chart)
    : m_motion(chart.size()), m_size(chart.size(), 0)
  {
    for(std::size_t c = 0; c < chart.size(); ++c)
      if(!chart[c].points().empty())
        lay_down(c, chart[c].points());
    stack();
  }

  const Motion& motion(std::size_t chart) const { return m_motion[chart]; }

private:
  // Rotates the chart, and moves its rectangle to the origin.
  void lay_down(std::size_t c, const std::vector<Complex>& points)
  {
    Motion& motion = m_motion[c];
    motion.turn = std::conj(direction_of_rectangle(points));
    set_box(c, points);
    if(m_size[c].imag() > m_size[c].real()) {
      motion = {motion.turn * Complex(0, 1), 0};
      set_box(c, points);
    }
  }

  void set_box(std::size_t c, const std::vector<Complex>& points)
  {
    Complex low = m_motion[c].turn * points.front(), high = low;
    for(const Complex& p : points) {
      const Complex z = m_motion[c].turn * p;
      low = {(std::min)(low.real(), z.real()), (std::min)(low.imag(), z.imag())};
      high = {(std::max)(high.real(), z.real()), (std::max)(high.imag(), z.imag())};
    }
    m_motion[c].shift = -low;
    m_size[c] = high - low;
  }

  // Returns the unit direction of a side of the smallest rectangle that contains the points. The
  // direction lies in the second quadrant. If several rectangles are smallest, the first one
  // counts.
  static Complex direction_of_rectangle(const std::vector<Complex>& points)
  {
    const std::vector<Complex> hull = convex_hull(points);
    if(hull.size() < 3)
      return 1;
    Complex result = 1;
    double least = std::numeric_limits<double>::infinity();
    std::array<std::size_t, 3> farthest{0, 0, 0}; // along a side, to its left, backwards
    for(std::size_t i = 0; i < hull.size(); ++i) {
      const Complex side = hull[(i + 1) % hull.size()] - hull[i], direction = side / std::abs(side);
      Complex axis = direction;
      std::array<double, 3> distance;
      for(std::size_t k = 0; k < 3; ++k, axis *= Complex(0, 1)) {
        const auto along_axis = [&](std::size_t j) {
          return ((hull[j % hull.size()] - hull[i]) * std::conj(axis)).real();
        };
        std::size_t& j = farthest[k] = (std::max)(farthest[k], k == 0 ? i + 1 : farthest[k - 1]);
        while(along_axis(j + 1) > along_axis(j))
          ++j;
        distance[k] = along_axis(j);
      }
      if(const double area = (distance[0] + distance[2]) * distance[1];
         area < (1 - tolerance::cancellation) * least) {
        least = area;
        result = direction;
      }
    }
    while(!(result.real() <= 0 && result.imag() > 0))
      result *= Complex(0, 1);
    return result;
  }

  std::vector<std::size_t> highest_first() const
  {
    std::vector<std::size_t> result(m_size.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    std::stable_sort(result.begin(), result.end(), [&](std::size_t a, std::size_t b) {
      return m_size[a].imag() > m_size[b].imag();
    });
    return result;
  }

  // Returns the width of shelves. It is at least the width of the widest chart, and about the side
  // length of a square that holds all charts.
  double width_of_shelves() const
  {
    double widest = 0, area = 0;
    for(const Complex& size : m_size) {
      widest = (std::max)(widest, size.real());
      area += size.real() * size.imag();
    }
    return (std::max)(widest, std::sqrt(area));
  }

  void stack()
  {
    const double width = width_of_shelves(), gap = width / 100;
    Complex corner = 0;
    double height = 0; // the height of the shelf
    for(const std::size_t c : highest_first()) {
      if(corner.real() + m_size[c].real() > width) {
        corner = {0, corner.imag() + height + gap};
        height = 0;
      }
      m_motion[c].shift += corner;
      height = (std::max)(height, m_size[c].imag());
      if(m_size[c] != 0.)
        corner += m_size[c].real() + gap;
    }
  }

  std::vector<Motion> m_motion;
  std::vector<Complex> m_size; // the sizes of the rectangles
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CHART_PACKING_H
