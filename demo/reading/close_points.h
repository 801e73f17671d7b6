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

// Vertices on the boundary of a surface that are where other ones are, or almost: edges that were
// meant to be one are two.
struct Cracks
{
  std::size_t coincident = 0;               // vertices that are where an earlier one is
  std::array<std::size_t, 2> coincide = {}; // the first of them, and the earlier one
  std::size_t close = 0; // vertices nearer to an earlier one than a hundredth of their edges on the
                         // boundary, and than 1e-4 of the diagonal of the mesh, but not at it
  std::array<std::size_t, 2> are_close = {}; // the first of them, and the earlier one
  double distance = 0;                       // the greatest of theirs

  // What there is and what merges it, a sentence each.
  std::vector<std::string> messages() const;
};

// Complexity: linear, unless very many vertices on the boundary are close to each other.
Cracks cracks(const Mesh& mesh);

// Moves each point to the nearest of those before it that have not been moved, if that is at most
// this far away. Returns how many have other coordinates than before.
std::size_t weld(std::vector<Point>& points, double distance);

#endif // INTRINSIC_CLOSE_POINTS_H
