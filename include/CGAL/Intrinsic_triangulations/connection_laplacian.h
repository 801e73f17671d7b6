// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTION_LAPLACIAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTION_LAPLACIAN_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Sparse_assembly.h>
#include <CGAL/Intrinsic_triangulations/internal/side_access.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/SparseCore>

#include <complex>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

template <typename FT>
Eigen::SparseMatrix<std::complex<FT>> connection_laplacian(const Delta_complex& mesh,
                                                           const std::vector<FT>& weights,
                                                           const Tangent_frames<FT>& frames)
{
  Sparse_assembly<std::complex<FT>> assembly(4 * mesh.number_of_edges());
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e);
    const Vertex_index i = mesh.source(h), j = mesh.target(h);
    const FT& w = weights[e.idx()];
    const std::complex<FT> transported = w * frames.transport(h);
    assembly.add(i, i, w);
    assembly.add(j, j, w);
    assembly.add(j, i, -transported);
    assembly.add(i, j, -std::conj(transported));
  }
  return assembly.matrix(mesh.num_vertices(), mesh.num_vertices());
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOperators
/// the matrix \f$L^\nabla\f$ of the energy \f$\sum w_{ij} |X_j - R_{ij} X_i|^2\f$ of tangent
/// vectors
/// \f$X\f$ at the vertices, with the weights \f$w_{ij}\f$ of `cotan_laplacian()` and the parallel
/// transport of `Tangent_frames`. It is Hermitian, and positive semidefinite if no weight is
/// negative; a loop adds what transport around it turns. The row of an isolated (or removed) vertex
/// is empty. Complexity: linear.
/// \param mesh the surface
/// \param length a readable property map from its edges to their lengths
/// \param frames the frames of `mesh` with these lengths
/// \throws Numerical_error if the area of a face is zero or out of range
template <typename EdgeLengthMap>
auto connection_laplacian(
  const Delta_complex& mesh, const EdgeLengthMap& length,
  const Tangent_frames<typename boost::property_traits<EdgeLengthMap>::value_type>& frames)
{
  return internal::connection_laplacian(mesh, internal::cotan_weights(mesh, length), frames);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// the same for one of the two triangulations of `tri`.
template <typename Traits>
auto connection_laplacian(Side side, const Intrinsic_triangulation<Traits>& tri,
                          const Tangent_frames<typename Traits::FT>& frames)
{
  return connection_laplacian(internal::mesh_of(side, tri), internal::lengths_of(side, tri),
                              frames);
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTION_LAPLACIAN_H
