// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTION_LAPLACIAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTION_LAPLACIAN_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Replaces negative weights by zero, so that the matrix cannot be indefinite. A Delaunay
// triangulation has negative weights only on border edges. Parallel fields remain parallel.
template <typename Surface>
std::vector<Length_of<Surface>> nonnegative_weights(const Surface& surface)
{
  auto weights = cotan_weights(surface);
  for(auto& w : weights)
    w = (std::max)(w, Length_of<Surface>(0));
  return weights;
}

template <typename FT, typename Frames>
Eigen::SparseMatrix<std::complex<FT>> connection_laplacian(const Delta_complex& mesh,
                                                           const std::vector<FT>& weights,
                                                           const Frames& frames)
{
  std::vector<Eigen::Triplet<std::complex<FT>>> entries;
  entries.reserve(4 * mesh.number_of_edges());
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e);
    const int i = int(mesh.source(h).idx()), j = int(mesh.target(h).idx());
    const FT& w = weights[e.idx()];
    const std::complex<FT> transported = w * frames.transport(h);
    entries.emplace_back(i, i, w);
    entries.emplace_back(j, j, w);
    entries.emplace_back(j, i, -transported);
    entries.emplace_back(i, j, -std::conj(transported));
  }
  return matrix_of(entries, mesh.num_vertices(), mesh.num_vertices());
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the matrix \f$L^\nabla\f$ of the energy \f$\sum w_{ij} |X_j - R_{ij} X_i|^2\f$ of
/// tangent vectors \f$X\f$ at the vertices. It has the weights \f$w_{ij}\f$ of `cotan_laplacian()`
/// and the parallel transport of `Tangent_frames`, with normalized angles also at corners of the
/// boundary. It is Hermitian, and positive semidefinite if
/// no weight is negative. A loop adds the turn of transport around it. The row of an isolated (or
/// removed) vertex is empty. Complexity: linear.
/// \param surface a model of `IntrinsicSurface`
/// \param frames the frames of `surface`
/// \throws Numerical_error if the area of a face is zero or out of range
template <typename Surface>
auto connection_laplacian(const Surface& surface, const Tangent_frames<Length_of<Surface>>& frames)
{
  return internal::connection_laplacian(surface.mesh(), internal::cotan_weights(surface), frames);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTION_LAPLACIAN_H
