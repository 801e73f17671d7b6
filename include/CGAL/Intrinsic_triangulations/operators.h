// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns whether a face is known to have zero area.
template <typename FT>
bool is_flat(const Face_metric<FT>& metric)
{
  return Digits<FT>::is_flat(metric.quadrupled_area(),
                             metric.length(0) + metric.length(1) + metric.length(2));
}

// Returns whether a face contributes to integrals of gradients; faces of zero area do not. Throws
// an exception if rounding leaves a metric without gradients.
template <typename FT>
bool has_gradients(const Face_metric<FT>& metric, Face_index f)
{
  if(is_flat(metric))
    return false;
  for(std::size_t s = 0; s < 3; ++s)
    if(!(metric.quadrupled_area() > 0) || !CGAL::is_finite(metric.cotangent(s)))
      throw Numerical_error("the area of face " + std::to_string(f.idx()) +
                            " is zero or out of range");
  return true;
}

// Throws an exception if some vertex has only faces without area. `flat` contains all these faces.
inline void check_flat_faces(const std::vector<Face_index>& flat, const Delta_complex& mesh)
{
  std::vector<std::size_t> count(mesh.num_vertices(), 0);
  for(Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(h))
      ++count[mesh.source(h).idx()];
  for(Face_index f : flat)
    for(Halfedge_index h : sides(f, mesh))
      if(--count[mesh.source(h).idx()] == 0)
        throw Numerical_error("the area of face " + std::to_string(f.idx()) +
                              " is zero, like the areas of all faces at vertex " +
                              std::to_string(mesh.source(h).idx()));
}

// Returns half the sum of the cotangents of the angles opposite to each edge.
template <typename Surface>
auto cotan_weights(const Surface& surface)
{
  typedef Length_of<Surface> FT;
  const Delta_complex& mesh = surface.mesh();
  std::vector<FT> result(mesh.num_edges(), FT(0));
  std::vector<Face_index> flat;
  for(Face_index f : mesh.faces()) {
    const Face_metric<FT> metric(f, surface);
    if(!has_gradients(metric, f)) {
      flat.push_back(f);
      continue;
    }
    const auto h = sides(f, mesh);
    for(std::size_t s = 0; s < 3; ++s)
      result[mesh.edge(h[s]).idx()] += metric.cotangent(s) / 2;
  }
  if(!flat.empty())
    check_flat_faces(flat, mesh);
  return result;
}

// Returns the symmetric matrix with `diagonal[v]` on the diagonal and `on_edge[e]` at both pairs
// of indices of the vertices of edge e. Entries at equal indices add up. Rows of isolated vertices
// are empty.
template <typename FT>
Eigen::SparseMatrix<FT> symmetric_matrix(const Delta_complex& mesh, std::vector<FT> diagonal,
                                         const std::vector<FT>& on_edge)
{
  std::vector<Eigen::Triplet<FT>> upper;
  upper.reserve(mesh.number_of_edges() + mesh.number_of_vertices());
  for(Edge_index e : mesh.edges()) {
    const auto [i, j] = std::minmax({mesh.vertex(e, 0), mesh.vertex(e, 1)});
    if(i == j)
      diagonal[i.idx()] += 2 * on_edge[e.idx()];
    else
      upper.emplace_back(int(i.idx()), int(j.idx()), on_edge[e.idx()]);
  }
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v))
      upper.emplace_back(int(v.idx()), int(v.idx()), diagonal[v.idx()]);
  return matrix_of(upper, diagonal.size(), diagonal.size())
    .template selfadjointView<Eigen::Upper>();
}

// Returns the Laplacian whose edges have these weights.
template <typename FT>
Eigen::SparseMatrix<FT> laplacian_of(const Delta_complex& mesh, std::vector<FT> on_edge)
{
  std::vector<FT> diagonal(mesh.num_vertices(), FT(0));
  for(Edge_index e : mesh.edges()) {
    FT& w = on_edge[e.idx()];
    const Vertex_index i = mesh.vertex(e, 0), j = mesh.vertex(e, 1);
    if(i == j)
      w = 0;
    diagonal[i.idx()] += w;
    diagonal[j.idx()] += w;
    w = -w;
  }
  return symmetric_matrix(mesh, std::move(diagonal), on_edge);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the matrix \f$L\f$ of the Dirichlet energy: \f$u^T L u = \int |\nabla u|^2\f$ for
/// every function \f$u\f$ that is linear on the faces. An edge that joins two vertices has the
/// weight \f$\frac{1}{2}(\cot\alpha + \cot\beta)\f$ with the angles opposite to it. Parallel edges
/// add up, and a loop contributes nothing. \f$L\f$ is symmetric and positive semidefinite. Its
/// kernel consists of the functions that are constant on every component. If the triangulation is
/// Delaunay, weights are not negative, except weights of border edges opposite to an obtuse angle.
/// The row of an isolated (or removed) vertex is empty. Complexity: linear.
/// \param surface a model of `IntrinsicSurface`
/// \throws Numerical_error if the area of a face is zero, or an area or a cotangent is out of
///         range; `make_Delaunay()` often resolves such faces (otherwise: \ref it_thin)
template <typename Surface>
auto cotan_laplacian(const Surface& surface)
{
  return internal::laplacian_of(surface.mesh(), internal::cotan_weights(surface));
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the integrals \f$\int \varphi_i \varphi_j\f$ of products of hat functions (the
/// consistent mass matrix). The sum of a row is the entry of `lumped_mass_matrix()`, and the row of
/// an isolated (or removed) vertex is empty. Complexity: linear.
/// \param surface a model of `IntrinsicSurface`; its faces may have zero area
template <typename Surface>
auto mass_matrix(const Surface& surface)
{
  typedef Length_of<Surface> FT;
  const Delta_complex& mesh = surface.mesh();
  std::vector<FT> diagonal(mesh.num_vertices(), FT(0)), on_edge(mesh.num_edges(), FT(0));
  for(Face_index f : mesh.faces()) {
    const Face_metric<FT> metric(f, surface);
    const auto h = sides(f, mesh);
    for(std::size_t s = 0; s < 3; ++s) {
      diagonal[mesh.source(h[s]).idx()] += metric.hat_product(s, s);
      on_edge[mesh.edge(h[s]).idx()] += metric.hat_product(s, (s + 1) % 3);
    }
  }
  return internal::symmetric_matrix(mesh, std::move(diagonal), on_edge);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the diagonal matrix of the integrals \f$\int \varphi_i\f$ of the hat functions, which
/// are a third of the areas of the faces around each vertex. The row of an isolated (or removed)
/// vertex is empty. Complexity: linear.
/// \param surface a model of `IntrinsicSurface`; its faces may have zero area
template <typename Surface>
auto lumped_mass_matrix(const Surface& surface)
{
  typedef Length_of<Surface> FT;
  const Delta_complex& mesh = surface.mesh();
  std::vector<FT> diagonal(mesh.num_vertices(), FT(0));
  for(Face_index f : mesh.faces()) {
    const Face_metric<FT> metric(f, surface);
    for(Halfedge_index h : sides(f, mesh))
      diagonal[mesh.source(h).idx()] += metric.area() / 3;
  }
  const auto collect = [&](std::size_t i, auto& entries) {
    const Vertex_index v(static_cast<Delta_complex::size_type>(i));
    if(!mesh.is_removed(v) && !mesh.is_isolated(v))
      entries.emplace_back(int(i), diagonal[i]);
  };
  return assembled<Eigen::SparseMatrix<FT>>(diagonal.size(), diagonal.size(), collect);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the matrix that maps the values of a function at the vertices to its gradients on the
/// faces. Rows \f$2f\f$ and \f$2f+1\f$ are the components in the frame of face \f$f\f$, whose
/// x-axis leads along `halfedge(f)` and whose y-axis points into the face. Complexity: linear.
/// \param surface a model of `IntrinsicSurface`
/// \throws Numerical_error if the area of a face is zero or out of range
template <typename Surface>
auto gradient_matrix(const Surface& surface)
{
  typedef Length_of<Surface> FT;
  const Delta_complex& mesh = surface.mesh();
  const auto collect = [&](std::size_t row, auto& entries) {
    const Face_index f(static_cast<Delta_complex::size_type>(row / 2));
    if(mesh.is_removed(f))
      return;
    const Face_metric<FT> metric(f, surface);
    if(!internal::has_gradients(metric, f))
      return;
    const auto h = sides(f, mesh);
    for(std::size_t s = 0; s < 3; ++s)
      entries.emplace_back(int(mesh.source(h[(s + 2) % 3]).idx()),
                           metric.turned_side(s)[row % 2] / metric.doubled_area());
  };
  return Eigen::SparseMatrix<FT>(assembled<Eigen::SparseMatrix<FT, Eigen::RowMajor>>(
    std::size_t(2) * mesh.num_faces(), mesh.num_vertices(), collect));
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the matrix that maps a vector field to its divergence integrated against the hat
/// functions: \f$-\int \langle X, \nabla\varphi_i\rangle\f$. The field is constant on every face,
/// with components as in `gradient_matrix()`. Its product with the gradient is \f$-L\f$, up to
/// rounding (`cotan_laplacian()`). At the boundary, the flow out of the surface is subtracted.
/// Complexity: linear.
/// \param surface a model of `IntrinsicSurface`; its faces may have zero area
template <typename Surface>
auto divergence_matrix(const Surface& surface)
{
  typedef Length_of<Surface> FT;
  const Delta_complex& mesh = surface.mesh();
  const auto collect = [&](std::size_t column, auto& entries) {
    const Face_index f(static_cast<Delta_complex::size_type>(column / 2));
    if(mesh.is_removed(f))
      return;
    const Face_metric<FT> metric(f, surface);
    if(internal::is_flat(metric))
      return;
    const auto h = sides(f, mesh);
    for(std::size_t s = 0; s < 3; ++s)
      entries.emplace_back(int(mesh.source(h[(s + 2) % 3]).idx()),
                           -metric.turned_side(s)[column % 2] / 2);
  };
  return assembled<Eigen::SparseMatrix<FT>>(mesh.num_vertices(), std::size_t(2) * mesh.num_faces(),
                                            collect);
}

#ifndef DOXYGEN_RUNNING
// Returns the factor of the operators of a surface.
template <typename Surface>
Length_of<Surface> share_of_operators(const Surface& /* surface */)
{
  return Length_of<Surface>(1);
}
#endif

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_H
