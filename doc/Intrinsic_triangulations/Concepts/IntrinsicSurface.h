// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicTriangulationsConcepts
/// \cgalConcept
///
/// a triangulated surface with edge lengths: all that operators, the heat method, geodesics and
/// logarithms need. A surface is the first argument of each of them.
///
/// The lengths satisfy the triangle inequality in every face. Removed elements may leave gaps in
/// the indices.
///
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Surface_view`
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Intrinsic_triangulation`, as the surface of
///   \f$T_2\f$; `input()` and `intrinsic()` are views of its two triangulations
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Tufted_surface`, for operators alone
/// \cgalHasModel `CGAL::Intrinsic_simplification::Surface_level`
/// \cgalHasModel `CGAL::Intrinsic_simplification::Intrinsic_surface`
/// \cgalHasModel `CGAL::Intrinsic_simplification::Evolving_surface`
class IntrinsicSurface
{
public:
  /// returns the connectivity, which lives as long as the surface.
  const CGAL::Intrinsic_triangulations::Delta_complex& mesh() const;

  /// returns a map of the edge lengths, by value or by reference. It is a model of
  /// `ReadablePropertyMap` with key type `CGAL::Intrinsic_triangulations::Edge_index` and a number
  /// type as value type. A copy of it is valid as long as the surface is not changed.
  unspecified_type length_map() const;
};
