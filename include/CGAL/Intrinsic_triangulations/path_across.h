// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_PATH_ACROSS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_PATH_ACROSS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Path_carrier.h>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// finds a path over one triangulation on the other: its places on edges of \f$T_2\f$ become places
/// on edges of \f$T_1\f$, or the other way round.
///
/// \param correspondence the crossings of both
/// \param side the triangulation that `path` runs over
/// \param path a path with places as `Shortest_paths::path()` returns them: between two vertices it
///        follows an edge, and everywhere else a straight line in a face. It may bend at inserted
///        vertices and at places inside faces, too.
/// \returns the path with its length, which stays, and its places on the other triangulation, in
///   the form of `Shortest_paths::path()`. Where it passes a vertex of \f$T_2\f$ that has been
///   inserted, there is a place in its face or on its edge of \f$T_1\f$; and where a place on
///   \f$T_1\f$ is that of an inserted vertex, the path passes this vertex of \f$T_2\f$.
///
/// The sequence of faces is connected, however flat they are: the order of places and crossings
/// along the edges of `side` determines which edges of the other triangulation are crossed. In a
/// face of \f$T_1\f$ with inserted vertices it also depends on which of them are on the left of the
/// path. Rounding can only choose between paths that are equal up to rounding, such as the sides of
/// an edge along which a path runs; apart from that, there and back is the identity.
///
/// Complexity: linear in the edges crossed, with a logarithm of the crossings on each edge that the
/// path crosses. In a face of \f$T_1\f$ with inserted vertices: linear in the edges of \f$T_2\f$
/// that the line through the path crosses there, and for an end inside the face as
/// `point_across()`.
/// \throws Invalid_input if two consecutive places that are not both vertices share no face
template <typename Traits>
Surface_path<typename Traits::FT> path_across(const Correspondence<Traits>& correspondence,
                                              Side side,
                                              const Surface_path<typename Traits::FT>& path)
{
  return {path.length, internal::Path_carrier<Traits>(correspondence, side)(path.places)};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PATH_ACROSS_H
