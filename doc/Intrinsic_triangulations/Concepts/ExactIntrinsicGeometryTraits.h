// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicTriangulationsConcepts
/// \cgalConcept
///
/// is a Euclidean geometry with lengths of type `double` and exact decisions. If lengths do not
/// decide, decisions are derived from the exact metric of the input. Stored lengths have a
/// relative error of at most \f$2^{-40}\f$, and the predicates on lengths take this into account.
///
/// \cgalRefines{IntrinsicGeometryTraitsWithDistance}
///
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Exact_Euclidean_geometry_traits`
///
/// \sa `CGAL::Intrinsic_triangulations::certify_Delaunay()`
class ExactIntrinsicGeometryTraits
{
public:
  /// the type of exact squared lengths: a model of `Field` and `RealEmbeddable` with exact signs.
  /// It is constructible from `double`, exactly.
  typedef unspecified_type Exact_number;

  /// a model of `LocalDelaunayPredicate` for lengths of type `double` whose result is of type
  /// `CGAL::Uncertain<bool>`: indeterminate if lengths within the error of stored ones disagree.
  typedef unspecified_type Is_locally_Delaunay;

  /// returns the function object.
  Is_locally_Delaunay is_locally_Delaunay_object() const;
};
