// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_REFERENCED_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_REFERENCED_CROSSINGS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// The halfedges of T1 that cross edges of T2, whatever class finds them: code that reads them is
// compiled once for all of these classes.
class Referenced_crossings
{
public:
  // refers to `crossings`, which have to live as long
  template <typename Crossings>
  Referenced_crossings(const Crossings& crossings)
    : Referenced_crossings(crossings, Access<Crossings, Crossings>())
  {}

  // refers to `source`, from which `Crossings` are made for each question, since they store nothing
  template <typename Crossings, typename Source>
  static Referenced_crossings found_in(const Source& source)
  {
    return Referenced_crossings(source, Access<Crossings, Source>());
  }

  // returns the halfedge of T1 that crosses `h` as its crossing `m` from left to right
  Halfedge_index operator()(Halfedge_index h, std::size_t m) const
  {
    return m_crossing(m_source, h, m);
  }

private:
  template <typename Crossings, typename Source>
  struct Access
  {
    static Halfedge_index crossing(const void* source, Halfedge_index h, std::size_t m)
    {
      const Source& typed = *static_cast<const Source*>(source);
      if constexpr(std::is_same_v<Crossings, Source>)
        return typed(h, m);
      else
        return Crossings(typed)(h, m);
    }
  };

  template <typename Source, typename Access>
  Referenced_crossings(const Source& source, Access)
    : m_source(&source), m_crossing(&Access::crossing)
  {}

  const void* m_source;
  Halfedge_index (*m_crossing)(const void*, Halfedge_index, std::size_t);
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_REFERENCED_CROSSINGS_H
