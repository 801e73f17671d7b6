// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_NORMAL_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_NORMAL_COORDINATES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// holds five values on the edges of a diamond: the edge \f$ij\f$ and the four other sides of its
/// faces \f$ijk\f$ and \f$jil\f$.
template <typename T>
struct Diamond
{
  T ij, ///< on the edge
    jk, ///< on the side after it in \f$ijk\f$
    ki, ///< on the side before it in \f$ijk\f$
    il, ///< on the side after it in \f$jil\f$
    lj; ///< on the side before it in \f$jil\f$
};

namespace internal {

// Returns the values of `of` on the halfedge `h` and the four other sides of its faces.
template <typename Function, typename Halfedge, typename Mesh>
auto diamond_of(const Function& of, Halfedge h, const Mesh& mesh)
{
  const Halfedge o = mesh.opposite(h);
  return Diamond<decltype(of(h))>{of(h), of(mesh.next(h)), of(mesh.prev(h)), of(mesh.next(o)),
                                  of(mesh.prev(o))};
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// returns \f$n^+ = \max(n, 0)\f$, the number of transversal crossings.
template <typename Integer>
Integer crossings(const Integer& n)
{
  return n < 0 ? Integer(0) : n;
}

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// returns \f$n^- = -\min(n, 0)\f$, one on a shared edge and zero elsewhere.
template <typename Integer>
int is_shared(const Integer& n)
{
  return n < 0 ? 1 : 0;
}

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// returns the number \f$e\f$ of curves that start at a corner of a triangle and cross the
/// opposite side (Equation 3.1). Arguments are the crossings of that side and of the two sides at
/// the corner.
template <typename Integer>
Integer curves_leaving(const Integer& opposite, const Integer& right, const Integer& left)
{
  const Integer excess = static_cast<Integer>(opposite - right - left);
  return excess < 0 ? Integer(0) : excess;
}

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// returns the number \f$c\f$ of curves that cut off a corner of a triangle (Equation 3.2).
/// Arguments are the crossings of the opposite side and of the two sides at the corner.
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
/// returns whether three numbers of crossings are valid on the sides of a triangle (Section
/// 3.1.1). If they obey the triangle inequality, their sum must be even.
template <typename Integer>
bool are_valid_crossings(const Integer& a, const Integer& b, const Integer& c)
{
  const bool obey = a <= b + c && b <= c + a && c <= a + b;
  return a >= 0 && b >= 0 && c >= 0 && (!obey || (a + b + c) % 2 == 0);
}

namespace internal {

// Stores the numbers e and c (Equations 3.1, 3.2) of all corners of a triangle. Corner s is
// opposite to side s.
template <typename Integer>
struct Corner_counts
{
  std::array<Integer, 3> leaving, around;

  explicit Corner_counts(const std::array<Integer, 3>& crossings)
  {
    std::array<Integer, 3> excess;
    for(std::size_t s = 0; s < 3; ++s) {
      excess[s] =
        static_cast<Integer>(crossings[s] - crossings[(s + 1) % 3] - crossings[(s + 2) % 3]);
      leaving[s] = excess[s] < 0 ? Integer(0) : excess[s];
    }
    // If one corner has curves that leave it, no curves leave the others, and this number is zero
    // at them.
    for(std::size_t s = 0; s < 3; ++s)
      around[s] = static_cast<Integer>(
        (leaving[s] - excess[s] - leaving[(s + 1) % 3] - leaving[(s + 2) % 3]) / 2);
  }
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// returns the normal coordinate of \f$kl\f$ after \f$ij\f$ has been flipped (Equation 3.4).
template <typename Integer>
Integer flipped_normal_coordinate(const Diamond<Integer>& n)
{
  const auto distance = [](const Integer& a, const Integer& b) { return a < b ? b - a : a - b; };
  if(!(n.ij > 0 || n.jk > 0 || n.ki > 0 || n.il > 0 || n.lj > 0))
    return Integer(is_shared(n.ij)); // nothing crosses the diamond: frequent, and faster
  // Corners 0 are k and l. Corner 1 of ijk and corner 2 of jil are at i.
  const Integer ij = crossings(n.ij);
  const internal::Corner_counts<Integer> k({ij, crossings(n.jk), crossings(n.ki)});
  const internal::Corner_counts<Integer> l({ij, crossings(n.il), crossings(n.lj)});
  const auto passing = distance(k.around[1], l.around[2]) + distance(k.around[2], l.around[1]);
  const auto leaving_ij = k.leaving[1] + k.leaving[2] + l.leaving[1] + l.leaving[2];
  return static_cast<Integer>(k.around[0] + l.around[0] +
                              (passing - k.leaving[0] - l.leaving[0]) / 2 + leaving_ij +
                              is_shared(n.ij));
}

namespace internal {

// Checks that `n` does not exceed the largest normal coordinate that is stored. The sums of the
// formulas above then stay within the range of the type.
template <typename Integer>
void check_range(const Integer& n)
{
  if constexpr(std::numeric_limits<Integer>::is_bounded)
    if(n > (std::numeric_limits<Integer>::max)() / 16)
      throw Overflow_error("a normal coordinate exceeds the range of its integer type");
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_NORMAL_COORDINATES_H
