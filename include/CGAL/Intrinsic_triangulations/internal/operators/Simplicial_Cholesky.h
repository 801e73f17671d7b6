// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SIMPLICIAL_CHOLESKY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SIMPLICIAL_CHOLESKY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace CGAL::Intrinsic_triangulations::internal {

// Adapts Eigen's Cholesky factorization of Hermitian matrices given by their upper triangles. Rows
// are not permuted.
template <typename Scalar>
class Simplicial_Cholesky
  : Eigen::SimplicialLLT<Eigen::SparseMatrix<Scalar>, Eigen::Upper, Eigen::NaturalOrdering<int>>
{
  typedef Eigen::SimplicialLLT<Eigen::SparseMatrix<Scalar>, Eigen::Upper,
                               Eigen::NaturalOrdering<int>>
    Base;

public:
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> Columns;

  // Returns the elimination order that keeps the factor sparse. Its k-th entry is the row that is
  // eliminated in step k.
  static Eigen::VectorXi fill_reducing_order(const Matrix& upper)
  {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(upper.template selfadjointView<Eigen::Upper>(), order);
    return order.indices();
  }

  void analyze(const Matrix& upper) { Base::analyzePattern(upper); }

  // Returns false if the matrix is not positive definite.
  bool factorize(const Matrix& upper)
  {
    Base::factorize(upper);
    return Base::info() == Eigen::Success;
  }

  Vector solve(const Vector& right_side) const { return Base::solve(right_side); }
  Columns solve_columns(const Columns& right_sides) const { return Base::solve(right_sides); }

  // Returns the number of entries of the factor. Eigen knows it after the analysis, but has no
  // public function for it.
  double size() const { return static_cast<double>(Base::m_matrix.nonZeros()); }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SIMPLICIAL_CHOLESKY_H
