// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/polygons_with_holes.h"

#include "reading/flat_polygons.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace {

// Represents the boundaries of a polygon with holes: its sides, without those that run in both
// directions.
class Keyhole
{
public:
  Keyhole(const std::vector<std::size_t>& vertices, const std::vector<Point>& points)
    : m_vertices(vertices)
  {
    std::multiset<std::pair<std::size_t, std::size_t>> sides;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      sides.emplace(vertices[i], target(i));
    for(std::size_t i = 0; i < vertices.size(); ++i)
      if(sides.count({target(i), vertices[i]}) == 0)
        m_sides.push_back(i);
    project(points);
  }

  // Returns the triangles, or nothing if the polygon has no holes, or boundaries cross.
  std::vector<Corners> triangles() const
  {
    double area = 0, all = 0;
    for(const std::vector<std::size_t>& loop : loops()) {
      area += doubled_area(loop);
      all += std::abs(doubled_area(loop));
    }
    Flat_triangulation triangulation;
    if(is_near(area, all) || !insert_sides(triangulation))
      return {};
    std::vector<Corners> result = inner_faces(triangulation);
    double found = 0;
    for(const Corners& t : result)
      found += doubled_area({t[0], t[1], t[2]});
    if(!is_near(found, area)) // some holes turn like the outer boundary
      result.clear();
    return result;
  }

private:
  static bool is_near(double area, double other)
  {
    constexpr double greatest_error = 1e-6;
    return std::abs(area - other) <= greatest_error * other;
  }

  std::size_t target(std::size_t i) const { return m_vertices[(i + 1) % m_vertices.size()]; }

  // Projects along the axis of the largest projection, so that the area is positive.
  void project(const std::vector<Point>& points)
  {
    const int axis = axes_by_area(points)[0];
    std::vector<std::size_t> all;
    for(std::size_t i = 0; i < points.size(); ++i) {
      m_flat.emplace_back(points[i][(axis + 1) % 3], points[i][(axis + 2) % 3]);
      all.push_back(i);
    }
    if(doubled_area(all) < 0)
      for(Flat_point& p : m_flat)
        p = Flat_point(p.y(), p.x());
  }

  double doubled_area(const std::vector<std::size_t>& corners) const
  {
    double result = 0;
    for(std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const auto v = m_flat[corners[i]] - m_flat[corners[0]],
                 w = m_flat[corners[i + 1]] - m_flat[corners[0]];
      result += v.x() * w.y() - v.y() * w.x();
    }
    return result;
  }

  // Returns the corners of closed loops of sides, in which no vertex is repeated.
  std::vector<std::vector<std::size_t>> loops() const
  {
    std::multimap<std::size_t, std::size_t> outgoing;
    for(const std::size_t i : m_sides)
      outgoing.emplace(m_vertices[i], i);
    std::vector<std::vector<std::size_t>> result;
    std::vector<std::size_t> path;
    std::map<std::size_t, std::size_t> place; // of the vertices on the path
    while(!outgoing.empty()) {
      const auto side = outgoing.find(path.empty() ? outgoing.begin()->first : target(path.back()));
      place.emplace(m_vertices[side->second], path.size());
      path.push_back(side->second);
      outgoing.erase(side);
      const auto closed = place.find(target(path.back()));
      if(closed == place.end())
        continue;
      const auto first = path.begin() + static_cast<std::ptrdiff_t>(closed->second);
      result.emplace_back(first, path.end());
      for(const std::size_t i : result.back())
        place.erase(m_vertices[i]);
      path.erase(first, path.end());
    }
    return result;
  }

  // Returns whether sides cross neither themselves nor each other.
  bool insert_sides(Flat_triangulation& triangulation) const
  {
    std::map<std::size_t, Flat_triangulation::Vertex_handle> vertex;
    for(const std::size_t i : m_sides) {
      vertex[m_vertices[i]] = triangulation.insert(m_flat[i]);
      vertex[m_vertices[i]]->info() = i;
    }
    if(triangulation.number_of_vertices() != vertex.size())
      return false;
    try {
      for(const std::size_t i : m_sides)
        triangulation.insert_constraint(vertex.at(m_vertices[i]), vertex.at(target(i)));
    } catch(const Flat_triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    return true;
  }

  const std::vector<std::size_t>& m_vertices;
  std::vector<std::size_t> m_sides; // by the corners at which they start
  Flat_points m_flat;               // of each corner
};

} // namespace

std::vector<std::array<std::size_t, 3>>
triangles_of_keyhole(const std::vector<std::size_t>& vertices, const std::vector<Point>& points)
{
  return Keyhole(vertices, points).triangles();
}
