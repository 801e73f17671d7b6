// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_POLYGON_SOUP_H
#define INTRINSIC_POLYGON_SOUP_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

// A mesh as a file gives it: indices are as they stand there.
struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  std::size_t merged_corners = 0; // of a format that has no indices
};

// Vertices and faces keep their indices, isolated vertices too.
// Precondition: the diagnosis of the soup is valid.
Mesh mesh_of(const Polygon_soup& soup);

#endif // INTRINSIC_POLYGON_SOUP_H
