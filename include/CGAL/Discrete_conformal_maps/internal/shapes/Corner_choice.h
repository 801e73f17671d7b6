// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_CORNER_CHOICE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_CORNER_CHOICE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/shapes/Boundary_loop.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Chooses the corners of a rectangle among the vertices of a loop.
class Corner_choice
{
public:
  typedef std::vector<std::size_t> Corners; // places on the loop

  // `angle` contains the exterior angles, and `length` the lengths of the edges that start at the
  // vertices.
  Corner_choice(std::vector<double> angle, const std::vector<double>& length)
    : m_length(std::accumulate(length.begin(), length.end(), 0.)),
      m_angle(std::move(angle)),
      m_place(length.size()),
      m_order(length.size())
  {
    std::exclusive_scan(length.begin(), length.end(), m_place.begin(), 0.);
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](std::size_t i, std::size_t j) { return m_angle[i] > m_angle[j]; });
  }

  // Returns four positions in ascending order, as far apart along the loop as possible. The sum of
  // their exterior angles must be at least 90 % of the sum of the four sharpest.
  Corners corners() const
  {
    Corners result = sharpest_at_distance(0);
    const double least = total_angle(result) - std::abs(total_angle(result)) / 10;
    for(double distance = m_length / 4; distance > 1e-3 * m_length; distance *= 0.9)
      if(Corners c = sharpest_at_distance(distance); c.size() == 4 && total_angle(c) >= least) {
        result = std::move(c);
        break;
      }
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  // Returns up to four positions. Each corner is the sharpest vertex at this distance from the
  // previous corners.
  Corners sharpest_at_distance(double distance) const
  {
    Corners result;
    for(const std::size_t i : m_order) {
      const bool is_far = std::all_of(result.begin(), result.end(), [&](std::size_t j) {
        return this->distance(i, j) >= distance;
      });
      if(is_far && result.size() < 4)
        result.push_back(i);
    }
    return result;
  }

  double distance(std::size_t i, std::size_t j) const
  {
    const double d = std::abs(m_place[i] - m_place[j]);
    return (std::min)(d, m_length - d);
  }

  double total_angle(const Corners& corners) const
  {
    return std::accumulate(corners.begin(), corners.end(), 0.,
                           [&](double sum, std::size_t i) { return sum + m_angle[i]; });
  }

  double m_length;
  std::vector<double> m_angle, m_place;
  std::vector<std::size_t> m_order; // the sharpest first
};

inline std::vector<Boundary_loop> rectangle_boundaries(const Delta_complex& mesh)
{
  return single_boundary_loops(mesh, 4, "the corners of a rectangle");
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_CORNER_CHOICE_H
