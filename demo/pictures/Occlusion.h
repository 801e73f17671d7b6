// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OCCLUSION_H
#define INTRINSIC_OCCLUSION_H

#include "reading/Polygon_soup.h"

#include <cstddef>
#include <vector>

// Determines which points are behind polygons. Coordinates are pixels to the right, downwards and
// to the viewer. A point less than a pixel behind a polygon is on it.
class Occlusion
{
public:
  typedef Kernel::Vector_3 Vector;

  explicit Occlusion(std::vector<Vector> points);

  // Hides the points behind a polygon, which is flat, with a normal of any length.
  void add_polygon(const std::vector<Vector>& corners, const Vector& normal);

  bool is_hidden(std::size_t i) const { return m_is_hidden[i]; }

private:
  std::vector<Vector> m_points;
  std::vector<std::size_t> m_order; // of the points, by their first coordinates
  std::vector<bool> m_is_hidden;
};

#endif // INTRINSIC_OCCLUSION_H
