// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicTriangulationsConcepts
/// \cgalConcept
///
/// is a geometry in which points inside triangles have distances too, so that vertices can be
/// inserted into the intrinsic triangulation. Barycentric coordinates are linear along geodesics: a
/// crossing of `Geodesic_strip` has no scale.
///
/// \cgalRefines{IntrinsicGeometryTraits}
///
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Euclidean_geometry_traits`
///
/// \sa `CGAL::Intrinsic_triangulations::Vertex_inserter`
class IntrinsicGeometryTraitsWithDistance
{
public:
  /// \name Types
  /// @{

  /// a model of `GeodesicStripWithDistance` with the same `FT`.
  typedef unspecified_type Geodesic_strip;

  /// provides `FT operator()(const std::array<FT, 3>& side, const std::array<FT, 3>& p, const
  /// std::array<FT, 3>& q) const`. It returns the distance of the points with barycentric
  /// coordinates `p` and `q` in a triangle. Side `s` of the triangle leads from corner `s` to the
  /// next and has length `side[s]`.
  typedef unspecified_type Compute_distance;

  /// @}
  /// \name Operations
  /// @{

  /// returns the function object.
  Compute_distance compute_distance_object() const;

  /// @}
};
