// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_GEOMETRY_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_GEOMETRY_TRAITS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Ideal_strip.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <array>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// the geometry of ideal hyperbolic triangles (Section 4.1.2). The length of an edge is
/// \f$\ell = e^{\lambda/2}\f$, with its Penner coordinate \f$\lambda\f$; it can be any positive number.
///
/// All formulas are sums, products and quotients of positive numbers: floating point loses no digits, and
/// with an exact field, such as rational numbers, all is exact. No root is drawn.
///
/// \tparam FT_ a model of `Field` and `RealEmbeddable`
/// \tparam Integer_ the signed integer type of normal coordinates
///
/// \cgalModels `IntrinsicGeometryTraits`
template <typename FT_ = double, typename Integer_ = std::int64_t>
class Ideal_geometry_traits
{
public:
  /// the number type of lengths.
  typedef FT_ FT;
  /// the type of normal coordinates.
  typedef Integer_ Integer;
  /// the layout of triangle strips.
  typedef Ideal_strip<FT> Geodesic_strip;

  /// computes the length of the edge \f$kl\f$ that replaces \f$ij\f$: a Ptolemy flip (Equation 4.4).
  struct Compute_flipped_length
  {
    /// returns the length of \f$kl\f$.
    FT operator()(const Diamond<FT>& length) const
    {
      return (length.ki * length.lj + length.jk * length.il) / length.ij;
    }
  };

  /// decides whether the edge \f$ij\f$ satisfies the local ideal Delaunay condition (Equation 4.5), or the
  /// tie. In floating point an edge counts as non-Delaunay only if it is so for all lengths within
  /// `rounding_unit()` of the stored ones: an edge that has just been flipped is never flipped back.
  struct Is_locally_Delaunay
  {
    /// returns whether the edge is Delaunay.
    bool operator()(const Diamond<FT>& length) const
    {
      const FT at_ij = length.ij * length.ij * (length.jk * length.ki + length.il * length.lj);
      const FT at_kl = (length.il * length.ki + length.jk * length.lj) *
                       (length.il * length.jk + length.ki * length.lj);
      // each side has four factors with an error; the rest is for the operations here
      return !(at_ij > at_kl * (1 + 9 * rounding_unit<FT>()));
    }
  };

  /// decides whether the diamond is strictly convex: two ideal triangles always are.
  struct Is_convex
  {
    /// returns true.
    bool operator()(const Diamond<FT>&) const { return true; }
  };

  /// decides whether a number can be the length of an edge: it is positive and finite, and so is its
  /// eighth power, beyond the degree of all formulas.
  struct Is_length
  {
    /// returns whether `length` can be the length of an edge.
    bool operator()(const FT& length) const
    {
      if constexpr(std::numeric_limits<FT>::is_iec559) {
        const FT square = length * length, power = square * square * square * square;
        return length > 0 && power >= (std::numeric_limits<FT>::min)() &&
               power <= (std::numeric_limits<FT>::max)();
      } else
        return length > 0;
    }
  };

  /// stands for the distance of two points of a triangle, which only vertices inside triangles have:
  /// there are none in ideal geometry.
  struct Compute_distance
  {
    /// returns zero, which is no length.
    FT operator()(const std::array<FT, 3>&, const std::array<FT, 3>&,
                  const std::array<FT, 3>&) const
    {
      return FT(0);
    }
  };

  /// decides whether three lengths can be those of a triangle: all are.
  struct Is_triangle
  {
    /// returns true.
    bool operator()(const FT&, const FT&, const FT&) const { return true; }
  };

  /// returns the function object.
  Compute_flipped_length compute_flipped_length_object() const { return {}; }
  /// returns the function object.
  Compute_distance compute_distance_object() const { return {}; }
  /// returns the function object.
  Is_locally_Delaunay is_locally_Delaunay_object() const { return {}; }
  /// returns the function object.
  Is_convex is_convex_object() const { return {}; }
  /// returns the function object.
  Is_length is_length_object() const { return {}; }
  /// returns the function object.
  Is_triangle is_triangle_object() const { return {}; }
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_GEOMETRY_TRAITS_H
