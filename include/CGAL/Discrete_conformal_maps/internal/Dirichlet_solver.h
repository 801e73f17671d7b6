// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_DIRICHLET_SOLVER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_DIRICHLET_SOLVER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/OrderingMethods>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

// Solves systems with symmetric positive semidefinite matrices from which the rows and columns of some
// variables are left out, one after the other. The order of elimination is looked for once: matrices that
// follow have nearly the same pattern.
class Dirichlet_solver
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef Eigen::VectorXd Vector;

  // Without the variables that are fixed, the matrix must be positive definite.
  // \throws Numerical_error if it is not
  void factorize(const Matrix& matrix, const std::vector<char>& is_fixed)
  {
    if(m_place.empty())
      order(matrix, is_fixed);
    const Matrix permuted = lower_part(matrix);
    m_solver.compute(permuted);
    if(m_size > 0 && m_solver.info() != Eigen::Success)
      throw Intrinsic_triangulations::Numerical_error(
        "the Laplacian has no factorization as a positive definite matrix");
  }

  // the solution; zero where variables are fixed
  Vector solve(const Vector& right_side) const
  {
    Vector reduced(m_size), result = Vector::Zero(right_side.size());
    for(Eigen::Index i = 0; i < right_side.size(); ++i)
      if(place(i) >= 0)
        reduced[place(i)] = right_side[i];
    if(m_size > 0)
      reduced = m_solver.solve(reduced).eval();
    for(Eigen::Index i = 0; i < right_side.size(); ++i)
      if(place(i) >= 0)
        result[i] = reduced[place(i)];
    return result;
  }

private:
  // in the order of elimination; negative for a variable that is fixed
  int place(Eigen::Index i) const { return m_place[static_cast<std::size_t>(i)]; }

  void order(const Matrix& matrix, const std::vector<char>& is_fixed)
  {
    m_place.assign(is_fixed.size(), -1);
    for(std::size_t i = 0; i < is_fixed.size(); ++i)
      if(!is_fixed[i])
        m_place[i] = m_size++;
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> inverse;
    const Matrix lower = lower_part(matrix);
    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), inverse);
    const auto permutation = inverse.inverse().eval();
    for(int& p : m_place)
      if(p >= 0)
        p = permutation.indices()[p];
  }

  // Columns are filled by counting, without sorting: the factorization does not need it.
  Matrix lower_part(const Matrix& matrix) const
  {
    Matrix result(m_size, m_size);
    Eigen::VectorXi count = Eigen::VectorXi::Zero(m_size);
    for_each_lower(matrix, [&](int, int column, double) { ++count[column]; });
    result.reserve(count);
    for_each_lower(matrix,
                   [&](int row, int column, double value) { result.insert(row, column) = value; });
    result.makeCompressed();
    return result;
  }

  template <typename Visit>
  void for_each_lower(const Matrix& matrix, const Visit& visit) const
  {
    for(Eigen::Index j = 0; j < matrix.outerSize(); ++j)
      if(place(j) >= 0)
        for(Matrix::InnerIterator it(matrix, j); it; ++it)
          if(place(it.row()) >= place(j))
            visit(place(it.row()), place(j), it.value());
  }

  std::vector<int> m_place;
  int m_size = 0;
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> m_solver;
};

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_DIRICHLET_SOLVER_H
