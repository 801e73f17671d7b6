// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicTriangulationsConcepts
/// \cgalConcept
///
/// lays out a strip of triangles. Geodesics may start and end at any point of the first and the
/// last triangle. The strip measures along the geodesic and along inner edges.
///
/// \cgalRefines{GeodesicStrip}
///
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Euclidean_strip`
///
/// \sa `IntrinsicGeometryTraitsWithDistance`
class GeodesicStripWithDistance
{
public:
  /// starts at the point of the triangle \f$aij\f$ with barycentric coordinates `p`, which belong
  /// to \f$a\f$, \f$i\f$, \f$j\f$.
  void start(const FT& ai, const FT& ij, const FT& ja, const std::array<FT, 3>& p);

  /// ends at the point of the triangle \f$jil\f$ with barycentric coordinates `q`, which belong to
  /// \f$l\f$, \f$j\f$, \f$i\f$.
  void finish(const FT& ij, const FT& jl, const FT& li, const std::array<FT, 3>& q);

  /// returns the crossing with inner edge `m`, not before `least` on the geodesic. If triangles
  /// have no area, the geodesic and the edge can run along each other: then it is a point that they
  /// share. \pre the strip is finished
  Crossing crossing(std::size_t m, const FT& least) const;

  /// returns the barycentric coordinate, on inner edge `m`, of the point closest to the point at
  /// `s` on the geodesic. \pre the strip is finished
  FT along_edge(std::size_t m, const FT& s) const;

  /// returns the barycentric coordinate, on the geodesic, of the point closest to the point at `t`
  /// on inner edge `m`. \pre the strip is finished
  FT along_line(std::size_t m, const FT& t) const;
};
