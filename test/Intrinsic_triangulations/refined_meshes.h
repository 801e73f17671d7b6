// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_REFINED_MESHES_H
#define INTRINSIC_TRIANGULATIONS_TEST_REFINED_MESHES_H

#include "generators.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

// Meshes of one shape, as fine as asked for.
namespace Test_surfaces {

// Unit square; inner vertices moved by up to a fifth of a cell.
inline Mesh unit_square(std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  const double h = 1 / static_cast<double>(n);
  return grid(n, n, [&](double x, double y) {
    const bool inside = x > 0 && y > 0 && x < static_cast<double>(n) && y < static_cast<double>(n);
    const double move = inside ? 0.2 : 0;
    return Point(h * (x + move * random.get_double(-1, 1)),
                 h * (y + move * random.get_double(-1, 1)), 0);
  });
}

// The octahedron with n edges in place of one, on the unit sphere.
inline Mesh unit_sphere(std::size_t n)
{
  const double h = 1 / static_cast<double>(n);
  const Mesh coarse = octahedron();
  std::map<std::array<int, 3>, std::size_t> numbers;
  std::vector<Point> points;
  Triangles triangles;
  for(Face_index f : coarse.faces()) {
    const Halfedge_index side = coarse.halfedge(f);
    const auto a = coarse.point(coarse.source(side)) - CGAL::ORIGIN;
    const auto b = coarse.point(coarse.target(side)) - CGAL::ORIGIN;
    const auto c = coarse.point(coarse.target(coarse.next(side))) - CGAL::ORIGIN;
    const auto number = [&](std::size_t i, std::size_t j) {
      const auto p = h * (static_cast<double>(n - i - j) * a + static_cast<double>(i) * b +
                          static_cast<double>(j) * c);
      const auto on_grid = [&](double x) {
        return static_cast<int>(std::lround(x * static_cast<double>(n)));
      };
      const auto [entry, is_new] =
        numbers.emplace(std::array{on_grid(p.x()), on_grid(p.y()), on_grid(p.z())}, points.size());
      if(is_new)
        points.push_back(CGAL::ORIGIN + p / std::sqrt(p.squared_length()));
      return entry->second;
    };
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = 0; i + j < n; ++j) {
        triangles.push_back({number(i, j), number(i + 1, j), number(i, j + 1)});
        if(i + j + 1 < n)
          triangles.push_back({number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
      }
  }
  return make_mesh(points, triangles);
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_REFINED_MESHES_H
