// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_PROLONGATION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_PROLONGATION_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>

#include <Eigen/SparseCore>

#include <cstddef>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Calls `visit` with the vertices of the face of a point and their barycentric coordinates other
// than zero.
template <typename Visit>
void for_each_weight(const Surface_map::Location& p, const Delta_complex& mesh, const Visit& visit)
{
  const auto sides = Intrinsic_triangulations::sides(p.first, mesh);
  for(std::size_t s = 0; s < 3; ++s)
    if(p.second[s] != 0)
      visit(mesh.source(sides[s]), p.second[s]);
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// returns the matrix \f$P\f$ that maps values at the vertices of the coarse surface to values at
/// the vertices of the fine surface (Section 5.2.3). A row holds the barycentric coordinates of a
/// fine vertex on the coarse surface: no entry is negative, and the sum is one. Rows of common
/// vertices are rows of the identity. Complexity: the time to map the vertices.
///
/// Its transpose maps integrals against hat functions of the fine surface to integrals against hat
/// functions of the coarse surface.
/// \tparam Map `Surface_map`, `Correspondence_map` or `Composed_map`
/// \tparam NamedParameters a sequence of named parameters
/// \param map the map
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{concurrency_tag}
///     \cgalParamDescription{whether several threads are used; see \ref is_parallel}
///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
///                    `CGAL::Parallel_if_available_tag`}
///     \cgalParamDefault{`CGAL::Sequential_tag`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
template <typename Map, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Eigen::SparseMatrix<double>
prolongation_matrix(const Map& map, const NamedParameters& np = CGAL::parameters::default_values())
{
  const Delta_complex &fine = map.fine().mesh(), &coarse = map.coarse().mesh();
  const auto collect = [&](std::size_t i, auto& entries) {
    const Vertex_index v(static_cast<Vertex_index::size_type>(i));
    const auto add = [&entries](Vertex_index w, double value) {
      entries.emplace_back(static_cast<int>(w.idx()), value);
    };
    if(fine.is_isolated(v))
      return add(map.coarse_vertex(v), 1);
    internal::for_each_weight(image_of_vertex(v, map), coarse, add);
  };
  Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows;
  Intrinsic_triangulations::assemble(Intrinsic_triangulations::concurrency_of(np),
                                     fine.num_vertices(), coarse.num_vertices(), collect, by_rows);
  return by_rows;
}

/// \ingroup PkgIntrinsicSimplificationRef
/// returns the matrix that maps values at the vertices of the fine level to values at the vertices
/// of the coarse level. Values are means, weighted with the area of a fine vertex and its share in
/// a coarse vertex. No entry is negative, and the sum of a row is one. With lumped masses, it is
/// \f$R = M_c^{-1} P^T M\f$ with the diagonal matrix \f$M_c\f$ of the sums of the rows of \f$P^T
/// M\f$. So the integral of a function is kept. A coarse vertex that no fine vertex of positive
/// area contributes to gets the value at its position. Complexity: linear, plus a mapped point for
/// each of these vertices.
/// \param prolongation the matrix \f$P\f$
/// \param map the map from which it was made
inline Eigen::SparseMatrix<double>
restriction_matrix(const Eigen::SparseMatrix<double>& prolongation, const Surface_map& map)
{
  const Surface_level &fine = map.fine(), &coarse = map.coarse();
  const Eigen::SparseMatrix<double> mass = Intrinsic_triangulations::lumped_mass_matrix(fine);
  Eigen::SparseMatrix<double, Eigen::RowMajor> result = prolongation.transpose() * mass;
  for(Vertex_index v : coarse.mesh().vertices()) {
    const int row = static_cast<int>(v.idx());
    const double sum = result.row(row).sum();
    if(sum > 0)
      result.row(row) /= sum;
    else if(coarse.mesh().is_isolated(v))
      result.coeffRef(row, static_cast<int>(fine.level_vertex(coarse.surface_vertex(v)))) = 1;
    else
      internal::for_each_weight(
        preimage_of_vertex(v, map), fine.mesh(),
        [&](Vertex_index w, double x) { result.coeffRef(row, static_cast<int>(w)) += x; });
  }
  return result;
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_PROLONGATION_H
