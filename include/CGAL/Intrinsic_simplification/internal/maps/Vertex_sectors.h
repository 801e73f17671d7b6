// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_SECTORS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_SECTORS_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_operation.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Surface_patch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Intrinsic_simplification::internal {

// Represents the removal of a vertex, or its inverse, an insertion. The sectors m01, m12 and m20
// together are the face 012; at the boundary m20 is missing.
class Vertex_sectors
{
public:
  static constexpr std::size_t m = 3;

  Vertex_sectors(const Vertex_change& o)
    : m_is_border(o.is_border),
      m_is_insertion(o.is_insertion),
      m_vertex{o.weight[0], o.weight[1], (std::max)(1 - o.weight[0] - o.weight[1], 0.)},
      m_whole(o.whole),
      m_sector(o.corners)
  {}

  bool is_insertion() const { return m_is_insertion; }
  bool is_border() const { return m_is_border; }
  Patch_face whole() const { return Patch_face(m_whole, {0, 1, 2}); }
  Patch_face operator[](std::size_t n) const
  {
    return Patch_face(m_sector[n], {m, n, (n + 1) % 3});
  }

  // Returns the index of the sector with the face `f`.
  std::size_t sector_of(Face_index f) const
  {
    return f == m_sector[0].face() ? 0 : f == m_sector[1].face() ? 1 : 2;
  }

  // Expresses the vertex by the corners of the whole face.
  void merge(Patch_coordinates& x) const
  {
    for(std::size_t c = 0; c < 3; ++c)
      x[c] += x[m] * m_vertex[c];
    x[m] = 0;
  }

  // Replaces corners by the vertex as far as the coordinates of a point of the whole face permit.
  // One coordinate becomes zero, and the point is in the sector opposite to its corner. Returns the
  // index of the corner.
  std::size_t split(Patch_coordinates& x) const
  {
    const std::size_t used_up = corner_used_up(x);
    const double at_vertex = x[used_up] / m_vertex[used_up];
    for(std::size_t c = 0; c < 3; ++c)
      x[c] = c == used_up ? 0 : (std::max)(x[c] - at_vertex * m_vertex[c], 0.);
    x[m] = at_vertex;
    return used_up;
  }

  // Returns a point of a sector, seen from the whole face.
  Patch_point in_whole(Patch_point x) const
  {
    if((x.corners & bit(m)) == 0)
      return x;
    merge(x.weight);
    const bool is_on_border = m_is_border && (x.corners & bit(1)) == 0;
    x.corners = is_on_border ? border_side() : whole_face();
    return x;
  }

  // Stores a point seen from a sector. It is in the sectors from `first` to `last`, which may be
  // next to each other.
  struct Sector_point
  {
    Patch_point point;
    std::size_t first, last;

    bool is_in(std::size_t n) const { return n == first || n == last; }
  };

  // Returns a point of the whole face, seen from the sectors.
  Sector_point in_sectors(Patch_point x) const
  {
    if(x.corners == whole_face() || (m_is_border && x.corners == border_side())) {
      const std::size_t used_up = split(x.weight);
      x.corners = (x.corners & ~bit(used_up)) | bit(m);
      return {x, (used_up + 1) % 3, (used_up + 1) % 3};
    }
    if(!is_single(x.corners)) {
      const std::size_t n = (x.corners & bit(0)) == 0 ? 1 : (x.corners & bit(1)) == 0 ? 2 : 0;
      return {x, n, n};
    }
    const std::size_t c = x.corners == bit(0) ? 0 : x.corners == bit(1) ? 1 : 2;
    if(m_is_border && c != 1)
      return {x, c / 2, c / 2};
    return {x, (c + 2) % 3, c};
  }

  // Stores a point on the line through the vertex and corner `outgoing`, between two points of the
  // whole face.
  struct Line_point
  {
    Patch_point point; // of the edge from m to the corner
    double excess;     // negative beyond m; as a part of the coordinates
  };

  Line_point on_line(std::size_t outgoing, const Patch_point& x, const Patch_point& y) const
  {
    const std::size_t a = (outgoing + 1) % 3, c = (outgoing + 2) % 3;
    Patch_point result = between(x, y, distance(a, c, x), distance(a, c, y));
    auto& w = result.weight;
    const double sum = w[0] + w[1] + w[2];
    const std::size_t greater = m_vertex[a] > m_vertex[c] ? a : c;
    const double at_vertex = m_vertex[greater] > 0 ? w[greater] / m_vertex[greater] : 0;
    const double rest = w[outgoing] - at_vertex * m_vertex[outgoing];
    w[a] = w[c] = 0;
    w[outgoing] = (std::max)(rest, 0.);
    w[m] = at_vertex;
    result.corners = bit(m) | bit(outgoing);
    return {result, rest / sum};
  }

  // Returns whether a segment between two such points runs along the boundary.
  static bool is_on_border_side(const Patch_point& x, const Patch_point& y)
  {
    return is_subset(x.corners | y.corners, border_side());
  }

private:
  static constexpr Corner_set whole_face() { return bit(0) | bit(1) | bit(2); }
  static constexpr Corner_set border_side() { return bit(0) | bit(2); }

  // Returns the corner whose coordinate in a point is least, compared with the vertex. The point
  // and this corner are on opposite sides of the vertex.
  std::size_t corner_used_up(const Patch_coordinates& x) const
  {
    const Coordinates& w = m_vertex;
    auto used_up = static_cast<std::size_t>(std::max_element(w.begin(), w.end()) - w.begin());
    for(std::size_t c = 0; c < 3; ++c)
      if(w[c] > 0 && x[c] * w[used_up] < x[used_up] * w[c])
        used_up = c;
    return used_up;
  }

  double distance(std::size_t a, std::size_t c, const Patch_point& x) const
  {
    return std::abs(m_vertex[a] * x.weight[c] - m_vertex[c] * x.weight[a]);
  }

  bool m_is_border, m_is_insertion;
  Coordinates m_vertex; // in the whole face
  Face_corner m_whole;  // 0
  std::array<Face_corner, 3> m_sector;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_SECTORS_H
