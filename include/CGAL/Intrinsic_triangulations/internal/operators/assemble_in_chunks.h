// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_ASSEMBLE_IN_CHUNKS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_ASSEMBLE_IN_CHUNKS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/concurrency/for_each_in_chunks.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Indices and values of the entries of a row or a column.
template <typename Scalar>
using Indexed_entries = std::vector<std::pair<int, Scalar>>;

// Sorts by indices, without memory where there are few. Stable.
template <typename Scalar>
void sort_by_index(Indexed_entries<Scalar>& entries)
{
  const auto is_less = [](const auto& a, const auto& b) { return a.first < b.first; };
  if(entries.size() > 16) {
    std::stable_sort(entries.begin(), entries.end(), is_less);
    return;
  }
  for(std::size_t i = 1; i < entries.size(); ++i) {
    const auto entry = entries[i];
    std::size_t k = i;
    for(; k > 0 && is_less(entry, entries[k - 1]); --k)
      entries[k] = entries[k - 1];
    entries[k] = entry;
  }
}

// Sorts entries and sums up those with one index, in the order in which they are.
template <typename Scalar>
void combine(Indexed_entries<Scalar>& entries)
{
  sort_by_index(entries);
  std::size_t size = 0;
  for(const auto& entry : entries)
    if(size > 0 && entries[size - 1].first == entry.first)
      entries[size - 1].second += entry.second;
    else
      entries[size++] = entry;
  entries.resize(size);
}

// Makes `matrix` the one whose row, or whose column if it is stored by columns, with index i has
// the entries that `collect(i, entries)` adds, in any order.
template <typename Matrix, typename Collect>
void assemble_in_chunks(Concurrency concurrency, std::size_t rows, std::size_t columns,
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
      combine(entries);
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_ASSEMBLE_IN_CHUNKS_H
