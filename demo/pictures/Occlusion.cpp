// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/Occlusion.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace {

typedef Occlusion::Vector Vector;

// Returns whether a polygon covers a point in the picture, by the number of sides below the point.
bool covers(const std::vector<Vector>& corners, const Vector& p)
{
  bool result = false;
  for(std::size_t k = 0; k < corners.size(); ++k) {
    const Vector &a = corners[k], &b = corners[(k + 1) % corners.size()];
    if((a[0] > p[0]) != (b[0] > p[0]))
      result ^= a[1] + (p[0] - a[0]) / (b[0] - a[0]) * (b[1] - a[1]) > p[1];
  }
  return result;
}

// Returns the least and the greatest value of a coordinate.
std::pair<double, double> range(const std::vector<Vector>& points, int k)
{
  const auto [low, high] = std::minmax_element(
    points.begin(), points.end(), [k](const Vector& a, const Vector& b) { return a[k] < b[k]; });
  return {(*low)[k], (*high)[k]};
}

} // namespace

Occlusion::Occlusion(std::vector<Vector> points)
  : m_points(std::move(points)), m_order(m_points.size()), m_is_hidden(m_points.size(), false)
{
  std::iota(m_order.begin(), m_order.end(), std::size_t(0));
  std::sort(m_order.begin(), m_order.end(),
            [this](std::size_t i, std::size_t j) { return m_points[i][0] < m_points[j][0]; });
}

void Occlusion::add_polygon(const std::vector<Vector>& corners, const Vector& normal)
{
  if(corners.empty() || normal[2] == 0)
    return; // edge-on
  const auto [left, right] = range(corners, 0);
  const auto [back, front] = range(corners, 2);
  const Vector& c = corners[0];
  auto i = std::lower_bound(m_order.begin(), m_order.end(), left,
                            [this](std::size_t j, double x) { return m_points[j][0] < x; });
  for(; i != m_order.end() && m_points[*i][0] <= right; ++i) {
    const Vector& p = m_points[*i];
    const double depth = c[2] - (normal[0] * (p[0] - c[0]) + normal[1] * (p[1] - c[1])) / normal[2];
    if(p[2] + 1 < std::clamp(depth, back, front) && covers(corners, p))
      m_is_hidden[*i] = true;
  }
}
