// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DEVELOPED_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DEVELOPED_FACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Development.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// A face ijk of T2 in the plane, i at the origin, with the edges of T1 that cross ij and ik laid
// out along these. So the relative error of a place is that of its vector from i, however thin the
// face and the regions are. Errors are not tracked.
template <typename Traits>
class Developed_face
{
  typedef Triangulation_pair<Traits> Pair;
  typedef Double_double N;
  typedef Rounded_corners<N, typename Pair::Metric::Number> Corners;
  typedef Development<Traits, Corners> Layout;
  typedef typename Layout::Placed_side Placed_side;
  typedef typename Layout::Complex Complex;

public:
  // A point in a triangle of T1: its coordinates from the source of `side` on, and its distances
  // from the sides, beginning with `side`.
  struct Place
  {
    Halfedge_index side;
    std::array<double, 3> weight, distance;
  };

  // `h` leads from i to j
  Developed_face(const Pair& pair, const Edge_courses<Traits>& courses, Corners& corners,
                 Halfedge_index h)
    : m_pair(pair),
      m_input(pair.input_mesh()),
      m_layout(pair, courses, corners),
      m_is_inserted(pair.is_inserted(pair.mesh().source(h))),
      m_regions(
        {courses.count(h), courses.count(pair.mesh().next(h)), courses.count(pair.mesh().prev(h))}),
      m_ij(m_layout.strip(h)),
      m_ik(m_layout.strip(opposite(pair.mesh().prev(h)), m_layout.following_side(h, m_ij.first))),
      m_unit(to_double(corners.length(m_ij.first.halfedge).x))
  {}

  // those of the face with ij as side 0
  const Face_regions& regions() const { return m_regions; }

  // the point with weight `b` at j and `c` at k
  Complex point(double b, double c) const { return number(b) * m_ij.end + number(c) * m_ik.end; }

  // returns the index of the region that has `p`
  std::size_t region_of(const Complex& p) const
  {
    const std::size_t n_ij = m_ij.crossed.size(), n_ik = m_ik.crossed.size();
    const std::array<std::size_t, 3> around{m_regions.around(0), m_regions.around(1),
                                            m_regions.around(2)};
    for(std::size_t j = 0; j < around[0]; ++j)
      if(is_before(p, m_ij.crossed[j]))
        return m_regions.around_corner(0, j);
    for(std::size_t j = 0; j < around[1]; ++j)
      if(!is_before(p, m_ij.crossed[n_ij - 1 - j]))
        return m_regions.around_corner(1, j);
    for(std::size_t j = 0; j < around[2]; ++j)
      if(!is_before(p, m_ik.crossed[n_ik - 1 - j]))
        return m_regions.around_corner(2, j);
    return m_regions.first_of_rest() + number_in_fan(p);
  }

  // returns the place of `p` in the triangle of T1 of a region
  Place place(const Complex& p, std::size_t region) const
  {
    const Placed_side side = triangle(region);
    const std::array<Complex, 3> corner{side.source, side.target, m_layout.apex(side)};
    Place result{side.halfedge, {}, {}};
    double sum = 0;
    for(std::size_t c = 0; c < 3; ++c) {
      const Complex &from = corner[c], &to = corner[(c + 1) % 3];
      const double area = to_double(cross(to - from, p - from));
      sum += result.weight[(c + 2) % 3] = area;
      result.distance[c] = m_unit * area / (to - from).norm();
    }
    for(double& w : result.weight)
      w /= sum;
    return result;
  }

private:
  static Complex number(double x) { return {N(x), N(0), 0}; }
  static N cross(const Complex& a, const Complex& b) { return a.x * b.y - a.y * b.x; }

  // whether `p` and the origin are on one side of an edge of T1
  static bool is_before(const Complex& p, const Placed_side& side)
  {
    return cross(side.vector, p - side.source) > 0;
  }

  std::size_t number_in_fan(const Complex& p) const
  {
    const std::size_t n = m_regions.leaving(), first = m_regions.around(0);
    std::size_t passed = 0;
    if(m_regions.apex() == 0) {
      for(Placed_side side = m_ij.first; passed < n; ++passed) {
        side = m_layout.following_outgoing(side, m_is_inserted);
        if(cross(side.target, p) <= 0)
          break;
      }
      return passed;
    }
    const auto& crossed = m_regions.apex() == 1 ? m_ik.crossed : m_ij.crossed;
    while(passed < n && !is_before(p, crossed[first + passed]))
      ++passed;
    return m_regions.apex() == 1 ? n - passed : passed;
  }

  // the triangle of T1 in which a region lies
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
    Placed_side side = m_ij.first;
    for(std::size_t s = 0; s < j; ++s)
      side = m_layout.following_outgoing(side, m_is_inserted);
    return side;
  }

  Placed_side triangle_after(const typename Layout::Strip& strip, std::size_t crossings) const
  {
    if(crossings == 0)
      return strip.first;
    const Placed_side& side = strip.crossed[crossings - 1];
    return {m_input.opposite(side.halfedge), side.target, side.source, -side.vector};
  }

  const Pair& m_pair;
  const Delta_complex& m_input;
  Layout m_layout;
  bool m_is_inserted;
  Face_regions m_regions;
  typename Layout::Strip m_ij, m_ik;
  double m_unit; // the length of a vector of length 1
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DEVELOPED_FACE_H
