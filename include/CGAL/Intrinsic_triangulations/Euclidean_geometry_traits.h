// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EUCLIDEAN_GEOMETRY_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EUCLIDEAN_GEOMETRY_TRAITS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Euclidean_strip.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// the geometry of triangles that are flat and Euclidean.
///
/// With an exact number type every decision is exact. With a floating point type a decision is taken
/// only where its sign is certain for the stored lengths; see `Is_locally_Delaunay`.
///
/// \tparam FT_ a model of `FieldWithSqrt`
/// \tparam Integer_ the signed integer type of normal coordinates
///
/// \cgalModels `IntrinsicGeometryTraits`
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

  /// computes the length of the edge \f$kl\f$ that replaces \f$ij\f$. Both triangles are laid out in the
  /// plane along \f$ij\f$, with all lengths multiplied by \f$2 \ell_{ij}\f$ until the end.
  struct Compute_flipped_length
  {
    /// returns the length of \f$kl\f$.
    FT operator()(const Diamond<FT>& length) const
    {
      const FT x = scaled_foot(length.jk, length.ki) - scaled_foot(length.lj, length.il);
      const FT height_k = squared_quadrupled_area(length.ij, length.jk, length.ki);
      const FT height_l = squared_quadrupled_area(length.ij, length.lj, length.il);
      const FT squared_height = height_k + height_l + 2 * CGAL::sqrt(height_k * height_l);
      return CGAL::sqrt(x * x + squared_height) / (2 * length.ij);
    }
  };

  /// decides whether the edge \f$ij\f$ satisfies the local Delaunay condition (Equation 2.6).
  ///
  /// The sign of \f$\sin(\theta_k + \theta_l)\f$ is that of
  /// \f$(\ell_{jk}^2 + \ell_{ki}^2 - \ell_{ij}^2) A_l + (\ell_{lj}^2 + \ell_{il}^2 - \ell_{ij}^2) A_k\f$,
  /// with \f$A\f$ the areas. In floating point an edge counts as non-Delaunay only if it is so for all
  /// lengths within `rounding_unit()` of the stored ones. So four cocircular points are a tie and ties
  /// are kept, an edge that has just been flipped is never flipped back, and a triangle of zero area
  /// over its long side gives way.
  struct Is_locally_Delaunay
  {
    /// returns whether \f$ij\f$ is Delaunay.
    bool operator()(const Diamond<FT>& length) const
    {
      const FT squared = length.ij * length.ij;
      const FT sides_k = length.jk * length.jk + length.ki * length.ki;
      const FT sides_l = length.lj * length.lj + length.il * length.il;
      if(!(sides_k < squared) && !(sides_l < squared))
        return true;
      const Corner k{sides_k, squared, length.jk, length.ki},
        l{sides_l, squared, length.lj, length.il};
      return sides_k < sides_l ? !exceeds_pi(k, l, length.ij) : !exceeds_pi(l, k, length.ij);
    }

  private:
    // the corner opposite to ij, with the sum of its squared sides, the square of ij, and the sides
    struct Corner
    {
      FT sides, squared, p, q;

      FT cosine(const FT& error) const { return sides - squared + error * (sides + squared); }
      FT squared_sine(const FT& ij, const FT& error) const
      {
        return squared_quadrupled_area(ij, p, q, error * (ij + p + q));
      }
    };

    // whether two angles, the first of them obtuse, add up to more than pi for certain; sines and
    // cosines have a common positive factor in each corner
    static bool exceeds_pi(const Corner& obtuse, const Corner& other, const FT& ij)
    {
      const FT u = rounding_unit<FT>();
      const FT cos_obtuse = obtuse.cosine(u), cos_other = other.cosine(u);
      if(!(cos_obtuse < 0))
        return false;
      if(cos_other < 0)
        return true;
      return cos_other * cos_other * obtuse.squared_sine(ij, u) <
             cos_obtuse * cos_obtuse * other.squared_sine(ij, -u);
    }
  };

  /// decides whether the diamond is strictly convex at \f$i\f$ and \f$j\f$, so that \f$ij\f$ can be
  /// flipped; in floating point, whether this is certain in spite of rounding.
  struct Is_convex
  {
    /// returns whether the diamond is convex.
    bool operator()(const Diamond<FT>& length) const
    {
      const FT foot_k = scaled_foot(length.jk, length.ki);
      const FT foot_l = scaled_foot(length.lj, length.il);
      const FT height_k = quadrupled_area(length.ij, length.jk, length.ki);
      const FT height_l = quadrupled_area(length.ij, length.lj, length.il);
      // kl crosses ij at this distance from its midpoint, times a common factor
      const FT crossing = CGAL::abs(foot_k * height_l + foot_l * height_k);
      const FT half = length.ij * length.ij * (height_k + height_l);
      const FT sum = CGAL::abs(foot_k) * height_l + CGAL::abs(foot_l) * height_k + half;
      return crossing < half - rounding_unit<FT>() * sum;
    }
  };

  /// decides whether a number can be the length of an edge: it is positive and finite, and so is its
  /// eighth power, to which the formulas above go up.
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EUCLIDEAN_GEOMETRY_TRAITS_H
