// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DELAUNAY_CERTIFICATE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DELAUNAY_CERTIFICATE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// the result of `certify_Delaunay()`.
struct Delaunay_certificate
{
  /// the edges of four cocircular points: either diagonal is Delaunay, and the faces at such an
  /// edge belong to one cell of the Delaunay tessellation.
  std::vector<Edge_index> ties;
  /// the edges that violate the local Delaunay condition.
  std::vector<Edge_index> non_Delaunay_edges;
  /// the edges that are not straight segments in the strips that their integer coordinates
  /// determine.
  std::vector<Edge_index> non_straight_edges;
  /// the inserted vertices whose faces are folded. They do not close up after one turn, or one of
  /// them has no positive area. Faces inside faces of \f$T_1\f$ without area are allowed.
  std::vector<Vertex_index> folded_vertices;

  /// the edges whose local Delaunay condition remains undecided, see `certify_Delaunay()`.
  std::vector<Edge_index> possibly_non_Delaunay_edges;
  /// the edges for which it is undecided whether they are straight.
  std::vector<Edge_index> possibly_non_straight_edges;
  /// the inserted vertices for which it is undecided whether their faces are folded.
  std::vector<Vertex_index> possibly_folded_vertices;

  /// the number of edges that are Delaunay for any rounding of lengths.
  std::size_t decided_by_lengths = 0;
  /// the number of decisions in floating point, with error bounds, on triangles that were laid out.
  std::size_t decided_in_floating_point = 0;
  /// the number of decisions with more digits, in sums of two `double` or in MPFR.
  std::size_t decided_in_multiprecision = 0;
  /// the number of decisions in exact arithmetic.
  std::size_t decided_exactly = 0;

  /// returns the number of edges and vertices about which something remains undecided.
  std::size_t undecided() const
  {
    return possibly_non_Delaunay_edges.size() + possibly_non_straight_edges.size() +
           possibly_folded_vertices.size();
  }
  /// returns whether the triangulation certainly is geodesic.
  bool is_geodesic() const
  {
    return non_straight_edges.empty() && folded_vertices.empty() &&
           possibly_non_straight_edges.empty() && possibly_folded_vertices.empty();
  }
  /// returns whether the triangulation certainly is geodesic and Delaunay.
  bool is_Delaunay() const
  {
    return is_geodesic() && non_Delaunay_edges.empty() && possibly_non_Delaunay_edges.empty();
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DELAUNAY_CERTIFICATE_H
