// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_REFERENCED_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_REFERENCED_CROSSINGS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Crossings that are kept elsewhere, for those who have theirs by value.
template <typename Crossings>
class Referenced_crossings
{
public:
  Referenced_crossings(const Crossings& crossings) : m_crossings(&crossings) {}

  std::size_t count(Halfedge_index h) const { return m_crossings->count(h); }
  Halfedge_index operator()(Halfedge_index h, std::size_t m) const { return (*m_crossings)(h, m); }

private:
  const Crossings* m_crossings;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_REFERENCED_CROSSINGS_H
