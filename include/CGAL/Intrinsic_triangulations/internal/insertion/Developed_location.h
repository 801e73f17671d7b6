// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DEVELOPED_LOCATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DEVELOPED_LOCATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Development.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/face_splits.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Lays out a point of a face ijk of T2 in the plane, with i at the origin. The edges of T1 that
// cross ij and ik are laid out along these edges. So the relative error of a position is the
// relative error of its vector from i, for any thin face and regions. Errors are not tracked.
template <typename Traits>
class Developed_location
{
  typedef Triangulation_pair<Traits> Pair;
  typedef Double_double N;
  typedef Rounded_corners<N, typename Pair::Metric::Number> Corners;
  typedef Development<Traits, Corners> Layout;
  typedef typename Layout::Placed_side Placed_side;
  typedef typename Layout::Complex Complex;
  typedef Face_regions::Curve Curve;
  typedef Point_to_insert<double> Point;

public:
  // The point has the weights `b` of i, j and k; `h` leads from i to j.
  Developed_location(const Pair& pair, const Edge_courses<Traits>& courses, Corners& corners,
                     Halfedge_index h, const std::array<double, 3>& b)
    : m_pair(pair),
      m_input(pair.input_mesh()),
      m_courses(courses),
      m_side{h, pair.mesh().next(h), pair.mesh().prev(h)},
      m_layout(pair, courses, corners),
      m_is_inserted(pair.is_inserted(pair.mesh().source(h))),
      m_regions(regions_at(h, pair.mesh(), courses)),
      m_ij(m_layout.strip(h)),
      m_ik(m_layout.strip(opposite(pair.mesh().prev(h)), m_layout.following_side(h, m_ij.first)))
  {
    const Complex p = number(b[1]) * m_ij.end + number(b[2]) * m_ik.end;
    m_region = region_of(p);
    set_position(p, triangle(m_region), to_double(corners.length(m_ij.first.halfedge).x));
  }

  // Returns the side from which regions are counted.
  Halfedge_index first_side() const { return m_side[0]; }
  // Returns the halfedge of T1 that leaves the face at a mark.
  Halfedge_index outward(const Region_corner& mark) const
  {
    return opposite(m_courses(m_side[mark.side])[mark.mark]);
  }
  const Face_regions& regions() const { return m_regions; }
  std::size_t region() const { return m_region; }

  // Returns the distance of the point from the curve between two corners of its region.
  double distance(const Region_corner& from, const Region_corner& to) const
  {
    return m_distance[side_along(from, to)];
  }

  // Returns the point in its region, or nothing if rounding has moved it out.
  std::optional<Point> inside() const
  {
    if(!(m_weight[0] > 0 && m_weight[1] > 0 && m_weight[2] > 0))
      return {};
    const std::size_t first = side_number(m_triangle, m_input);
    std::array<double, 3> b;
    for(std::size_t c = 0; c < 3; ++c)
      b[(first + c) % 3] = m_weight[c];
    return Point{Face_location<double>(m_input.face(m_triangle), b), {}};
  }

  // Returns the foot of the height over the curve, or nothing if it is beyond the ends of the
  // curve.
  std::optional<Point> on_curve(const Region_corner& from, const Region_corner& to) const
  {
    const std::size_t s = side_along(from, to);
    const std::array<Halfedge_index, 3> sides{m_triangle, m_input.next(m_triangle),
                                              m_input.prev(m_triangle)};
    const auto length = [&](std::size_t k) {
      return m_pair.input_length(m_input.edge(sides[(s + k) % 3]));
    };
    const double base = length(0);
    const double foot = doubled_corner_product(length(1), base, length(2)) / (2 * base * base);
    const double above = m_weight[(s + 2) % 3];
    const double at_source = m_weight[s] + above * (1 - foot),
                 at_target = m_weight[(s + 1) % 3] + above * foot;
    if(!(at_source > 0 && at_target > 0))
      return {};
    const double sum = at_source + at_target;
    return Point{Edge_location<double>{sides[s], {at_source / sum, at_target / sum}}, {}};
  }

private:
  static Complex number(double x) { return {N(x), N(0), 0}; }
  static N cross(const Complex& a, const Complex& b) { return a.x * b.y - a.y * b.x; }

  // Returns whether `p` and the origin are on one side of an edge of T1.
  static bool is_before(const Complex& p, const Placed_side& side)
  {
    return cross(side.vector, p - side.source) > 0;
  }

  // Returns the side of the triangle of T1 that lies along the curve from one corner of the region
  // to the next.
  std::size_t side_along(const Region_corner& from, const Region_corner& to) const
  {
    const Region_corner mark = m_regions.curve(from, to).mark;
    const Halfedge_index out = outward(mark);
    const bool leads_to_mark = !to.is_vertex() && to.side == mark.side && to.mark == mark.mark;
    return side_number(leads_to_mark ? out : opposite(out), m_triangle, m_input);
  }

  std::size_t region_of(const Complex& p) const
  {
    const auto &ij = m_ij.crossed, &ik = m_ik.crossed;
    const std::size_t n = m_regions.leaving(), around_i = m_regions.around(0);
    return m_regions.find(
      [&](std::size_t s, std::size_t j) {
        return s == 0   ? is_before(p, ij[j])
               : s == 1 ? !is_before(p, ij[ij.size() - 1 - j])
                        : !is_before(p, ik[ik.size() - 1 - j]);
      },
      [&](std::size_t j) {
        return m_regions.apex() == 0   ? cross(outgoing(j + 1).target, p) <= 0
               : m_regions.apex() == 1 ? !is_before(p, ik[around_i + n - 1 - j])
                                       : is_before(p, ij[around_i + j]);
      });
  }

  // Returns the outgoing halfedge of T1 with number `s`, counted from ij.
  Placed_side outgoing(std::size_t s) const
  {
    Placed_side side = m_ij.first;
    for(; s > 0; --s)
      side = m_layout.following_outgoing(side, m_is_inserted);
    return side;
  }

  // Sets the coordinates of the point `p` in the triangle of `side`, and its distances from the
  // sides. `unit` is the length of a vector of length 1.
  void set_position(const Complex& p, const Placed_side& side, double unit)
  {
    m_triangle = side.halfedge;
    const std::array<Complex, 3> corner{side.source, side.target, m_layout.apex(side)};
    double sum = 0;
    for(std::size_t c = 0; c < 3; ++c) {
      const Complex &from = corner[c], &to = corner[(c + 1) % 3];
      const double area = to_double(cross(to - from, p - from));
      sum += m_weight[(c + 2) % 3] = area;
      m_distance[c] = unit * area / (to - from).norm();
    }
    for(double& w : m_weight)
      w /= sum;
  }

  // Returns the triangle of T1 in which a region lies.
  Placed_side triangle(std::size_t region) const
  {
    const std::size_t around_i = m_regions.around(0), around_j = m_regions.around(1);
    if(region < around_i)
      return triangle_after(m_ij, region);
    if(region < around_i + around_j)
      return triangle_after(m_ij, m_ij.crossed.size() - (region - around_i));
    if(region < m_regions.first_of_rest())
      return triangle_after(m_ik, m_ik.crossed.size() - (region - around_i - around_j));
    const std::size_t j = region - m_regions.first_of_rest();
    if(m_regions.leaving() == 0 || m_regions.apex() == 2)
      return triangle_after(m_ij, around_i + j);
    if(m_regions.apex() == 1)
      return triangle_after(m_ik, around_i + m_regions.leaving() - j);
    return outgoing(j);
  }

  Placed_side triangle_after(const typename Layout::Strip& strip, std::size_t crossings) const
  {
    return crossings == 0 ? strip.first : m_layout.beyond(strip.crossed[crossings - 1]);
  }

  const Pair& m_pair;
  const Delta_complex& m_input;
  const Edge_courses<Traits>& m_courses;
  std::array<Halfedge_index, 3> m_side;
  Layout m_layout;
  bool m_is_inserted;
  Face_regions m_regions;
  typename Layout::Strip m_ij, m_ik;
  std::size_t m_region;
  Halfedge_index m_triangle; // a side of the triangle of T1 in which the point lies
  std::array<double, 3> m_weight, m_distance; // of its corners and from its sides, from there on
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DEVELOPED_LOCATION_H
