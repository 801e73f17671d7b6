// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Edge_course.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

template <typename Traits>
Exact_surface<typename Input_metric_of<Traits>::Number>
exact_input(const Triangulation_pair<Traits>& pair)
{
  return {pair.input(), pair.input_metric()};
}

// Returns the square of pq, or NaN if products of the squares of three sides may underflow or
// overflow. Products of Long_float never do.
template <typename N>
N square_in_range(const N& pq, const N& pr, const N& qr)
{
  constexpr bool is_bounded = std::is_floating_point_v<N> || std::is_same_v<N, Double_double>;
  constexpr double least = is_bounded ? 1e-100 : 0,
                   greatest = is_bounded ? 1e100 : std::numeric_limits<double>::infinity();
  return (std::min)({pq, pr, qr}) > N(least) && (std::max)({pq, pr, qr}) < N(greatest)
           ? pq
           : N(std::numeric_limits<double>::quiet_NaN());
}

// Stores products of the sides of a triangle pqr on the left of pq. These are the scalar products
// of pq with pr and with qr, and the length of their vector product. The squared lengths of the
// sides are stored, too. The square of pq is NaN if products may leave the range of numbers.
template <typename N>
struct Apex_products
{
  N with_pr, with_qr, across;
  N square_pq, square_pr, square_qr;
};

// Returns the products of the triangle of the halfedge pq, from positions. Divided by the square of
// pq, the products yield vectors to r. These have a relative error of 20 u, for the rounding unit
// u, however thin the triangle is. Components of vectors have an error of one u. So a scalar
// product has an error of 5 u, relative to the product of both lengths. The vector product with the
// shorter side at r has 9 u; the quotients add 7 u. Inlined, the products of two triangles are
// computed at once.
template <typename N>
BOOST_FORCEINLINE Apex_products<N> apex_products(const Position& p, const Position& q,
                                                 const Position& r)
{
  const auto pq = vector_between<N>(p, q), pr = vector_between<N>(p, r),
             qr = vector_between<N>(q, r);
  const N square_pq = dot(pq, pq), square_pr = dot(pr, pr), square_qr = dot(qr, qr);
  const auto normal = cross(pq, square_pr < square_qr ? pr : qr);
  return {N(dot(pq, pr)),
          N(dot(pq, qr)),
          N(sqrt(dot(normal, normal))),
          square_in_range(square_pq, square_pr, square_qr),
          square_pr,
          square_qr};
}

// Returns the products, computed from lengths. No difference in the formulas cancels digits.
template <typename N>
BOOST_FORCEINLINE Apex_products<N> apex_products(const N& pq, const N& qr, const N& rp)
{
  const N half(0.5), square_pr(rp * rp), square_qr(qr * qr);
  return {N(half * doubled_corner_product(qr, pq, rp)),
          N(-half * doubled_corner_product(rp, pq, qr)),
          N(half * sqrt(squared_quadrupled_area(pq, qr, rp))),
          square_in_range(N(pq * pq), square_pr, square_qr),
          square_pr,
          square_qr};
}

// Returns the products of the triangle on the left of `h`.
// \pre `input` has no squared lengths
template <typename N, typename Number>
Apex_products<N> apex_products(Halfedge_index h, const Exact_surface<Number>& input)
{
  const Delta_complex& mesh = input.mesh();
  const auto& points = input.metric.points;
  if(!points.empty())
    return apex_products<N>(points[mesh.source(h)], points[mesh.target(h)],
                            points[mesh.target(mesh.next(h))]);
  const auto [a, b, c] = side_lengths(h, input);
  return apex_products<N>(N(a), N(b), N(c));
}

// Stores the coordinates of r along pq, from p and from q, and its height over pq. All are divided
// by the length of pq.
template <typename N>
struct Apex_ratios
{
  N from_source, from_target, across;
};

// Returns the products of the triangle on the left of `h`; NaN if products may leave the range of
// numbers.
// \pre `input` has no squared lengths
template <typename N, typename Number>
Apex_ratios<N> apex_ratios(Halfedge_index h, const Exact_surface<Number>& input)
{
  const auto products = apex_products<N>(h, input);
  const N inverse = N(1) / products.square_pq;
  return {N(products.with_pr * inverse), N(products.with_qr * inverse),
          N(products.across * inverse)};
}

// Stores the length of an edge of T2, computed in floating point, and whether it is certainly
// straight.
struct Straight_edge
{
  bool is_certain; // the edge is certainly straight
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
