// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_DIRICHLET_SOLVER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_DIRICHLET_SOLVER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

// Solves systems with symmetric positive semidefinite matrices from which the rows and columns of some
// variables are left out. Matrices of one size and with the same variables are factorized one after the
// other; the order of elimination is looked for again only where the pattern is not that of the one
// before: an old order can be very bad for a pattern with flipped edges.
class Dirichlet_solver
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef Eigen::VectorXd Vector;

  // Without the variables that are fixed, the matrix must be positive definite.
  // \throws Numerical_error if it is not
  void factorize(const Matrix& matrix, const std::vector<char>& is_fixed)
  {
    number_free(is_fixed);
    Matrix reduced = lower_part(matrix);
    if(!has_same_pattern(reduced, m_matrix))
      m_solver.analyzePattern(reduced);
    m_matrix.swap(reduced);
    m_solver.factorize(m_matrix);
    if(m_size > 0 && m_solver.info() != Eigen::Success)
      throw Intrinsic_triangulations::Numerical_error(
        "the Laplacian has no factorization as a positive definite matrix");
  }

  // the solution; zero where variables are fixed
  Vector solve(const Vector& right_side) const
  {
    Vector reduced(m_size), result = Vector::Zero(right_side.size());
    for(Eigen::Index i = 0; i < right_side.size(); ++i)
      if(number(i) >= 0)
        reduced[number(i)] = right_side[i];
    if(m_size > 0)
      reduced = m_solver.solve(reduced).eval();
    for(Eigen::Index i = 0; i < right_side.size(); ++i)
      if(number(i) >= 0)
        result[i] = reduced[number(i)];
    return result;
  }

private:
  // among those that are free; negative for a variable that is fixed
  int number(Eigen::Index i) const { return m_number[static_cast<std::size_t>(i)]; }

  void number_free(const std::vector<char>& is_fixed)
  {
    m_number.assign(is_fixed.size(), -1);
    m_size = 0;
    for(std::size_t i = 0; i < is_fixed.size(); ++i)
      if(!is_fixed[i])
        m_number[i] = m_size++;
  }

  // rows stay in order
  Matrix lower_part(const Matrix& matrix) const
  {
    Matrix result(m_size, m_size);
    result.reserve(matrix.nonZeros() / 2 + m_size);
    for(Eigen::Index j = 0; j < matrix.outerSize(); ++j)
      if(number(j) >= 0) {
        result.startVec(number(j));
        for(Matrix::InnerIterator it(matrix, j); it; ++it)
          if(number(it.row()) >= number(j))
            result.insertBack(number(it.row()), number(j)) = it.value();
      }
    result.finalize();
    return result;
  }

  static bool has_same_pattern(const Matrix& a, const Matrix& b)
  {
    return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() &&
           std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1,
                      b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
  }

  std::vector<int> m_number;
  int m_size = 0;
  Matrix m_matrix;
  Eigen::SimplicialLLT<Matrix> m_solver;
};

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_DIRICHLET_SOLVER_H
