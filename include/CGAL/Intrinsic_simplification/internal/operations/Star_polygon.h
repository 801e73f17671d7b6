// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_STAR_POLYGON_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_STAR_POLYGON_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Flattened_star.h>
#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_simplification/internal/operations/recorded_changes.h>
#include <CGAL/Intrinsic_simplification/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

typedef Intrinsic_triangulations::internal::Plane_vector<double> Plane_vector;

// Represents an edge from the center that is to be flipped.
struct Star_flip
{
  Halfedge_index halfedge;
  Flip_geometry geometry;
};

// Represents the flat star of a vertex without loops, laid out in the plane around the origin.
// Chooses the outgoing halfedges whose flips leave three. A flip cuts off an ear of the polygon.
class Star_polygon
{
public:
  // Lays out the star and chooses the flips. Returns whether possible flips exist. On thin faces,
  // rounding may have moved the center across cuts on which it lies.
  bool plan(const Flattened_star& star)
  {
    lay_out(star);
    return plan(star, rounding_unit()) || plan(star, star.angle_rounding());
  }

  const std::vector<Star_flip>& flips() const { return m_flips; }

  // Returns the barycentric coordinate of the center that belongs to one of the last three outgoing
  // halfedges.
  double weight(Halfedge_index outgoing) const
  {
    return m_weight[outgoing == m_last[0] ? 0 : outgoing == m_last[1] ? 1 : 2];
  }

private:
  struct Corner
  {
    Plane_vector point;
    Halfedge_index outgoing;
    std::size_t previous, next; // among the remaining corners
    double power;               // the ear of greatest power is cut off first
  };

  static constexpr double never() { return -std::numeric_limits<double>::infinity(); }

  // Chooses the flips, with this error of the angles at the center.
  bool plan(const Flattened_star& star, double angle_error)
  {
    m_angle_error = angle_error;
    join_all_corners(star);
    m_flips.clear();
    std::size_t rest = star.size();
    for(std::size_t n = 0; n < star.size(); ++n)
      rate(n);
    for(; rest > 3; --rest) {
      const std::size_t ear = best_ear();
      if(ear == m_corners.size())
        return false;
      cut(ear);
    }
    return set_last_three();
  }

  void lay_out(const Flattened_star& star)
  {
    m_corners.resize(star.size());
    m_is_border = star.is_border();
    Plane_vector direction{1, 0};
    for(std::size_t n = 0; n < star.size(); ++n) {
      const double length = star.flat_length(n);
      m_corners[n].point = {length * direction.x, length * direction.y};
      m_corners[n].outgoing = star[n].halfedge;
      if(n < star.number_of_corners())
        direction =
          turned(direction, length, star.flat_length(star.next(n)), star.flat_opposite_length(n));
    }
  }

  void join_all_corners(const Flattened_star& star)
  {
    for(std::size_t n = 0; n < star.size(); ++n) {
      m_corners[n].previous = n == 0 ? star.size() - 1 : n - 1;
      m_corners[n].next = star.next(n);
    }
    m_first = 0;
  }

  // Returns `p` after a rotation by the angle between the sides a and b.
  static Plane_vector turned(const Plane_vector& p, double a, double b, double opposite)
  {
    using namespace Intrinsic_triangulations;
    return p * Plane_vector{corner_cosine(opposite, a, b), corner_sine(opposite, a, b)};
  }

  // Rates an ear, which can be cut off if it is convex and does not contain the center. The center
  // may be on the cut. Ears are rated by the power of the center with respect to their
  // circumcircle. In a Delaunay star, the best ears are Delaunay.
  void rate(std::size_t n)
  {
    Corner& corner = m_corners[n];
    corner.power = never();
    if(m_is_border && (n == 0 || n + 1 == m_corners.size()))
      return;
    const Plane_vector &l = m_corners[corner.previous].point, &j = corner.point;
    const Plane_vector& k = m_corners[corner.next].point;
    const double area = cross(j - l, k - j);
    const double inside = cross(l, k);
    const double unit = std::sqrt(norm(l) * norm(k));
    if(area > rounding_unit() * unit && inside >= -m_angle_error * unit)
      corner.power = -incircle(l, j, k) / area;
  }

  // Returns a positive number if the origin is inside the circle.
  static double incircle(const Plane_vector& a, const Plane_vector& b, const Plane_vector& c)
  {
    return norm(a) * cross(b, c) + norm(b) * cross(c, a) + norm(c) * cross(a, b);
  }

  std::size_t best_ear() const
  {
    std::size_t best = m_corners.size(), n = m_first;
    do {
      if(m_corners[n].power > (best == m_corners.size() ? never() : m_corners[best].power))
        best = n;
      n = m_corners[n].next;
    } while(n != m_first);
    return best;
  }

  void cut(std::size_t n)
  {
    const std::size_t l = m_corners[n].previous, k = m_corners[n].next;
    m_flips.push_back(flip(m_corners[n], m_corners[l].point, m_corners[k].point));
    m_corners[l].next = k;
    m_corners[k].previous = l;
    m_first = l;
    rate(l);
    rate(k);
  }

  // Returns the flip of the outgoing halfedge to j, between the outgoing halfedges to l and k.
  static Star_flip flip(const Corner& j, const Plane_vector& l, const Plane_vector& k)
  {
    const double at_l = cross(l, j.point), at_k = cross(j.point, k);
    const double both = at_l + at_k;
    return {j.outgoing,
            {std::sqrt(norm(k - l)), std::clamp(cross(l, k) / both, 0., 1.),
             std::clamp(at_l / both, 0., 1.)}};
  }

  // Returns false if the center is not between the last three outgoing halfedges.
  bool set_last_three()
  {
    const std::size_t a = m_is_border ? 0 : m_first, b = m_corners[a].next, c = m_corners[b].next;
    const Plane_vector &p = m_corners[a].point, &q = m_corners[b].point, &r = m_corners[c].point;
    m_last = {m_corners[a].outgoing, m_corners[b].outgoing, m_corners[c].outgoing};
    const std::array<double, 3> area{cross(q, r), m_is_border ? 0 : cross(r, p), cross(p, q)};
    const std::array<double, 3> unit{norm(q) * norm(r), norm(r) * norm(p), norm(p) * norm(q)};
    const double sum = area[0] + area[1] + area[2];
    for(std::size_t n = 0; n < 3; ++n) {
      if(!(area[n] >= -m_angle_error * std::sqrt(unit[n])))
        return false;
      m_weight[n] = (std::max)(area[n], 0.) / sum;
    }
    return sum > 0;
  }

  std::vector<Corner> m_corners;
  std::vector<Star_flip> m_flips;
  std::array<Halfedge_index, 3> m_last;
  std::array<double, 3> m_weight;
  std::size_t m_first = 0;
  double m_angle_error = 0; // at the center
  bool m_is_border = false;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_STAR_POLYGON_H
