// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SPARSE_ASSEMBLY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SPARSE_ASSEMBLY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Collects the entries of a sparse matrix; entries at one place add up.
template <typename Scalar>
class Sparse_assembly
{
public:
  explicit Sparse_assembly(std::size_t expected) { m_entries.reserve(expected); }

  void add(std::size_t row, std::size_t column, const Scalar& value)
  {
    m_entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  }

  void add(Vertex_index row, Vertex_index column, const Scalar& value)
  {
    add(row.idx(), column.idx(), value);
  }

  Eigen::SparseMatrix<Scalar> matrix(std::size_t rows, std::size_t columns) const
  {
    Eigen::SparseMatrix<Scalar> result(static_cast<int>(rows), static_cast<int>(columns));
    result.setFromTriplets(m_entries.begin(), m_entries.end());
    return result;
  }

private:
  std::vector<Eigen::Triplet<Scalar>> m_entries;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SPARSE_ASSEMBLY_H
