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
/// The geodesics of `Geodesic_strip` start and end at such points too. It has five more functions:
/// - `void start(const FT& ai, const FT& ij, const FT& ja, const std::array<FT, 3>& p)` starts at
///   the point of the triangle \f$aij\f$ with barycentric coordinates `p`, which belong to \f$a\f$,
///   \f$i\f$,
///   \f$j\f$;
/// - `void finish(const FT& ij, const FT& jl, const FT& li, const std::array<FT, 3>& q)` ends at
///   the point of the triangle \f$jil\f$ with barycentric coordinates `q`, which belong to \f$l\f$,
///   \f$j\f$,
///   \f$i\f$;
/// - `Crossing crossing(std::size_t m, const FT& least) const` returns the crossing with inner edge
///   `m`, not before `least` on the geodesic. Where triangles have no area, both can run along each
///   other: then it is a point that they share;
/// - `FT along_edge(std::size_t m, const FT& s) const` returns the place on inner edge `m` closest
///   to the point at `s` on the geodesic;
/// - `FT along_line(std::size_t m, const FT& t) const` returns the place on the geodesic closest to
///   the point at `t` on inner edge `m`.
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

  /// provides `FT operator()(const std::array<FT, 3>& side, const std::array<FT, 3>& p,
  /// const std::array<FT, 3>& q) const`, which returns the distance of the points with barycentric
  /// coordinates `p` and `q` in a triangle whose side `s` leads from corner `s` to the next and has
  /// length `side[s]`.
  typedef unspecified_type Compute_distance;

  /// @}
  /// \name Operations
  /// @{

  /// returns the function object.
  Compute_distance compute_distance_object() const;

  /// @}
};
