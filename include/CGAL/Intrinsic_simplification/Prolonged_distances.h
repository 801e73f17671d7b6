// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_PROLONGED_DISTANCES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_PROLONGED_DISTANCES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Returns the geodesic distances from a vertex, or another point, to all vertices of a level.
template <typename Source>
Eigen::VectorXd geodesic_distances(const Source& source, const Surface_level& level)
{
  Intrinsic_triangulations::Shortest_paths paths(level);
  paths.add_source(source);
  paths.run();
  Eigen::VectorXd result(static_cast<Eigen::Index>(level.mesh().num_vertices()));
  for(Vertex_index v : level.mesh().vertices())
    result[v] = paths.distance(v);
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationApplications
/// approximates the geodesic distances from a vertex of the fine level to all vertices. It computes
/// exact distances from its image to the vertices of the coarse level, and prolongs them.
/// Unreachable vertices get infinity. Complexity: exact geodesic distances on the coarse level,
/// about linear in practice, plus linear time in the fine level.
/// \param source the vertex
/// \param map the map between the levels
/// \param prolongation the matrix `prolongation_matrix(map)`
/// \pre `source` is not isolated
inline Eigen::VectorXd
prolonged_distances_from(Vertex_index source, const Surface_map& map,
                         const Eigen::SparseMatrix<double, Eigen::RowMajor>& prolongation)
{
  const Vertex_index there = map.coarse_vertex(source);
  if(there.is_valid())
    return prolongation * internal::geodesic_distances(there, map.coarse());
  return prolongation * internal::geodesic_distances(image_of_vertex(source, map), map.coarse());
}

/// \ingroup PkgIntrinsicSimplificationApplications
/// approximates the geodesic distances between all pairs of vertices of a fine level by \f$P D
/// P^T\f$. The matrix \f$D\f$ has exact distances between vertices of a coarse level. The distance
/// of a vertex from itself is zero only for vertices of the coarse level. Distances much shorter
/// than coarse edges are too large.
///
/// Memory: \f$8 n_c^2\f$ bytes for \f$n_c\f$ coarse vertices, plus the prolongation.
class Prolonged_distances
{
public:
  /// the type of matrices with three entries in a row.
  typedef Eigen::SparseMatrix<double, Eigen::RowMajor> Prolongation;

  /// computes the distances on the coarse level. Complexity: exact geodesic distances from each
  /// coarse vertex, about quadratic in practice.
  /// \param coarse the coarse level
  /// \param prolongation the prolongation from the coarse level
  Prolonged_distances(const Surface_level& coarse, const Prolongation& prolongation)
    : m_prolongation(prolongation), m_coarse(prolongation.cols(), prolongation.cols())
  {
    CGAL_precondition(prolongation.cols() ==
                      static_cast<Eigen::Index>(coarse.mesh().number_of_vertices()));
    for(Vertex_index v : coarse.mesh().vertices())
      m_coarse.col(v) = internal::geodesic_distances(v, coarse);
  }

  /// returns the distances \f$D\f$ on the coarse level.
  const Eigen::MatrixXd& coarse_distances() const { return m_coarse; }

  /// returns the distance between two vertices of the fine level. Complexity: constant.
  double operator()(Vertex_index v, Vertex_index w) const
  {
    double sum = 0;
    for(Prolongation::InnerIterator a(m_prolongation, v); a; ++a)
      for(Prolongation::InnerIterator b(m_prolongation, w); b; ++b)
        sum += a.value() * b.value() * m_coarse(a.index(), b.index());
    return sum;
  }

  /// returns the distances from a vertex of the fine level to all vertices. Complexity: linear.
  Eigen::VectorXd from(Vertex_index v) const
  {
    Eigen::VectorXd to_coarse = Eigen::VectorXd::Zero(m_coarse.rows());
    for(Prolongation::InnerIterator a(m_prolongation, v); a; ++a)
      to_coarse += a.value() * m_coarse.col(a.index());
    return m_prolongation * to_coarse;
  }

  /// computes all distances between vertices of the fine level. Complexity: quadratic.
  /// Memory: \f$8 n (n + n_c)\f$ bytes for \f$n\f$ vertices.
  Eigen::MatrixXd matrix() const
  {
    const Eigen::MatrixXd from_coarse = m_coarse * m_prolongation.transpose();
    return m_prolongation * from_coarse;
  }

private:
  Prolongation m_prolongation;
  Eigen::MatrixXd m_coarse;
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_PROLONGED_DISTANCES_H
