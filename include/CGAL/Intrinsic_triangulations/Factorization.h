// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FACTORIZATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FACTORIZATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Cholesky.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/number_utils.h>

#include <Eigen/SparseCore>

#include <memory>
#include <string>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// an order of elimination: its k-th entry is the k-th row to be eliminated.
typedef Eigen::VectorXi Elimination_order;

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// returns an order for all Hermitian matrices with this pattern that keeps their factors sparse.
/// Complexity: by nested dissection or minimum degree, almost linear on meshes.
template <typename Scalar>
Elimination_order fill_reducing_order(const Eigen::SparseMatrix<Scalar>& matrix)
{
  if(matrix.nonZeros() == 0) // the libraries need an entry
    return Elimination_order::LinSpaced(matrix.rows(), 0, static_cast<int>(matrix.rows()) - 1);
  return Cholesky<Scalar>::fill_reducing_order(matrix);
}

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// the factorization of a Hermitian positive definite matrix; real if `Scalar` is.
template <typename Scalar>
class Factorization
{
public:
  /// the type of the matrix.
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  /// the type of right sides and solutions.
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;

  /// the type of several right sides and solutions.
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> Columns;

  /// factorizes `matrix`, whose name in an error is `name`.
  /// \throws Numerical_error if it is not positive definite
  Factorization(const Matrix& matrix, const std::string& name)
    : Factorization(matrix, fill_reducing_order(matrix), name)
  {}

  /// factorizes `matrix` in this order.
  Factorization(const Matrix& matrix, const Elimination_order& order, const std::string& name)
    : m_order(order)
  {
    if(matrix.rows() == 0)
      return;
    Matrix upper(matrix.rows(), matrix.cols());
    upper.template selfadjointView<Eigen::Upper>() =
      matrix.template selfadjointView<Eigen::Upper>().twistedBy(m_order.inverse());
    if(!factorize(upper))
      throw Numerical_error("the " + name + " has no factorization as a positive definite matrix");
  }

  /// returns the order of elimination.
  const Elimination_order& order() const { return m_order.indices(); }

  /// returns the solution. It may be called by several threads at once.
  Vector solve(const Vector& right_side) const
  {
    return m_cholesky ? Vector(m_order * m_cholesky->solve(m_order.inverse() * right_side))
                      : right_side;
  }

  /// returns the solutions for all columns. This takes less time than one call for each column.
  /// They are equal to the results of `solve()` up to rounding. It may be called by several threads
  /// at once.
  Columns solve_columns(const Columns& right_sides) const
  {
    return m_cholesky
             ? Columns(m_order * m_cholesky->solve_columns(m_order.inverse() * right_sides))
             : right_sides;
  }

private:
  bool factorize(const Matrix& upper)
  {
    if(upper.nonZeros() == 0 || !CGAL::is_finite(upper.coeffs().abs().sum()))
      return false;
    m_cholesky = std::make_unique<Cholesky<Scalar>>();
    m_cholesky->analyze(upper, true);
    return m_cholesky->factorize(upper);
  }

  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> m_order;
  std::unique_ptr<Cholesky<Scalar>> m_cholesky; // cannot be moved itself
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FACTORIZATION_H
