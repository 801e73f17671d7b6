// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/polygon_splitting.h"

#include "Program_error.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace {

using Index = Polygons::Index;
using Flat_point = Kernel::Point_2;
using Flat_points = std::vector<Flat_point>;
using Corners = std::array<std::size_t, 3>; // of a triangle, among those of its polygon
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
  Kernel, CGAL::Triangulation_data_structure_2<
            CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>,
            CGAL::Constrained_triangulation_face_base_2<Kernel>>>;

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

// Returns the axes. The axis along which the polygon has the largest projection comes first.
std::array<int, 3> axes_by_area(const std::vector<Point>& points)
{
  std::array<double, 3> area{};
  for(std::size_t i = 1; i + 1 < points.size(); ++i)
    for(int x = 0; x < 3; ++x) {
      const auto v = points[i] - points[0], w = points[i + 1] - points[0];
      area[static_cast<std::size_t>(x)] += CGAL::cross_product(v, w)[x];
    }
  std::array<int, 3> result{0, 1, 2};
  std::stable_sort(result.begin(), result.end(), [&](int x, int y) {
    return std::abs(area[static_cast<std::size_t>(x)]) >
           std::abs(area[static_cast<std::size_t>(y)]);
  });
  return result;
}

// Returns the best projection, or nothing if the polygon is simple in none.
Flat_points best_projection(const std::vector<Point>& points)
{
  for(const int x : axes_by_area(points))
    if(Flat_points result = projection(points, x); !result.empty())
      return result;
  return {};
}

// Returns the faces of a triangulation inside the polygon of its constraints, which is simple.
std::vector<Corners> inner_faces(const Triangulation& triangulation)
{
  std::set<Triangulation::Face_handle> outside{triangulation.infinite_face()};
  std::vector<Triangulation::Face_handle> stack(outside.begin(), outside.end());
  while(!stack.empty()) {
    const auto f = stack.back();
    stack.pop_back();
    for(int i = 0; i < 3; ++i)
      if(!f->is_constrained(i) && outside.insert(f->neighbor(i)).second)
        stack.push_back(f->neighbor(i));
  }
  std::vector<Corners> result;
  for(const auto f : triangulation.finite_face_handles())
    if(outside.count(f) == 0)
      result.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return result;
}

std::vector<Corners> triangles_of(const Flat_points& points)
{
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
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

// ---- Polygons with holes ----

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
    Triangulation triangulation;
    if(is_near(area, all) || !insert_sides(triangulation))
      return {};
    std::vector<Corners> result = faces_between(triangulation);
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
  bool insert_sides(Triangulation& triangulation) const
  {
    std::map<std::size_t, Triangulation::Vertex_handle> vertex;
    for(const std::size_t i : m_sides) {
      vertex[m_vertices[i]] = triangulation.insert(m_flat[i]);
      vertex[m_vertices[i]]->info() = i;
    }
    if(triangulation.number_of_vertices() != vertex.size())
      return false;
    try {
      for(const std::size_t i : m_sides)
        triangulation.insert_constraint(vertex.at(m_vertices[i]), vertex.at(target(i)));
    } catch(const Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    return true;
  }

  // Returns the faces that an odd number of sides separates from infinity.
  static std::vector<Corners> faces_between(const Triangulation& triangulation)
  {
    std::map<Triangulation::Face_handle, bool> is_inside{{triangulation.infinite_face(), false}};
    std::vector<Triangulation::Face_handle> stack{triangulation.infinite_face()};
    while(!stack.empty()) {
      const auto f = stack.back();
      stack.pop_back();
      for(int i = 0; i < 3; ++i)
        if(is_inside.emplace(f->neighbor(i), is_inside.at(f) != f->is_constrained(i)).second)
          stack.push_back(f->neighbor(i));
    }
    std::vector<Corners> result;
    for(const auto f : triangulation.finite_face_handles())
      if(is_inside.at(f))
        result.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    return result;
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

void split_polygons(const std::string& path, Polygon_soup& soup, const Polygon_tolerance& tolerance)
{
  Splitter(path, soup, tolerance)();
}
