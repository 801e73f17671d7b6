// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVERS_SOUP_SIDES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVERS_SOUP_SIDES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The sides of a soup of triangles: side 3 t + i leads from corner i of triangle t to the next.
class Soup_sides
{
public:
  typedef Delta_complex::size_type Index;
  typedef std::array<Index, 3> Triangle;
  typedef std::vector<Index> Bundle; // the sides of an edge

  template <typename Triangles>
  Soup_sides(std::size_t number_of_vertices, const Triangles& triangles)
  {
    for(const auto& corners : triangles)
      add(three_of(corners), number_of_vertices);
    sort(number_of_vertices);
  }

  std::size_t number_of_triangles() const { return m_triangles.size(); }
  std::size_t number_of_sides() const { return 3 * m_triangles.size(); }

  Index corner(std::size_t triangle, std::size_t i) const { return m_triangles[triangle][i]; }
  Index source(std::size_t side) const { return corner(side / 3, side % 3); }
  Index target(std::size_t side) const { return corner(side / 3, (side + 1) % 3); }
  Index apex(std::size_t side) const { return corner(side / 3, (side + 2) % 3); }
  bool ascends(std::size_t side) const { return source(side) < target(side); }

  // Calls visit(bundle) for the sides of each edge, in the order of their numbers.
  template <typename Visit>
  void for_each_edge(const Visit& visit) const
  {
    Bundle bundle;
    for(std::size_t i = 0; i < m_sorted.size(); ++i) {
      bundle.push_back(m_sorted[i].second);
      if(i + 1 < m_sorted.size() && ends(m_sorted[i]) == ends(m_sorted[i + 1]))
        continue;
      visit(bundle);
      bundle.clear();
    }
  }

private:
  typedef std::pair<Index, Index> Numbered_end; // the greater vertex and the side

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

  void add(const std::array<std::size_t, 3>& corners, std::size_t number_of_vertices)
  {
    const std::size_t t = m_triangles.size();
    if(6 * (t + 1) >= (std::numeric_limits<Index>::max)() ||
       number_of_vertices >= (std::numeric_limits<Index>::max)())
      throw std::length_error("too many faces for the numbers of halfedges");
    for(std::size_t i = 0; i < 3; ++i) {
      if(corners[i] >= number_of_vertices)
        throw Invalid_input(name(t) + " names a vertex that does not exist");
      if(corners[i] == corners[(i + 1) % 3])
        throw Invalid_input(name(t) + " names the same vertex twice");
    }
    m_triangles.push_back({static_cast<Index>(corners[0]), static_cast<Index>(corners[1]),
                           static_cast<Index>(corners[2])});
  }

  std::pair<Index, Index> ends(const Numbered_end& side) const
  {
    return {(std::min)(source(side.second), target(side.second)), side.first};
  }

  // By the smaller vertex in linear time, then by the greater one.
  void sort(std::size_t number_of_vertices)
  {
    std::vector<Index> first(number_of_vertices + 2, 0);
    for(std::size_t s = 0; s < number_of_sides(); ++s)
      ++first[(std::min)(source(s), target(s)) + 2];
    for(std::size_t v = 2; v < first.size(); ++v)
      first[v] += first[v - 1];
    m_sorted.resize(number_of_sides());
    for(Index s = 0; s < number_of_sides(); ++s)
      m_sorted[first[(std::min)(source(s), target(s)) + 1]++] = {(std::max)(source(s), target(s)),
                                                                 s};
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      std::sort(m_sorted.begin() + first[v], m_sorted.begin() + first[v + 1]);
  }

  std::vector<Triangle> m_triangles;
  std::vector<Numbered_end> m_sorted;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVERS_SOUP_SIDES_H
