// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_REORDERED_MATRIX_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_REORDERED_MATRIX_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the upper triangle of some rows and columns of a symmetric matrix, in a given order. The
// position of each entry is stored for matrices of the same pattern.
class Reordered_matrix
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef std::vector<Eigen::Index> Order;

  const Matrix& upper() const { return m_upper; }

  bool has_pattern_of(const Matrix& source) const
  {
    const int* outer = source.outerIndexPtr();
    const int* inner = source.innerIndexPtr();
    return m_outer.size() == static_cast<std::size_t>(source.outerSize() + 1) &&
           m_inner.size() == static_cast<std::size_t>(source.nonZeros()) &&
           std::equal(m_outer.begin(), m_outer.end(), outer) &&
           std::equal(m_inner.begin(), m_inner.end(), inner);
  }

  // Copies the pattern of `source`, which is compressed, with its rows and columns in `order`. The
  // diagonal always exists. Complexity: linear.
  void set_pattern(const Matrix& source, const Order& order)
  {
    m_outer.assign(source.outerIndexPtr(), source.outerIndexPtr() + source.outerSize() + 1);
    m_inner.assign(source.innerIndexPtr(), source.innerIndexPtr() + source.nonZeros());
    m_target.assign(m_inner.size(), -1);
    const std::vector<int> rank = ranks(order);
    allocate(order, rank);
    fill_pattern(order, rank);
  }

  // Copies the values of `source`, which has the same pattern as before, and adds `diagonal` (an
  // entry for each row of `source`).
  void set_values(const Matrix& source, const Eigen::VectorXd& diagonal, const Order& order)
  {
    double* values = m_upper.valuePtr();
    std::fill(values, values + m_upper.nonZeros(), 0.);
    for(std::size_t k = 0; k < m_target.size(); ++k)
      if(m_target[k] >= 0)
        values[m_target[k]] = source.valuePtr()[k];
    for(std::size_t column = 0; column < order.size(); ++column)
      values[diagonal_entry(column)] += diagonal[order[column]];
  }

private:
  std::vector<int> ranks(const Order& order) const
  {
    std::vector<int> result(m_outer.size() - 1, -1);
    for(std::size_t k = 0; k < order.size(); ++k)
      result[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
    return result;
  }

  // Returns the diagonal entry, which is the last entry of its column.
  int diagonal_entry(std::size_t column) const { return m_upper.outerIndexPtr()[column + 1] - 1; }

  // Calls `visit(entry, row)` for the entries of `column` of the source in rows that are used.
  template <typename Visit>
  void for_entries(Eigen::Index column, const std::vector<int>& rank, Visit visit) const
  {
    const std::size_t c = static_cast<std::size_t>(column);
    for(int k = m_outer[c]; k < m_outer[c + 1]; ++k)
      if(const int row = rank[static_cast<std::size_t>(m_inner[static_cast<std::size_t>(k)])];
         row >= 0)
        visit(static_cast<std::size_t>(k), row);
  }

  void allocate(const Order& order, const std::vector<int>& rank)
  {
    const int size = static_cast<int>(order.size());
    m_upper.resize(size, size);
    int* start = m_upper.outerIndexPtr();
    for(int q = 0; q < size; ++q) {
      start[q + 1] = 1;
      for_entries(order[static_cast<std::size_t>(q)], rank,
                  [&](std::size_t, int p) { start[q + 1] += p < q; });
    }
    for(int q = 0; q < size; ++q)
      start[q + 1] += start[q];
    m_upper.resizeNonZeros(start[size]);
  }

  // Fills the pattern. A column of the symmetric source is a row of the upper triangle, so rows
  // come in order.
  void fill_pattern(const Order& order, const std::vector<int>& rank)
  {
    int* inner = m_upper.innerIndexPtr();
    std::vector<int> next(m_upper.outerIndexPtr(), m_upper.outerIndexPtr() + order.size());
    for(std::size_t q = 0; q < order.size(); ++q) {
      const int row = static_cast<int>(q);
      for_entries(order[q], rank, [&](std::size_t k, int p) {
        if(p > row) {
          m_target[k] = next[static_cast<std::size_t>(p)]++;
          inner[m_target[k]] = row;
        } else if(p == row)
          m_target[k] = diagonal_entry(q);
      });
      inner[diagonal_entry(q)] = row;
    }
  }

  Matrix m_upper;
  std::vector<int> m_outer, m_inner; // the pattern of the source
  std::vector<int> m_target;         // for its entries, where they go; -1: nowhere
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_REORDERED_MATRIX_H
