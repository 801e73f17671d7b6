// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_SQUARES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_SQUARES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact_numbers.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Direct_mapped_cache.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

typedef std::array<double, 3> Position;

template <typename R>
R squared_distance(const Position& p, const Position& q)
{
  const std::array<R, 3> u = vector_between<R>(p, q);
  return dot(u, u);
}

inline std::array<Position, 4>
corner_positions(Halfedge_index h, const std::vector<Position>& points, const Delta_complex& mesh)
{
  return {points[mesh.source(h)], points[mesh.target(h)], points[mesh.target(mesh.next(h))],
          points[mesh.target(mesh.next(mesh.opposite(h)))]};
}

// Returns the exponent of the last binary digit of `x` that is not zero.
inline int last_exponent(double x)
{
  constexpr int digits = std::numeric_limits<double>::digits;
  int exponent;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), digits));
  return exponent - digits + std::ilogb(static_cast<double>(mantissa & -mantissa));
}

// Multiplies coordinates by the least power of two that makes all of them integers, if they stay in
// range. Returns this power, or a smaller power that keeps them in range.
template <std::size_t n>
double scale_to_integers(std::array<Position, n>& points)
{
  int last = (std::numeric_limits<int>::max)(), first = (std::numeric_limits<int>::min)();
  for(const Position& p : points)
    for(double x : p)
      if(x != 0) {
        last = (std::min)(last, last_exponent(x));
        first = (std::max)(first, std::ilogb(x));
      }
  constexpr int limit = std::numeric_limits<double>::max_exponent;
  if(first < last || first - last >= limit)
    return 1;
  for(Position& p : points)
    for(double& x : p)
      x = std::ldexp(x, -last);
  return std::ldexp(1., std::clamp(-last, 2 - limit, limit - 1));
}

// Returns (x - y) * unit for a power of two `unit`. Exact numbers are avoided if the result is a
// number of type `double`.
template <typename R>
R scaled_difference(double x, double y, double unit)
{
  const Double_double difference = Double_double::exact_sum(x, -y);
  const double scaled = difference.high() * unit;
  return difference.low() == 0 && scaled / unit == difference.high() ? R(scaled)
                                                                     : R((R(x) - R(y)) * R(unit));
}

// Returns a vector between positions, multiplied by a power of two.
template <typename R>
std::array<R, 3> exact_vector(const Position& p, const Position& q, double unit = 1)
{
  const auto coordinate = [&](std::size_t c) { return scaled_difference<R>(q[c], p[c], unit); };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

// Stores a corner of a triangle: the scalar product of its sides and the product of their squares,
// or both numbers times 2 and 4.
template <typename R>
struct Corner_cosine
{
  R product, square;
};

// Returns the sign of pi minus the sum of two angles. It is the sign of cos_k sin_l + cos_l sin_k.
// Each angle contributes only one root, so that squaring decides.
template <typename R>
Sign compare_with_pi(const Corner_cosine<R>& k, const Corner_cosine<R>& l)
{
  const Sign sign_k = CGAL::sign(k.product), sign_l = CGAL::sign(l.product);
  if(sign_k * sign_l != NEGATIVE)
    return sign_k == ZERO ? sign_l : sign_k;
  return sign_k *
         CGAL::sign(R(k.product * k.product * l.square - l.product * l.product * k.square));
}

// Returns the sign of pi minus the sum of the angles opposite to ij, from squared lengths.
template <typename R>
Sign compare_opposite_angles(const Diamond<R>& square)
{
  const auto corner = [](const R& a, const R& b, const R& opposite) {
    return Corner_cosine<R>{a + b - opposite, R(4) * a * b};
  };
  return compare_with_pi(corner(square.jk, square.ki, square.ij),
                         corner(square.il, square.lj, square.ij));
}

template <typename R>
Corner_cosine<R> corner_cosine(const Position& i, const Position& k, const Position& j)
{
  const auto u = exact_vector<R>(k, i), v = exact_vector<R>(k, j);
  return {dot(u, v), dot(u, u) * dot(v, v)};
}

// Returns the sign of a sum. The rounding errors of partial sums are added up, too.
template <std::size_t n>
Sign sign_of_sum(std::array<double, n> x)
{
  for(std::size_t i = 1; i < n; ++i)
    for(std::size_t j = 0; j < i; ++j) {
      const Double_double sum = Double_double::exact_sum(x[i], x[j]);
      x[i] = sum.high();
      x[j] = sum.low();
    }
  const auto last = std::find_if(x.rbegin(), x.rend(), [](double y) { return y != 0; });
  return last == x.rend() ? ZERO : CGAL::sign(*last);
}

// Returns the sign of a sum of three products and their rounding errors, which come first. If
// coordinates have few digits, only the last sum is rounded, and its sign is correct.
inline Sign sign_of_products(const std::array<double, 6>& x)
{
  const Double_double sum = Double_double::exact_sum(x[3], x[4]);
  return x[0] == 0 && x[1] == 0 && x[2] == 0 && sum.low() == 0 ? CGAL::sign(sum.high() + x[5])
                                                               : sign_of_sum(x);
}

// Returns the sign of the scalar product of k - i and k - j. The differences must be numbers of
// type `double`, or the product clearly not zero. Products near the ends of the range are not
// considered.
inline Uncertain<Sign> sign_of_cosine(const Position& i, const Position& k, const Position& j)
{
  double sum = 0, size = 0;
  for(std::size_t c = 0; c < 3; ++c) {
    const double product = (k[c] - i[c]) * (k[c] - j[c]);
    sum += product;
    size += CGAL::abs(product);
  }
  if(CGAL::abs(sum) > 8 * std::numeric_limits<double>::epsilon() * size + 1e-250)
    return CGAL::sign(sum);
  std::array<double, 6> terms;
  bool is_exact = true;
  for(std::size_t c = 0; c < 3; ++c) {
    const Double_double u = Double_double::exact_sum(k[c], -i[c]),
                        v = Double_double::exact_sum(k[c], -j[c]),
                        product = Double_double::exact_product(u.high(), v.high());
    terms[c] = product.low();
    terms[c + 3] = product.high();
    is_exact = is_exact && u.low() == 0 && v.low() == 0 &&
               CGAL::abs(u.high()) + CGAL::abs(v.high()) < 1e150 &&
               (u.high() == 0 || v.high() == 0 || CGAL::abs(product.high()) > 1e-250);
  }
  return is_exact ? Uncertain<Sign>(sign_of_products(terms)) : Uncertain<Sign>::indeterminate();
}

// Returns the sign of pi minus the sum of the angles at k and l opposite to ij. Most ties are right
// angles.
inline Sign compare_opposite_angles(const Position& i, const Position& j, const Position& k,
                                    const Position& l)
{
  const Uncertain<Sign> sign_k = sign_of_cosine(i, k, j), sign_l = sign_of_cosine(i, l, j);
  if(is_certain(sign_k) && is_certain(sign_l) && get_certain(sign_k) == get_certain(sign_l))
    return get_certain(sign_k);
  return compare_with_pi(corner_cosine<Exact_ring>(i, k, j), corner_cosine<Exact_ring>(i, l, j));
}

// Stores the determinant of three vectors, and the scalar product of the normals of two triangles
// at the first vector.
template <typename R>
struct Hinge
{
  R volume, cosine;

  Hinge(const std::array<R, 3>& ij, const std::array<R, 3>& ik, const std::array<R, 3>& il)
  {
    const std::array<R, 3> normal = cross(ij, ik);
    volume = dot(normal, il);
    cosine = dot(normal, cross(il, ij));
  }
};

// Returns whether the triangles ijk and jil lie in one plane, side by side.
inline bool is_flat_in_space(const Position& i, const Position& j, const Position& k,
                             const Position& l)
{
  const auto hinge = [&](auto number) {
    typedef decltype(number) R;
    return Hinge<R>(vector_between<R>(i, j), vector_between<R>(i, k), vector_between<R>(i, l));
  };
  const auto norm = [&](const Position& p) {
    return CGAL::abs(p[0] - i[0]) + CGAL::abs(p[1] - i[1]) + CGAL::abs(p[2] - i[2]);
  };
  // The determinant has a relative error of less than 16 units of roundoff, and the scalar product
  // has less than 32.
  const double error = 8 * std::numeric_limits<double>::epsilon() * norm(j) * norm(k) * norm(l);
  const Hinge<double> rounded = hinge(double());
  if(CGAL::abs(rounded.volume) > error + (std::numeric_limits<double>::min)())
    return false;
  bool is_axial = false;
  for(std::size_t c = 0; c < 3; ++c)
    is_axial = is_axial || (i[c] == j[c] && i[c] == k[c] && i[c] == l[c]);
  if(is_axial && rounded.cosine > 2 * error * norm(j) + 1e-250)
    return true;
  const auto exact = hinge(Exact_ring());
  return CGAL::is_zero(exact.volume) && CGAL::is_positive(exact.cosine);
}

// Determines the edges of T1 whose two faces are coplanar and lie side by side.
class Flat_edges
{
public:
  Flat_edges(const std::vector<Position>& points, const Delta_complex& mesh)
    : m_points(points), m_mesh(mesh)
  {}

  // Returns whether the edge of `h`, which is not on the boundary, is flat. Returns false without
  // positions.
  bool operator()(Halfedge_index h)
  {
    return !m_points.empty() && m_is_flat(std::size_t(Edge_index(h).idx()), [&] {
      const auto [i, j, k, l] = corner_positions(h, m_points, m_mesh);
      return is_flat_in_space(i, j, k, l);
    });
  }

private:
  const std::vector<Position>& m_points;
  const Delta_complex& m_mesh;
  Direct_mapped_cache<bool> m_is_flat;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_SQUARES_H
