// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Dijkstra_search.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

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

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPaths
/// finds shortest paths along edges between pairs of vertices.
///
/// The first paths are searched for from both ends. As more paths are requested, distances from up
/// to eight vertices are computed, which guide later searches to their targets (the algorithm A*).
/// Each path equals the path by Dijkstra's algorithm from the source, to the last bit. Distances
/// are the rounded sums of lengths in the order of the path. If rounding loses whole lengths, the
/// result can be another shortest path.
///
/// \tparam Surface a model of `IntrinsicSurface`
template <typename Surface>
class Shortest_edge_paths
{
public:
  /// the number type of lengths.
  typedef Length_of<Surface> FT;

  /// prepares for searches on `surface`, whose connectivity and lengths are referred to. They must
  /// be the same whenever a path is searched for. Complexity: linear in the vertices.
  explicit Shortest_edge_paths(const Surface& surface)
    : m_surface(internal::view_of(surface)),
      m_mesh(surface.mesh()),
      m_ahead(m_mesh.num_vertices()),
      m_back(m_mesh.num_vertices())
  {}

  /// finds a shortest path along edges.
  ///
  /// \param source the vertex where it starts
  /// \param target the vertex where it ends
  /// \returns its halfedges from `source` to `target`; none if the two are equal, or if there is
  ///   no path. Of equally short paths to a vertex, the one whose last halfedge has the least index
  ///   counts.
  ///
  /// Complexity: \f$O(m \log m)\f$ for \f$m\f$ edges near the ends, up to about half the distance
  /// between them, or later near shortest paths. Before the paths with the indices 2, 4, 8, ...,
  /// 256, it is \f$O(n \log n)\f$ for \f$n\f$ vertices.
  std::vector<Halfedge_index> path(Vertex_index source, Vertex_index target)
  {
    std::vector<Halfedge_index> result;
    if(source == target || m_mesh.is_isolated(source) || m_mesh.is_isolated(target))
      return result;
    if(m_number_of_paths++ == std::size_t(2) << m_landmarks.size() &&
       m_landmarks.size() < internal::Landmarks<View>::greatest_number)
      m_landmarks.add(source, m_surface, m_ahead);
    m_ahead.restart();
    if(m_landmarks.size() > 0)
      search_by_landmarks(source, target);
    else
      search_from_both(source, target);
    if(m_ahead.is_final(target))
      for(Halfedge_index h = m_ahead.entry(target); h.is_valid();
          h = m_ahead.entry(m_mesh.source(h)))
        result.push_back(h);
    std::reverse(result.begin(), result.end());
    return result;
  }

private:
  typedef Surface_view<Length_map_of<Surface>> View;
  typedef Dijkstra_search<Vertex_index, FT> Search;

  // Returns more than a bound for the relative error of a sum of lengths along a path, which is
  // rounded once for each edge.
  FT rounding() const { return 4 * std::numeric_limits<FT>::epsilon() * FT(m_mesh.num_vertices()); }

  // ---- From both ends ----

  void search_from_both(Vertex_index source, Vertex_index target)
  {
    m_back.restart();
    m_ahead.reach(source, FT(0));
    m_back.reach(target, FT(0));
    if(const std::optional<FT> length = meet())
      go_on(target, *length * (1 + rounding()));
  }

  // Searches from both ends until no path between them can be shorter than a known path. Returns
  // its length, or nothing if no path exists.
  std::optional<FT> meet()
  {
    std::optional<FT> shortest;
    for(;;) {
      const Vertex_index v = m_ahead.peek(), w = m_back.peek();
      if(!v.is_valid() || !w.is_valid() ||
         (shortest && *shortest <= m_ahead.distance(v) + m_back.distance(w)))
        return shortest;
      const bool is_ahead = m_ahead.number_of_open() <= m_back.number_of_open();
      const Search& other = is_ahead ? m_back : m_ahead;
      advance(is_ahead ? m_ahead : m_back, [&](Vertex_index x, const FT& distance) {
        if(other.is_reached(x))
          if(const FT length = distance + other.distance(x); !shortest || length < *shortest)
            shortest = length;
      });
    }
  }

  // Continues the search from the source to the target, on vertices through which a path can have a
  // length of at most `longest`.
  void go_on(Vertex_index target, const FT& longest)
  {
    const Vertex_index nearest = m_back.peek(); // its distance to the target is not yet final
    const FT radius = nearest.is_valid() ? m_back.distance(nearest) : longest;
    const auto is_near = [&](Vertex_index v) {
      return m_ahead.distance(v) + (m_back.is_final(v) ? m_back.distance(v) : radius) <= longest;
    };
    for(Vertex_index v = m_ahead.peek(); v.is_valid() && v != target; v = m_ahead.peek())
      if(is_near(v))
        advance(m_ahead, [](Vertex_index, const FT&) {});
      else
        m_ahead.next();
    m_ahead.next();
  }

  // Makes the distance of one vertex final, and calls `visit(w, distance)` for the paths from it
  // to its neighbors.
  template <typename Visit>
  void advance(Search& search, const Visit& visit)
  {
    const Vertex_index v = search.next();
    for_each_outgoing_halfedge(v, m_mesh, [&, from = search.distance(v)](Halfedge_index h) {
      const Vertex_index w = m_mesh.target(h);
      const FT distance = from + internal::edge_length(h, m_surface);
      if(search.reach(w, distance, h))
        visit(w, distance);
      else if(!search.is_final(w))
        choose_entry(w, distance, h, search);
    });
  }

  // Ends the path to `w` with `h` if it is as short, and `h` has a lesser index than its last
  // halfedge. If rounding loses the last length of a path, other paths replace it.
  void choose_entry(Vertex_index w, const FT& distance, Halfedge_index h, Search& search) const
  {
    const auto is_closer = [&](Halfedge_index x) {
      return search.distance(m_mesh.source(x)) < distance;
    };
    if(distance == search.distance(w) && is_closer(h) &&
       (h < search.entry(w) || !is_closer(search.entry(w))))
      search.set_entry(w, h);
  }

  // ---- By landmarks ----

  // Searches until all paths that are as short as the shortest one up to rounding are known.
  void search_by_landmarks(Vertex_index source, Vertex_index target)
  {
    const auto rest = [&](Vertex_index v) { return m_landmarks.bound(v, target); };
    m_ahead.reach(source, FT(0));
    for(Vertex_index v = m_ahead.peek(); v.is_valid(); v = m_ahead.peek()) {
      const FT distance = m_ahead.distance(v);
      if(m_ahead.is_reached(target) && distance + rest(v) > longest_like(m_ahead.distance(target)))
        break;
      m_ahead.next();
      for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
        const Vertex_index w = m_mesh.target(h);
        const FT length = distance + internal::edge_length(h, m_surface);
        if(!m_ahead.is_reached(w) || length < m_ahead.distance(w))
          m_ahead.reach(w, length, h, rest(w));
        else
          choose_entry(w, length, h, m_ahead);
      });
    }
  }

  FT longest_like(const FT& distance) const
  {
    return distance + rounding() * (distance + m_landmarks.greatest_distance());
  }

  View m_surface;
  const Delta_complex& m_mesh;
  Search m_ahead, m_back; // from the source; from the target
  internal::Landmarks<View> m_landmarks;
  std::size_t m_number_of_paths = 0;
};

/// \ingroup PkgIntrinsicTriangulationsPaths
/// finds a shortest path along edges, see `Shortest_edge_paths::path()`.
///
/// \param surface a model of `IntrinsicSurface`
/// \param source the vertex where it starts
/// \param target the vertex where it ends
/// \returns its halfedges from `source` to `target`; none if the two are equal, or if there is no
///   path. Of equally short paths to a vertex, the one whose last halfedge has the least index
///   counts.
///
/// Complexity: \f$O(n + m \log m)\f$ for \f$n\f$ vertices, and \f$m\f$ edges near one of the
/// ends, up to about half the distance between them. For many pairs, use `Shortest_edge_paths`.
template <typename Surface>
std::vector<Halfedge_index> shortest_edge_path(const Surface& surface, Vertex_index source,
                                               Vertex_index target)
{
  return Shortest_edge_paths<Surface>(surface).path(source, target);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_EDGE_PATH_H
