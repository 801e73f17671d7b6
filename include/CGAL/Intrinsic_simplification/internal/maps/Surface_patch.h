// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SURFACE_PATCH_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SURFACE_PATCH_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_operation.h>
#include <CGAL/Intrinsic_simplification/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Intrinsic_simplification::internal {

// The faces that an operation changes, before and after it, are a patch with four corners. An
// operation is linear in homogeneous coordinates of the patch. A point has only coordinates. A
// point of a curve or polygon also stores its edge or corner combinatorially.

typedef std::array<double, 3> Coordinates;       // in a face
typedef std::array<double, 4> Patch_coordinates; // in a patch
typedef Intrinsic_triangulations::Face_location<double> Location;

inline void normalize(Coordinates& b)
{
  const double sum = b[0] + b[1] + b[2];
  for(double& x : b)
    x /= sum;
}

// Stores corners of a face or patch, as bits.
typedef unsigned int Corner_set;

constexpr Corner_set bit(std::size_t corner) { return 1u << corner; }

inline bool is_subset(Corner_set part, Corner_set whole) { return (part & ~whole) == 0; }

inline bool is_single(Corner_set corners) { return (corners & (corners - 1)) == 0; }

inline bool is_pair(Corner_set corners)
{
  return !is_single(corners) && is_single(corners & (corners - 1));
}

// Represents a point of a curve or polygon, seen from a face of `n` corners with homogeneous
// coordinates. The set of its corners determines whether it is at a corner, on a side or inside.
// Rounding never does.
template <std::size_t n, typename FT = double>
struct Curve_point
{
  std::array<FT, n> weight;
  Corner_set corners;
  std::array<FT, 3> along; // on the edge that is traced, or in the face that is cut; homogeneous
  std::size_t node;        // the index of the point
};

typedef Curve_point<3> Face_point;
typedef Curve_point<4> Patch_point;

// Represents a face of a patch.
struct Patch_face
{
  Face_index face;
  std::size_t base; // the index of the first of the corners in the face
  std::array<std::size_t, 3> corner;

  Patch_face(const Face_corner& first, const std::array<std::size_t, 3>& corners)
    : face(first.face()), base(first.index()), corner(corners)
  {}

  std::size_t in_face(std::size_t n) const { return (base + n) % 3; }

  Corner_set corners() const { return bit(corner[0]) | bit(corner[1]) | bit(corner[2]); }

  template <typename FT>
  std::array<FT, 4> in_patch(const std::array<FT, 3>& b) const
  {
    std::array<FT, 4> result{};
    for(std::size_t n = 0; n < 3; ++n)
      result[corner[n]] = b[in_face(n)];
    return result;
  }

  template <typename FT>
  std::array<FT, 3> in_face(const std::array<FT, 4>& x) const
  {
    std::array<FT, 3> result{};
    for(std::size_t n = 0; n < 3; ++n)
      result[in_face(n)] = x[corner[n]];
    return result;
  }

  template <typename FT>
  Curve_point<4, FT> in_patch(const Curve_point<3, FT>& p) const
  {
    Curve_point<4, FT> result{in_patch(p.weight), 0, p.along, p.node};
    for(std::size_t n = 0; n < 3; ++n)
      if(p.corners & bit(in_face(n)))
        result.corners |= bit(corner[n]);
    return result;
  }

  template <typename FT>
  Curve_point<3, FT> in_face(const Curve_point<4, FT>& p) const
  {
    Curve_point<3, FT> result{in_face(p.weight), 0, p.along, p.node};
    for(std::size_t n = 0; n < 3; ++n)
      if(p.corners & bit(corner[n]))
        result.corners |= bit(in_face(n));
    return result;
  }
};

// Returns the zero of a linear function between p and q, given the absolute values of the function
// at p and q.
template <typename FT>
Curve_point<4, FT> between(const Curve_point<4, FT>& p, const Curve_point<4, FT>& q, const FT& at_p,
                           const FT& at_q)
{
  const FT sum = at_p + at_q;
  const FT a = sum > 0 ? FT(at_q / sum) : FT(0.5), b = sum > 0 ? FT(at_p / sum) : FT(0.5);
  Curve_point<4, FT> result{};
  for(std::size_t c = 0; c < 4; ++c)
    result.weight[c] = a * p.weight[c] + b * q.weight[c];
  for(std::size_t c = 0; c < 3; ++c)
    result.along[c] = a * p.along[c] + b * q.along[c];
  return result;
}

// Returns a part of an edge or face, from 0 to 1. If rounding has made it or the rest zero, that
// becomes `least`.
inline double proper_part(double part, double least)
{
  return part > 0 ? (part < 1 ? part : 1 - least) : least;
}

// Represents a flip or its inverse: the faces pqr and qpo become orp and roq.
// The points have coordinates of type `FT`.
template <typename FT = double>
class Recorded_flip
{
  typedef std::array<FT, 4> Coordinates;
  typedef Curve_point<4, FT> Point;

public:
  enum Corner : std::size_t
  {
    p,
    q,
    o,
    r
  };

  Recorded_flip(const Flip& flip, bool forward, double least_part = 0)
  {
    const auto& [left, right] = flip.corners;
    const Face_corner first(left.face(), 0), second(right.face(), 0);
    const FT s = proper_part(flip.crossing_before, least_part),
             t = proper_part(flip.crossing_after, least_part);
    if(forward) {
      m_before = {left, right};
      m_after = {first, second};
      m_crossing = {1 - s, s, 1 - t, t};
    } else {
      m_before = {first, second};
      m_after = {right, left};
      m_crossing = {1 - t, t, s, 1 - s};
    }
  }

  // Returns whether `f` is the face with r before the flip.
  bool has_r(Face_index f) const { return f == m_before[0].face(); }

  // Returns the face with r or the face with o, before the flip.
  Patch_face before(bool has_r) const
  {
    return has_r ? Patch_face(m_before[0], {p, q, r}) : Patch_face(m_before[1], {q, p, o});
  }

  // Returns the face with p or the face with q, after the flip.
  Patch_face after(bool has_p) const
  {
    return has_p ? Patch_face(m_after[0], {o, r, p}) : Patch_face(m_after[1], {r, o, q});
  }

  // Returns whether a point of the faces before the flip belongs to the face with p after it.
  bool is_beside_p(const Coordinates& x) const
  {
    return x[p] * m_crossing[q] > x[q] * m_crossing[p];
  }

  // Changes the coordinates for the face with p or for the face with q; one of the two may be
  // negative. Replaces p and q by the crossing as far as possible, and the crossing by o and r.
  void change(Coordinates& x, bool has_p) const
  {
    const Corner left_over = has_p ? p : q, used_up = has_p ? q : p;
    const FT all = m_crossing[used_up] > 0 ? FT(x[used_up] / m_crossing[used_up]) : FT(0);
    x[left_over] -= all * m_crossing[left_over];
    x[used_up] = 0;
    add_crossing(all, x);
  }

  // Changes the coordinates of a point of one of these faces, which are nonnegative.
  void change_inside(Coordinates& x, bool has_p) const
  {
    change(x, has_p);
    x[has_p ? p : q] = (std::max)(x[has_p ? p : q], FT(0));
  }

  // Returns 1 if a point belongs to the face with p, -1 if it belongs to the face with q, and 0 for
  // both.
  int side(const Point& x) const
  {
    if(is_on_or_in_diamond(x))
      return is_beside_p(x.weight) ? 1 : -1;
    return (x.corners & bit(p)) ? 1 : (x.corners & bit(q)) ? -1 : 0;
  }

  // Returns the point in the faces after the flip.
  Point turned(Point x) const
  {
    if(is_on_or_in_diamond(x)) {
      const bool has_p = is_beside_p(x.weight);
      change_inside(x.weight, has_p);
      x.corners = after(has_p).corners();
    }
    return x;
  }

  // Returns whether the point is on the edge up to rounding.
  bool is_near_diagonal(const Point& x) const
  {
    const FT sum = x.weight[p] + x.weight[q] + x.weight[o] + x.weight[r];
    return is_on_or_in_diamond(x) && distance(x) <= rounding<FT>() * sum;
  }

  // Returns the point where the segment from x to y, seen from before the flip, crosses the edge
  // or.
  Point crossing(const Point& x, const Point& y) const
  {
    Point result = between(x, y, distance(x), distance(y));
    const FT all = result.weight[p] + result.weight[q];
    result.weight[p] = result.weight[q] = 0;
    add_crossing(all, result.weight);
    result.corners = bit(o) | bit(r);
    return result;
  }

private:
  // Points on pq, and points inside of the faces, must be compared with the other diagonal.
  static bool is_on_or_in_diamond(const Point& x) { return is_subset(bit(p) | bit(q), x.corners); }

  FT distance(const Point& x) const
  {
    using std::abs;
    return abs(FT(x.weight[p] * m_crossing[q] - x.weight[q] * m_crossing[p]));
  }

  void add_crossing(const FT& amount, Coordinates& x) const
  {
    x[o] += amount * m_crossing[o];
    x[r] += amount * m_crossing[r];
  }

  std::array<Face_corner, 2> m_before, m_after; // at p and q, and at o and r
  Coordinates m_crossing;                       // of p and q, and of o and r
};

// Represents the removal of a vertex, or its inverse, an insertion. The sectors m01, m12 and m20
// together are the face 012; at the boundary m20 is missing.
// The points have coordinates of type `FT`.
template <typename FT = double>
class Vertex_sectors
{
  typedef std::array<FT, 4> Coordinates;

public:
  typedef Curve_point<4, FT> Point;
  static constexpr std::size_t m = 3;

  Vertex_sectors(const Vertex_change& o, double least_part = 0)
    : m_is_border(o.is_border),
      m_is_insertion(o.is_insertion),
      m_vertex{proper_part(o.weight[0], least_part),
               o.is_border ? 0 : proper_part(o.weight[1], least_part),
               proper_part(1 - o.weight[0] - o.weight[1], least_part)},
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

  std::size_t sector_of(Face_index f) const
  {
    return f == m_sector[0].face() ? 0 : f == m_sector[1].face() ? 1 : 2;
  }

  // Expresses the vertex by the corners of the whole face.
  void merge(Coordinates& x) const
  {
    for(std::size_t c = 0; c < 3; ++c)
      x[c] += x[m] * m_vertex[c];
    x[m] = 0;
  }

  // Replaces corners by the vertex as far as the coordinates of a point of the whole face permit.
  // One coordinate becomes zero, and the point is in the sector opposite to its corner. Returns the
  // index of the corner.
  std::size_t split(Coordinates& x) const
  {
    const std::size_t used_up = corner_used_up(x);
    const FT at_vertex = x[used_up] / m_vertex[used_up];
    for(std::size_t c = 0; c < 3; ++c)
      x[c] = c == used_up ? FT(0) : (std::max)(FT(x[c] - at_vertex * m_vertex[c]), FT(0));
    x[m] = at_vertex;
    return used_up;
  }

  // Returns a point of a sector, seen from the whole face.
  Point in_whole(Point x) const
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
    Point point;
    std::size_t first, last;

    bool is_in(std::size_t n) const { return n == first || n == last; }
  };

  // Returns a point of the whole face, seen from the sectors.
  Sector_point in_sectors(Point x) const
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
    Point point; // of the edge from m to the corner
    FT excess;   // negative beyond m; as a part of the coordinates
  };

  Line_point on_line(std::size_t outgoing, const Point& x, const Point& y) const
  {
    const std::size_t a = (outgoing + 1) % 3, c = (outgoing + 2) % 3;
    Point result = between(x, y, distance(a, c, x), distance(a, c, y));
    auto& w = result.weight;
    const FT sum = w[0] + w[1] + w[2];
    const std::size_t greater = m_vertex[a] > m_vertex[c] ? a : c;
    const FT at_vertex = m_vertex[greater] > 0 ? FT(w[greater] / m_vertex[greater]) : FT(0);
    const FT rest = w[outgoing] - at_vertex * m_vertex[outgoing];
    w[a] = w[c] = FT(0);
    w[outgoing] = (std::max)(rest, FT(0));
    w[m] = at_vertex;
    result.corners = bit(m) | bit(outgoing);
    return {result, FT(rest / sum)};
  }

  // Returns whether a segment between two such points runs along the boundary.
  static bool is_on_border_side(const Point& x, const Point& y)
  {
    return is_subset(x.corners | y.corners, border_side());
  }

private:
  static constexpr Corner_set whole_face() { return bit(0) | bit(1) | bit(2); }
  static constexpr Corner_set border_side() { return bit(0) | bit(2); }

  // Returns the corner whose coordinate in a point is least, compared with the vertex. The point
  // and this corner are on opposite sides of the vertex.
  std::size_t corner_used_up(const Coordinates& x) const
  {
    const std::array<FT, 3>& w = m_vertex;
    auto used_up = static_cast<std::size_t>(std::max_element(w.begin(), w.end()) - w.begin());
    for(std::size_t c = 0; c < 3; ++c)
      if(w[c] > 0 && x[c] * w[used_up] < x[used_up] * w[c])
        used_up = c;
    return used_up;
  }

  FT distance(std::size_t a, std::size_t c, const Point& x) const
  {
    using std::abs;
    return abs(FT(m_vertex[a] * x.weight[c] - m_vertex[c] * x.weight[a]));
  }

  bool m_is_border, m_is_insertion;
  std::array<FT, 3> m_vertex; // in the whole face
  Face_corner m_whole;        // 0
  std::array<Face_corner, 3> m_sector;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SURFACE_PATCH_H
