// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicTriangulationsConcepts
/// \cgalConcept
///
/// determines the geometry of an intrinsic triangulation. It provides number types, the length of
/// a flipped edge, the local Delaunay condition, and the layout of a strip of triangles.
///
/// A model is default constructible, copy constructible and assignable. The function objects are
/// obtained from a constant object and called through a constant reference. `Diamond<FT>` holds the
/// lengths of an edge \f$ij\f$ and of the four other sides of its faces \f$ijk\f$ and \f$jil\f$.
///
/// A model can have circles at the vertices: it then has the member functions `has_radii()` and
/// `radius(v)`. If `has_radii()` returns `true`, the function objects are called with a
/// `Diamond<Decorated_length<FT>>`, whose edges know the radii at their ends, and the strip with
/// `Decorated_length<FT>`.
///
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Euclidean_geometry_traits`
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Ideal_geometry_traits`
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Hyperideal_geometry_traits`
///
/// \sa `IntrinsicGeometryTraitsWithDistance`
/// \sa `CGAL::Intrinsic_triangulations::Intrinsic_triangulation`
class IntrinsicGeometryTraits
{
public:
  /// \name Types
  /// @{

  /// the type of lengths and barycentric coordinates: a model of `Field` and `RealEmbeddable`, with
  /// an implicit conversion from `int`. Square roots are needed only if lengths come from positions,
  /// or if a model documents them. Only saving and loading need a floating point type.
  typedef unspecified_type FT;

  /// the signed integer type of normal coordinates, with explicit conversions from and to built-in
  /// integers. If `std::numeric_limits<Integer>::is_bounded`, values up to a sixteenth of its
  /// greatest are used, and overflow is reported; otherwise it has arbitrary precision, as
  /// `boost::multiprecision::cpp_int`.
  typedef unspecified_type Integer;

  /// a model of `GeodesicStrip` with the same `FT`.
  typedef unspecified_type Geodesic_strip;

  /// provides `FT operator()(const Diamond<FT>& length) const`, which returns the length of the
  /// edge \f$kl\f$ that replaces \f$ij\f$. A result that is not a length is allowed; it is refused
  /// later.
  typedef unspecified_type Compute_flipped_length;

  /// a model of `LocalDelaunayPredicate` for lengths of type `FT`. Exact decisions know the
  /// condition of `Euclidean_geometry_traits<double>` only: traits that replace it have none.
  typedef unspecified_type Is_locally_Delaunay;

  /// provides `bool operator()(const Diamond<FT>& length) const`, which returns whether the union
  /// of the two triangles is strictly convex at \f$i\f$ and \f$j\f$.
  typedef unspecified_type Is_convex;

  /// provides `bool operator()(const FT& length) const`, which returns whether a number can be the
  /// length of an edge.
  typedef unspecified_type Is_length;

  /// provides `bool operator()(const FT& a, const FT& b, const FT& c) const`, which returns
  /// whether a triangle with these three side lengths exists.
  typedef unspecified_type Is_triangle;

  /// @}
  /// \name Operations
  /// @{

  /// returns the function object.
  Compute_flipped_length compute_flipped_length_object() const;
  /// returns the function object.
  Is_locally_Delaunay is_locally_Delaunay_object() const;
  /// returns the function object.
  Is_convex is_convex_object() const;
  /// returns the function object.
  Is_length is_length_object() const;
  /// returns the function object.
  Is_triangle is_triangle_object() const;

  /// @}
};
