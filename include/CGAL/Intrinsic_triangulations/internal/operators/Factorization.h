// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_FACTORIZATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_FACTORIZATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/number_utils.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <complex>
#include <memory>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// The factorization of a Hermitian positive definite matrix; real if `Scalar` is.
template <typename Scalar>
class Factorization
{
public:
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;

  // `name` is what the error calls the matrix
  Factorization(const Matrix& matrix, const std::string& name)
  {
    if(matrix.rows() == 0)
      return; // Eigen cannot
    m_solver = std::make_unique<Eigen::SimplicialLDLT<Matrix>>(matrix);
    if(m_solver->info() != Eigen::Success || !is_positive(m_solver->vectorD().real()))
      throw Numerical_error("the " + name + " has no factorization as a positive definite matrix");
  }

  Vector solve(const Vector& right_side) const
  {
    return m_solver ? Vector(m_solver->solve(right_side)) : right_side;
  }

private:
  template <typename Diagonal>
  static bool is_positive(const Diagonal& d)
  {
    return d.minCoeff() > 0 && CGAL::is_finite(d.sum());
  }

  std::unique_ptr<Eigen::SimplicialLDLT<Matrix>> m_solver; // cannot be moved itself
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_FACTORIZATION_H
