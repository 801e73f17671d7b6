// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_NORMAL_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_NORMAL_COORDINATES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <limits>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// five values on the edges of a diamond: the edge \f$ij\f$ and the four other sides of its faces
/// \f$ijk\f$ and \f$jil\f$.
template <typename T>
struct Diamond
{
  T ij, ///< on the edge
    jk, ///< on the side after it in \f$ijk\f$
    ki, ///< on the side before it in \f$ijk\f$
    il, ///< on the side after it in \f$jil\f$
    lj; ///< on the side before it in \f$jil\f$
};

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// \f$n^+ = \max(n, 0)\f$, the number of transversal crossings.
template <typename Integer>
Integer crossings(const Integer& n)
{
  return n < 0 ? Integer(0) : n;
}

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// \f$n^- = -\min(n, 0)\f$, one on a shared edge and zero elsewhere.
template <typename Integer>
int is_shared(const Integer& n)
{
  return n < 0 ? 1 : 0;
}

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// the number \f$e\f$ of curves that start at a corner of a triangle and cross the opposite side
/// (Equation 3.1), from the crossings of that side and of the two sides at the corner.
template <typename Integer>
Integer curves_leaving(const Integer& opposite, const Integer& right, const Integer& left)
{
  const Integer excess = static_cast<Integer>(opposite - right - left);
  return excess < 0 ? Integer(0) : excess;
}

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// the number \f$c\f$ of curves that cut off a corner of a triangle (Equation 3.2), from the crossings
/// of the opposite side and of the two sides at the corner.
template <typename Integer>
Integer curves_around(const Integer& opposite, const Integer& right, const Integer& left)
{
  const Integer excess = static_cast<Integer>(right + left - opposite);
  if(!(excess > 0))
    return Integer(0);
  const Integer leaving = static_cast<Integer>(curves_leaving(right, left, opposite) +
                                               curves_leaving(left, opposite, right));
  return static_cast<Integer>((excess - leaving) / 2);
}

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// says whether three numbers of crossings are possible on the sides of a triangle (Section 3.1.1): if
/// they obey the triangle inequality, their sum must be even.
template <typename Integer>
bool are_valid_crossings(const Integer& a, const Integer& b, const Integer& c)
{
  const bool obey = a <= b + c && b <= c + a && c <= a + b;
  return a >= 0 && b >= 0 && c >= 0 && (!obey || (a + b + c) % 2 == 0);
}

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// the normal coordinate of \f$kl\f$ after \f$ij\f$ has been flipped (Equation 3.4).
template <typename Integer>
Integer flipped_normal_coordinate(const Diamond<Integer>& n)
{
  const Integer ij = crossings(n.ij), jk = crossings(n.jk), ki = crossings(n.ki),
                il = crossings(n.il), lj = crossings(n.lj);
  const auto distance = [](const Integer& a, const Integer& b) { return a < b ? b - a : a - b; };
  // in each face the corner at i, the corner at j and the apex
  const Integer around_i_k = curves_around(jk, ij, ki), around_i_l = curves_around(lj, il, ij);
  const Integer around_j_k = curves_around(ki, jk, ij), around_j_l = curves_around(il, ij, lj);
  const Integer around_k = curves_around(ij, ki, jk), around_l = curves_around(ij, lj, il);
  const auto leaving_ij = curves_leaving(jk, ij, ki) + curves_leaving(lj, il, ij) +
                          curves_leaving(ki, jk, ij) + curves_leaving(il, ij, lj);
  const auto leaving_kl = curves_leaving(ij, ki, jk) + curves_leaving(ij, lj, il);
  const auto passing = distance(around_j_l, around_j_k) + distance(around_i_l, around_i_k);
  return static_cast<Integer>(around_l + around_k + (passing - leaving_kl) / 2 + leaving_ij +
                              is_shared(n.ij));
}

namespace internal {

// The largest normal coordinate that is stored: the sums of the formulas above stay within the type.
template <typename Integer>
void check_range(const Integer& n)
{
  if constexpr(std::numeric_limits<Integer>::is_bounded)
    if(n > (std::numeric_limits<Integer>::max)() / 16)
      throw Overflow_error("a normal coordinate exceeds the range of its integer type");
}

} // namespace internal

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_NORMAL_COORDINATES_H
