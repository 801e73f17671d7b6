// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LANDMARKS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LANDMARKS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Dijkstra_search.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores distances along edges from a few vertices, the landmarks, to all others. By the triangle
// inequality they bound distances between other vertices from below (Goldberg and Harrelson 2005).
template <typename Surface>
class Landmarks
{
public:
  typedef Length_of<Surface> FT;
  typedef Dijkstra_search<Vertex_index, FT> Search;

  static constexpr std::size_t greatest_number = 8;

  std::size_t size() const { return m_size; }

  // Returns the greatest distance from a landmark.
  const FT& greatest_distance() const { return m_greatest; }

  // Adds the vertex that is farthest from all landmarks; the first one is far from `v`. Complexity:
  // O(n log n).
  void add(Vertex_index v, const Surface& surface, Search& search)
  {
    if(m_size == 0) {
      m_nearest.assign(surface.mesh().num_vertices(), std::numeric_limits<FT>::infinity());
      m_distance.assign(m_nearest.size(), Distances());
      v = find_distances(v, surface, search);
    } else
      v = farthest(surface.mesh());
    find_distances(v, surface, search);
    for(Vertex_index w : surface.mesh().vertices())
      if(search.is_reached(w)) {
        m_distance[w][m_size] = search.distance(w);
        m_nearest[w] = (std::min)(m_nearest[w], search.distance(w));
        m_greatest = (std::max)(m_greatest, search.distance(w));
      }
    ++m_size;
  }

  // Returns a lower bound for the distance between two vertices, up to rounding.
  FT bound(Vertex_index v, Vertex_index w) const
  {
    const Distances &from_v = m_distance[v], &from_w = m_distance[w];
    FT result(0);
    for(std::size_t i = 0; i < m_size; ++i)
      result = (std::max)({result, FT(from_v[i] - from_w[i]), FT(from_w[i] - from_v[i])});
    return result;
  }

private:
  typedef std::array<FT, greatest_number> Distances; // 0 on other components than the landmark

  // Computes the distances from `source`, and returns the last vertex that is reached.
  static Vertex_index find_distances(Vertex_index source, const Surface& surface, Search& search)
  {
    const Delta_complex& mesh = surface.mesh();
    Vertex_index last = source;
    search.restart();
    search.reach(source, FT(0));
    for(Vertex_index v = search.next(); v.is_valid(); v = search.next()) {
      last = v;
      for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
        search.reach(mesh.target(h), search.distance(v) + edge_length(h, surface), h);
      });
    }
    return last;
  }

  // Returns the vertex farthest from all landmarks. Vertices of a component without a landmark come
  // first.
  Vertex_index farthest(const Delta_complex& mesh) const
  {
    Vertex_index result;
    for(Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v) && (!result.is_valid() || m_nearest[v] > m_nearest[result]))
        result = v;
    return result;
  }

  std::size_t m_size = 0;
  FT m_greatest{0};
  std::vector<Distances> m_distance;
  std::vector<FT> m_nearest; // the distance of each vertex to the nearest landmark
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LANDMARKS_H
