// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CUT_GRAPH_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CUT_GRAPH_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Seam_pruning.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// The edges of a short tree that joins all terminals of each component: the shortest paths that a
// minimum spanning tree of the terminals needs (Mehlhorn 1988). Terminals at cut edges are joined
// already. Complexity: O(n log n).
class Cone_tree
{
  typedef Delta_complex::size_type size_type;

public:
  // `length` is that of edges; a cut edge is not passed
  Cone_tree(const Delta_complex& mesh, const std::vector<double>& length,
            const std::vector<char>& is_cut_edge, const std::vector<char>& is_terminal)
    : m_mesh(mesh),
      m_length(length),
      m_is_cut_edge(is_cut_edge),
      m_distance(mesh.num_vertices(), std::numeric_limits<double>::infinity()),
      m_origin(mesh.num_vertices()),
      m_way(mesh.num_vertices()),
      m_contains(mesh.num_edges(), 0)
  {
    grow(is_terminal);
    join();
  }

  bool contains(Edge_index e) const { return m_contains[e.idx()] != 0; }

private:
  typedef std::pair<double, size_type> Entry;

  // the terminal closest to each vertex, and the way back to it
  void grow(const std::vector<char>& is_terminal)
  {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for(Vertex_index v : m_mesh.vertices())
      if(is_terminal[v.idx()]) {
        m_distance[v.idx()] = 0;
        m_origin[v.idx()] = v;
        queue.emplace(0., v.idx());
      }
    while(!queue.empty()) {
      const auto [distance, i] = queue.top();
      queue.pop();
      if(distance > m_distance[i])
        continue;
      Intrinsic_triangulations::for_each_spoke(
        Vertex_index(i), m_mesh, [&, d = distance, from = i](Halfedge_index h) {
          const size_type to = m_mesh.target(h).idx();
          const double there = d + m_length[Edge_index(h).idx()];
          if(m_is_cut_edge[Edge_index(h).idx()] || !(there < m_distance[to]))
            return;
          m_distance[to] = there;
          m_origin[to] = m_origin[from];
          m_way[to] = m_mesh.opposite(h);
          queue.emplace(there, to);
        });
    }
  }

  // Kruskal's algorithm on the edges between the regions of terminals
  void join()
  {
    std::vector<std::tuple<double, Edge_index>> bridges;
    boost::disjoint_sets_with_storage<> sets(m_mesh.num_vertices());
    for(Vertex_index v : m_mesh.vertices())
      sets.make_set(v.idx());
    for(Edge_index e : m_mesh.edges()) {
      const size_type i = m_mesh.vertex(e, 0).idx(), j = m_mesh.vertex(e, 1).idx();
      if(m_is_cut_edge[e.idx()])
        sets.union_set(i, j);
      else if(m_origin[i].is_valid() && m_origin[i] != m_origin[j])
        bridges.emplace_back(m_distance[i] + m_length[e.idx()] + m_distance[j], e);
    }
    join_cut_edges(sets);
    std::sort(bridges.begin(), bridges.end());
    for(const auto& [length, e] : bridges) {
      const size_type i = m_mesh.vertex(e, 0).idx(), j = m_mesh.vertex(e, 1).idx();
      const size_type a = m_origin[i].idx(), b = m_origin[j].idx();
      if(sets.find_set(a) == sets.find_set(b))
        continue;
      sets.union_set(a, b);
      m_contains[e.idx()] = 1;
      add_way(i);
      add_way(j);
    }
  }

  // All boundaries count as one: a cut from one to another is not needed.
  void join_cut_edges(boost::disjoint_sets_with_storage<>& sets) const
  {
    Edge_index first;
    for(Edge_index e : m_mesh.edges())
      if(m_is_cut_edge[e.idx()]) {
        if(!first.is_valid())
          first = e;
        sets.union_set(m_mesh.vertex(first, 0).idx(), m_mesh.vertex(e, 0).idx());
      }
  }

  void add_way(size_type i)
  {
    while(m_way[i].is_valid()) {
      m_contains[Edge_index(m_way[i]).idx()] = 1;
      i = m_mesh.target(m_way[i]).idx();
    }
  }

  const Delta_complex& m_mesh;
  const std::vector<double>& m_length;
  const std::vector<char>& m_is_cut_edge;
  std::vector<double> m_distance;
  std::vector<Vertex_index> m_origin;
  std::vector<Halfedge_index> m_way; // from each vertex towards its terminal
  std::vector<char> m_contains;
};

// A surface cut into pieces that can be unfolded into the plane: a spanning forest of faces, which
// are joined through its edges, and the seams, the edges that stay open when all others are closed
// again from their ends.
class Cut_graph
{
public:
  // `length` is that of edges; `is_cut_edge` says which are not passed; `is_used` which faces are
  // wanted; every vertex where faces cannot close up, a cone or an end of a cut edge, is a
  // terminal
  Cut_graph(const Delta_complex& mesh, const std::vector<double>& length,
            const std::vector<char>& is_cut_edge, const std::vector<char>& is_used,
            const std::vector<char>& is_terminal)
    : m_mesh(mesh), m_is_open(mesh.num_edges(), 1), m_is_cut_edge(is_cut_edge)
  {
    grow_forest(length, Cone_tree(mesh, length, is_cut_edge, is_terminal), is_used);
    m_is_seam = m_is_open;
    close_ends(mesh, is_terminal, m_is_seam);
  }

  // the halfedges through which faces are reached, in this order, each in the new face; a root has
  // a null halfedge before it
  struct Step
  {
    Halfedge_index entry;
    Face_index face;
  };
  const std::vector<Step>& steps() const { return m_steps; }

  bool is_seam(Edge_index e) const { return m_is_seam[e.idx()] != 0; }

private:
  // Longest edges first: positions are handed on through large triangles.
  void grow_forest(const std::vector<double>& length, const Cone_tree& tree,
                   const std::vector<char>& is_used)
  {
    std::vector<char> is_reached(m_mesh.num_faces(), 0);
    std::priority_queue<std::pair<double, Delta_complex::size_type>> queue;
    const auto reach = [&](Face_index f, Halfedge_index entry) {
      is_reached[f.idx()] = 1;
      m_steps.push_back({entry, f});
      for(Halfedge_index h : Intrinsic_triangulations::sides(f, m_mesh))
        if(!m_is_cut_edge[Edge_index(h).idx()] && !tree.contains(Edge_index(h)))
          queue.emplace(length[Edge_index(h).idx()], m_mesh.opposite(h).idx());
    };
    for(Face_index root : m_mesh.faces()) {
      if(is_used[root.idx()] && !is_reached[root.idx()])
        reach(root, Halfedge_index());
      while(!queue.empty()) {
        const Halfedge_index h(queue.top().second);
        queue.pop();
        if(is_reached[m_mesh.face(h).idx()])
          continue;
        m_is_open[Edge_index(h).idx()] = 0;
        reach(m_mesh.face(h), h);
      }
    }
  }

  const Delta_complex& m_mesh;
  std::vector<Step> m_steps;
  std::vector<char> m_is_open; // not in the forest
  std::vector<char> m_is_seam;
  const std::vector<char>& m_is_cut_edge;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CUT_GRAPH_H
