// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ASSEMBLE_COLUMNS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ASSEMBLE_COLUMNS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// rows and values, of which those in one row add up
typedef std::vector<std::pair<int, double>> Column_entries;

// Makes `matrix` the one, of this size, whose column for a vertex has the entries that `collect(v,
// entries)` adds, in any order. No more than one column is sorted at a time.
template <typename Collect>
void assemble_columns(std::size_t size, std::size_t number_of_entries, const Collect& collect,
                      Eigen::SparseMatrix<double>& matrix)
{
  const auto n = static_cast<Eigen::Index>(size);
  matrix.resize(n, n);
  matrix.reserve(static_cast<Eigen::Index>(number_of_entries));
  Column_entries entries;
  for(int column = 0; column < n; ++column) {
    const Vertex_index v(static_cast<Delta_complex::size_type>(column));
    matrix.startVec(column);
    entries.clear();
    collect(v, entries);
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for(std::size_t k = 0; k < entries.size();) {
      double& entry = matrix.insertBack(entries[k].first, column) = 0;
      for(const int row = entries[k].first; k < entries.size() && entries[k].first == row; ++k)
        entry += entries[k].second;
    }
  }
  matrix.finalize();
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ASSEMBLE_COLUMNS_H
