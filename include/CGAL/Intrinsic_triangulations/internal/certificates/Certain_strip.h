// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_course.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// What floating point says about an edge of T2 that has been laid out.
struct Straight_edge
{
  bool is_certain; // that it is straight
  double length;   // NaN if it is not known up to the error that is allowed
};

// The strip of triangles of T1 that an edge of T2 crosses, laid out in `double` from its source.
//
// A side comes from the side before by a factor with a relative error of at most 20 u, and the
// product adds less than 3 u, for the rounding unit u: so a side has at most 24 u for each
// triangle. A corner is placed by adding up sides on the shorter way from the source; each sum adds
// a u of that way. Hence no corner is displaced by more than 32 u times the number of triangles
// times the longest of these ways.
template <typename Traits>
class Certain_strip
{
  typedef Triangulation_pair<Traits> Pair;

  struct Vector
  {
    double x, y;

    friend Vector operator+(const Vector& v, const Vector& w) { return {v.x + w.x, v.y + w.y}; }
    friend Vector operator-(const Vector& v) { return {-v.x, -v.y}; }
    // product of complex numbers
    friend Vector operator*(const Vector& v, const Vector& w)
    {
      return {v.x * w.x - v.y * w.y, v.x * w.y + v.y * w.x};
    }
    friend double cross(const Vector& v, const Vector& w) { return v.x * w.y - v.y * w.x; }
  };

  struct Corner
  {
    Vector position;
    double way; // from the source of the strip, along sides

    Corner moved(const Vector& v, double length) const { return {position + v, way + length}; }
  };

  // a side of a triangle that lies on its left
  struct Side
  {
    Halfedge_index halfedge;
    Vector vector;
    Corner source, target;
  };

  // the third corner of this triangle
  struct Apex
  {
    Vector from_source, from_target;
    Corner corner;
  };

public:
  explicit Certain_strip(const Pair& pair) : m_pair(pair), m_input(pair.input_mesh()) {}

  // Returns the length of an edge with this course, unless it may have a relative error of more
  // than `error`, and whether it certainly passes between the ends of the edges of T1 that it
  // crosses.
  // \pre the edge crosses some and has no inserted ends, and T1 has positions or lengths
  Straight_edge operator()(const Edge_course& course, double error)
  {
    if(course.size() == 1)
      return across(opposite(course[0]), error);
    lay_out(course);
    const double triangles = static_cast<double>(m_left.size() + m_right.size());
    const double displacement = 32 * Rounding<double>::unit() * triangles * m_longest_way;
    const double length = std::sqrt(m_end.x * m_end.x + m_end.y * m_end.y);
    return {is_straight(4 * displacement * m_longest_way),
            displacement <= error / 2 * length ? length : std::numeric_limits<double>::quiet_NaN()};
  }

private:
  // Two triangles are laid out from their common side `x`: each of their other corners on its own.
  // From either end of `x` they are seen with a relative error of 20 u, and the products that
  // determine on which side of the end the edge passes have 44 u; the length has 22 u of two sides.
  // Products of sides are bounded by half of the sum of their squares.
  Straight_edge across(Halfedge_index x, double error) const
  {
    const auto apex = apex_products<double>(x, m_pair.input_metric(), m_pair.input()),
               other = apex_products<double>(opposite(x), m_pair.input_metric(), m_pair.input());
    constexpr double unit = 64 * Rounding<double>::unit();
    const double inverse = 2 / (apex.square_pq + other.square_pq); // NaN if one is
    const double at_source = apex.square_pr + other.square_qr,
                 at_target = apex.square_qr + other.square_pr;
    const double after_source = apex.with_pr * other.across - other.with_qr * apex.across,
                 before_target = other.with_pr * apex.across - apex.with_qr * other.across;
    const bool is_straight = after_source * inverse > unit / 2 * at_source &&
                             before_target * inverse > unit / 2 * at_target;
    const double along = apex.with_pr + other.with_qr, across = apex.across + other.across;
    const double square = (along * along + across * across) * inverse;
    return {is_straight, 2 * unit * unit * at_source <= error * error * square
                           ? std::sqrt(square)
                           : std::numeric_limits<double>::quiet_NaN()};
  }

  void lay_out(const Edge_course& course)
  {
    const Halfedge_index exit = course[0], first = m_input.prev(exit);
    const double length = side_length(first);
    m_left.clear();
    m_right.assign(1, {length, 0});
    m_longest_way = length;
    Side side = passed({first, {length, 0}, {{0, 0}, 0}, {{length, 0}, length}}, exit);
    for(std::size_t m = 1; m < course.size(); ++m)
      side = passed(side, course[m]);
    m_end = apex(side).corner.position;
  }

  // returns the side by which the strip enters the next triangle through `exit`
  Side passed(const Side& side, Halfedge_index exit)
  {
    const Apex a = apex(side);
    if(exit == m_input.next(side.halfedge)) {
      m_left.push_back(a.corner.position);
      return {opposite(exit), -a.from_target, a.corner, side.target};
    }
    m_right.push_back(a.corner.position);
    return {opposite(exit), a.from_source, side.source, a.corner};
  }

  Apex apex(const Side& side)
  {
    const Halfedge_index h = side.halfedge;
    const auto ratios = apex_ratios<double>(h, m_pair.input_metric(), m_pair.input());
    const Vector from_source = side.vector * Vector{ratios.from_source, ratios.across},
                 from_target = side.vector * Vector{ratios.from_target, ratios.across};
    const Corner by_source = side.source.moved(from_source, side_length(m_input.prev(h))),
                 by_target = side.target.moved(from_target, side_length(m_input.next(h)));
    const Corner& corner = by_source.way <= by_target.way ? by_source : by_target;
    m_longest_way = (std::max)(m_longest_way, corner.way);
    return {from_source, from_target, corner};
  }

  double side_length(Halfedge_index h) const { return m_pair.input_length(m_input.edge(h)); }

  bool is_straight(double margin) const
  {
    const auto is_on_left = [&](const Vector& v) { return cross(m_end, v) > margin; };
    const auto is_on_right = [&](const Vector& v) { return cross(m_end, v) < -margin; };
    return std::all_of(m_left.begin(), m_left.end(), is_on_left) &&
           std::all_of(m_right.begin(), m_right.end(), is_on_right);
  }

  const Pair& m_pair;
  const Delta_complex& m_input;
  std::vector<Vector> m_left, m_right; // corners of the strip
  Vector m_end{};
  double m_longest_way = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_STRIP_H
