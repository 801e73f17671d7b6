// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SPARSE_ASSEMBLY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SPARSE_ASSEMBLY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// the entries of a row or a column of a sparse matrix: indices and values. Values at one index add
/// up.
template <typename Scalar>
using Indexed_entries = std::vector<std::pair<int, Scalar>>;

namespace internal {

// Sorts entries and adds up entries with one index, in their order. `std::sort()` does not change
// the order of few entries, and needs no memory.
template <typename Scalar>
void combine(Indexed_entries<Scalar>& entries)
{
  const auto is_less = [](const auto& a, const auto& b) { return a.first < b.first; };
  if(entries.size() > 16)
    std::stable_sort(entries.begin(), entries.end(), is_less);
  else
    std::sort(entries.begin(), entries.end(), is_less);
  std::size_t size = 0;
  for(const auto& entry : entries)
    if(size > 0 && entries[size - 1].first == entry.first)
      entries[size - 1].second += entry.second;
    else
      entries[size++] = entry;
  entries.resize(size);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// makes `matrix` from its rows, or from its columns if it is stored by columns. `collect(i,
/// entries)` adds the entries of row i to `Indexed_entries`, in any order. Rows are collected in
/// chunks, at the same time if `concurrency` is parallel.
template <typename Matrix, typename Collect>
void assemble(Concurrency concurrency, std::size_t rows, std::size_t columns,
              const Collect& collect, Matrix& matrix)
{
  typedef Indexed_entries<typename Matrix::Scalar> Entries;
  matrix.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  const auto n = static_cast<std::size_t>(matrix.outerSize());
  int* const first = matrix.outerIndexPtr();
  std::vector<Entries> chunks(number_of_chunks(n));
  for_each_chunk(concurrency, n, [&](std::size_t begin, std::size_t end) {
    Entries& all = chunks[begin / chunk_size];
    all.reserve(4 * (end - begin));
    Entries entries;
    for(std::size_t i = begin; i < end; ++i) {
      entries.clear();
      collect(i, entries);
      internal::combine(entries);
      all.insert(all.end(), entries.begin(), entries.end());
      first[i + 1] = static_cast<int>(entries.size());
    }
  });
  for(std::size_t i = 0; i < n; ++i)
    first[i + 1] += first[i];
  matrix.resizeNonZeros(first[n]);
  for_each_chunk(concurrency, n, [&](std::size_t begin, std::size_t) {
    int k = first[begin];
    for(const auto& [index, value] : chunks[begin / chunk_size]) {
      matrix.innerIndexPtr()[k] = index;
      matrix.valuePtr()[k++] = value;
    }
  });
}

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// returns the matrix of type `Matrix` whose rows or columns `collect()` adds, one after the other.
template <typename Matrix, typename Collect>
Matrix assembled(std::size_t rows, std::size_t columns, const Collect& collect)
{
  Matrix result;
  assemble(Concurrency(), rows, columns, collect, result);
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// returns the matrix that places values at the indices `selected` among `size` values.
template <typename Scalar>
Eigen::SparseMatrix<Scalar> selection_matrix(std::size_t size,
                                             const std::vector<std::size_t>& selected)
{
  return assembled<Eigen::SparseMatrix<Scalar>>(
    size, selected.size(), [&](std::size_t column, auto& entries) {
      entries.emplace_back(static_cast<int>(selected[column]), Scalar(1));
    });
}

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// returns the matrix with these entries, in any order; entries at equal indices add up.
template <typename Scalar>
Eigen::SparseMatrix<Scalar> matrix_of(const std::vector<Eigen::Triplet<Scalar>>& entries,
                                      std::size_t rows, std::size_t columns)
{
  Eigen::SparseMatrix<Scalar> result(static_cast<Eigen::Index>(rows),
                                     static_cast<Eigen::Index>(columns));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SPARSE_ASSEMBLY_H
