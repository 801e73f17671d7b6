// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_LAPLACIAN_ELIMINATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_LAPLACIAN_ELIMINATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Solves with the Laplacian of a graph with positive weights, however different they are. The
// excess of a diagonal entry over the weights of its row is stored as a separate number. So no
// subtraction is needed to eliminate vertices. Each weight keeps all its digits, as in the
// algorithm of Grassmann, Taksar and Heyman (1985). A Cholesky factorization loses a weight of 1
// beside one of 10^16. With more digits than `double` has, solutions of strongly tied variables
// have correct differences.
template <typename FT>
class Laplacian_elimination
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef std::vector<Eigen::Index> Order;
  typedef std::vector<FT> Solution;

  // Returns whether the weights of rows and columns of a matrix are so different that this
  // algorithm is needed, and none is negative.
  static bool is_needed(const Matrix& matrix, const Order& rows)
  {
    double least = std::numeric_limits<double>::infinity(), greatest = 0;
    for(Eigen::Index column : rows)
      for(Matrix::InnerIterator i(matrix, column); i; ++i)
        if(i.row() == column) {
          least = (std::min)(least, i.value());
          greatest = (std::max)(greatest, i.value());
        }
    return least > 0 && tolerance::stiffness * greatest > least &&
           has_no_negative_weight(matrix, rows);
  }

  // Eliminates the rows and columns of `order`, with `ground` added to the diagonal. Returns false
  // if the sum is singular.
  // \pre The rows of the matrix sum to zero, or `ground` contains their sums.
  bool factorize(const Matrix& matrix, const Eigen::VectorXd& ground, const Order& order)
  {
    m_order = order;
    set_weights(matrix, ground);
    for(std::size_t k = 0; k < m_order.size(); ++k) {
      FT& sum = m_sum[k] = m_ground[k];
      for(const Entry& e : m_row[k])
        sum += e.weight;
      if(!(sum > 0 && std::isfinite(static_cast<double>(sum))))
        return false;
      for(Entry& e : m_row[k])
        e.part = e.weight / sum;
      const FT ground_part = m_ground[k] / sum;
      for(const Entry& e : m_row[k]) {
        m_ground[e.column] += e.weight * ground_part;
        add_star(k, e);
      }
    }
    return true;
  }

  // Returns the solution, in which variables that are not eliminated are zero.
  Solution solve(const Eigen::VectorXd& right_side) const
  {
    Solution b;
    for(Eigen::Index i : m_order)
      b.push_back(FT(right_side[i]));
    for(std::size_t k = 0; k < m_order.size(); ++k)
      for(const Entry& e : m_row[k])
        b[e.column] += e.part * b[k];
    Solution result(std::size_t(right_side.size()), FT(0));
    for(std::size_t k = m_order.size(); k-- > 0;) {
      b[k] /= m_sum[k];
      for(const Entry& e : m_row[k])
        b[k] += e.part * b[e.column];
      result[std::size_t(m_order[k])] = b[k];
    }
    return result;
  }

private:
  struct Entry
  {
    std::size_t column;
    FT weight, part; // of the sum of all weights of its row, once this row is eliminated
  };
  typedef std::vector<Entry> Row; // in ascending order

  // Returns whether no weight is negative. Rounding can leave a weight of a cocircular pair of
  // faces slightly below zero.
  static bool has_no_negative_weight(const Matrix& matrix, const Order& rows)
  {
    for(Eigen::Index column : rows)
      for(Matrix::InnerIterator i(matrix, column); i; ++i)
        if(i.row() != column && i.value() > tolerance::negative_weight)
          return false;
    return true;
  }

  // Sets the weights to variables that are eliminated later, and the sum of all other weights to
  // the ground.
  void set_weights(const Matrix& matrix, const Eigen::VectorXd& ground)
  {
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> place(std::size_t(matrix.cols()), none);
    for(std::size_t k = 0; k < m_order.size(); ++k)
      place[std::size_t(m_order[k])] = k;
    m_row.assign(m_order.size(), Row());
    m_ground.assign(m_order.size(), FT(0));
    m_sum.assign(m_order.size(), FT(0));
    for(std::size_t k = 0; k < m_order.size(); ++k) {
      m_ground[k] = FT(ground[m_order[k]]);
      for(Matrix::InnerIterator i(matrix, m_order[k]); i; ++i) {
        const FT weight((std::max)(-i.value(), 0.));
        if(const std::size_t other = place[std::size_t(i.row())]; other == none)
          m_ground[k] += weight;
        else if(other > k)
          m_row[k].push_back({other, weight, FT(0)});
      }
      std::sort(m_row[k].begin(), m_row[k].end(),
                [](const Entry& a, const Entry& b) { return a.column < b.column; });
    }
  }

  // Joins the neighbor `e` of the variable `k` to the neighbors after it.
  void add_star(std::size_t k, const Entry& e)
  {
    Row& row = m_row[e.column];
    Row joined;
    auto present = row.begin();
    for(const Entry& other : m_row[k]) {
      if(other.column <= e.column)
        continue;
      while(present != row.end() && present->column < other.column)
        joined.push_back(*present++);
      FT weight = e.weight * other.part;
      if(present != row.end() && present->column == other.column)
        weight += present++->weight;
      joined.push_back({other.column, weight, FT(0)});
    }
    joined.insert(joined.end(), present, row.end());
    row = std::move(joined);
  }

  Order m_order;                   // of elimination
  std::vector<Row> m_row;          // weights to variables after each
  std::vector<FT> m_ground, m_sum; // the weight to fixed variables; that of all neighbors
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_LAPLACIAN_ELIMINATION_H
