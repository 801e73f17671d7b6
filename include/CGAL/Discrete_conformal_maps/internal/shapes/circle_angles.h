// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_CIRCLE_ANGLES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_CIRCLE_ANGLES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the exterior angles of a polygon in a circle, at the start of each edge. Arguments are
// half of the angles under which the center sees its edges.
inline std::vector<double> angles_between(const std::vector<double>& half_arc)
{
  const std::size_t n = half_arc.size();
  std::vector<double> result(n);
  for(std::size_t i = 0; i < n; ++i)
    result[i] = half_arc[i] + half_arc[(i + n - 1) % n];
  return result;
}

// Returns the exterior angles of the polygon in a circle whose edges have these lengths, at the
// start of each edge. In a circle with the diameter 1 / x, the center sees an edge of length l
// under twice the angle asin(l x). If the center is outside, the half angle of the longest edge is
// pi minus this angle. Angles are NaN if one length is not less than the sum of the others.
// Precondition: no length is zero.
inline std::vector<double> circle_angles(const std::vector<double>& length)
{
  constexpr double pi = CGAL_PI;
  const std::size_t n = length.size();
  const auto longest =
    static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  const double sum = std::accumulate(length.begin(), length.end(), 0.);
  if(!(length[longest] < sum - length[longest]))
    return std::vector<double>(n, std::numeric_limits<double>::quiet_NaN());
  const auto half_arcs = [&](double x, bool is_center_outside) {
    std::vector<double> result(n);
    std::transform(length.begin(), length.end(), result.begin(),
                   [&](double l) { return std::asin((std::min)(l * x, 1.)); });
    if(is_center_outside)
      result[longest] = pi - result[longest];
    return result;
  };
  const auto excess = [&](const std::vector<double>& arcs) {
    return std::accumulate(arcs.begin(), arcs.end(), -pi);
  };
  double low = 0, high = 1 / length[longest];
  const bool is_outside = excess(half_arcs(high, false)) < 0;
  for(double x; x = (low + high) / 2, low < x && x < high;)
    ((excess(half_arcs(x, is_outside)) > 0) != is_outside ? high : low) = x;
  std::vector<double> arcs = half_arcs(high, is_outside);
  arcs[longest] -= excess(arcs); // the arc of a chord near a diameter has half of the digits
  return angles_between(arcs);
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_CIRCLE_ANGLES_H
