// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/close_points.h"

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

namespace {

double diagonal(const CGAL::Bbox_3& box)
{
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

double distance_of(const Point& p, const Point& q)
{
  return std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() - q.z());
}

// Stores points in the cells of a grid.
class Point_grid
{
public:
  // Cells are large enough for their numbers to stay in range.
  Point_grid(const std::vector<Point>& points, double reach)
    : m_points(points),
      m_box(CGAL::bbox_3(points.begin(), points.end())),
      m_size(
        (std::max)({reach, std::ldexp(diagonal(m_box), -40), (std::numeric_limits<double>::min)()}))
  {}

  void insert(std::size_t i) { m_cells[cell(m_points[i])].push_back(i); }

  // Returns the nearest point that was inserted, at most as far away as `reach(i)`, and its
  // distance. Among equally near points, the least index wins.
  template <class Reach>
  std::optional<std::pair<double, std::size_t>> nearest(const Point& p, const Reach& reach) const
  {
    std::optional<std::pair<double, std::size_t>> result;
    const Cell center = cell(p);
    for(int n = 0; n < 27; ++n) {
      const auto found =
        m_cells.find({center[0] + n % 3 - 1, center[1] + n / 3 % 3 - 1, center[2] + n / 9 - 1});
      if(found == m_cells.end())
        continue;
      for(const std::size_t i : found->second) {
        const std::pair<double, std::size_t> candidate(distance_of(p, m_points[i]), i);
        if(candidate.first <= reach(i) && (!result || candidate < *result))
          result = candidate;
      }
    }
    return result;
  }

private:
  typedef std::array<std::int64_t, 3> Cell;

  Cell cell(const Point& p) const
  {
    const auto number = [&](double x, double least) {
      const double n = std::floor((x - least) / m_size);
      return n >= 0 && n < 0x1p62 ? static_cast<std::int64_t>(n) : 0; // a box may be infinite
    };
    return {number(p.x(), m_box.xmin()), number(p.y(), m_box.ymin()), number(p.z(), m_box.zmin())};
  }

  const std::vector<Point>& m_points;
  CGAL::Bbox_3 m_box;
  double m_size;
  std::unordered_map<Cell, std::vector<std::size_t>, boost::hash<Cell>> m_cells;
};

// Returns for each vertex the shorter of its edges on the boundary, or infinity inside.
std::vector<double> boundary_lengths(const Mesh& mesh)
{
  std::vector<double> result(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  for(const Mesh::Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h)) {
      const double length = distance_of(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
      for(const Mesh::Vertex_index v : {mesh.source(h), mesh.target(h)})
        result[v] = (std::min)(result[v], length);
    }
  return result;
}

std::string text_of(const char* format, double x)
{
  char text[32];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

std::string first_of(const std::array<std::size_t, 2>& pair)
{
  return ", first " + std::to_string(pair[0]) + " with " + std::to_string(pair[1]);
}

} // namespace

std::vector<std::string> Cracks::messages(bool is_repaired) const
{
  std::vector<std::string> result;
  if(coincident > 0)
    result.push_back("points on the boundary that coincide with another: " +
                     std::to_string(coincident) + first_of(coincide) +
                     (is_repaired ? "; the surface is manifold only if they are apart"
                                  : "; --repair merges them"));
  if(close > 0) // a tenth more, so that two digits suffice
    result.push_back(
      "points on the boundary that nearly coincide with another: " + std::to_string(close) +
      first_of(are_close) + ", at most " + text_of("%.3g", distance) + " apart; --weld " +
      text_of("%.2g", 1.1 * distance) + " merges them");
  return result;
}

Cracks cracks(const Mesh& mesh)
{
  const std::vector<double> length = boundary_lengths(mesh);
  std::vector<Point> points;
  std::vector<std::size_t> vertex;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(std::isfinite(length[v])) {
      points.push_back(mesh.point(v));
      vertex.push_back(v);
    }
  Cracks result;
  if(points.empty())
    return result;
  const double most = 1e-4 * diagonal(CGAL::bbox_3(mesh.points().begin(), mesh.points().end()));
  Point_grid grid(points, most);
  for(std::size_t i = 0; i < points.size(); ++i) {
    const auto reach = [&](std::size_t k) {
      return (std::min)(most, (std::min)(length[vertex[i]], length[vertex[k]]) / 100);
    };
    if(const auto found = grid.nearest(points[i], reach)) {
      const auto [distance, k] = *found;
      const std::array<std::size_t, 2> pair{vertex[i], vertex[k]};
      if(distance == 0 && result.coincident++ == 0)
        result.coincide = pair;
      if(distance > 0 && result.close++ == 0)
        result.are_close = pair;
      result.distance = (std::max)(result.distance, distance);
    } else // as weld() does
      grid.insert(i);
  }
  return result;
}

std::size_t weld(std::vector<Point>& points, double distance)
{
  std::size_t moved = 0;
  const std::vector<Point> original = points;
  Point_grid grid(original, distance);
  const auto reach = [&](std::size_t) { return distance; };
  for(std::size_t i = 0; i < points.size(); ++i)
    if(const auto found = grid.nearest(original[i], reach)) {
      points[i] = original[found->second];
      moved += found->first > 0;
    } else
      grid.insert(i);
  return moved;
}

std::vector<std::size_t> first_equal_points(const std::vector<Point>& points)
{
  std::map<Point, std::size_t> first;
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < points.size(); ++i)
    result.push_back(first.emplace(points[i], i).first->second);
  return result;
}
