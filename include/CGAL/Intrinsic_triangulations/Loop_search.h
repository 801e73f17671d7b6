// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LOOP_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LOOP_SEARCH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Dijkstra_search.h>
#include <CGAL/Intrinsic_triangulations/Loop_signatures.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/Tree_cotree.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// searches from one vertex after the other for loops along edges that do not bound.
///
/// A loop that does not bound has an edge whose number, see `Loop_signatures`, is not zero.
/// Searches begin at one end of each of these edges, the centers. The shortest loop through a
/// vertex consists of two shortest paths from the vertex and an edge between their ends.
///
/// \tparam Surface a model of `IntrinsicSurface`
template <typename Surface>
class Loop_search
{
public:
  /// the number type of lengths.
  typedef Length_of<Surface> FT;
  /// the number of a homology class modulo 2.
  typedef Loop_signatures::Signature Signature;

  /// prepares for searches on `surface`, which is referred to. Complexity: \f$O(n \log n)\f$.
  Loop_search(const Surface& surface, Boundary_loops boundary)
    : m_surface(surface),
      m_mesh(surface.mesh()),
      m_signatures(m_mesh, boundary),
      m_search(m_mesh.num_vertices()),
      m_path_signature(m_mesh.num_vertices())
  {}

  /// returns the numbers of edges.
  const Loop_signatures& signatures() const { return m_signatures; }

  /// returns one end of each edge whose number is not zero, unless `is_allowed(v)` is false for one
  /// of its ends.
  template <typename Filter>
  std::vector<Vertex_index> centers(const Filter& is_allowed) const
  {
    std::vector<Vertex_index> result;
    std::vector<bool> is_center(m_mesh.num_vertices(), false);
    for(Edge_index e : m_mesh.edges()) {
      const Vertex_index v = m_mesh.vertex(e, 0), w = m_mesh.vertex(e, 1);
      if(m_signatures[e] == 0 || is_center[v] || is_center[w] || !is_allowed(v) || !is_allowed(w))
        continue;
      is_center[v] = true;
      result.push_back(v);
    }
    return result;
  }

  /// calls `visit(h, length, signature)` for the edges that close a loop through `center` which
  /// does not bound. Vertices with `is_allowed(v)` are reached by increasing distance, as long as
  /// `goes_on(v)` returns true.
  template <typename Filter, typename Go_on, typename Visit>
  void search(Vertex_index center, const Filter& is_allowed, const Go_on& goes_on,
              const Visit& visit)
  {
    m_search.restart();
    m_search.reach(center, FT(0));
    m_path_signature[center.idx()] = 0;
    for(Vertex_index v = m_search.next(); v.is_valid() && goes_on(v); v = m_search.next())
      for_each_outgoing_halfedge(v, m_mesh, [&, from = m_search.distance(v)](Halfedge_index h) {
        const Vertex_index w = m_mesh.target(h);
        const Signature s = m_path_signature[v.idx()] ^ m_signatures[Edge_index(h)];
        const FT reached = from + internal::edge_length(h, m_surface);
        if(m_search.is_final(w)) {
          if(s != m_path_signature[w.idx()])
            visit(h, FT(reached + m_search.distance(w)), s ^ m_path_signature[w.idx()]);
        } else if(is_allowed(w) && m_search.reach(w, reached, h))
          m_path_signature[w.idx()] = s;
      });
  }

  /// returns the distance of a vertex that the last search has reached.
  const FT& distance(Vertex_index v) const { return m_search.distance(v); }

  /// returns the loop that `h` closes in the last search.
  std::vector<Halfedge_index> loop(Halfedge_index h) const
  {
    return internal::tree_loop(
      h, [&](Vertex_index v) { return m_search.entry(v); }, m_mesh);
  }

  /// returns the sum of the lengths of edges.
  FT length(const std::vector<Halfedge_index>& halfedges) const
  {
    FT sum(0);
    for(Halfedge_index h : halfedges)
      sum += internal::edge_length(h, m_surface);
    return sum;
  }

private:
  const Surface& m_surface;
  const Delta_complex& m_mesh;
  Loop_signatures m_signatures;
  Dijkstra_search<Vertex_index, FT> m_search;
  std::vector<Signature> m_path_signature; // of the path to each vertex
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LOOP_SEARCH_H
