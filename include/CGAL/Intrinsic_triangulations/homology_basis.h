// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HOMOLOGY_BASIS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HOMOLOGY_BASIS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Mesh_components.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Shortest paths along edges from one vertex of each component (Dijkstra), and the loops that edges
// beside them close.
template <typename Surface>
class Edge_path_trees
{
  typedef Length_of<Surface> FT;

public:
  explicit Edge_path_trees(const Surface& surface)
    : m_surface(surface),
      m_mesh(surface.mesh()),
      m_distance(m_mesh.num_vertices(), FT(0)),
      m_entry(m_mesh.num_vertices()),
      m_is_reached(m_mesh.num_vertices(), 0)
  {
    for(Vertex_index v : m_mesh.vertices())
      if(!m_is_reached[v.idx()])
        grow_from(v);
  }

  bool is_in_tree(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    return entry(m_mesh.target(h)) == h || entry(m_mesh.source(h)) == opposite(h);
  }

  FT loop_length(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    return m_distance[m_mesh.source(h).idx()] + edge_length(h, m_surface) +
           m_distance[m_mesh.target(h).idx()];
  }

  // without what it goes to and fro
  std::vector<Halfedge_index> loop(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    std::vector<Halfedge_index> there = path_to_root(m_mesh.source(h)),
                                back = path_to_root(m_mesh.target(h));
    while(!there.empty() && !back.empty() && there.back() == back.back()) {
      there.pop_back();
      back.pop_back();
    }
    std::reverse(there.begin(), there.end());
    for(Halfedge_index& x : there)
      x = opposite(x);
    there.push_back(h);
    there.insert(there.end(), back.begin(), back.end());
    return there;
  }

private:
  typedef std::pair<FT, Halfedge_index> Step; // the length of a path, and its last halfedge

  // the last halfedge of the path to `v`; null if it is a root
  Halfedge_index entry(Vertex_index v) const { return m_entry[v.idx()]; }

  void grow_from(Vertex_index root)
  {
    std::priority_queue<Step, std::vector<Step>, std::greater<Step>> queue;
    const auto go_on_from = [&](Vertex_index v) {
      m_is_reached[v.idx()] = 1;
      if(!m_mesh.is_isolated(v))
        for_each_spoke(v, m_mesh, [&](Halfedge_index h) {
          if(!m_is_reached[m_mesh.target(h).idx()])
            queue.push({m_distance[v.idx()] + edge_length(h, m_surface), h});
        });
    };
    go_on_from(root);
    while(!queue.empty()) {
      const auto [length, h] = queue.top();
      queue.pop();
      const Vertex_index v = m_mesh.target(h);
      if(m_is_reached[v.idx()])
        continue;
      m_distance[v.idx()] = length;
      m_entry[v.idx()] = h;
      go_on_from(v);
    }
  }

  // halfedges from `v` on
  std::vector<Halfedge_index> path_to_root(Vertex_index v) const
  {
    std::vector<Halfedge_index> result;
    for(Halfedge_index h = entry(v); h.is_valid(); h = entry(m_mesh.source(h)))
      result.push_back(opposite(h));
    return result;
  }

  const Surface& m_surface;
  const Delta_complex& m_mesh;
  std::vector<FT> m_distance;
  std::vector<Halfedge_index> m_entry;
  std::vector<char> m_is_reached;
};

// Joins the faces through edges beside the trees, those that close the longest loops first, as long
// as they do not meet; the borders of a component are one face. Returns the edges that are left.
template <typename Surface>
std::vector<Edge_index> edges_beside_cotree(const Edge_path_trees<Surface>& trees,
                                            const Delta_complex& mesh)
{
  std::vector<Edge_index> edges, result;
  for(Edge_index e : mesh.edges())
    if(!trees.is_in_tree(e))
      edges.push_back(e);
  std::stable_sort(edges.begin(), edges.end(), [&](Edge_index a, Edge_index b) {
    return trees.loop_length(b) < trees.loop_length(a);
  });
  const Mesh_components components(mesh);
  boost::disjoint_sets_with_storage<> faces(mesh.num_faces() + components.size());
  const auto face = [&](Halfedge_index h) {
    return mesh.is_border(h) ? mesh.num_faces() + components[mesh.target(h).idx()]
                             : std::size_t(mesh.face(h).idx());
  };
  for(Edge_index e : edges) {
    const Halfedge_index h = mesh.halfedge(e);
    const std::size_t f = faces.find_set(face(h)), g = faces.find_set(face(mesh.opposite(h)));
    if(f == g)
      result.push_back(e);
    else
      faces.link(f, g);
  }
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPaths
/// finds loops along edges that are a basis of the first homology group: every closed curve is
/// homologous to exactly one integer combination of them.
///
/// In each component, shortest paths from its first vertex and edges between their ends make loops,
/// of which a shortest basis is taken (Erickson and Whittlesey 2005); what a loop goes to and fro
/// is left out. `Edge_paths` shortens them to geodesics.
///
/// \param surface a model of `IntrinsicSurface`
/// \returns the halfedges of each loop, each starting where the one before ends. For a component of
///          genus \f$g\f$ these are \f$2g\f$ loops, or \f$2g+b-1\f$ if it has \f$b>0\f$ boundary
///          components. The shortest come first.
///
/// Complexity: \f$O(n \log n)\f$, and linear in the length of the result. Which loops are found is
/// decided by rounded lengths; that they are a basis is not.
template <typename Surface>
std::vector<std::vector<Halfedge_index>> homology_basis(const Surface& surface)
{
  const internal::Edge_path_trees<Surface> trees(surface);
  std::vector<std::vector<Halfedge_index>> result;
  for(Edge_index e : internal::edges_beside_cotree(trees, surface.mesh()))
    result.push_back(trees.loop(e));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HOMOLOGY_BASIS_H
