// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EUCLIDEAN_GEOMETRY_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EUCLIDEAN_GEOMETRY_TRAITS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Uncertain.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// defines the geometry of flat Euclidean triangles with exact decisions and lengths of type
/// `double`.
///
/// The surface is given by the exact positions of the input's vertices, its exact squared edge
/// lengths (`squared_edge_length_map`), or its edge lengths. Stored lengths are lengths on this
/// surface, with a relative error of at most \f$2^{-40}\f$ after any number of flips. They make a
/// decision if their error bounds allow it. Otherwise the triangles of \f$T_1\f$ on which it
/// depends are laid out, as the integer coordinates determine. They are laid out in numbers with
/// error bounds, with increasing precision, and finally exactly. No tolerance is used: an edge is
/// Delaunay if it is Delaunay on the exact surface, and ties are kept.
///
/// \tparam ExactNumber_ a model of `Field` and `RealEmbeddable` with exact signs, which has the
///   squared lengths of the input
/// \tparam Integer_ the signed integer type of normal coordinates
///
/// \cgalModels `ExactIntrinsicGeometryTraits`
template <typename ExactNumber_ = Exact_rational, typename Integer_ = std::int64_t>
class Exact_Euclidean_geometry_traits : public Euclidean_geometry_traits<double, Integer_>
{
public:
  /// the number type of exact squared lengths.
  typedef ExactNumber_ Exact_number;

  /// decides whether the edge \f$ij\f$ of a diamond is locally Delaunay, if all lengths within the
  /// error of stored lengths agree on that.
  /// \cgalModels `LocalDelaunayPredicate`
  class Is_locally_Delaunay
  {
  public:
    /// returns whether the edge is Delaunay, or that this is uncertain.
    Uncertain<bool> operator()(const Diamond<double>& length) const
    {
      if(is_certain(length))
        return true;
      return m_by_lengths(length) ? Uncertain<bool>::indeterminate() : Uncertain<bool>(false);
    }

    /// returns whether the edge certainly is Delaunay; branch-free.
    bool is_certain(const Diamond<double>& length) const { return m_by_lengths.is_certain(length); }

  private:
    Euclidean_geometry_traits<double>::Is_locally_Delaunay m_by_lengths{
      internal::certified_length_error()};
  };

  /// returns the function object.
  Is_locally_Delaunay is_locally_Delaunay_object() const { return {}; }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EUCLIDEAN_GEOMETRY_TRAITS_H
