// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EUCLIDEAN_GEOMETRY_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EUCLIDEAN_GEOMETRY_TRAITS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// defines the geometry of triangles that are flat and Euclidean.
///
/// With an exact number type every decision is exact. With a floating-point type decisions have a
/// one-sided tolerance of `rounding_unit()`. An edge is flipped only if the stored lengths decide
/// with certainty; see `Is_locally_Delaunay`.
///
/// \tparam FT_ a model of `FieldWithSqrt` and `RealEmbeddable`
/// \tparam Integer_ the signed integer type of normal coordinates
///
/// \cgalModels `IntrinsicGeometryTraitsWithDistance`
template <typename FT_ = double, typename Integer_ = std::int64_t>
class Euclidean_geometry_traits
{
public:
  /// the number type of lengths.
  typedef FT_ FT;
  /// the type of normal coordinates.
  typedef Integer_ Integer;
  /// the layout of triangle strips.
  typedef Euclidean_strip<FT> Geodesic_strip;

  /// computes the length of the edge \f$kl\f$ that replaces \f$ij\f$. Both triangles are laid out
  /// in the plane along \f$ij\f$, with all lengths multiplied by \f$2 \ell_{ij}\f$ until the end.
  struct Compute_flipped_length
  {
    /// returns the length of \f$kl\f$.
    FT operator()(const Diamond<FT>& length) const
    {
      using CGAL::sqrt; // or the one of `FT`
      const FT x = scaled_distance_of_feet(length);
      const FT height_k = squared_quadrupled_area(length.ij, length.jk, length.ki);
      const FT height_l = squared_quadrupled_area(length.ij, length.lj, length.il);
      // Terms known before the first root come first, and the quotient needs no root, because roots
      // are slow.
      const FT scaled_square = x * x + (height_k + height_l) + 2 * sqrt(height_k * height_l);
      return sqrt(scaled_square) * (FT(1) / (2 * length.ij));
    }

  private:
    // Returns the scaled distance of the feet. The four squares can be paired in two ways. One
    // loses no digits if i and j are close, the other if k and l are close. The pairs with the
    // smaller differences are used.
    static FT scaled_distance_of_feet(const Diamond<FT>& length)
    {
      using CGAL::abs; // or the one of `FT`
      const FT at_k = scaled_foot(length.jk, length.ki), at_l = scaled_foot(length.lj, length.il);
      if constexpr(internal::is_rounded<FT>()) {
        const FT at_i = scaled_foot(length.il, length.ki), at_j = scaled_foot(length.lj, length.jk);
        const bool are_k_and_l_near = abs(at_i) + abs(at_j) < abs(at_k) + abs(at_l);
        return are_k_and_l_near ? at_i - at_j : at_k - at_l;
      }
      return at_k - at_l;
    }
  };

private:
  // Represents a corner of a triangle by the two sides at it and the opposite side.
  struct Corner
  {
    FT p, q, opposite;

    // Returns the cosine times 2 p q, and the squared sine times (2 p q)^2. If `u` is positive,
    // both belong to a smaller angle. They are increased as much as a relative error `u` of the
    // sides allows. If `u` is negative, they belong to a larger angle, as long as the angle is
    // obtuse.
    FT cosine(const FT& u) const
    {
      const FT sides = p * p + q * q, square = opposite * opposite;
      return sides - square + u * (sides + square);
    }
    FT squared_sine(const FT& u) const
    {
      // Each slack of the triangle inequality changes by at most this value.
      const FT change = u * (p + q + opposite);
      const FT slack_p = positive(opposite + (q - p) + change);
      const FT slack_q = positive(opposite - (q - p) + change);
      return (p + q + opposite) * slack_p * slack_q * positive(p + (q - opposite) + change);
    }

    static FT positive(const FT& x) { return x > 0 ? x : FT(0); }
  };

  // Compares the sum of two angles with pi. The sum is decreased as much as a relative error `u` of
  // the sides allows (increased, if `u` is negative).
  static Sign compare_sum_with_pi(const Corner& a, const Corner& b, const FT& u)
  {
    const FT cos_a = a.cosine(u), cos_b = b.cosine(u);
    if(!(cos_a < 0) && !(cos_b < 0))
      return cos_a + cos_b == FT(0) ? ZERO : NEGATIVE;
    if(!(cos_a > 0) && !(cos_b > 0))
      return POSITIVE;
    const Corner &obtuse = cos_a < 0 ? a : b, &other = cos_a < 0 ? b : a;
    const FT cos_obtuse = cos_a < 0 ? cos_a : cos_b, cos_other = cos_a < 0 ? cos_b : cos_a;
    const FT excess = cos_obtuse * cos_obtuse * other.squared_sine(-u) -
                      cos_other * cos_other * obtuse.squared_sine(u);
    return excess < 0 ? NEGATIVE : excess > 0 ? POSITIVE : ZERO;
  }

public:
  /// decides whether the edge \f$ij\f$ satisfies the local Delaunay condition (Equation 2.6).
  ///
  /// The angles at \f$k\f$ and \f$l\f$ have a sum of more than \f$\pi\f$ if one of them, at \f$k\f$
  /// say, is obtuse, and \f$\cos\theta_l \sin\theta_k < -\cos\theta_k \sin\theta_l\f$. In floating
  /// point, an edge counts as non-Delaunay only if it is non-Delaunay for all lengths within
  /// `rounding_unit()` of the stored ones. So ties are kept, and an edge that has just been flipped
  /// is not flipped back. The longest side of a triangle of zero area is flipped.
  /// \cgalModels `LocalDelaunayPredicate`
  struct Is_locally_Delaunay
  {
    /// the relative error that is granted to every length.
    FT error = rounding_unit<FT>();

    /// returns whether the edge is Delaunay.
    bool operator()(const Diamond<FT>& length) const
    {
      // Except for near ties, the cosines decide, which are cheap. Near 0 and pi, cosines hardly
      // change, and only the sines can decide.
      if(is_certain(length))
        return true;
      if(is_surely_less(outer(length), inner(length)))
        return false;
      return compare_sum_with_pi({length.jk, length.ki, length.ij},
                                 {length.lj, length.il, length.ij}, error) != POSITIVE;
    }

    /// returns whether the edge is Delaunay and far from a tie. Branch-free: in loops over all
    /// edges, where the answer is unpredictable, this is several times faster.
    bool is_certain(const Diamond<FT>& length) const
    {
      return is_surely_less(inner(length), outer(length));
    }

  private:
    // The sum of the cosines at k and l, times twice the product of the outer sides, is outer -
    // inner.
    static FT outer(const Diamond<FT>& length)
    {
      return (length.jk * length.jk + length.ki * length.ki) * (length.il * length.lj) +
             (length.il * length.il + length.lj * length.lj) * (length.jk * length.ki);
    }
    static FT inner(const Diamond<FT>& length)
    {
      return length.ij * length.ij * (length.jk * length.ki + length.il * length.lj);
    }

    // Each side changes by four errors with the lengths. The rest covers the rounding of this
    // function.
    bool is_surely_less(const FT& x, const FT& y) const { return (1 + 10 * error) * x < y; }
  };

  /// decides whether the diamond is strictly convex at \f$i\f$ and \f$j\f$, so that \f$ij\f$ can
  /// be flipped. In floating point, it must be strictly convex for all lengths within
  /// `rounding_unit()` of the stored ones.
  struct Is_convex
  {
    /// returns whether the diamond is convex.
    bool operator()(const Diamond<FT>& length) const
    {
      const FT u = -rounding_unit<FT>();
      const Corner i_k{length.ij, length.ki, length.jk}, i_l{length.ij, length.il, length.lj};
      const Corner j_k{length.ij, length.jk, length.ki}, j_l{length.ij, length.lj, length.il};
      return compare_sum_with_pi(i_k, i_l, u) == NEGATIVE &&
             compare_sum_with_pi(j_k, j_l, u) == NEGATIVE;
    }
  };

  /// decides whether a number can be the length of an edge. It must be positive, and its eighth
  /// power must be in the range of the type, since it occurs in the formulas of this class. For
  /// `double` the length is between \f$2^{-127}\f$ and \f$2^{127}\f$.
  struct Is_length
  {
    /// returns whether `length` can be the length of an edge.
    bool operator()(const FT& length) const
    {
      if constexpr(std::numeric_limits<FT>::is_iec559) {
        constexpr FT greatest =
          internal::power_of_two<FT>(std::numeric_limits<FT>::max_exponent / 8 - 1);
        return length >= 1 / greatest && length <= greatest;
      } else
        return length > 0;
    }
  };

  /// computes the distance of two points of a triangle (Equation 3.7).
  struct Compute_distance
  {
    /// returns the distance of the points with barycentric coordinates `p` and `q`; side `s` leads
    /// from corner `s` to the next and has length `side[s]`.
    FT operator()(const std::array<FT, 3>& side, const std::array<FT, 3>& p,
                  const std::array<FT, 3>& q) const
    {
      return vector_length(side, {q[0] - p[0], q[1] - p[1], q[2] - p[2]});
    }
  };

  /// decides whether three lengths obey the triangle inequality; equality, to within the
  /// rounding of the lengths, is a degenerate triangle and allowed.
  struct Is_triangle
  {
    /// returns whether there is a triangle with these sides.
    bool operator()(const FT& a, const FT& b, const FT& c) const
    {
      const FT slack = (std::min)({b + c - a, c + a - b, a + b - c});
      return !(slack < -rounding_unit<FT>() * (a + b + c));
    }
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

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EUCLIDEAN_GEOMETRY_TRAITS_H
