// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONE_TREE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONE_TREE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>
#include <CGAL/Intrinsic_triangulations/Cut_graph.h>
#include <CGAL/Intrinsic_triangulations/Dijkstra_search.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <queue>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

using Intrinsic_triangulations::Cut_graph;

// Computes the edges of a short tree that joins all terminals of each component. The tree consists
// of the shortest paths that a minimum spanning tree of the terminals needs (Mehlhorn 1988).
// Terminals at cut edges are joined from the start. Complexity: O(n log n).
class Cone_tree
{
  typedef Delta_complex::size_type size_type;

public:
  // `length` contains the lengths of edges. Paths do not cross cut edges.
  Cone_tree(const Delta_complex& mesh, const std::vector<double>& length,
            const std::vector<char>& is_cut_edge, const std::vector<char>& is_terminal)
    : m_mesh(mesh),
      m_length(length),
      m_is_cut_edge(is_cut_edge),
      m_search(mesh.num_vertices()),
      m_origin(mesh.num_vertices()),
      m_contains(mesh.num_edges(), 0)
  {
    grow(is_terminal);
    join();
  }

  bool contains(Edge_index e) const { return m_contains[e.idx()] != 0; }

private:
  // Finds the shortest paths to all vertices, each from the closest terminal.
  void grow(const std::vector<char>& is_terminal)
  {
    for(Vertex_index v : m_mesh.vertices())
      if(is_terminal[v.idx()]) {
        m_search.reach(v, 0);
        m_origin[v.idx()] = v;
      }
    for(Vertex_index v = m_search.next(); v.is_valid(); v = m_search.next())
      for_each_outgoing_halfedge(v, m_mesh, [&, distance = m_search.distance(v)](Halfedge_index h) {
        const double length = m_length[Edge_index(h).idx()];
        if(!m_is_cut_edge[Edge_index(h).idx()] &&
           m_search.reach(m_mesh.target(h), distance + length, h))
          m_origin[m_mesh.target(h).idx()] = m_origin[v.idx()];
      });
  }

  // Joins the regions of terminals by Kruskal's algorithm on the edges between them.
  void join()
  {
    std::vector<std::tuple<double, Edge_index>> bridges;
    boost::disjoint_sets_with_storage<> sets(m_mesh.num_vertices());
    for(Edge_index e : m_mesh.edges()) {
      const Vertex_index v = m_mesh.vertex(e, 0), w = m_mesh.vertex(e, 1);
      if(m_is_cut_edge[e.idx()])
        sets.union_set(v.idx(), w.idx());
      else if(m_origin[v.idx()].is_valid() && m_origin[v.idx()] != m_origin[w.idx()])
        bridges.emplace_back(m_search.distance(v) + m_length[e.idx()] + m_search.distance(w), e);
    }
    join_cut_edges(sets);
    std::sort(bridges.begin(), bridges.end());
    for(const auto& [length, e] : bridges) {
      const Vertex_index v = m_mesh.vertex(e, 0), w = m_mesh.vertex(e, 1);
      const size_type a = m_origin[v.idx()].idx(), b = m_origin[w.idx()].idx();
      if(sets.find_set(a) == sets.find_set(b))
        continue;
      sets.union_set(a, b);
      m_contains[e.idx()] = 1;
      add_way(v);
      add_way(w);
    }
  }

  // Joins all boundaries, so that no cut leads from one boundary to another.
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

  void add_way(Vertex_index v)
  {
    for(Halfedge_index h = m_search.entry(v); h.is_valid(); h = m_search.entry(m_mesh.source(h)))
      m_contains[Edge_index(h).idx()] = 1;
  }

  const Delta_complex& m_mesh;
  const std::vector<double>& m_length;
  const std::vector<char>& m_is_cut_edge;
  Intrinsic_triangulations::Dijkstra_search<Vertex_index, double> m_search;
  std::vector<Vertex_index> m_origin; // the terminal closest to each vertex
  std::vector<char> m_contains;
};

// Returns the priorities of edges for the order of crossings: the edge with the greatest value
// comes first. With few digits, the longest edges come first, so that positions are propagated
// through large triangles. With enough digits, the shortest edges come first. Then no path between
// small faces leads across large faces, and errors are proportional to the sizes of the faces.
template <typename FT>
std::vector<double> crossing_order(const std::vector<FT>& length)
{
  std::vector<double> result;
  for(const FT& l : length)
    if constexpr(std::is_same<FT, Decimal_1500>::value)
      result.push_back(-static_cast<double>(exponent_of(l)));
    else
      result.push_back(static_cast<double>(l));
  return result;
}

// Cuts a surface into pieces that can be unfolded into the plane. `length` contains the lengths of
// edges. Edges are crossed in the order that `order` determines. Edges marked by `is_cut_edge` are
// not crossed, and only faces marked by `is_used` belong to pieces. Cones and the ends of cut
// edges are terminals, because their faces do not close up in the plane.
inline Cut_graph cut_to_pieces(const Delta_complex& mesh, const std::vector<double>& length,
                               const std::vector<double>& order,
                               const std::vector<char>& is_cut_edge,
                               const std::vector<char>& is_used,
                               const std::vector<char>& is_terminal)
{
  const Cone_tree tree(mesh, length, is_cut_edge, is_terminal);
  Cut_graph result(mesh);
  std::vector<char> is_reached(mesh.num_faces(), 0);
  std::priority_queue<std::pair<double, Delta_complex::size_type>> queue;
  const auto reach = [&](Face_index f, Halfedge_index entry) {
    is_reached[f.idx()] = 1;
    result.join(entry, f);
    for(Halfedge_index h : sides(f, mesh))
      if(!is_cut_edge[Edge_index(h).idx()] && !tree.contains(Edge_index(h)))
        queue.emplace(order[Edge_index(h).idx()], mesh.opposite(h).idx());
  };
  for(Face_index root : mesh.faces()) {
    if(is_used[root.idx()] && !is_reached[root.idx()])
      reach(root, Halfedge_index());
    while(!queue.empty()) {
      const Halfedge_index h(queue.top().second);
      queue.pop();
      if(!is_reached[mesh.face(h).idx()])
        reach(mesh.face(h), h);
    }
  }
  result.close_ends(is_terminal);
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CONE_TREE_H
