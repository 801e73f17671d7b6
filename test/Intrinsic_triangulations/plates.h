// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_PLATES_H
#define INTRINSIC_TRIANGULATIONS_TEST_PLATES_H

#include "generators.h"

namespace Test_surfaces {

// A plate of cubes with `genus` square holes in a row.
inline Mesh straight_plate_with_holes(int genus)
{
  const auto is_full = [&](int x, int y, int z) {
    return z == 0 && y >= 0 && y < 3 && x >= 0 && x < 2 * genus + 1 && !(x % 2 == 1 && y == 1);
  };
  std::map<std::array<int, 3>, std::size_t> number;
  std::vector<Point> points;
  Triangles triangles;
  const auto corner = [&](const std::array<int, 3>& p) {
    const auto [entry, is_new] = number.emplace(p, points.size());
    if(is_new)
      points.emplace_back(p[0], p[1], p[2]);
    return entry->second;
  };
  const auto add_side = [&](std::array<int, 3> cell, std::size_t axis, int side) {
    std::array<int, 3> a = cell;
    a[axis] += side;
    std::array<int, 3> b = a, c = a, d = a;
    const std::size_t s = (axis + 1) % 3, t = (axis + 2) % 3;
    ++b[s], ++c[s], ++c[t], ++d[t];
    std::array<std::size_t, 4> q{corner(a), corner(b), corner(c), corner(d)};
    if(side == 0)
      std::swap(q[1], q[3]);
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  };
  for(int x = 0; x < 2 * genus + 1; ++x)
    for(int y = 0; y < 3; ++y)
      for(std::size_t axis = 0; axis < 3; ++axis)
        for(int side : {0, 1})
          if(is_full(x, y, 0)) {
            std::array<int, 3> beyond_side{x, y, 0};
            beyond_side[axis] += 2 * side - 1;
            if(!is_full(beyond_side[0], beyond_side[1], beyond_side[2]))
              add_side({x, y, 0}, axis, side);
          }
  return make_mesh(points, triangles);
}

// That mesh a little out of shape.
inline Mesh plate_with_holes(int genus)
{
  return perturbed(straight_plate_with_holes(genus), 0.1, 12);
}

// Two spheres, a torus, a disk, and a point beside them.
inline Mesh five_components()
{
  Mesh result = random_sphere(20, 8);
  result += tetrahedron();
  result.add_vertex(Point(9, 9, 9));
  result += perturbed(embedded_torus(5, 4), 0.3, 9);
  result += perturbed(grid(3, 3, [](double x, double y) { return Point(x, y, 0); }), 0.3, 4);
  return result;
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_PLATES_H
