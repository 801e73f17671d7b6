// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Intrinsic_triangulations/Edge_course.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/apex_products.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the length of an edge of T2, computed in floating point, and whether it is certainly
// straight.
struct Straight_edge
{
  bool is_certain; // that it is straight
  double length;   // NaN if it is not known up to the error that is allowed
  double error;    // a bound for its relative error
};

// Lays out the strip of triangles of T1 that an edge of T2 crosses. The layout is computed in
// `double` from the corners of these triangles, not from lengths.
//
// Let u be the rounding unit. Each side is the previous side times a factor with an error of at
// most 20 u. The product adds less than 3 u, so a side has an error of at most 24 u per triangle.
// The position of a corner is the sum of sides on the shorter path from the source. Each sum adds u
// times the length of this path. Hence the displacement of a corner is at most 32 u times the
// number of triangles times the length of the longest path.
template <typename Number>
class Certain_strip : Euclidean_strip<double>
{
  typedef Euclidean_strip<double> Base;
  using typename Base::Corner;
  using typename Base::Vector;

public:
  explicit Certain_strip(const Exact_surface<Number>& input) : m_input(input) {}

  // Returns the length of an edge with this course, unless it may have a relative error of more
  // than `error`. Also returns whether it certainly passes between the ends of the edges of T1
  // that it crosses.
  // \pre the edge crosses some and has no inserted ends, and T1 has positions or lengths
  Straight_edge operator()(const Edge_course& course, double error)
  {
    if(course.size() == 1)
      return across(opposite(course[0]), error);
    lay_out(course);
    const double triangles = static_cast<double>(course.size() + 1);
    const double displacement = 32 * Rounding<double>::unit() * triangles * longest_way();
    return bounded(is_straight(displacement), length(), 2 * displacement / length(), error);
  }

private:
  static Straight_edge bounded(bool is_straight, double length, double bound, double error)
  {
    return {is_straight, bound <= error ? length : std::numeric_limits<double>::quiet_NaN(), bound};
  }

  // The two triangles are laid out from their common side `x`. From either end of `x`, each apex
  // has a relative error of 20 u. The products that determine on which side of an end the edge
  // passes have an error of 44 u. The length has an error of 22 u times two sides. Products of
  // sides are bounded by half of the sum of their squares.
  Straight_edge across(Halfedge_index x, double error) const
  {
    const auto apex = apex_products<double>(x, m_input),
               other = apex_products<double>(opposite(x), m_input);
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
    return bounded(is_straight, std::sqrt(square), unit * std::sqrt(2 * at_source / square), error);
  }

  // The plane is seen from behind: a triangle on the left of a side is laid out on its right.
  void lay_out(const Edge_course& course)
  {
    const Halfedge_index ai = m_input.mesh().prev(course[0]);
    const Vector side{edge_length(ai, m_input), 0};
    const Apex j = apex(ai);
    start({side * j.from_source, edge_length(m_input.mesh().prev(ai), m_input)}, {side, side.x},
          -(side * j.from_target));
    for(std::size_t m = 1; m < course.size(); ++m)
      pass(opposite(course[m - 1]), course[m]);
    const Halfedge_index last = opposite(course[course.size() - 1]);
    set_end(corner(last, apex(last)));
  }

  // Enters a triangle through its side `h`, and leaves it through `exit`.
  void pass(Halfedge_index h, Halfedge_index exit)
  {
    const Apex l = apex(h);
    if(exit == m_input.mesh().next(h))
      turn_around_target(corner(h, l), -(direction() * l.from_target));
    else
      turn_around_source(corner(h, l), direction() * l.from_source);
  }

  // Stores the third corner of a triangle, relative to both ends of a side, as fractions of this
  // side.
  struct Apex
  {
    Vector from_source, from_target;
  };

  Apex apex(Halfedge_index h) const
  {
    const auto ratios = apex_ratios<double>(h, m_input);
    return {{ratios.from_source, -ratios.across}, {ratios.from_target, -ratios.across}};
  }

  // Returns the third corner of the triangle of `h`.
  Corner corner(Halfedge_index h, const Apex& l) const
  {
    return placed(
      edge_length(m_input.mesh().next(h), m_input), edge_length(m_input.mesh().prev(h), m_input),
      [&] { return last_edge().source + direction() * l.from_source; },
      [&] { return last_edge().target + direction() * l.from_target; });
  }

  Exact_surface<Number> m_input;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_STRIP_H
