// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/flat_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

// Whether the height of the triangle is more than rounding of the coordinates of its points.
bool has_area(const Point& p, const Point& q, const Point& r)
{
  const double longest = std::sqrt((std::max)(
    {CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)}));
  double greatest = 0;
  for(const Point& x : {p, q, r})
    for(int i = 0; i < 3; ++i)
      greatest = (std::max)(greatest, std::abs(x[i]));
  // each of three points may be wrong by some roundings
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * greatest;
  return 2 * std::sqrt(CGAL::squared_area(p, q, r)) > rounding * longest;
}

// Calls `visit` with each polygon, the orientation in the plane of each triangle into which it is
// cut, and whether the triangle has area in space beyond rounding.
template <class Visit>
void for_each_triangle(const Output_mesh& mesh, const Visit& visit)
{
  const auto place = [&](std::size_t c) {
    const std::array<double, 3>& z = mesh.texture.coordinates[c];
    return Kernel::Point_2(z[0] / z[2], z[1] / z[2]);
  };
  for(std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const Polygons::Polygon p = mesh.polygons[i], t = mesh.texture.polygons[i];
    for(std::size_t k = 2; k < p.size(); ++k)
      visit(i, CGAL::orientation(place(t[0]), place(t[k - 1]), place(t[k])),
            has_area(mesh.points[p[0]], mesh.points[p[k - 1]], mesh.points[p[k]]));
  }
}

} // namespace

std::vector<std::int64_t> flipped_polygons(const Output_mesh& mesh)
{
  std::vector<std::int64_t> result;
  for_each_triangle(mesh, [&](std::size_t i, CGAL::Orientation turn, bool has_area) {
    const auto polygon = static_cast<std::int64_t>(i);
    if(has_area && turn == CGAL::RIGHT_TURN && (result.empty() || result.back() != polygon))
      result.push_back(polygon);
  });
  return result;
}

void describe_triangles(Statistics& statistics, const Output_mesh& mesh)
{
  std::size_t flipped = 0, degenerate = 0, slivers = 0;
  for_each_triangle(mesh, [&](std::size_t, CGAL::Orientation turn, bool has_area) {
    flipped += has_area && turn == CGAL::RIGHT_TURN;
    degenerate += has_area && turn == CGAL::COLLINEAR;
    slivers += !has_area && turn != CGAL::LEFT_TURN;
  });
  statistics["flipped_triangles"] = flipped;
  statistics["degenerate_triangles"] = degenerate;
  statistics["flipped_slivers"] = slivers;
}
