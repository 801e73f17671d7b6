// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HYPERIDEAL_GEOMETRY_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HYPERIDEAL_GEOMETRY_TRAITS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Hyperideal_strip.h>
#include <CGAL/Intrinsic_triangulations/Ideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// defines the geometry of hyperbolic triangles whose corners are decorated with circles (Lutz
/// 2022). A corner with a positive radius is hyperideal, and a corner with radius zero is ideal.
/// The length of an edge is the length of the tangent between its two circles, see
/// `Decorated_length`.
///
/// Without radii this is `Ideal_geometry_traits`, with the same results and no other operations.
///
/// A flip maps the Gram coordinates of four circles, as vectors of \f$\mathbb{R}^{2,1}\f$, to the
/// coordinates of the other diagonal. It generalizes Ptolemy's relation, keeps inversive
/// distances, and commutes with scaling by vertices. Radii and tangents give it as a sum of
/// products that are not negative, so no digit is lost. It needs square roots.
///
/// Barycentric coordinates are coordinates in the triangle of the vectors of the corners. One
/// point has different coordinates in different triangles: only the ray counts.
///
/// \tparam FT_ a floating point type
/// \tparam Integer_ the signed integer type of normal coordinates
///
/// \cgalModels `IntrinsicGeometryTraits`
template <typename FT_ = double, typename Integer_ = std::int64_t>
class Hyperideal_geometry_traits
{
  typedef Ideal_geometry_traits<FT_, Integer_> Ideal_traits;
  typedef Diamond<Decorated_length<FT_>> Decorated;

public:
  /// the number type of lengths of tangents, and of radii.
  typedef FT_ FT;
  /// the type of normal coordinates.
  typedef Integer_ Integer;
  /// the layout of triangle strips.
  typedef Hyperideal_strip<FT> Geodesic_strip;

  /// makes traits without radii: all vertices are ideal.
  Hyperideal_geometry_traits() = default;

  /// makes traits with radii, or without radii if `radii` is empty.
  /// \param radii the radii of the circles, by the indices of vertices
  explicit Hyperideal_geometry_traits(std::vector<FT> radii)
    : m_radii(radii.empty() ? nullptr : std::make_shared<const std::vector<FT>>(std::move(radii)))
  {}

  /// returns whether there are radii.
  bool has_radii() const { return m_radii != nullptr; }
  /// returns the radius of the circle at `v`. \pre `has_radii()`
  const FT& radius(Vertex_index v) const { return (*m_radii)[v.idx()]; }

  /// computes the length of the tangent between \f$k\f$ and \f$l\f$.
  struct Compute_flipped_length : Ideal_traits::Compute_flipped_length
  {
    using Ideal_traits::Compute_flipped_length::operator();
    /// returns the length by the generalized relation of Ptolemy. \pre the circles at the ends of
    /// the edge do not touch
    FT operator()(const Decorated& edges) const
    {
      return internal::Decorated_diamond<FT>(edges).flipped_tangent();
    }
  };

  /// decides whether the edge \f$ij\f$ satisfies the local weighted ideal Delaunay condition. The
  /// polyhedron in the span of the vectors of its faces must be convex at the edge. Equality is a
  /// tie and kept. If triangles with these lengths and radii exist, it is the weighted Delaunay
  /// condition.
  ///
  /// Both sides of the condition are sums of positive terms. In floating point an edge counts as
  /// non-Delaunay only if it is so for all lengths and radii within `rounding_unit()` of the stored
  /// ones. An edge between circles that touch is Delaunay.
  /// \cgalModels `LocalDelaunayPredicate`
  struct Is_locally_Delaunay : Ideal_traits::Is_locally_Delaunay
  {
    using Ideal_traits::Is_locally_Delaunay::operator();
    /// returns whether the edge is Delaunay.
    bool operator()(const Decorated& edges) const
    {
      const auto condition = internal::Decorated_diamond<FT>(edges).condition();
      // Both sides are of degree seven, and have fewer than 15 roundings.
      return !(condition.inner > condition.outer * (1 + 15 * rounding_unit<FT>()));
    }

    using Ideal_traits::Is_locally_Delaunay::is_certain;
    /// returns whether the edge is Delaunay; there is no cheaper form.
    bool is_certain(const Decorated& edges) const { return (*this)(edges); }
  };

  /// decides whether an edge can be flipped: unless its circles touch, no union of two triangles
  /// prevents it.
  struct Is_convex : Ideal_traits::Is_convex
  {
    using Ideal_traits::Is_convex::operator();
    /// returns whether the circles at the ends of the edge do not touch.
    bool operator()(const Decorated& edges) const { return edges.ij.determinant() > 0; }
  };

  /// decides whether a number can be the length of a tangent. It must be positive and finite, as
  /// in `Ideal_geometry_traits`. Between circles, which can touch, it may be zero.
  struct Is_length : Ideal_traits::Is_length
  {
    /// returns whether `length` can be the length of a tangent.
    bool operator()(const FT& length) const
    {
      return (has_circles && length == 0) || Ideal_traits::Is_length::operator()(length);
    }
    /// whether there are circles.
    bool has_circles = false;
  };

  /// returns `true`, since there is no triangle inequality.
  typedef typename Ideal_traits::Is_triangle Is_triangle;

  /// returns the function object.
  Compute_flipped_length compute_flipped_length_object() const { return {}; }
  /// returns the function object.
  Is_locally_Delaunay is_locally_Delaunay_object() const { return {}; }
  /// returns the function object.
  Is_convex is_convex_object() const { return {}; }
  /// returns the function object.
  Is_length is_length_object() const { return {{}, has_radii()}; }
  /// returns the function object.
  Is_triangle is_triangle_object() const { return {}; }

private:
  std::shared_ptr<const std::vector<FT>> m_radii; // null if there are none
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HYPERIDEAL_GEOMETRY_TRAITS_H
