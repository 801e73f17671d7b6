// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/polygon_splitting.h"

#include "Program_error.h"
#include "reading/flat_polygons.h"

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace {

using Index = Polygons::Index;

// ---- One polygon ----

// Returns the projection along axis x, reflected if necessary, so that it is counterclockwise.
Flat_points projection(const std::vector<Point>& points, int x)
{
  const auto flat = [&](int a, int b) {
    Flat_points result;
    for(const Point& p : points)
      result.emplace_back(p[a], p[b]);
    return result;
  };
  const Flat_points result = flat((x + 1) % 3, (x + 2) % 3);
  if(!CGAL::is_simple_2(result.begin(), result.end(), Kernel()))
    return {};
  if(CGAL::orientation_2(result.begin(), result.end(), Kernel()) == CGAL::COUNTERCLOCKWISE)
    return result;
  return flat((x + 2) % 3, (x + 1) % 3);
}

// Returns the best projection, or nothing if the polygon is simple in none.
Flat_points best_projection(const std::vector<Point>& points)
{
  for(const int x : axes_by_area(points))
    if(Flat_points result = projection(points, x); !result.empty())
      return result;
  return {};
}

// Returns whether a line contains all points.
bool are_collinear(const std::vector<Point>& points)
{
  const auto other =
    std::find_if(points.begin(), points.end(), [&](const Point& p) { return p != points.front(); });
  return std::all_of(other, points.end(),
                     [&](const Point& p) { return CGAL::collinear(points.front(), *other, p); });
}

std::vector<Corners> triangles_of(const Flat_points& points)
{
  Flat_triangulation triangulation;
  std::vector<Flat_triangulation::Vertex_handle> vertices;
  for(const Flat_point& p : points) {
    vertices.push_back(triangulation.insert(p));
    vertices.back()->info() = vertices.size() - 1;
  }
  for(std::size_t i = 0; i < vertices.size(); ++i)
    triangulation.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
  return inner_faces(triangulation);
}

// Returns the triangles, or nothing if CGAL finds none. Also returns nothing for so many points
// that the search would take minutes. It is cubic if the faces of a Delaunay triangulation in space
// do not suffice.
std::vector<Corners> triangles_of_hole(const std::vector<Point>& points)
{
  std::vector<CGAL::Triple<int, int, int>> patch;
  if(points.size() <= 1000)
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      points, std::back_inserter(patch),
      CGAL::parameters::do_not_use_cubic_algorithm(points.size() > 300));
  std::vector<Corners> result;
  for(const auto& [a, b, c] : patch)
    result.push_back(
      {static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
  return result;
}

// ---- Edges that are taken ----

class Edge_set
{
public:
  // Inserts an edge, and returns whether it is new.
  bool insert(Index v, Index w) { return m_edges.insert(key(v, w)).second; }
  bool contains(Index v, Index w) const { return m_edges.count(key(v, w)) > 0; }

private:
  static std::uint64_t key(Index v, Index w)
  {
    return (std::uint64_t((std::min)(v, w)) << 32) | (std::max)(v, w);
  }

  std::unordered_set<std::uint64_t> m_edges;
};

// Stores the triangles of one polygon, whose diagonals can be flipped.
class Diagonals
{
public:
  // Without flat points, any triangles are allowed.
  Diagonals(std::vector<Corners> triangles, Flat_points points, Polygons::Polygon polygon)
    : m_triangles(std::move(triangles)), m_points(std::move(points)), m_polygon(polygon)
  {}

  const std::vector<Corners>& triangles() const { return m_triangles; }

  // Avoids edges in `taken`. Returns false if this is impossible.
  bool avoid(const Edge_set& taken)
  {
    for(std::size_t flips = 0; flips <= m_triangles.size(); ++flips) {
      const auto diagonal = first_in(taken);
      if(!diagonal)
        return true;
      if(!flip_any(*diagonal, taken))
        return false;
    }
    return false;
  }

  void add_to(Edge_set& taken) const
  {
    for_each_diagonal([&](std::size_t t, std::size_t i) {
      taken.insert(corner(t, i), corner(t, i + 1));
      return false;
    });
  }

private:
  typedef std::pair<std::size_t, std::size_t> Side; // of a triangle, to the next corner

  std::size_t number(std::size_t t, std::size_t i) const { return m_triangles[t][i % 3]; }
  Index corner(std::size_t t, std::size_t i) const { return m_polygon[number(t, i)]; }

  bool is_diagonal(std::size_t t, std::size_t i) const
  {
    const std::size_t n = m_polygon.size(), a = number(t, i), b = number(t, i + 1);
    return (a + 1) % n != b && (b + 1) % n != a;
  }

  // Visits the diagonals until visit(t, i) is true.
  template <class Visit>
  std::optional<Side> for_each_diagonal(const Visit& visit) const
  {
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i)
        if(is_diagonal(t, i) && visit(t, i))
          return Side{t, i};
    return std::nullopt;
  }

  std::optional<Side> first_in(const Edge_set& taken) const
  {
    return for_each_diagonal(
      [&](std::size_t t, std::size_t i) { return taken.contains(corner(t, i), corner(t, i + 1)); });
  }

  // Flips a diagonal if the new one is not taken.
  bool flip_any(const Side& side, const Edge_set& taken)
  {
    const auto [t, i] = side;
    const std::size_t a = number(t, i), b = number(t, i + 1), c = number(t, i + 2);
    const auto other = for_each_diagonal([&, a = a, b = b](std::size_t u, std::size_t j) {
      return number(u, j) == b && number(u, j + 1) == a;
    });
    const std::size_t d = number(other->first, other->second + 2);
    const auto turns_left = [&](std::size_t p, std::size_t q, std::size_t r) {
      return m_points.empty() || CGAL::left_turn(m_points[p], m_points[q], m_points[r]);
    };
    if(!turns_left(d, b, c) || !turns_left(c, a, d) || taken.contains(m_polygon[c], m_polygon[d]))
      return false;
    m_triangles[t] = {d, b, c};
    m_triangles[other->first] = {c, a, d};
    return true;
  }

  std::vector<Corners> m_triangles;
  Flat_points m_points;
  Polygons::Polygon m_polygon;
};

// ---- All polygons ----

class Splitter
{
public:
  Splitter(const std::string& path, Polygon_soup& soup, const Polygon_tolerance& tolerance)
    : m_path(path), m_soup(soup), m_tolerance(tolerance)
  {}

  void operator()()
  {
    if(!m_tolerance.may_share_edges)
      for(const Polygons::Polygon& p : m_soup.polygons)
        for(std::size_t i = 0; i < p.size(); ++i)
          m_taken.insert(p[i], p[(i + 1) % p.size()]);
    for(std::size_t f = 0; f < m_soup.polygons.size(); ++f)
      split(f);
    carry_to_parts(m_soup.polygons, m_parents, m_triangles, m_soup.data);
    m_soup.polygons = std::move(m_triangles);
    m_soup.parents = std::move(m_parents);
    m_soup.is_reversed = std::move(m_is_reversed);
  }

private:
  [[noreturn]] void fail(std::size_t f, const std::string& what) const
  {
    throw Program_error(m_path + ": face " + std::to_string(f) + " " + what);
  }

  void split(std::size_t f)
  {
    const Polygons::Polygon polygon = m_soup.polygons[f];
    if(polygon.size() < 3)
      fail(f, "has fewer than three corners; remove it, or let --repair do so");
    if(polygon.size() == 3)
      return add(f, polygon);
    Diagonals diagonals = triangulation(f, polygon);
    if(!m_tolerance.may_share_edges) {
      if(!diagonals.avoid(m_taken))
        fail(f, "cannot be split into triangles without an edge that another face has; split "
                "it in the file");
      diagonals.add_to(m_taken);
    }
    for(Corners t : diagonals.triangles()) {
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      add(f, std::array<Index, 3>{polygon[t[0]], polygon[t[1]], polygon[t[2]]});
    }
  }

  Diagonals triangulation(std::size_t f, const Polygons::Polygon& polygon) const
  {
    std::vector<Point> points;
    for(const Index v : polygon)
      points.push_back(m_soup.points[v]);
    const Flat_points flat = best_projection(points);
    if(!flat.empty())
      return {triangles_of(flat), flat, polygon};
    if(are_collinear(points))
      fail(f, "has no area, because a line contains its corners; remove it from the file");
    const std::string reason = "crosses or touches itself, seen along every axis";
    if(!m_tolerance.may_touch_themselves)
      fail(f, reason + "; split it in the file, or let --repair do so");
    std::vector<Corners> triangles = triangles_of_hole(points);
    if(triangles.size() != points.size() - 2)
      fail(f, reason + ", and cannot be split into triangles; split it in the file");
    return {std::move(triangles), {}, polygon};
  }

  template <class Triangle>
  void add(std::size_t f, const Triangle& triangle)
  {
    m_triangles.push_back(triangle);
    m_parents.push_back(static_cast<std::int64_t>(f));
    if(!m_soup.is_reversed.empty())
      m_is_reversed.push_back(m_soup.is_reversed[f]);
  }

  const std::string& m_path;
  Polygon_soup& m_soup;
  Polygon_tolerance m_tolerance;
  Edge_set m_taken;
  Polygons m_triangles;
  std::vector<std::int64_t> m_parents;
  std::vector<bool> m_is_reversed;
};

} // namespace

void split_polygons(const std::string& path, Polygon_soup& soup, const Polygon_tolerance& tolerance)
{
  Splitter(path, soup, tolerance)();
}
