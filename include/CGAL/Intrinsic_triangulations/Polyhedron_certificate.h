// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_POLYHEDRON_CERTIFICATE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_POLYHEDRON_CERTIFICATE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <cstddef>
#include <string>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// the decision about the convexity of a result of `convex_polyhedron()`.
enum class Polyhedron_kind
{
  convex, ///< the polyhedron is convex, by exact predicates on its positions of type `double`
  /// the polyhedron is convex with coordinates of twice as many digits, up to relative errors of
  /// \f$2^{-95}\f$. Rounding them to `double` makes edges concave, whose angles are nearly flat.
  convex_before_rounding,
  /// a polygon with two sides, convex by exact predicates on its positions of type `double`.
  polygon
};

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// returns the name of the enumerator.
inline const char* to_string(Polyhedron_kind kind)
{
  constexpr const char* names[] = {"convex", "convex_before_rounding", "polygon"};
  return names[static_cast<std::size_t>(kind)];
}

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// the results of exact predicates about a polyhedron with positions of type `double`, without a
/// tolerance. Flat vertices do not count: rounding moves them out of their faces.
struct Polyhedron_certificate
{
  bool is_flat = false; ///< whether the polyhedron is a polygon with two sides
  /// the edges at which the polyhedron is convex; of a polygon, its sides.
  std::size_t convex_edges = 0;
  /// the edges between triangles in one plane.
  std::size_t flat_edges = 0;
  /// the edges that are not convex; of a polygon, the vertices.
  std::size_t concave_edges = 0;
  /// the triangles whose inner side is not seen from the center; for a polygon, the triangles
  /// without area.
  std::size_t hidden_faces = 0;
  /// how often the triangles cover the sphere of directions from the center; of a polygon, how
  /// often its sides turn around.
  int degree = 0;

  /// returns whether the polyhedron is convex.
  bool is_convex() const { return concave_edges == 0 && hidden_faces == 0 && degree == 1; }
};

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// returns the numbers of a certificate that decide about convexity.
inline std::string to_string(const Polyhedron_certificate& certificate)
{
  return "concave edges: " + std::to_string(certificate.concave_edges) +
         ", hidden faces: " + std::to_string(certificate.hidden_faces) +
         ", degree: " + std::to_string(certificate.degree);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_POLYHEDRON_CERTIFICATE_H
