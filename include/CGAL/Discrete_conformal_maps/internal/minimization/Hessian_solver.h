// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_HESSIAN_SOLVER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_HESSIAN_SOLVER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Factorization_counts.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Reordered_matrix.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL::Discrete_conformal_maps::internal {

// Solves with a sequence of matrices of similar pattern. The elimination order, the costly part of
// the analysis, is kept while it is good, and shared with others. `Cholesky` is
// `Simplicial_Cholesky`, `Supernodal_Cholesky` or `Indefinite_Cholesky`.
template <typename Cholesky>
class Hessian_solver
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef Reordered_matrix::Order Order;

  // `rows` are the rows and columns used of every matrix; `shared` is an order of all rows.
  explicit Hessian_solver(Order rows,
                          std::shared_ptr<Shared_order> shared = std::make_shared<Shared_order>())
    : m_order(std::move(rows)), m_shared(std::move(shared))
  {}

  const Factorization_counts& counts() const { return m_counts; }

  // Returns the elimination order of the rows of `matrix`.
  const Order& order(const Matrix& matrix)
  {
    if(!m_matrix.has_pattern_of(matrix))
      analyze(matrix);
    return m_order;
  }

  // Factorizes `matrix` with `diagonal` added. Returns false if the factorization does not exist:
  // if the sum is not positive definite, unless the factorization is for indefinite matrices.
  bool factorize(const Matrix& matrix, const Eigen::VectorXd& diagonal)
  {
    if(m_order.empty())
      return true;
    if(!m_matrix.has_pattern_of(matrix))
      analyze(matrix);
    m_matrix.set_values(matrix, diagonal, m_order);
    count(&Factorization_counts::factorizations);
    return m_cholesky.factorize(m_matrix.upper());
  }

  // Returns the solution. Unused rows have no influence, and are zero in it.
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
    if(m_shared->is_known()) {
      analyze_in_order(matrix);
      if(m_shared->is_good(entries_of_row()))
        return;
    }
    reorder(matrix);
    analyze_in_order(matrix);
    m_shared->set_entries(entries_of_row());
  }

  void analyze_in_order(const Matrix& matrix)
  {
    m_order = m_shared->sorted(m_order);
    m_matrix.set_pattern(matrix, m_order);
    m_cholesky.analyze(m_matrix.upper());
    count(&Factorization_counts::symbolic_analyses);
  }

  // Recomputes the order. Omitted variables have an entry, too, because others may use it.
  void reorder(const Matrix& matrix)
  {
    const Eigen::VectorXi order = Cholesky::fill_reducing_order(matrix);
    m_shared->set(Order(order.begin(), order.end()));
    count(&Factorization_counts::orderings);
  }

  double entries_of_row() { return m_cholesky.size() / static_cast<double>(m_order.size()); }

  void count(std::size_t Factorization_counts::*what)
  {
    ++(m_counts.*what);
    ++((*m_shared->counts()).*what);
  }

  Order m_order;
  std::shared_ptr<Shared_order> m_shared;
  Reordered_matrix m_matrix;
  Cholesky m_cholesky;
  Factorization_counts m_counts;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_HESSIAN_SOLVER_H
