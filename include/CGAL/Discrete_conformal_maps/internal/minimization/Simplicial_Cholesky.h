// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_SIMPLICIAL_CHOLESKY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_SIMPLICIAL_CHOLESKY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace CGAL::Discrete_conformal_maps::internal {

// Eigen's Cholesky factorization of matrices given by their upper triangles, in the order they
// have.
class Simplicial_Cholesky
  : Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>>
{
  typedef Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Upper,
                               Eigen::NaturalOrdering<int>>
    Base;

public:
  typedef Eigen::SparseMatrix<double> Matrix;

  // The order of elimination that keeps the factor sparse: its k-th entry is the k-th row to go.
  static Eigen::VectorXi fill_reducing_order(const Matrix& upper)
  {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(upper.selfadjointView<Eigen::Upper>(), order);
    return order.indices();
  }

  void analyze(const Matrix& upper) { Base::analyzePattern(upper); }

  // Returns false if the matrix is not positive definite.
  bool factorize(const Matrix& upper)
  {
    Base::factorize(upper);
    return Base::info() == Eigen::Success;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const { return Base::solve(right_side); }

  // The number of entries of the factor; it is known after the analysis, but not to Eigen's users.
  double size() const { return static_cast<double>(m_matrix.nonZeros()); }
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_SIMPLICIAL_CHOLESKY_H
