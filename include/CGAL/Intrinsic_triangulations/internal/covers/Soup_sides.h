// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVERS_SOUP_SIDES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVERS_SOUP_SIDES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Orders triangles with a common side by their angles around it. The order is counterclockwise,
// seen against the direction of the side. The angle is zero at a reference. All decisions are
// exact. Triangles with one angle lie in one plane. They are stacked by their indices, in the
// direction of the normal whose first nonzero component is positive. So equal triangles have the
// same order around all their sides. Triangles without a plane come last.
template <typename Point_>
class Wing_order
{
  typedef typename Kernel_traits<Point_>::Kernel Own_kernel;
  static constexpr bool is_floating = std::is_floating_point_v<typename Own_kernel::FT>;
  typedef std::conditional_t<is_floating, Exact_predicates_inexact_constructions_kernel, Own_kernel>
    Kernel;
  typedef typename Kernel::Point_3 Point;

public:
  // Stores an apex of a triangle, with the index of the triangle.
  struct Wing
  {
    Point apex;
    std::size_t index;
    int section; // of the angle: at the reference, less than pi, pi, more, without a plane
  };

  Wing_order(const Point_& from, const Point_& to)
    : m_from(converted(from)), m_to(converted(to)), m_reference(m_from)
  {}

  void set_reference(const Point_& apex) { m_reference = converted(apex); }

  bool has_plane(const Point_& apex) const
  {
    return !typename Kernel::Collinear_3()(m_from, m_to, converted(apex));
  }

  Wing wing(const Point_& apex, std::size_t index) const
  {
    const Point p = converted(apex);
    return {p, index, section(p)};
  }

  bool operator()(const Wing& a, const Wing& b) const
  {
    if(a.section != b.section)
      return a.section < b.section;
    const Orientation turn = a.section == 1 || a.section == 3
                               ? typename Kernel::Orientation_3()(m_from, m_to, a.apex, b.apex)
                               : COPLANAR;
    if(turn != COPLANAR)
      return turn == POSITIVE;
    return is_stacked_upwards(a.apex) ? a.index < b.index : b.index < a.index;
  }

private:
  static Point converted(const Point_& p)
  {
    if constexpr(is_floating)
      return Point(double(p.x()), double(p.y()), double(p.z()));
    else
      return p;
  }

  int section(const Point& apex) const
  {
    if(typename Kernel::Collinear_3()(m_from, m_to, apex))
      return 4;
    const Orientation turn = typename Kernel::Orientation_3()(m_from, m_to, m_reference, apex);
    if(turn != COPLANAR)
      return turn == POSITIVE ? 1 : 3;
    return typename Kernel::Coplanar_orientation_3()(m_from, m_to, m_reference, apex) == POSITIVE
             ? 0
             : 2;
  }

  // Returns whether the normal of the triangle has the chosen direction. Without a normal, returns
  // true.
  bool is_stacked_upwards(const Point& apex) const
  {
    for(int x = 0; x < 3; ++x) {
      const auto flat = [&](const Point& p) {
        return typename Kernel::Point_2(p[(x + 1) % 3], p[(x + 2) % 3]);
      };
      const Orientation turn =
        typename Kernel::Orientation_2()(flat(m_from), flat(m_to), flat(apex));
      if(turn != COLLINEAR)
        return turn == LEFT_TURN;
    }
    return true;
  }

  Point m_from, m_to, m_reference;
};

// Stores the sides of a soup of triangles: side 3 t + i leads from corner i of triangle t to the
// next.
class Soup_sides
{
public:
  typedef Delta_complex::size_type Index;
  typedef std::array<Index, 3> Triangle;
  typedef std::vector<Index> Bundle; // the sides of an edge

  template <typename Triangles>
  Soup_sides(std::size_t number_of_vertices, const Triangles& triangles)
    : m_number_of_vertices(number_of_vertices)
  {
    check_number(number_of_vertices);
    m_triangles.reserve(
      static_cast<std::size_t>(std::distance(std::begin(triangles), std::end(triangles))));
    for(const auto& corners : triangles)
      add(three_of(corners));
  }

  std::size_t number_of_triangles() const { return m_triangles.size(); }
  std::size_t number_of_sides() const { return 3 * m_triangles.size(); }

  Index corner(std::size_t triangle, std::size_t i) const { return m_triangles[triangle][i]; }
  Index source(std::size_t side) const { return corner(side / 3, side % 3); }
  Index target(std::size_t side) const { return corner(side / 3, (side + 1) % 3); }
  Index apex(std::size_t side) const { return corner(side / 3, (side + 2) % 3); }
  bool ascends(std::size_t side) const { return source(side) < target(side); }

  // Returns for each side the previous one around its edge. The sides of an edge are in the order
  // of their indices; more than two sides are in the order of `order(bundle)`. Complexity: linear,
  // plus the calls of `order`.
  template <typename Order>
  std::vector<Index> sides_before(const Order& order) const
  {
    std::vector<Index> before(number_of_sides());
    Bundle bundle;
    for(const Index first : link_in_rings(before)) {
      bundle.assign(1, first);
      for(Index s = before[first]; s != first; s = before[s])
        bundle.push_back(s);
      std::reverse(bundle.begin() + 1, bundle.end());
      order(bundle);
      for(std::size_t i = 0; i < bundle.size(); ++i)
        before[bundle[i]] = bundle[(i == 0 ? bundle.size() : i) - 1];
    }
    return before;
  }

private:
  // Stores a side and the greater of its vertices.
  struct Numbered_end
  {
    Index greater, side;
  };

  static void check_number(std::size_t number)
  {
    if(number >= (std::numeric_limits<Index>::max)())
      throw std::length_error("more faces than indices of halfedges allow");
  }

  static std::string name(std::size_t t) { return "face " + std::to_string(t); }

  template <typename Polygon>
  std::array<std::size_t, 3> three_of(const Polygon& polygon) const
  {
    std::array<std::size_t, 3> result{};
    std::size_t count = 0;
    for(const auto corner : polygon)
      result[count++ % 3] = static_cast<std::size_t>(corner);
    if(count != 3)
      throw Invalid_input(name(m_triangles.size()) + " is not a triangle");
    return result;
  }

  void add(const std::array<std::size_t, 3>& corners)
  {
    const std::size_t t = m_triangles.size();
    check_number(6 * (t + 1));
    for(std::size_t i = 0; i < 3; ++i) {
      if(corners[i] >= m_number_of_vertices)
        throw Invalid_input(name(t) + " names a vertex that does not exist");
      if(corners[i] == corners[(i + 1) % 3])
        throw Invalid_input(name(t) + " names the same vertex twice");
    }
    m_triangles.push_back({static_cast<Index>(corners[0]), static_cast<Index>(corners[1]),
                           static_cast<Index>(corners[2])});
  }

  // Calls visit(smaller, greater, side) for all sides and their vertices.
  template <typename Visit>
  void for_each_side(const Visit& visit) const
  {
    Index side = 0;
    for(const auto& [a, b, c] : m_triangles)
      for(const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        visit((std::min)(from, to), (std::max)(from, to), side++);
  }

  // Returns the sides in the order of their smaller vertices; the sides of vertex v begin at
  // first[v].
  std::vector<Numbered_end> sorted_by_smaller_vertex(std::vector<Index>& first) const
  {
    first.assign(m_number_of_vertices + 2, 0);
    for_each_side([&](Index smaller, Index, Index) { ++first[smaller + 2]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Numbered_end> result(number_of_sides());
    for_each_side([&](Index smaller, Index greater, Index side) {
      result[first[smaller + 1]++] = {greater, side};
    });
    return result;
  }

  // Links the sides of each edge in a ring, in the order of their indices. Returns the first side
  // of each edge that has more than two.
  Bundle link_in_rings(std::vector<Index>& before) const
  {
    struct Latest_edge // to a greater vertex
    {
      Index smaller, first_side;
    };
    std::vector<Index> begin;
    const std::vector<Numbered_end> sorted = sorted_by_smaller_vertex(begin);
    std::vector<Latest_edge> latest(m_number_of_vertices,
                                    {static_cast<Index>(m_number_of_vertices), 0});
    Bundle crowded;
    for(Index v = 0; v < m_number_of_vertices; ++v)
      for(Index i = begin[v]; i < begin[v + 1]; ++i) {
        const auto [greater, side] = sorted[i];
        Latest_edge& edge = latest[greater];
        if(edge.smaller != v) {
          edge = {v, side};
          before[side] = side;
        } else if(insert_last(side, edge.first_side, before) == 3)
          crowded.push_back(edge.first_side);
      }
    return crowded;
  }

  // Adds a side to the end of a ring. Returns the size of the ring, if it is less than four.
  static int insert_last(Index side, Index first, std::vector<Index>& before)
  {
    const Index last = std::exchange(before[first], side);
    before[side] = last;
    return last == first ? 2 : before[last] == first ? 3 : 4;
  }

  std::size_t m_number_of_vertices;
  std::vector<Triangle> m_triangles;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVERS_SOUP_SIDES_H
