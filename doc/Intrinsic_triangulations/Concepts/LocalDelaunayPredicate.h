// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicTriangulationsConcepts
/// \cgalConcept
///
/// decides whether an edge \f$ij\f$ is locally Delaunay, by the lengths of a `Diamond`. They
/// belong to the edge and the four other sides of its faces \f$ijk\f$ and \f$jil\f$. For a border
/// edge, two of the five lengths are unspecified.
///
/// A model is called through a constant reference.
///
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Euclidean_geometry_traits::Is_locally_Delaunay`
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Ideal_geometry_traits::Is_locally_Delaunay`
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Hyperideal_geometry_traits::Is_locally_Delaunay`
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Exact_Euclidean_geometry_traits::Is_locally_Delaunay`
///
/// \sa `IntrinsicGeometryTraits`
/// \sa `ExactIntrinsicGeometryTraits`
class LocalDelaunayPredicate
{
public:
  /// `bool`; or `CGAL::Uncertain<bool>` in a model of `ExactIntrinsicGeometryTraits`.
  typedef unspecified_type Result;

  /// returns whether the edge satisfies the local Delaunay condition. The condition must hold for
  /// ties. If it does not hold for an edge, it must hold for the flipped edge; otherwise
  /// `make_Delaunay()` may use up its flips. A result of type `CGAL::Uncertain<bool>` is
  /// indeterminate if the lengths, within their errors, do not determine it.
  Result operator()(const Diamond<FT>& length) const;

  /// returns `true` only if the edge certainly satisfies the condition. `false` is always allowed,
  /// and is returned if it would take long to decide: loops over all edges ask this first.
  bool is_certain(const Diamond<FT>& length) const;
};
