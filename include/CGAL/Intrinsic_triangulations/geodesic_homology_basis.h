// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_HOMOLOGY_BASIS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_HOMOLOGY_BASIS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Flipped_paths.h>
#include <CGAL/Intrinsic_triangulations/homology_basis.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// returns closed geodesics around all handles and holes, the shortest ones first. Every closed
/// curve is homologous to a combination of them with integer coefficients.
///
/// Loops along edges of \f$T_2\f$ are shortened by flips, and a basis is chosen by their lengths
/// (`homology_basis()`). Call `make_Delaunay()` before, since edges of a Delaunay triangulation
/// lead to short loops.
///
/// \param tri the triangulation; it is not changed
/// \returns \f$2g\f$ loops for each closed component of genus \f$g\f$, and
///   \f$2g + b - 1\f$ with \f$b > 0\f$ boundary loops. A loop may be blocked if it touches itself
///   (`Shortening_status`).
/// \throws Numerical_error, Overflow_error as `Flipped_paths::path()`
///
/// Complexity: as `homology_basis()`, and `Flipped_paths::loop()` for each loop that it finds.
template <typename Traits>
std::vector<Flipped_path<typename Traits::FT>>
geodesic_homology_basis(const Intrinsic_triangulation<Traits>& tri)
{
  typedef std::vector<Halfedge_index> Loop;
  Flipped_paths<Traits> paths(tri);
  std::vector<Flipped_path<typename Traits::FT>> result;
  for(const Loop& loop :
      homology_basis(tri.intrinsic(), [&](const Loop& l) { return paths.loop(l).path.length; }))
    result.push_back(paths.loop(loop));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_HOMOLOGY_BASIS_H
