// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MULTIGRID_MULTIGRID_CYCLE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MULTIGRID_MULTIGRID_CYCLE_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/multigrid/Matrix_components.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

typedef Eigen::SparseMatrix<double> Matrix;
typedef Eigen::VectorXd Vector;

// Represents a symmetric matrix with a smoother. Columns serve as rows.
class Multigrid_level
{
public:
  explicit Multigrid_level(Matrix matrix)
  {
    m_matrix.swap(matrix); // Eigen's matrices are not moved
    m_matrix.makeCompressed();
    const Vector diagonal = m_matrix.diagonal();
    m_inverse_diagonal = (diagonal.array() > 0).select(diagonal.cwiseInverse(), 0); // empty rows
  }

  const Matrix& matrix() const { return m_matrix; }

  Vector residual(const Vector& b, const Vector& x) const { return b - m_matrix.transpose() * x; }

  // Applies a Gauss-Seidel sweep.
  void smooth(const Vector& b, Vector& x) const
  {
    for(Eigen::Index j = 0; j < x.size(); ++j)
      relax(j, b, x);
  }

  // Applies a Gauss-Seidel sweep in reverse order, so that both sweeps together are symmetric.
  void smooth_back(const Vector& b, Vector& x) const
  {
    for(Eigen::Index j = x.size(); j-- > 0;)
      relax(j, b, x);
  }

private:
  void relax(Eigen::Index j, const Vector& b, Vector& x) const
  {
    double rest = b[j];
    for(Matrix::InnerIterator entry(m_matrix, j); entry; ++entry)
      rest -= entry.value() * x[entry.index()];
    x[j] += rest * m_inverse_diagonal[j];
  }

  Matrix m_matrix;
  Vector m_inverse_diagonal;
};

// Solves on the coarsest level. On a component where the matrix maps constants to zero, the first
// value is zero.
class Coarse_solver
{
public:
  Coarse_solver(const Matrix& matrix, const Matrix_components& components)
    : m_unknowns(select_unknowns(static_cast<std::size_t>(matrix.cols()), components)),
      m_factorization(m_unknowns.transpose() * matrix * m_unknowns, "coarse matrix")
  {}

  Vector operator()(const Vector& b) const
  {
    return m_unknowns * m_factorization.solve(m_unknowns.transpose() * b);
  }

private:
  static Matrix select_unknowns(std::size_t size, const Matrix_components& components)
  {
    std::vector<char> is_determined(components.size());
    for(std::size_t c = 0; c < components.size(); ++c)
      is_determined[c] = components.is_floating(c) ? 0 : 1;
    std::vector<std::size_t> unknowns;
    for(std::size_t v = 0; v < size; ++v) {
      char& determined = is_determined[components[v]];
      if(determined)
        unknowns.push_back(v);
      determined = 1;
    }
    return Intrinsic_triangulations::selection_matrix<double>(size, unknowns);
  }

  Matrix m_unknowns;
  Intrinsic_triangulations::Factorization<double> m_factorization;
};

// Applies one V-cycle, an approximate inverse that is symmetric, and positive definite if the
// matrix is. Coarser levels have the Galerkin matrices P^T A P.
class Multigrid_cycle
{
public:
  Multigrid_cycle(const Matrix& matrix, const Matrix_components& components,
                  const std::vector<Matrix>& prolongations)
    : m_prolongations(prolongations)
  {
    Matrix_components coarse_components = components;
    m_levels.emplace_back(matrix);
    for(const Matrix& p : prolongations) {
      m_levels.emplace_back(Matrix(p.transpose() * m_levels.back().matrix() * p));
      coarse_components = Matrix_components(coarse_components, p);
    }
    m_coarse_solver = std::make_unique<Coarse_solver>(m_levels.back().matrix(), coarse_components);
  }

  const Multigrid_level& finest() const { return m_levels.front(); }

  Vector operator()(const Vector& b) const { return cycle(0, b); }

  // Returns the number of entries of the matrices and prolongations of all levels.
  std::size_t number_of_entries() const
  {
    Eigen::Index result = 0;
    for(const Multigrid_level& level : m_levels)
      result += level.matrix().nonZeros();
    for(const Matrix& p : m_prolongations)
      result += p.nonZeros();
    return static_cast<std::size_t>(result);
  }

private:
  Vector cycle(std::size_t n, const Vector& b) const
  {
    if(n == m_prolongations.size())
      return (*m_coarse_solver)(b);
    const Multigrid_level& level = m_levels[n];
    const Matrix& p = m_prolongations[n];
    Vector x = Vector::Zero(b.size());
    level.smooth(b, x);
    x += p * cycle(n + 1, p.transpose() * level.residual(b, x));
    level.smooth_back(b, x);
    return x;
  }

  std::vector<Matrix> m_prolongations;
  std::vector<Multigrid_level> m_levels; // the finest first
  std::unique_ptr<Coarse_solver> m_coarse_solver;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MULTIGRID_MULTIGRID_CYCLE_H
