// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_GEOMETRY_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_GEOMETRY_TRAITS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Ideal_strip.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Stores both sides of Equation 4.5, divided by the product of the four outer lengths. An edge
// satisfies the local ideal Delaunay condition if `inner` is not greater than `outer`. All terms
// are positive.
template <typename FT>
struct Ideal_Delaunay_condition
{
  explicit Ideal_Delaunay_condition(const Diamond<FT>& length)
  {
    const FT square = length.ij * length.ij;
    const FT k = length.jk * length.ki, l = length.il * length.lj;
    inner = square / k + square / l;
    outer = (length.jk * length.jk + length.ki * length.ki) / k +
            (length.il * length.il + length.lj * length.lj) / l;
  }

  FT inner, outer;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTraits
/// defines the geometry of ideal hyperbolic triangles whose corners are decorated with horocycles.
/// The length of an edge is its Penner length \f$\ell = e^{\lambda/2}\f$, where \f$\lambda\f$ is
/// the signed distance of the two horocycles (Section 4.1.2). Any positive numbers are the lengths
/// of a decorated triangle.
///
/// Sums, differences, products and quotients suffice; square roots do not occur. So with an exact
/// number type every length and every decision is exact. Examples are `CGAL::Exact_rational`, and
/// `CGAL::Lazy_exact_nt<CGAL::Exact_rational>`, which filters by intervals. With a floating-point
/// type an edge is flipped only if the stored lengths decide with certainty; see
/// `Is_locally_Delaunay`. `certify_ideal_Delaunay()` checks exactly afterwards.
///
/// Barycentric coordinates are coordinates in the triangle of the light-like vectors of the
/// corners, with \f$\langle q_i, q_j\rangle = -2\ell_{ij}^2\f$. One point has different
/// coordinates in different triangles: only the ray counts.
///
/// \tparam FT_ a model of `Field` and `RealEmbeddable`
/// \tparam Integer_ the signed integer type of normal coordinates
///
/// \cgalModels `IntrinsicGeometryTraits`
template <typename FT_ = double, typename Integer_ = std::int64_t>
class Ideal_geometry_traits
{
public:
  /// the number type of Penner lengths.
  typedef FT_ FT;
  /// the type of normal coordinates.
  typedef Integer_ Integer;
  /// the layout of triangle strips.
  typedef Ideal_strip<FT> Geodesic_strip;

  /// computes the length of the edge \f$kl\f$ that replaces \f$ij\f$.
  struct Compute_flipped_length
  {
    /// returns the length of \f$kl\f$ by Ptolemy's relation (Equation 4.4).
    FT operator()(const Diamond<FT>& length) const
    {
      return internal::Ptolemy_flip<FT>::flipped(length.ij, length.jk, length.ki, length.il,
                                                 length.lj);
    }
  };

  /// decides whether the edge \f$ij\f$ satisfies the local ideal Delaunay condition: the polyhedron
  /// with the two faces is convex in the light cone. Equality is a tie and kept.
  ///
  /// Both sides of Equation 4.5 are divided by the product of the four outer lengths. The condition
  /// is then \f$ \frac{\ell_{ij}^2}{\ell_{jk}\ell_{ki}} + \frac{\ell_{ij}^2}{\ell_{il}\ell_{lj}}
  /// \leq \frac{\ell_{jk}^2 + \ell_{ki}^2}{\ell_{jk}\ell_{ki}} +
  /// \frac{\ell_{il}^2 + \ell_{lj}^2}{\ell_{il}\ell_{lj}} \f$. All terms are positive. In floating
  /// point an edge counts as non-Delaunay only if it is non-Delaunay for all lengths within
  /// `rounding_unit()` of the stored ones. These change a term on the left by four such units. A
  /// term on the right is a sum of quotients of two lengths, and changes by two. So an edge that
  /// has just been flipped is never flipped back.
  /// \cgalModels `LocalDelaunayPredicate`
  struct Is_locally_Delaunay
  {
    /// returns whether the edge is Delaunay.
    bool operator()(const Diamond<FT>& length) const
    {
      const internal::Ideal_Delaunay_condition<FT> condition(length);
      // The seventh unit covers the rounding of this function, at most four on each side.
      return !(condition.inner > condition.outer * (1 + 7 * rounding_unit<FT>()));
    }

    /// returns whether the edge is Delaunay; there is no cheaper form.
    bool is_certain(const Diamond<FT>& length) const { return (*this)(length); }
  };

  /// returns `true`, since every edge can be flipped: the union of two ideal triangles is always
  /// strictly convex.
  struct Is_convex
  {
    /// returns `true`.
    bool operator()(const Diamond<FT>&) const { return true; }
  };

  /// decides whether a number can be the length of an edge. It must be positive and finite, and so
  /// must be sums of two products of two such numbers.
  struct Is_length
  {
    /// returns whether `length` can be the length of an edge.
    bool operator()(const FT& length) const
    {
      if constexpr(std::numeric_limits<FT>::has_infinity) {
        const FT square = length * length;
        return length > 0 && square >= (std::numeric_limits<FT>::min)() &&
               4 * square <= (std::numeric_limits<FT>::max)();
      } else
        return length > 0;
    }
  };

  /// returns `true`, since there is no triangle inequality.
  struct Is_triangle
  {
    /// returns `true`.
    bool operator()(const FT&, const FT&, const FT&) const { return true; }
  };

  /// returns the function object.
  Compute_flipped_length compute_flipped_length_object() const { return {}; }
  /// returns the function object.
  Is_locally_Delaunay is_locally_Delaunay_object() const { return {}; }
  /// returns the function object.
  Is_convex is_convex_object() const { return {}; }
  /// returns the function object.
  Is_length is_length_object() const { return {}; }
  /// returns the function object.
  Is_triangle is_triangle_object() const { return {}; }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_GEOMETRY_TRAITS_H
