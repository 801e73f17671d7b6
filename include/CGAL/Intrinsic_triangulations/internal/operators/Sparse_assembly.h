// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SPARSE_ASSEMBLY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SPARSE_ASSEMBLY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/concurrency/for_each_in_chunks.h>

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

  // adds the entries of another one
  void append(const Sparse_assembly& other)
  {
    m_entries.insert(m_entries.end(), other.m_entries.begin(), other.m_entries.end());
  }

  std::size_t size() const { return m_entries.size(); }

  Eigen::SparseMatrix<Scalar> matrix(std::size_t rows, std::size_t columns) const
  {
    Eigen::SparseMatrix<Scalar> result(static_cast<int>(rows), static_cast<int>(columns));
    result.setFromTriplets(m_entries.begin(), m_entries.end());
    return result;
  }

private:
  std::vector<Eigen::Triplet<Scalar>> m_entries;
};

// Collects the entries of a symmetric matrix, of which those above the diagonal are kept. Where many
// add up this is faster than `Sparse_assembly`, and the sums are the same, to the bit.
template <typename Scalar>
class Symmetric_assembly
{
public:
  // for a matrix with `size` rows and `expected` entries above the diagonal
  Symmetric_assembly(std::size_t size, std::size_t expected)
    : m_diagonal(size, Scalar(0)), m_is_on_diagonal(size), m_entries(expected + size)
  {}

  void add(Vertex_index row, Vertex_index column, const Scalar& value)
  {
    if(row < column)
      m_entries.add(row, column, value);
    if(row != column)
      return;
    m_diagonal[row.idx()] += value;
    m_is_on_diagonal[row.idx()] = true;
  }

  // To be called once.
  Eigen::SparseMatrix<Scalar> matrix()
  {
    const std::size_t size = m_diagonal.size();
    for(std::size_t i = 0; i < size; ++i)
      if(m_is_on_diagonal[i])
        m_entries.add(i, i, m_diagonal[i]);
    return m_entries.matrix(size, size).template selfadjointView<Eigen::Upper>();
  }

private:
  std::vector<Scalar> m_diagonal;
  std::vector<char> m_is_on_diagonal; // whether there is an entry
  Sparse_assembly<Scalar> m_entries;
};

// Returns what `add(f, assembly)` adds for the faces f of `mesh`, in their order.
template <typename Scalar, typename Add>
Sparse_assembly<Scalar> assembled_by_faces(Concurrency concurrency, const Delta_complex& mesh,
                                           const Add& add)
{
  std::vector<Sparse_assembly<Scalar>> chunks(number_of_chunks(mesh.num_faces()),
                                              Sparse_assembly<Scalar>(0));
  for_each_chunk(concurrency, mesh.num_faces(), [&](std::size_t begin, std::size_t end) {
    for(std::size_t f = begin; f < end; ++f)
      if(const Face_index face(static_cast<Delta_complex::size_type>(f)); !mesh.is_removed(face))
        add(face, chunks[begin / chunk_size]);
  });
  std::size_t size = 0;
  for(const auto& chunk : chunks)
    size += chunk.size();
  Sparse_assembly<Scalar> result(size);
  for(const auto& chunk : chunks)
    result.append(chunk);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SPARSE_ASSEMBLY_H
