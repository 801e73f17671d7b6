// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MULTIGRID_MULTIGRID_CYCLE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MULTIGRID_MULTIGRID_CYCLE_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Stores the connected components of the graph of a symmetric matrix, and the components on which
// constants are mapped to zero.
class Matrix_components
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;

  explicit Matrix_components(const Matrix& matrix)
    : m_label(static_cast<std::size_t>(matrix.cols()), none)
  {
    for(int j = 0; j < matrix.cols(); ++j)
      if(m_label[index(j)] == none)
        explore(j, matrix);
  }

  // Constructs components of the unknowns of a coarse level, with the indices of components of the
  // fine level.
  Matrix_components(const Matrix_components& fine, const Matrix& prolongation)
    : m_label(static_cast<std::size_t>(prolongation.cols()), none),
      m_is_floating(fine.m_is_floating)
  {
    for(int j = 0; j < prolongation.cols(); ++j)
      for(Matrix::InnerIterator entry(prolongation, j); entry; ++entry)
        m_label[index(j)] = fine[index(entry.row())];
  }

  std::size_t size() const { return m_is_floating.size(); }
  std::size_t operator[](std::size_t unknown) const { return m_label[unknown]; }
  bool is_floating(std::size_t component) const { return m_is_floating[component] != 0; }

private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  static std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

  // Explores a component. A sum of all entries that rounding can have caused counts as zero.
  void explore(int start, const Matrix& matrix)
  {
    double sum = 0, size = 0;
    std::vector<int> open{start};
    m_label[index(start)] = m_is_floating.size();
    while(!open.empty()) {
      const int j = open.back();
      open.pop_back();
      for(Matrix::InnerIterator entry(matrix, j); entry; ++entry) {
        sum += entry.value();
        size += std::abs(entry.value());
        if(std::size_t& label = m_label[index(entry.row())]; label == none) {
          label = m_is_floating.size();
          open.push_back(static_cast<int>(entry.row()));
        }
      }
    }
    m_is_floating.push_back(std::abs(sum) <= matrix_rounding * size ? 1 : 0);
  }

  std::vector<std::size_t> m_label; // of each unknown
  std::vector<char> m_is_floating;  // of each component
};

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
