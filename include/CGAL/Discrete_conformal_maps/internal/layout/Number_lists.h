// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_NUMBER_LISTS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_NUMBER_LISTS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores lists of numbers in one array.
class Number_lists
{
public:
  void add(std::size_t n) { m_numbers.push_back(n); }
  void close() { m_first.push_back(m_numbers.size()); }

  std::size_t size() const { return m_first.size() - 1; }
  std::size_t size(std::size_t i) const { return m_first[i + 1] - m_first[i]; }
  std::size_t operator()(std::size_t i, std::size_t k) const { return m_numbers[m_first[i] + k]; }

  // Returns for each number below `n` the indices of the lists that contain it, in order. If a
  // list contains the number twice, its index occurs twice. Complexity: linear.
  Number_lists inverse(std::size_t n) const
  {
    Number_lists result;
    result.m_first.assign(n + 1, 0);
    for(std::size_t x : m_numbers)
      ++result.m_first[x + 1];
    for(std::size_t x = 0; x < n; ++x)
      result.m_first[x + 1] += result.m_first[x];
    result.m_numbers.resize(m_numbers.size());
    std::vector<std::size_t> next(result.m_first);
    for(std::size_t i = 0; i < size(); ++i)
      for(std::size_t k = 0; k < size(i); ++k)
        result.m_numbers[next[(*this)(i, k)]++] = i;
    return result;
  }

private:
  std::vector<std::size_t> m_numbers, m_first{0};
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_NUMBER_LISTS_H
