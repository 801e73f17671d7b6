// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_SQUARES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_SQUARES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>
#ifdef CGAL_USE_GMP
#include <CGAL/Gmpq.h>
#include <CGAL/Mpzf.h>
#else
#include <CGAL/Exact_rational.h>
#endif
#ifndef CGAL_HAS_MPZF
#include <CGAL/MP_Float.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Where sums and products of numbers of type `double` are exact, and where quotients are. CGAL's own
// types compile faster than those that it selects.
#ifdef CGAL_HAS_MPZF
typedef Mpzf Exact_ring;
#else
typedef MP_Float Exact_ring;
#endif
#ifdef CGAL_USE_GMP
typedef Gmpq Exact_field;
#else
typedef Exact_rational Exact_field;
#endif

template <typename R>
R squared_distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  const std::array<R, 3> u = vector_between<R>(p, q);
  return dot(u, u);
}

// Multiplies coordinates with a power of two that makes all of them whole numbers, if it is in range.
inline void scale_to_integers(std::array<std::array<double, 3>, 3>& points)
{
  int least = std::numeric_limits<int>::max();
  int greatest = 0;
  for(const auto& p : points)
    for(double x : p)
      if(x != 0) {
        int exponent;
        std::frexp(x, &exponent);
        least = (std::min)(least, exponent);
        greatest = (std::max)(greatest, exponent);
      }
  const int shift = std::numeric_limits<double>::digits - least;
  if(greatest + shift < std::numeric_limits<double>::max_exponent)
    for(auto& p : points)
      for(double& x : p)
        x = std::ldexp(x, shift);
}

// Returns the sign of pi minus the sum of the angles opposite to ij, from squared lengths: of
// cos_k sin_l + cos_l sin_k. Only one root of each angle enters, so that squaring decides.
template <typename R>
Sign compare_opposite_angles(const Diamond<R>& square)
{
  const R cos_k = square.jk + square.ki - square.ij, cos_l = square.il + square.lj - square.ij;
  const Sign sign_k = CGAL::sign(cos_k), sign_l = CGAL::sign(cos_l);
  if(sign_k * sign_l != NEGATIVE)
    return sign_k == ZERO ? sign_l : sign_k;
  const R square_k = cos_k * cos_k, square_l = cos_l * cos_l;
  const R product_k = square.jk * square.ki, product_l = square.il * square.lj;
  // squared sines, times 4 p q in each triangle
  const R four(4);
  return sign_k * CGAL::sign(R(square_k * (four * product_l - square_l) -
                               square_l * (four * product_k - square_k)));
}

// the determinant of three vectors and the scalar product of the normals of two triangles at the
// first one
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

// Returns whether the two faces at the edge of `h` in T1 lie in one plane, side by side.
inline bool is_flat_in_space(Halfedge_index h, const std::vector<std::array<double, 3>>& points,
                             const Delta_complex& input)
{
  const auto &i = points[input.source(h)], &j = points[input.target(h)];
  const auto& k = points[input.target(input.next(h))];
  const auto& l = points[input.target(input.next(input.opposite(h)))];
  const auto hinge = [&](auto number) {
    typedef decltype(number) R;
    return Hinge<R>(vector_between<R>(i, j), vector_between<R>(i, k), vector_between<R>(i, l));
  };
  const auto norm = [&](const std::array<double, 3>& p) {
    return CGAL::abs(p[0] - i[0]) + CGAL::abs(p[1] - i[1]) + CGAL::abs(p[2] - i[2]);
  };
  // the determinant has a relative error of less than 16 units of roundoff
  const double error = 8 * std::numeric_limits<double>::epsilon() * norm(j) * norm(k) * norm(l);
  if(CGAL::abs(hinge(double()).volume) > error + (std::numeric_limits<double>::min)())
    return false;
  const auto exact = hinge(Exact_ring());
  return CGAL::is_zero(exact.volume) && CGAL::is_positive(exact.cosine);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_SQUARES_H
