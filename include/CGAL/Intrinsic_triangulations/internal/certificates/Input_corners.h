// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_INPUT_CORNERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_INPUT_CORNERS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Ball.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Recent_values.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Root_tower.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <unordered_map>

namespace CGAL::Intrinsic_triangulations::internal {

// A corner at p of a triangle pqr of T1, where pq is the side of a halfedge. As a complex number it
// is (r - p) / (q - p), up to conjugation: its argument is the angle, its absolute value the ratio
// of the sides.
struct Input_corner
{
  Vertex_index p, q, r;
  Edge_index pq, pr, qr;
};

inline Input_corner corner_at_source(Halfedge_index h, const Delta_complex& mesh)
{
  const Halfedge_index jk = mesh.next(h), ki = mesh.prev(h);
  return {mesh.source(h), mesh.target(h), mesh.target(jk),
          mesh.edge(h),   mesh.edge(ki),  mesh.edge(jk)};
}

inline Input_corner corner_at_target(Halfedge_index h, const Delta_complex& mesh)
{
  const Input_corner c = corner_at_source(h, mesh);
  return {c.q, c.p, c.r, c.pq, c.qr, c.pr};
}

// the field of exact squared lengths that are stored as numbers of another type
template <typename Stored>
using Exact_number_of = std::conditional_t<std::is_same_v<Stored, double>, Exact_field, Stored>;

// Twice the scalar product of the sides at a corner, and the square of four times the area, from
// the squared lengths of pq, pr and qr. Nothing is divided.
template <typename K>
struct Corner_products
{
  K doubled_product, squared_quadrupled_area;

  explicit Corner_products(const std::array<K, 3>& square)
    : doubled_product(square[0] + square[1] - square[2]),
      squared_quadrupled_area(K(4) * square[0] * square[1] - doubled_product * doubled_product)
  {}
};

// The shortest sides, by their squares, whose products do not underflow. With Long_float none do.
template <typename N>
constexpr double least_square()
{
  return std::is_floating_point_v<N> || std::is_same_v<N, Double_double> ? 1e-100 : 0;
}

// The third corner r of a triangle pqr on the left of pq: from p and from q along pq, and across
// it, divided by the length of pq.
template <typename N>
struct Apex_ratios
{
  N from_source, from_target, across;
};

// Returns those of the triangle of the halfedge pq, from positions; NaN if products may underflow.
// Vectors to r that they make are correct to a relative error of 20 u, for the rounding unit u,
// however thin the triangle is: components of vectors have one of u, so that compared with the
// product of both lengths a scalar product has 5 u, and the vector product with the shorter side at
// r has 9 u; the quotients add 7 u.
template <typename N>
Apex_ratios<N> apex_ratios(const Position& p, const Position& q, const Position& r)
{
  const auto pq = vector_between<N>(p, q), pr = vector_between<N>(p, r),
             qr = vector_between<N>(q, r);
  const N square_pq = dot(pq, pq), square_pr = dot(pr, pr), square_qr = dot(qr, qr);
  const auto normal = cross(pq, square_pr < square_qr ? pr : qr);
  const bool is_good = (std::min)({square_pq, square_pr, square_qr}) > N(least_square<N>());
  const N inverse = is_good ? N(N(1) / square_pq) : N(std::numeric_limits<double>::quiet_NaN());
  return {N(dot(pq, pr) * inverse), N(dot(pq, qr) * inverse),
          N(sqrt(dot(normal, normal)) * inverse)};
}

// Returns those from lengths: no formula loses digits.
template <typename N>
Apex_ratios<N> apex_ratios(const N& pq, const N& qr, const N& rp)
{
  const N least = (std::min)({pq, qr, rp});
  const bool is_good = least * least > N(least_square<N>());
  const N inverse =
    is_good ? N(N(1) / (N(2) * pq * pq)) : N(std::numeric_limits<double>::quiet_NaN());
  return {N(doubled_corner_product(qr, pq, rp) * inverse),
          N(-(doubled_corner_product(rp, pq, qr) * inverse)),
          N(sqrt(squared_quadrupled_area(pq, qr, rp)) * inverse)};
}

// Returns those of the triangle on the left of `h`. \pre `metric` has no squared lengths
template <typename N, typename Metric, typename Surface>
Apex_ratios<N> apex_ratios(Halfedge_index h, const Metric& metric, const Surface& input)
{
  const Delta_complex& mesh = input.mesh();
  if(!metric.points.empty())
    return apex_ratios<N>(metric.points[mesh.source(h)], metric.points[mesh.target(h)],
                          metric.points[mesh.target(mesh.next(h))]);
  const auto length = [&](Halfedge_index x) { return N(input.length_map()[mesh.edge(x)]); };
  return apex_ratios<N>(length(h), length(mesh.next(h)), length(mesh.prev(h)));
}

// Corners up to an error that is a few units of roundoff of their absolute value, however thin the
// triangle is.
template <typename N, typename Metric, typename Surface>
class Rounded_corners
{
  typedef Exact_number_of<typename Metric::Number> K;

public:
  typedef Ball<N> Complex;
  static constexpr bool is_rounded = true;

  Rounded_corners(const Metric& metric, const Surface& input) : m_metric(metric), m_input(input) {}

  static Complex number(int x) { return {N(x), N(0), 0}; }

  // exact digits are asked for only where `double` is not enough
  template <typename Lazy_number>
  static Complex number(const Lazy_number& x)
  {
    if constexpr(std::is_same_v<N, double>) {
      const auto [lower, upper] = to_interval(x);
      const double middle = lower / 2 + upper / 2;
      return Complex{middle, 0, (std::max)(upper - middle, middle - lower)}.with_error(2);
    } else
      return to_ball<N>(x.exact());
  }

  // returns `z` as corners of the triangle of `h` are scaled
  static const Complex& scaled(const Complex& z, Halfedge_index) { return z; }

  // returns numbers that are not negative, divided by their sum
  static std::array<Complex, 3> weights(const std::array<double, 3>& b)
  {
    const N sum = N(b[0]) + N(b[1]) + N(b[2]);
    const auto weight = [&](double x) { return Complex{N(x) / sum, N(0), 0}.with_error(4); };
    return {weight(b[0]), weight(b[1]), weight(b[2])};
  }

  // the corners at the ends of the side `h` of a triangle
  Complex at_source(Halfedge_index h)
  {
    return m_corner(2 * std::size_t(h.idx()), [&] {
      if(!m_metric.squared_lengths.empty())
        return from_squared_lengths(corner_at_source(h, m_input.mesh()));
      const auto ratios = apex_ratios<N>(h, m_metric, m_input);
      return corner(ratios.from_source, ratios.across);
    });
  }
  Complex at_target(Halfedge_index h)
  {
    return m_corner(2 * std::size_t(h.idx()) + 1, [&] {
      if(!m_metric.squared_lengths.empty())
        return from_squared_lengths(corner_at_target(h, m_input.mesh()));
      const auto ratios = apex_ratios<N>(h, m_metric, m_input);
      return corner(-ratios.from_target, ratios.across);
    });
  }

  Complex length(Halfedge_index h) const
  {
    const Delta_complex& mesh = m_input.mesh();
    if(!m_metric.points.empty()) {
      const auto u = vector(mesh.source(h), mesh.target(h));
      return Complex{sqrt(dot(u, u)), N(0), 0}.with_error(6);
    }
    if(!m_metric.squared_lengths.empty())
      return root(to_ball<N>(K(m_metric.squared_lengths[mesh.edge(h)])));
    return {N(m_input.length_map()[mesh.edge(h)]), N(0), 0};
  }

private:
  static Complex corner(const N& along, const N& across)
  {
    if(!(across >= N(0)))
      return {N(0), N(0), std::numeric_limits<double>::infinity()};
    return Complex{along, across, 0}.with_error(20);
  }

  std::array<N, 3> vector(Vertex_index v, Vertex_index w) const
  {
    return vector_between<N>(m_metric.points[v], m_metric.points[w]);
  }

  Complex from_squared_lengths(const Input_corner& c) const
  {
    const auto& square = m_metric.squared_lengths;
    const K pq(square[c.pq]);
    const Corner_products<K> exact({pq, K(square[c.pr]), K(square[c.qr])});
    const Complex along = to_ball<N>(K(exact.doubled_product / (K(2) * pq)));
    const Complex across =
      root(to_ball<N>(K((std::max)(exact.squared_quadrupled_area, K(0)) / (K(4) * pq * pq))));
    return along + Complex{N(0), across.x, across.radius};
  }

  const Metric& m_metric;
  Surface m_input;
  Recent_values<Complex> m_corner;
};

// Corners of numbers with square roots, exactly. They are not divided by the squared length of
// their side: a position is one up to a positive factor.
template <typename Metric, typename Surface>
class Exact_corners
{
  typedef Exact_number_of<typename Metric::Number> K;

public:
  typedef Root_complex<K> Complex;
  static constexpr bool is_rounded = false;

  Exact_corners(const Metric& metric, const Surface& input) : m_metric(metric), m_input(input) {}

  // Begins a decision, which is left open if it involves more than `maximum` independent roots.
  void restart(std::size_t maximum)
  {
    m_tower = Root_tower<K>(maximum);
    m_has_too_many_roots = false;
    ++m_decisions;
  }

  Complex number(int x) const { return real(K(x)); }
  template <typename Lazy_number>
  Complex number(const Lazy_number& x) const
  {
    return real(K(x.exact()));
  }

  Complex scaled(const Complex& z, Halfedge_index h)
  {
    return z * K(K(2) * triangle(h).square[side_number(h, m_input.mesh())]);
  }

  // returns numbers that are not negative; they need not be divided by their sum
  std::array<Complex, 3> weights(const std::array<double, 3>& b) const
  {
    return {real(K(b[0])), real(K(b[1])), real(K(b[2]))};
  }

  Complex at_source(Halfedge_index h) { return corner(h, 0, 2, 1); }
  Complex at_target(Halfedge_index h) { return corner(h, 0, 1, 2); }

  // returns the sign of the squared area of the triangle of `h`: NEGATIVE if the triangle
  // inequality fails
  Sign area_sign(Halfedge_index h) const
  {
    return CGAL::sign(Corner_products<K>(squares(h)).squared_quadrupled_area);
  }

  // whether there were more roots than are allowed
  bool has_too_many_roots() const { return m_has_too_many_roots; }

private:
  typedef typename Complex::Element Element;

  Complex real(const K& x) const { return {&m_tower, Element{x}, Element{K(0)}}; }

  typedef std::array<K, 3> Squares;

  struct Triangle
  {
    Squares square;
    K squared_quadrupled_area;
    Element root;         // of that, which all corners have in common
    std::size_t decision; // for which it is
  };

  // Returns the squared lengths of the sides, beginning with `h`, up to a common factor:
  // coordinates are made whole numbers, which need no common denominators.
  Squares squares(Halfedge_index h) const
  {
    const Delta_complex& mesh = m_input.mesh();
    const std::array<Halfedge_index, 3> side{h, mesh.next(h), mesh.prev(h)};
    if(m_metric.points.empty())
      return {squared_length(mesh.edge(side[0])), squared_length(mesh.edge(side[1])),
              squared_length(mesh.edge(side[2]))};
    std::array<std::array<double, 3>, 3> p;
    for(std::size_t s = 0; s < 3; ++s)
      p[s] = m_metric.points[mesh.source(side[s])];
    scale_to_integers(p);
    return {squared_distance<K>(p[0], p[1]), squared_distance<K>(p[1], p[2]),
            squared_distance<K>(p[2], p[0])};
  }

  K squared_length(Edge_index e) const
  {
    return m_metric.squared_lengths.empty() ? K(CGAL::square(K(m_input.length_map()[e])))
                                            : K(m_metric.squared_lengths[e]);
  }

  // Lengths that exceed the triangle inequality by rounding are those of a flat triangle.
  const Triangle& triangle(Halfedge_index h)
  {
    const Face_index f = m_input.mesh().face(h);
    auto place = m_triangle.find(f);
    if(place == m_triangle.end()) {
      const Squares square = squares(m_input.mesh().halfedge(f));
      const K area = (std::max)(Corner_products<K>(square).squared_quadrupled_area, K(0));
      place = m_triangle.insert({f, Triangle{square, area, {}, 0}}).first;
    }
    Triangle& triangle = place->second;
    if(triangle.decision != m_decisions) {
      const auto root = m_tower.root(triangle.squared_quadrupled_area);
      m_has_too_many_roots = m_has_too_many_roots || !root;
      triangle.root = root.value_or(Element{K(0)});
      triangle.decision = m_decisions;
    }
    return triangle;
  }

  // The corner between two sides of a triangle, the first of which is that of `h`, as the sides are
  // counted from there.
  Complex corner(Halfedge_index h, std::size_t a, std::size_t b, std::size_t opposite)
  {
    const Triangle& t = triangle(h);
    const std::size_t first = side_number(h, m_input.mesh());
    const auto square = [&](std::size_t s) -> const K& { return t.square[(first + s) % 3]; };
    return {&m_tower, Element{K(square(a) + square(b) - square(opposite))}, t.root};
  }

  const Metric& m_metric;
  Surface m_input;
  Root_tower<K> m_tower;
  std::unordered_map<Face_index, Triangle> m_triangle;
  bool m_has_too_many_roots = false;
  std::size_t m_decisions = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_INPUT_CORNERS_H
