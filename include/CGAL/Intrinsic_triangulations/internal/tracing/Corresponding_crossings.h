// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CORRESPONDING_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CORRESPONDING_CROSSINGS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Referenced_crossings.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

template <typename Traits>
class Correspondence;

namespace internal {

// The crossings of a correspondence.
template <typename Traits>
class Corresponding_crossings
{
  typedef Delta_complex::size_type size_type;

public:
  explicit Corresponding_crossings(const Correspondence<Traits>& correspondence)
    : m_correspondence(&correspondence)
  {}

  // returns the number of crossings on the edge of `h`
  std::size_t count(Halfedge_index h) const
  {
    return m_correspondence->number_of_crossings(Side::intrinsic, Edge_index(h));
  }

  // returns the halfedge of T1 that crosses `h` as its crossing `m` from left to right
  Halfedge_index operator()(Halfedge_index h, std::size_t m) const
  {
    return m_correspondence->crossing(Side::intrinsic, h, static_cast<size_type>(m))
      .across.halfedge;
  }

private:
  const Correspondence<Traits>* m_correspondence;
};

// decisions about all edges of T2
template <typename Traits>
Referenced_crossings crossings_of(const Correspondence<Traits>& correspondence)
{
  return Referenced_crossings::found_in<Corresponding_crossings<Traits>>(correspondence);
}

} // namespace internal
} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CORRESPONDING_CROSSINGS_H
