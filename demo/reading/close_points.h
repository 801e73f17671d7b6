// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_CLOSE_POINTS_H
#define INTRINSIC_CLOSE_POINTS_H

#include "reading/Polygon_soup.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Describes vertices on the boundary that coincide, or almost coincide. Edges that should be one
// edge are two.
struct Cracks
{
  std::size_t coincident = 0;               // vertices that are where an earlier one is
  std::array<std::size_t, 2> coincide = {}; // the first of them, and the earlier one
  std::size_t close = 0; // vertices nearer to an earlier one than a hundredth of their edges on the
                         // boundary, and than 1e-4 of the diagonal of the mesh, but not at it
  std::array<std::size_t, 2> are_close = {}; // the first of them, and the earlier one
  double distance = 0;                       // the greatest of theirs

  // Returns a sentence for each kind of crack, and the option that merges it. In a repaired mesh,
  // points coincide only if the surface would not be manifold otherwise.
  std::vector<std::string> messages(bool is_repaired) const;
};

// Finds the cracks. Complexity: linear, unless very many vertices on the boundary are close to each
// other.
Cracks cracks(const Mesh& mesh);

// Returns, for each point, the first point at its position.
std::vector<std::size_t> first_equal_points(const std::vector<Point>& points);

// Moves each point to the nearest previous point that has not been moved, if its distance is at
// most `distance`. Returns how many points have changed their coordinates.
std::size_t weld(std::vector<Point>& points, double distance);

#endif // INTRINSIC_CLOSE_POINTS_H
