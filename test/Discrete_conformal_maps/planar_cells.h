// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_TEST_PLANAR_CELLS_H
#define DISCRETE_CONFORMAL_MAPS_TEST_PLANAR_CELLS_H

#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/flatten_to_rectangle.h>

// This file generates polygons of unit squares, and computes the ratios of the sides of their
// rectangles.
namespace Test_surfaces {

typedef std::pair<int, int> Cell;

// Represents unit squares with these lower left corners, each of n x n small ones with random
// diagonals.
class Planar_cells
{
public:
  Planar_cells(const std::set<Cell>& cells, int n, unsigned int seed) : m_n(n)
  {
    CGAL::Random random(seed);
    std::vector<Point> points;
    Triangles triangles;
    for(const auto& [x, y] : cells)
      for(int i = n * x; i < n * (x + 1); ++i)
        for(int j = n * y; j < n * (y + 1); ++j) {
          const std::size_t a = index({i, j}, points), b = index({i + 1, j}, points),
                            c = index({i + 1, j + 1}, points), d = index({i, j + 1}, points);
          if(random.get_bool())
            triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
          else
            triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
        }
    mesh = make_mesh(points, triangles);
  }

  // Returns the vertex at a corner of small squares, in multiples of their sides.
  Vertex_index at(const Cell& corner) const { return Vertex_index(m_index.at(corner)); }

  // Returns the vertex at a corner of unit squares.
  Vertex_index at_corner(int x, int y) const { return at({m_n * x, m_n * y}); }

  // Returns the position of a vertex in multiples of the sides of small squares.
  Cell place(Vertex_index v) const
  {
    const Point& p = mesh.point(v);
    return {int(std::lround(p.x() * m_n)), int(std::lround(p.y() * m_n))};
  }

  Mesh mesh;

private:
  std::size_t index(const Cell& corner, std::vector<Point>& points)
  {
    const auto [entry, is_new] = m_index.emplace(corner, unsigned(m_index.size()));
    if(is_new)
      points.emplace_back(double(corner.first) / m_n, double(corner.second) / m_n, 0);
    return entry->second;
  }

  int m_n;
  std::map<Cell, unsigned int> m_index;
};

// Returns the image of a vertex by a map to the plane.
inline Complex image(const Planar_conformal_map& map, Vertex_index v)
{
  return map(corner(mesh_A(map), v));
}

// Returns the ratio of the first side of the rectangle, from the first to the second corner, to the
// next one.
template <typename... Parameters>
double ratio_of_sides(const Mesh& mesh, const std::vector<Vertex_index>& corners,
                      const Parameters&... parameters)
{
  const Planar_conformal_map map = DCM::flatten_to_rectangle(mesh, corners, parameters...);
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  std::vector<Complex> z;
  for(Vertex_index v : corners)
    z.push_back(image(map, v));
  return std::abs(z[1] - z[0]) / std::abs(z[2] - z[1]);
}

// Checks that errors on finer and finer meshes decrease by a factor, to at most a bound.
inline void expect_convergence(const std::vector<double>& errors, double factor, double bound)
{
  for(std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_LT(errors[i] * factor, errors[i - 1]) << testing::PrintToString(errors);
  EXPECT_LT(errors.back(), bound) << testing::PrintToString(errors);
}

} // namespace Test_surfaces

#endif // DISCRETE_CONFORMAL_MAPS_TEST_PLANAR_CELLS_H
