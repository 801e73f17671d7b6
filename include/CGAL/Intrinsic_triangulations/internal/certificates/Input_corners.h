// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_INPUT_CORNERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_INPUT_CORNERS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Ball.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Certain_strip.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Direct_mapped_cache.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Root_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Root_tower.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores a corner at p of a triangle pqr of T1, for the side pq of a halfedge. As a complex number
// it is (r - p) / (q - p), up to conjugation. Its argument is the angle, and its absolute value is
// the ratio of the sides.
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

// Names the ring and the field of exact squared lengths that are stored as numbers of another type.
template <typename Stored>
using Ring_of = std::conditional_t<std::is_same_v<Stored, double>, Exact_ring, Stored>;
template <typename Stored>
using Field_of = std::conditional_t<std::is_same_v<Stored, double>, Exact_field, Stored>;

// Stores twice the scalar product of the sides at a corner, and the square of four times the area.
// Both are computed from the squared lengths of pq, pr and qr, without divisions.
template <typename K>
struct Corner_products
{
  K doubled_product, squared_quadrupled_area;

  explicit Corner_products(const std::array<K, 3>& square)
    : doubled_product(square[0] + square[1] - square[2]),
      squared_quadrupled_area(K(4) * square[0] * square[1] - doubled_product * doubled_product)
  {}
};

template <typename Number>
std::array<Position, 3> corners_of_triangle(Halfedge_index h, const Exact_surface<Number>& input)
{
  const Delta_complex& mesh = input.mesh();
  return {input.metric.points[mesh.source(h)], input.metric.points[mesh.target(h)],
          input.metric.points[mesh.target(mesh.next(h))]};
}

// Computes corners of T1. Their error is a few units of roundoff of their absolute value, however
// thin the triangle is.
template <typename N, typename Number>
class Rounded_corners
{
  typedef Field_of<Number> K;

public:
  typedef Ball<N> Complex;
  static constexpr bool is_rounded = true;

  explicit Rounded_corners(const Exact_surface<Number>& input) : m_input(input) {}

  static Complex number(int x) { return {N(x), N(0), 0}; }
  static Complex number(double x) { return {N(x), N(0), 0}; }

  // Exact digits are requested only if `double` does not suffice.
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

  // Returns `z` unchanged: rounded corners are not scaled.
  static const Complex& scaled(const Complex& z, Halfedge_index) { return z; }

  // Returns false: triangles are laid out one by one.
  static bool is_flat(Halfedge_index) { return false; }

  // Returns numbers that are not negative, divided by their sum.
  static std::array<Complex, 3> weights(const std::array<double, 3>& b)
  {
    const N sum = N(b[0]) + N(b[1]) + N(b[2]);
    const auto weight = [&](double x) { return Complex{N(x) / sum, N(0), 0}.with_error(4); };
    return {weight(b[0]), weight(b[1]), weight(b[2])};
  }

  // The next functions return the corners at the ends of the side `h` of a triangle.
  Complex at_source(Halfedge_index h)
  {
    return m_corner(2 * std::size_t(h.idx()), [&] {
      if(!m_input.metric.squared_lengths.empty())
        return from_squared_lengths(corner_at_source(h, m_input.mesh()));
      const auto ratios = apex_ratios<N>(h, m_input);
      return corner(ratios.from_source, ratios.across);
    });
  }
  Complex from_source(Halfedge_index h, Halfedge_index /* of the third corner */)
  {
    return at_source(h);
  }
  Complex at_target(Halfedge_index h)
  {
    return m_corner(2 * std::size_t(h.idx()) + 1, [&] {
      if(!m_input.metric.squared_lengths.empty())
        return from_squared_lengths(corner_at_target(h, m_input.mesh()));
      const auto ratios = apex_ratios<N>(h, m_input);
      return corner(-ratios.from_target, ratios.across);
    });
  }

  Complex squared_length(Halfedge_index h) const
  {
    const Complex result = length(h);
    return result * result;
  }

  Complex length(Halfedge_index h) const
  {
    const Delta_complex& mesh = m_input.mesh();
    if(!m_input.metric.points.empty()) {
      const auto u = vector(mesh.source(h), mesh.target(h));
      return Complex{sqrt(dot(u, u)), N(0), 0}.with_error(6);
    }
    if(!m_input.metric.squared_lengths.empty())
      return root(to_ball<N>(K(m_input.metric.squared_lengths[mesh.edge(h)])));
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
    return vector_between<N>(m_input.metric.points[v], m_input.metric.points[w]);
  }

  Complex from_squared_lengths(const Input_corner& c) const
  {
    const auto& square = m_input.metric.squared_lengths;
    const K pq(square[c.pq]);
    const Corner_products<K> exact({pq, K(square[c.pr]), K(square[c.qr])});
    const Complex along = to_ball<N>(K(exact.doubled_product / (K(2) * pq)));
    const Complex across =
      root(to_ball<N>(K((std::max)(exact.squared_quadrupled_area, K(0)) / (K(4) * pq * pq))));
    return along + Complex{N(0), across.x, across.radius};
  }

  Exact_surface<Number> m_input;
  Direct_mapped_cache<Complex> m_corner;
};

// Returns the squared lengths of the sides of the triangle of `h`, beginning with `h`, up to a
// common factor. Coordinates and lengths are scaled to whole numbers, which need no common
// denominators.
template <typename K, typename Number>
std::array<K, 3> squared_sides(Halfedge_index h, const Exact_surface<Number>& input)
{
  const Delta_complex& mesh = input.mesh();
  if constexpr(std::is_constructible_v<K, const Number&>)
    if(const auto& square = input.metric.squared_lengths; !square.empty())
      return {K(square[mesh.edge(h)]), K(square[mesh.edge(mesh.next(h))]),
              K(square[mesh.edge(mesh.prev(h))])};
  if(!input.metric.points.empty()) {
    auto p = corners_of_triangle(h, input);
    scale_to_integers(p);
    return {squared_distance<K>(p[0], p[1]), squared_distance<K>(p[1], p[2]),
            squared_distance<K>(p[2], p[0])};
  }
  std::array<Position, 1> length{side_lengths(h, input)};
  scale_to_integers(length);
  const auto square = [&](std::size_t s) { return K(CGAL::square(K(length[0][s]))); };
  return {square(0), square(1), square(2)};
}

// Returns the squared length of the edge of `h`.
template <typename K, typename Number>
K exact_squared_length(Halfedge_index h, const Exact_surface<Number>& input)
{
  const Delta_complex& mesh = input.mesh();
  if constexpr(std::is_constructible_v<K, const Number&>)
    if(const auto& square = input.metric.squared_lengths; !square.empty())
      return K(square[mesh.edge(h)]);
  if(!input.metric.points.empty())
    return squared_distance<K>(input.metric.points[mesh.source(h)],
                               input.metric.points[mesh.target(h)]);
  return K(CGAL::square(K(input.length_map()[mesh.edge(h)])));
}

// Returns the sign of the squared area of the triangle of `h`: NEGATIVE if the triangle inequality
// fails.
template <typename Number>
Sign area_sign(Halfedge_index h, const Exact_surface<Number>& input)
{
  typedef Ring_of<Number> K;
  return CGAL::sign(Corner_products<K>(squared_sides<K>(h, input)).squared_quadrupled_area);
}

// Computes corners exactly, as numbers with square roots, for one decision. Corners are not divided
// by the squared length of their side, so positions are determined up to a positive factor. With
// positions, adjacent coplanar faces form one face, whose vertices are placed at once.
template <typename K, typename Number>
class Exact_corners
{
public:
  typedef Root_complex<K> Complex;
  static constexpr bool is_rounded = false;

  // The decision is left open if it involves more independent roots than `most_roots`, or more
  // vectors than `most_vectors`. The digits of exact numbers increase with each vector.
  Exact_corners(const Exact_surface<Number>& input, Flat_edges& is_flat, std::size_t most_roots,
                std::size_t most_vectors)
    : m_input(input), m_is_flat(is_flat), m_tower(most_roots), m_most_vectors(most_vectors)
  {}

  Complex number(int x) const { return real(K(x)); }
  Complex number(double x) const { return real(K(x)); }
  template <typename Lazy_number>
  Complex number(const Lazy_number& x) const
  {
    return real(K(x.exact()));
  }

  Complex scaled(Complex z, Halfedge_index h)
  {
    return m_is_open ? number(0) : z.is_zero() ? z : std::move(z) * scale(h);
  }

  // Returns numbers that are not negative, which need not be divided by their sum.
  std::array<Complex, 3> weights(const std::array<double, 3>& b) const
  {
    return {real(K(b[0])), real(K(b[1])), real(K(b[2]))};
  }

  // Returns whether the faces on both sides of `h` are one face.
  bool is_flat(Halfedge_index h) const { return m_is_flat(h); }

  Complex at_source(Halfedge_index h) { return from_source(h, m_input.mesh().prev(h)); }
  Complex at_target(Halfedge_index h) { return conj(real(scale(h)) - at_source(h)); }

  // Returns the vector from the source of `h` to the source of `other`, a halfedge of the same
  // face.
  Complex from_source(Halfedge_index h, Halfedge_index other)
  {
    m_is_open = m_is_open || ++m_number_of_vectors > m_most_vectors;
    if(other == h || m_is_open)
      return number(0);
    if(other == m_input.mesh().next(h))
      return real(scale(h));
    const Face& f = face(h);
    if(m_input.metric.points.empty())
      return {&m_tower, Element{K((square(h, 0) + square(h, 2) - square(h, 1)) * f.factor)},
              f.root};
    const auto u = exact_vector<K>(source(h), target(h), f.unit),
               v = exact_vector<K>(source(h), source(other), f.unit);
    Complex result{&m_tower, Element{K(dot(u, v) * f.factor)}, f.root};
    Root_tower<K>::multiply(result.y, K(f.sign) * cross_coordinate(u, v, f.axis));
    return result;
  }

  // Returns whether the decision is left open. Then all vectors vanish.
  bool is_open() const { return m_is_open; }

protected:
  typedef typename Complex::Element Element;

  Complex real(const K& x) const { return {&m_tower, Element{x}, Element{K(0)}}; }

  // Returns the factor of positions to which a corner of the face of `h` has contributed.
  K scale(Halfedge_index h)
  {
    const Face& f = face(h);
    if(m_input.metric.points.empty())
      return K(2) * square(h, 0) * f.factor;
    const auto u = exact_vector<K>(source(h), target(h), f.unit);
    return dot(u, u) * f.factor;
  }

  Exact_surface<Number> m_input;

private:
  // Stores the common data of the corners of a face. Up to `factor`, their imaginary parts are
  // multiples of a root.
  struct Face
  {
    std::array<K, 3> square; // the squared sides; unused with positions
    std::size_t axis = 0;    // a nonzero component of the normal, and its sign
    int sign = 0;
    double unit = 1; // coordinates in this unit have few digits
    Element root;
    K factor{1};
  };

  const Position& source(Halfedge_index h) const
  {
    return m_input.metric.points[m_input.mesh().source(h)];
  }
  const Position& target(Halfedge_index h) const
  {
    return m_input.metric.points[m_input.mesh().target(h)];
  }

  // Returns the squared length of the side with number `s`, counted from `h`.
  const K& square(Halfedge_index h, std::size_t s)
  {
    return face(h).square[(side_number(h, m_input.mesh()) + s) % 3];
  }

  const Face& face(Halfedge_index h)
  {
    const auto [place, is_new] = m_face.try_emplace(m_input.mesh().face(h));
    if(is_new)
      m_input.metric.points.empty() ? set_sides(h, place->second) : set_plane(h, place->second);
    return place->second;
  }

  // If lengths exceed the triangle inequality by rounding, the triangle is flat.
  void set_sides(Halfedge_index h, Face& f)
  {
    f.square = squared_sides<K>(m_input.mesh().halfedge(m_input.mesh().face(h)), m_input);
    set_root((std::max)(Corner_products<K>(f.square).squared_quadrupled_area, K(0)), f);
  }

  // A vector product is a multiple of the normal, which one coordinate determines.
  void set_plane(Halfedge_index h, Face& f)
  {
    auto p = corners_of_triangle(h, m_input);
    f.unit = scale_to_integers(p);
    const auto normal = cross(vector_between<K>(p[0], p[1]), vector_between<K>(p[0], p[2]));
    const auto is_zero = [&](std::size_t c) { return normal[c] == K(0); };
    while(f.axis < 2 && is_zero(f.axis))
      ++f.axis;
    f.sign = CGAL::sign(normal[f.axis]);
    if(is_zero((f.axis + 1) % 3) && is_zero((f.axis + 2) % 3)) {
      f.root = Element{K(1)};
      return;
    }
    set_root(dot(normal, normal), f);
    f.factor *= K(f.sign) * normal[f.axis];
  }

  void set_root(const K& square, Face& f)
  {
    const auto multiple = m_tower.root(square);
    m_is_open = m_is_open || !multiple;
    f.root = multiple ? multiple->root : Element{K(0)};
    f.factor = multiple ? multiple->factor : K(1);
  }

  Flat_edges& m_is_flat;
  Root_tower<K> m_tower;
  std::unordered_map<Face_index, Face> m_face;
  bool m_is_open = false;
  std::size_t m_most_vectors, m_number_of_vectors = 0;
};

// Computes corners exactly, in a field, and divides them by the squared length of their side.
// Positions are to scale, in units of the length of the first side.
template <typename K, typename Number>
class Exact_corners_to_scale : public Exact_corners<K, Number>
{
  typedef Exact_corners<K, Number> Base;

public:
  typedef typename Base::Complex Complex;
  using Base::Base;

  static Complex scaled(Complex z, Halfedge_index) { return z; }

  std::array<Complex, 3> weights(const std::array<double, 3>& b) const
  {
    const K sum = K(b[0]) + K(b[1]) + K(b[2]);
    const auto weight = [&](double x) { return this->real(K(K(x) / sum)); };
    return {weight(b[0]), weight(b[1]), weight(b[2])};
  }

  Complex at_source(Halfedge_index h) { return from_source(h, this->m_input.mesh().prev(h)); }
  Complex at_target(Halfedge_index h) { return conj(this->number(1) - at_source(h)); }
  Complex from_source(Halfedge_index h, Halfedge_index other)
  {
    return Base::from_source(h, other) * K(K(1) / this->scale(h));
  }

  Complex squared_length(Halfedge_index h) const
  {
    return this->real(exact_squared_length<K>(h, this->m_input));
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_INPUT_CORNERS_H
