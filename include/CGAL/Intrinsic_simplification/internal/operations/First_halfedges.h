// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_FIRST_HALFEDGES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_FIRST_HALFEDGES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Finds the first outgoing halfedge of a star to each neighbor, by a small hash table that remains
// in the cache.
class First_halfedges
{
public:
  void start(std::size_t number_of_outgoing_halfedges)
  {
    m_bits = 3;
    while((std::size_t(1) << m_bits) < 2 * number_of_outgoing_halfedges)
      ++m_bits;
    m_entries.assign(std::size_t(1) << m_bits, {Vertex_index(), none});
  }

  // Returns the index of the first outgoing halfedge to `j`, or `n` if none has been added before.
  std::size_t first(Vertex_index j, std::size_t n)
  {
    std::size_t place = (j.idx() * 2654435769U) >> (32 - m_bits);
    while(m_entries[place].second != none && m_entries[place].first != j)
      place = (place + 1) % m_entries.size();
    if(m_entries[place].second == none)
      m_entries[place] = {j, static_cast<std::uint32_t>(n)};
    return m_entries[place].second;
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t m_bits = 0;
  std::vector<std::pair<Vertex_index, std::uint32_t>> m_entries;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_FIRST_HALFEDGES_H
