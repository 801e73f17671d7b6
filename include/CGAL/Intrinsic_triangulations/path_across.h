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
///        follows an edge, and everywhere else a straight line in a face
/// \returns the path with its length, which stays, and its places on the other triangulation, in
///   the form of `Shortest_paths::path()`. Where it passes a vertex of \f$T_2\f$ that has been
///   inserted, there is a place in its face or on its edge of \f$T_1\f$.
///
/// The sequence of faces is connected, however flat they are: the order of places and crossings
/// along the edges of `side` determines which edges of the other triangulation are crossed. Only
/// for ends inside faces it depends on rounded areas.
///
/// Complexity: linear in the edges crossed, with a logarithm of the crossings on each edge that the
/// path crosses.
/// \throws Invalid_input if `side` is `Side::input` and the path passes a face of \f$T_1\f$ that
///         contains inserted vertices (`curve_across()` takes curves through those)
template <typename Traits>
Surface_path<typename Traits::FT> path_across(const Correspondence<Traits>& correspondence,
                                              Side side,
                                              const Surface_path<typename Traits::FT>& path)
{
  return {path.length, internal::Path_carrier<Traits>(correspondence, side)(path.places)};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PATH_ACROSS_H
