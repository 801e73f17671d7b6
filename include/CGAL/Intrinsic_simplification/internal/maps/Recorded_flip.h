// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_RECORDED_FLIP_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_RECORDED_FLIP_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_operation.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Surface_patch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Intrinsic_simplification::internal {

// Represents a flip or its inverse: the faces pqr and qpo become orp and roq.
class Recorded_flip
{
public:
  enum Corner : std::size_t
  {
    p,
    q,
    o,
    r
  };

  Recorded_flip(const Flip& flip, bool forward)
  {
    const auto& [left, right] = flip.corners;
    const Face_corner first(left.face(), 0), second(right.face(), 0);
    const double s = flip.crossing_before, t = flip.crossing_after;
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
  bool is_beside_p(const Patch_coordinates& x) const
  {
    return x[p] * m_crossing[q] > x[q] * m_crossing[p];
  }

  // Changes the coordinates for the face with p or for the face with q; one of the two may be
  // negative. Replaces p and q by the crossing as far as possible, and the crossing by o and r.
  void change(Patch_coordinates& x, bool has_p) const
  {
    const Corner left_over = has_p ? p : q, used_up = has_p ? q : p;
    const double all = m_crossing[used_up] > 0 ? x[used_up] / m_crossing[used_up] : 0;
    x[left_over] -= all * m_crossing[left_over];
    x[used_up] = 0;
    add_crossing(all, x);
  }

  // Changes the coordinates of a point of one of these faces, which are nonnegative.
  void change_inside(Patch_coordinates& x, bool has_p) const
  {
    change(x, has_p);
    x[has_p ? p : q] = (std::max)(x[has_p ? p : q], 0.);
  }

  // Returns 1 if a point belongs to the face with p, -1 if it belongs to the face with q, and 0 for
  // both.
  int side(const Patch_point& x) const
  {
    if(is_on_or_in_diamond(x))
      return is_beside_p(x.weight) ? 1 : -1;
    return (x.corners & bit(p)) ? 1 : (x.corners & bit(q)) ? -1 : 0;
  }

  // Returns the point in the faces after the flip.
  Patch_point turned(Patch_point x) const
  {
    if(is_on_or_in_diamond(x)) {
      const bool has_p = is_beside_p(x.weight);
      change_inside(x.weight, has_p);
      x.corners = after(has_p).corners();
    }
    return x;
  }

  // Returns whether the point is on the edge up to rounding.
  bool is_near_diagonal(const Patch_point& x) const
  {
    const double sum = x.weight[p] + x.weight[q] + x.weight[o] + x.weight[r];
    return is_on_or_in_diamond(x) && distance(x) <= rounding() * sum;
  }

  // Returns the point where the segment from x to y, seen from before the flip, crosses the edge
  // or.
  Patch_point crossing(const Patch_point& x, const Patch_point& y) const
  {
    Patch_point result = between(x, y, distance(x), distance(y));
    const double all = result.weight[p] + result.weight[q];
    result.weight[p] = result.weight[q] = 0;
    add_crossing(all, result.weight);
    result.corners = bit(o) | bit(r);
    return result;
  }

private:
  // Points on pq, and points inside of the faces, must be compared with the other diagonal.
  static bool is_on_or_in_diamond(const Patch_point& x)
  {
    return is_subset(bit(p) | bit(q), x.corners);
  }

  double distance(const Patch_point& x) const
  {
    return std::abs(x.weight[p] * m_crossing[q] - x.weight[q] * m_crossing[p]);
  }

  void add_crossing(double amount, Patch_coordinates& x) const
  {
    x[o] += amount * m_crossing[o];
    x[r] += amount * m_crossing[r];
  }

  std::array<Face_corner, 2> m_before, m_after; // at p and q, and at o and r
  Patch_coordinates m_crossing;                 // of p and q, and of o and r
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_RECORDED_FLIP_H
