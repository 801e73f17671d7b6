// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SURFACE_PATCH_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SURFACE_PATCH_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_history.h>
#include <CGAL/Intrinsic_simplification/internal/maps/carry_point.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Intrinsic_simplification {
namespace internal {

// Corners of a face or patch, as bits.
typedef unsigned int Corner_set;

constexpr Corner_set bit(std::size_t corner) { return 1u << corner; }

inline bool is_subset(Corner_set part, Corner_set whole) { return (part & ~whole) == 0; }

// whether there is one corner
inline bool is_single(Corner_set corners) { return (corners & (corners - 1)) == 0; }

// whether there are two
inline bool is_pair(Corner_set corners)
{
  return !is_single(corners) && is_single(corners & (corners - 1));
}

// A point of a curve or polygon, seen from a face of `n` corners with homogeneous coordinates. It
// is at a corner, on a side or inside, as the set of its corners says: this is never left to
// rounding.
template <std::size_t n>
struct Curve_point
{
  std::array<double, n> weight;
  Corner_set corners;
  std::array<double, 3>
    along; // the homogeneous coordinates on the edge that is traced, or in the face that is cut
  std::size_t node; // the number of the point
};

// The part of a coordinate that may be due to rounding where a point comes to a vertex or an edge.
inline double rounding() { return 16 * Intrinsic_triangulations::rounding_unit<double>(); }

// The faces that an operation changes, before or after it, have four corners in all.
typedef Curve_point<3> Face_point;
typedef Curve_point<4> Patch_point;

// A face of a patch, and its corners in the order of its coordinates.
struct Patch_face
{
  Patch_face(Face_index f, std::size_t base, const std::array<std::size_t, 3>& corners) : face(f)
  {
    for(std::size_t c = 0; c < 3; ++c)
      corner[(base + c) % 3] = corners[c];
  }

  Corner_set corners() const { return bit(corner[0]) | bit(corner[1]) | bit(corner[2]); }

  Patch_point in_patch(const Face_point& p) const
  {
    Patch_point result{{}, 0, p.along, p.node};
    for(std::size_t c = 0; c < 3; ++c) {
      result.weight[corner[c]] = p.weight[c];
      if(p.corners & bit(c))
        result.corners |= bit(corner[c]);
    }
    return result;
  }

  Face_point in_face(const Patch_point& p) const
  {
    Face_point result{{}, 0, p.along, p.node};
    for(std::size_t c = 0; c < 3; ++c) {
      result.weight[c] = p.weight[corner[c]];
      if(p.corners & bit(corner[c]))
        result.corners |= bit(c);
    }
    return result;
  }

  Face_index face;
  std::array<std::size_t, 3> corner;
};

// the point between p and q where a linear function vanishes that has these absolute values at p
// and q
inline Patch_point between(const Patch_point& p, const Patch_point& q, double at_p, double at_q)
{
  const double sum = at_p + at_q;
  const double a = sum > 0 ? at_q / sum : 0.5, b = sum > 0 ? at_p / sum : 0.5;
  Patch_point result{};
  for(std::size_t c = 0; c < 4; ++c)
    result.weight[c] = a * p.weight[c] + b * q.weight[c];
  for(std::size_t c = 0; c < 3; ++c)
    result.along[c] = a * p.along[c] + b * q.along[c];
  return result;
}

// A flip or the inverse of one: the faces pqr and qpo become orp and roq.
class Turned_edge
{
public:
  enum Corner : std::size_t
  {
    p,
    q,
    o,
    r
  };

  Turned_edge(const Surface_operation& flip, bool forward)
    : m_before{forward ? left(flip, {p, q, r}) : first(flip, {p, q, r}),
               forward ? right(flip, {q, p, o}) : second(flip, {q, p, o})},
      m_after{forward ? first(flip, {o, r, p}) : right(flip, {o, r, p}),
              forward ? second(flip, {r, o, q}) : left(flip, {r, o, q})}
  {
    const auto& [s, t] = flip.x;
    m_weight = forward ? std::array<double, 4>{1 - s, s, 1 - t, t}
                       : std::array<double, 4>{1 - t, t, s, 1 - s};
  }

  const Patch_face& before(std::size_t n) const { return m_before[n]; }
  const Patch_face& after(std::size_t n) const { return m_after[n]; }

  // 1 if a point belongs to the face with p, -1 for that with q, 0 for both
  int side(const Patch_point& x) const
  {
    if(is_on_or_in_diamond(x))
      return x.weight[p] * m_weight[q] > x.weight[q] * m_weight[p] ? 1 : -1;
    return (x.corners & bit(p)) ? 1 : (x.corners & bit(q)) ? -1 : 0;
  }

  // the point seen from the faces after the turn
  Patch_point turned(Patch_point x) const
  {
    if(!is_on_or_in_diamond(x))
      return x;
    const bool has_p = side(x) > 0;
    x = changed(x, has_p);
    x.weight[has_p ? p : q] = (std::max)(x.weight[has_p ? p : q], 0.);
    return x;
  }

  // the coordinates for the face with p or for that with q, of which one may be negative
  Patch_point changed(Patch_point x, bool has_p) const
  {
    const Corner left_over = has_p ? p : q, used_up = has_p ? q : p;
    const double all = m_weight[used_up] > 0 ? x.weight[used_up] / m_weight[used_up] : 0;
    x.weight[left_over] -= all * m_weight[left_over];
    x.weight[used_up] = 0;
    add_crossing(all, x);
    x.corners = m_after[has_p ? 0 : 1].corners();
    return x;
  }

  // whether the point is on the edge or within rounding
  bool is_near_diagonal(const Patch_point& x) const
  {
    const double sum = x.weight[p] + x.weight[q] + x.weight[o] + x.weight[r];
    return is_on_or_in_diamond(x) && distance(x) <= rounding() * sum;
  }

  // where the segment from x to y, seen from before the turn, crosses the edge or
  Patch_point crossing(const Patch_point& x, const Patch_point& y) const
  {
    Patch_point result = between(x, y, distance(x), distance(y));
    const double all = result.weight[p] + result.weight[q];
    result.weight[p] = result.weight[q] = 0;
    add_crossing(all, result);
    result.corners = bit(o) | bit(r);
    return result;
  }

private:
  typedef std::array<std::size_t, 3> Corners;

  static Patch_face left(const Surface_operation& f, const Corners& corners)
  {
    return Patch_face(Face_index(f.id[1]), f.corner[0], corners);
  }
  static Patch_face right(const Surface_operation& f, const Corners& corners)
  {
    return Patch_face(Face_index(f.id[2]), f.corner[1], corners);
  }
  static Patch_face first(const Surface_operation& f, const Corners& corners)
  {
    return Patch_face(Face_index(f.id[1]), 0, corners);
  }
  static Patch_face second(const Surface_operation& f, const Corners& corners)
  {
    return Patch_face(Face_index(f.id[2]), 0, corners);
  }

  // points on pq, and those inside of the faces, have to be compared with the other diagonal
  static bool is_on_or_in_diamond(const Patch_point& x)
  {
    return is_subset(bit(p) | bit(q), x.corners);
  }

  double distance(const Patch_point& x) const
  {
    return std::abs(x.weight[p] * m_weight[q] - x.weight[q] * m_weight[p]);
  }

  void add_crossing(double amount, Patch_point& x) const
  {
    x.weight[o] += amount * m_weight[o];
    x.weight[r] += amount * m_weight[r];
  }

  std::array<Patch_face, 2> m_before, m_after;
  std::array<double, 4> m_weight; // of p and q, and of o and r, where the diagonals cross
};

// The removal of a vertex or its inverse: the sectors m01, m12 and m20, of which m20 is missing at
// the boundary, are the face 012.
class Vertex_sectors
{
public:
  static constexpr std::size_t m = 3;

  explicit Vertex_sectors(const Surface_operation& removal)
    : m_is_border(removal.kind == Surface_operation::Kind::border_removal),
      m_weight(removed_vertex(removal)),
      m_whole(Face_index(removal.id[0]), place_of_first(removal), {0, 1, 2}),
      m_sector{sector(removal, 0), sector(removal, 1), sector(removal, 2)}
  {}

  bool is_border() const { return m_is_border; }
  const Patch_face& whole() const { return m_whole; }
  const Patch_face& operator[](std::size_t n) const { return m_sector[n]; }

  // the number of the sector that has the face `f`
  std::size_t sector_of(Face_index f) const
  {
    return f == m_sector[0].face ? 0 : f == m_sector[1].face ? 1 : 2;
  }

  // a point of a sector seen from the whole face
  Patch_point in_whole(Patch_point x) const
  {
    if((x.corners & bit(m)) == 0)
      return x;
    for(std::size_t c = 0; c < 3; ++c)
      x.weight[c] += x.weight[m] * m_weight[c];
    x.weight[m] = 0;
    const bool is_on_border = m_is_border && (x.corners & bit(1)) == 0;
    x.corners = is_on_border ? border_side() : whole_face();
    return x;
  }

  // A point seen from a sector. It is in the sectors from `first` to `last`, which may be next to
  // each other.
  struct Sector_point
  {
    Patch_point point;
    std::size_t first, last;

    bool is_in(std::size_t n) const { return n == first || n == last; }
  };

  // a point of the whole face seen from the sectors
  Sector_point in_sectors(const Patch_point& x) const
  {
    if(x.corners == whole_face() || (m_is_border && x.corners == border_side()))
      return compared(x);
    if(!is_single(x.corners)) {
      const std::size_t n = (x.corners & bit(0)) == 0 ? 1 : (x.corners & bit(1)) == 0 ? 2 : 0;
      return {x, n, n};
    }
    const std::size_t c = x.corners == bit(0) ? 0 : x.corners == bit(1) ? 1 : 2;
    if(m_is_border && c != 1)
      return {x, c / 2, c / 2};
    return {x, (c + 2) % 3, c};
  }

  // A point on the line through the vertex and corner `spoke`, between two points of the whole
  // face.
  struct Line_point
  {
    Patch_point point; // of the edge from m to the corner
    double excess;     // negative beyond m; as a part of the coordinates
  };

  Line_point on_line(std::size_t spoke, const Patch_point& x, const Patch_point& y) const
  {
    const std::size_t a = (spoke + 1) % 3, c = (spoke + 2) % 3;
    Patch_point result = between(x, y, distance(a, c, x), distance(a, c, y));
    auto& w = result.weight;
    const double sum = w[0] + w[1] + w[2];
    const std::size_t greater = m_weight[a] > m_weight[c] ? a : c;
    const double at_vertex = m_weight[greater] > 0 ? w[greater] / m_weight[greater] : 0;
    const double rest = w[spoke] - at_vertex * m_weight[spoke];
    w[a] = w[c] = 0;
    w[spoke] = (std::max)(rest, 0.);
    w[m] = at_vertex;
    result.corners = bit(m) | bit(spoke);
    return {result, rest / sum};
  }

  // whether a segment between two such points runs along the boundary
  static bool is_on_border_side(const Patch_point& x, const Patch_point& y)
  {
    return is_subset(x.corners | y.corners, border_side());
  }

private:
  static constexpr Corner_set whole_face() { return bit(0) | bit(1) | bit(2); }
  static constexpr Corner_set border_side() { return bit(0) | bit(2); }

  static Patch_face sector(const Surface_operation& removal, std::size_t n)
  {
    return Patch_face(Face_index(removal.id[n]), removal.corner[n], {m, n, (n + 1) % 3});
  }

  Sector_point compared(Patch_point x) const
  {
    const std::size_t used_up = corner_used_up(m_weight, {x.weight[0], x.weight[1], x.weight[2]});
    const double at_vertex = x.weight[used_up] / m_weight[used_up];
    for(std::size_t c = 0; c < 3; ++c)
      x.weight[c] = c == used_up ? 0 : (std::max)(x.weight[c] - at_vertex * m_weight[c], 0.);
    x.weight[m] = at_vertex;
    x.corners = (x.corners & ~bit(used_up)) | bit(m);
    return {x, (used_up + 1) % 3, (used_up + 1) % 3};
  }

  double distance(std::size_t a, std::size_t c, const Patch_point& x) const
  {
    return std::abs(m_weight[a] * x.weight[c] - m_weight[c] * x.weight[a]);
  }

  bool m_is_border;
  Coordinates m_weight; // of the vertex
  Patch_face m_whole;
  std::array<Patch_face, 3> m_sector;
};

} // namespace internal
} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SURFACE_PATCH_H
