// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_PROLONGATION_HIERARCHY_H
#define CGAL_INTRINSIC_SIMPLIFICATION_PROLONGATION_HIERARCHY_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/Transport_cost.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationApplications
/// simplifies a surface repeatedly to a fourth of the vertices, and returns the prolongation from
/// each level to the level before. The first one leads to the original surface. All levels share
/// one `default_cost()`.
///
/// Complexity: see `simplify()` and `prolongation_matrix()`. Memory: two levels at a time besides
/// the result.
/// \param surface the surface; afterwards it is as coarse as the last level
/// \param number_of_vertices the hierarchy ends at a level with at most this number of vertices, or
///   if no vertex can be removed
/// \throws Intrinsic_triangulations::Flip_limit_exceeded,
///         Intrinsic_triangulations::Numerical_error and
///         Intrinsic_triangulations::Overflow_error as `simplify()` and `Surface_map`
inline std::vector<Eigen::SparseMatrix<double>>
prolongation_hierarchy(Evolving_surface& surface, std::size_t number_of_vertices = 500)
{
  std::vector<Eigen::SparseMatrix<double>> result;
  Transport_cost cost = default_cost(surface);
  Surface_level fine(surface);
  while(fine.mesh().number_of_vertices() > number_of_vertices) {
    const std::size_t target = fine.mesh().number_of_vertices() / 4;
    if(simplify(surface, cost, parameters::number_of_vertices(target)).removed == 0)
      break;
    Surface_level coarse(surface);
    result.push_back(prolongation_matrix(Surface_map(surface, fine, coarse)));
    fine = std::move(coarse);
  }
  return result;
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_PROLONGATION_HIERARCHY_H
