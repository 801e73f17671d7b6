// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_EXACT_DISTANCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_EXACT_DISTANCES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Path_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the number of windows that exact distances are expected to need. Four scanned and
// modelled surfaces needed from a quarter of this number to a little more. It is proportional to
// the number of edges that a straight line crosses. Several sources divide the surface among them.
inline double expected_windows(std::size_t vertices, std::size_t sources)
{
  const auto n = static_cast<double>(vertices);
  return n / 2 * std::sqrt(n / static_cast<double>((std::max)(sources, std::size_t(1))));
}

// Computes the lengths of shortest paths to all vertices, in linear memory, and the length up to
// which they are known.
template <typename Surface>
class Exact_distances
{
public:
  typedef Length_of<Surface> FT;

  Exact_distances(const Surface& surface, const Distance_sources<Surface>& sources)
    : m_search(view_of(surface), false),
      m_size(surface.mesh().num_vertices()),
      m_number_of_sources(Access_to_sources::vertices(sources).size() +
                          Access_to_sources::curve(sources).size())
  {
    for(const Vertex_index v : Access_to_sources::vertices(sources))
      m_search.add_source(v);
    m_search.add_source(Access_to_sources::curve(sources));
  }

  double expected_windows() const
  {
    return internal::expected_windows(m_size, m_number_of_sources);
  }

  // Returns whether all distances are known after at most `most_windows` windows.
  template <typename Visitor>
  bool run(std::size_t most_windows, Visitor& visitor)
  {
    m_has_run = true;
    return m_search.run(most_windows, visitor);
  }

  bool has_run() const { return m_has_run; }
  FT distance(std::size_t v) const { return m_search.distance(Vertex_index(size_type(v))); }
  FT final_length() { return m_search.final_length(); }

  std::vector<FT> distances() const
  {
    std::vector<FT> result(m_size);
    for(std::size_t v = 0; v < m_size; ++v)
      result[v] = distance(v);
    return result;
  }

private:
  typedef Delta_complex::size_type size_type;

  Path_search<Length_map_of<Surface>> m_search;
  std::size_t m_size, m_number_of_sources;
  bool m_has_run = false;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_EXACT_DISTANCES_H
