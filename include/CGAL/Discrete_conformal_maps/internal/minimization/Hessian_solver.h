// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_HESSIAN_SOLVER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_HESSIAN_SOLVER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Reordered_matrix.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <utility>

namespace CGAL::Discrete_conformal_maps::internal {

// Solves with matrix after matrix of similar pattern. The order of elimination, the costly part of
// the analysis, is kept while it is still good. `Cholesky` is `Simplicial_Cholesky` or
// `Supernodal_Cholesky`.
template <typename Cholesky>
class Hessian_solver
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef Reordered_matrix::Order Order;

  // the rows and columns that are taken from every matrix
  explicit Hessian_solver(Order rows) : m_order(std::move(rows)) {}

  std::size_t factorizations() const { return m_factorizations; }
  std::size_t symbolic_analyses() const { return m_symbolic_analyses; }
  std::size_t orderings() const { return m_orderings; }

  // Factorizes `matrix` with `diagonal` added; returns false if that is not positive definite.
  bool factorize(const Matrix& matrix, const Eigen::VectorXd& diagonal)
  {
    if(m_order.empty())
      return true;
    if(!m_matrix.has_pattern_of(matrix))
      analyze(matrix);
    m_matrix.set_values(matrix, diagonal, m_order);
    ++m_factorizations;
    return m_cholesky.factorize(m_matrix.upper());
  }

  // Rows that are not taken have no influence, and zero in the solution.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side)
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(right_side.size());
    if(!m_order.empty())
      result(m_order) = m_cholesky.solve(right_side(m_order));
    return result;
  }

private:
  void analyze(const Matrix& matrix)
  {
    if(m_orderings > 0) {
      analyze_in_order(matrix);
      if(m_cholesky.size() <= 1.2 * m_size_when_ordered) // else the order is outdated
        return;
    }
    reorder(matrix);
    analyze_in_order(matrix);
    m_size_when_ordered = m_cholesky.size();
  }

  void analyze_in_order(const Matrix& matrix)
  {
    m_matrix.set_pattern(matrix, m_order);
    m_cholesky.analyze(m_matrix.upper());
    ++m_symbolic_analyses;
  }

  void reorder(const Matrix& matrix)
  {
    m_matrix.set_pattern(matrix, m_order);
    const Order old(m_order);
    const Eigen::VectorXi order = Cholesky::fill_reducing_order(m_matrix.upper());
    for(std::size_t k = 0; k < old.size(); ++k)
      m_order[k] = old[static_cast<std::size_t>(order[static_cast<Eigen::Index>(k)])];
    ++m_orderings;
  }

  Order m_order;
  Reordered_matrix m_matrix;
  Cholesky m_cholesky;
  double m_size_when_ordered = 0;
  std::size_t m_factorizations = 0, m_symbolic_analyses = 0, m_orderings = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_HESSIAN_SOLVER_H
