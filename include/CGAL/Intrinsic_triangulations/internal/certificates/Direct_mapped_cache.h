// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_DIRECT_MAPPED_CACHE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_DIRECT_MAPPED_CACHE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores values of a function of integers until others replace them. A single value costs little,
// and few values are computed twice.
template <typename Value>
class Direct_mapped_cache
{
public:
  // Returns the value of `key`, which `compute()` returns if it is not stored.
  template <typename Compute>
  Value operator()(std::size_t key, const Compute& compute)
  {
    if(m_entries.empty() || (m_entries[place(key)].key != key && ++m_misses > m_entries.size()))
      grow();
    Entry& entry = m_entries[place(key)];
    if(entry.key != key) {
      entry.value = compute();
      entry.key = key;
    }
    return entry.value;
  }

private:
  struct Entry
  {
    std::size_t key = (std::numeric_limits<std::size_t>::max)();
    Value value{};
  };

  // Returns the position of `key`. The number of entries is a power of two.
  std::size_t place(std::size_t key) const { return key & (m_entries.size() - 1); }

  // Enlarges a table that is too small. The table is filled again, which at most doubles the cost.
  void grow()
  {
    m_misses = 0;
    const std::size_t size = m_entries.empty() ? 16 : 2 * m_entries.size();
    if(size <= 1 << 12)
      m_entries = std::vector<Entry>(size);
  }

  std::vector<Entry> m_entries;
  std::size_t m_misses = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_DIRECT_MAPPED_CACHE_H
