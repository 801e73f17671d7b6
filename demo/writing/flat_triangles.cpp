// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/flat_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace {

// Returns whether the height of the triangle exceeds the rounding errors of the coordinates of its
// points.
bool has_area(const Point& p, const Point& q, const Point& r)
{
  const double longest = std::sqrt((std::max)(
    {CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)}));
  double greatest = 0;
  for(const Point& x : {p, q, r})
    for(int i = 0; i < 3; ++i)
      greatest = (std::max)(greatest, std::abs(x[i]));
  // Each of three points may be wrong by some rounding errors.
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * greatest;
  return 2 * std::sqrt(CGAL::squared_area(p, q, r)) > rounding * longest;
}

// Returns the orientation in the plane of points with three coordinates. Homogeneous coordinates
// are not divided, which would round.
CGAL::Orientation turn(const Corner_data& texture, std::size_t i, std::size_t j, std::size_t k)
{
  const auto& [p, q, r] =
    std::tie(texture.coordinates[i], texture.coordinates[j], texture.coordinates[k]);
  if(texture.dimension == 2)
    return CGAL::orientation(Kernel::Point_2(p[0], p[1]), Kernel::Point_2(q[0], q[1]),
                             Kernel::Point_2(r[0], r[1]));
  return CGAL::orientation(Point(0, 0, 0), Point(p[0], p[1], p[2]), Point(q[0], q[1], q[2]),
                           Point(r[0], r[1], r[2]));
}

// Calls `visit` with each polygon, the orientation in the plane of each of its triangles, and
// whether the triangle has area in space beyond rounding.
template <class Visit>
void for_each_triangle(const Output_mesh& mesh, const Visit& visit)
{
  for(std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const Polygons::Polygon p = mesh.polygons[i], t = mesh.texture.polygons[i];
    for(std::size_t k = 2; k < p.size(); ++k)
      visit(i, turn(mesh.texture, t[0], t[k - 1], t[k]),
            has_area(mesh.points[p[0]], mesh.points[p[k - 1]], mesh.points[p[k]]));
  }
}

// Adds the first faces of the input that contain polygons.
void name_faces(Statistics& statistics, const Output_mesh& mesh,
                const std::vector<std::size_t>& polygons)
{
  constexpr std::size_t most = 10;
  std::vector<std::int64_t> faces;
  for(std::size_t n = 0; n < polygons.size() && faces.size() < most; ++n)
    if(const std::int64_t face = number_of(mesh.placement.face(polygons[n], 0));
       std::find(faces.begin(), faces.end(), face) == faces.end())
      faces.push_back(face);
  statistics["flipped_faces"] = faces;
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
  std::vector<std::size_t> polygons;
  for_each_triangle(mesh, [&](std::size_t i, CGAL::Orientation turn, bool has_area) {
    flipped += has_area && turn == CGAL::RIGHT_TURN;
    degenerate += has_area && turn == CGAL::COLLINEAR;
    slivers += !has_area && turn != CGAL::LEFT_TURN;
    if(turn == CGAL::RIGHT_TURN)
      polygons.push_back(i);
  });
  statistics["flipped_triangles"] = flipped;
  statistics["degenerate_triangles"] = degenerate;
  statistics["flipped_slivers"] = slivers;
  name_faces(statistics, mesh, polygons);
}

void describe_triangles_on_sphere(Statistics& statistics, const Output_mesh& mesh, bool is_flat)
{
  std::vector<std::size_t> polygons;
  for(std::size_t i = 0; i < mesh.polygons.size() && !is_flat; ++i) {
    const Polygons::Polygon p = mesh.polygons[i];
    for(std::size_t k = 2; k < p.size(); ++k)
      if(CGAL::orientation(Point(0, 0, 0), mesh.points[p[0]], mesh.points[p[k - 1]],
                           mesh.points[p[k]]) == CGAL::NEGATIVE)
        polygons.push_back(i);
  }
  statistics["flipped_in_output"] = polygons.size();
  name_faces(statistics, mesh, polygons);
}

std::string flipped_slivers(const Statistics& statistics)
{
  const auto slivers = statistics["flipped_slivers"].get<std::size_t>();
  return slivers == 0 ? "" : " and " + std::to_string(slivers) + " slivers";
}

std::string first_flipped_face(const Statistics& statistics)
{
  const Statistics& faces = statistics["flipped_faces"];
  return faces.empty() ? "" : " (the first in face " + faces[0].dump() + ")";
}
