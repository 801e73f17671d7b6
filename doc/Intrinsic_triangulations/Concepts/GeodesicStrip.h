// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicTriangulationsConcepts
/// \cgalConcept
///
/// lays out a strip of triangles and intersects its inner edges with the geodesic between its ends.
///
/// The strip leaves the corner \f$a\f$ of a first triangle through the opposite side
/// \f$\overrightarrow{ij}\f$. It passes triangle after triangle, always through the last inner
/// edge, and ends at a corner \f$b\f$. All arguments are lengths of edges. The calls for one strip
/// are `start()`, then any number of turns, then `finish()`. An object is used for many strips,
/// one after the other.
///
/// A model is default constructible.
///
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Euclidean_strip`
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Ideal_strip`
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Hyperideal_strip`
///
/// \sa `IntrinsicGeometryTraits`
class GeodesicStrip
{
public:
  /// the position where the geodesic meets an inner edge \f$\overrightarrow{ij}\f$. A model is
  /// copyable. It has a member `along_line`, the barycentric coordinate on the geodesic from
  /// \f$a\f$ to \f$b\f$, which the user may change. It also has a member `along_edge`, the
  /// coordinate on \f$\overrightarrow{ij}\f$. Both are of type `FT` and in \f$[0,1]\f$. They need
  /// not be in order along the geodesic: the user ensures this.
  ///
  /// If barycentric coordinates are homogeneous coordinates, it also has a positive member `scale`
  /// of type `FT`. Then the vector \f$(1-s)a + sb\f$ of the geodesic is `scale` times the vector
  /// \f$(1-t)i + tj\f$ of the edge. The maps between the two triangulations are then projective on
  /// the regions of the common subdivision. Without this member, the scale is 1 and the maps are
  /// linear.
  typedef unspecified_type Crossing;

  /// starts a strip in the triangle \f$aij\f$, which is left through \f$\overrightarrow{ij}\f$.
  void start(const FT& ai, const FT& ij, const FT& ja);

  /// continues through the triangle \f$jil\f$ beyond the last inner edge \f$\overrightarrow{ij}\f$
  /// and leaves it through \f$\overrightarrow{il}\f$.
  void turn_around_source(const FT& ij, const FT& jl, const FT& li);

  /// continues through the triangle \f$jil\f$ beyond the last inner edge \f$\overrightarrow{ij}\f$
  /// and leaves it through \f$\overrightarrow{lj}\f$.
  void turn_around_target(const FT& ij, const FT& jl, const FT& li);

  /// ends the strip at the corner \f$b = l\f$ of the triangle \f$jil\f$ beyond the last inner edge
  /// \f$\overrightarrow{ij}\f$.
  void finish(const FT& ij, const FT& jl, const FT& li);

  /// returns the length of the geodesic. \pre the strip is finished
  FT length() const;

  /// returns the crossing with inner edge `m`; the one given to `start()` is number 0.
  /// \pre the strip is finished
  Crossing crossing(std::size_t m) const;
};
