// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MULTIGRID_MATRIX_COMPONENTS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MULTIGRID_MATRIX_COMPONENTS_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/tolerances.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <limits>
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

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MULTIGRID_MATRIX_COMPONENTS_H
