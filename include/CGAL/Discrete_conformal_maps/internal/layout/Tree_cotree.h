// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_TREE_COTREE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_TREE_COTREE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Seam_pruning.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Ways between faces of a closed surface through edges, each of which has a length.
class Dual_distances
{
  typedef Delta_complex::size_type size_type;

public:
  Dual_distances(const Delta_complex& mesh, const std::vector<double>& crossing_length)
    : m_mesh(mesh),
      m_crossing_length(crossing_length),
      m_distance(mesh.num_faces(), infinity),
      m_entry(mesh.num_faces())
  {}

  // Finds the distances of all faces that can be reached from `root`, and shortest ways there.
  // Complexity: O(n log n).
  void start_at(Face_index root)
  {
    std::fill(m_distance.begin(), m_distance.end(), infinity);
    m_order.clear();
    m_entry[root.idx()] = Halfedge_index();
    relax(root, 0);
    while(!m_queue.empty()) {
      const auto [distance, i] = m_queue.top();
      m_queue.pop();
      if(distance > m_distance[i])
        continue;
      const Face_index f(i);
      m_order.push_back(f);
      for(Halfedge_index h : Intrinsic_triangulations::sides(f, m_mesh)) {
        const Halfedge_index o = m_mesh.opposite(h);
        if(relax(m_mesh.face(o), distance + m_crossing_length[Edge_index(h).idx()]))
          m_entry[m_mesh.face(o).idx()] = o;
      }
    }
  }

  // the faces that were reached, the closest first
  const std::vector<Face_index>& order() const { return m_order; }
  double operator[](Face_index f) const { return m_distance[f.idx()]; }

  // the halfedge of `f` through which it is reached; null for the root
  Halfedge_index entry(Face_index f) const { return m_entry[f.idx()]; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  bool relax(Face_index f, double distance)
  {
    if(!(distance < m_distance[f.idx()]))
      return false;
    m_distance[f.idx()] = distance;
    m_queue.emplace(distance, f.idx());
    return true;
  }

  typedef std::pair<double, size_type> Entry;

  const Delta_complex& m_mesh;
  const std::vector<double>& m_crossing_length;
  std::vector<double> m_distance;
  std::vector<Halfedge_index> m_entry;
  std::vector<Face_index> m_order;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

// A closed surface cut into one disk per component: the faces are joined along the shortest ways
// from a central face. The edges that are open then are a tree with all vertices, and two more
// edges per handle. Those with the shortest loops through the central face are chosen (Erickson and
// Whittlesey 2005, on the dual graph).
class Tree_cotree
{
public:
  // `crossing_length` is a distance of the two faces of each edge
  Tree_cotree(const Delta_complex& mesh, const std::vector<double>& crossing_length,
              const std::vector<char>& is_terminal)
    : m_mesh(mesh),
      m_component(mesh.num_faces(), none),
      m_is_open(mesh.num_edges(), 1),
      m_is_in_tree(mesh.num_edges(), 0)
  {
    Dual_distances distance(mesh, crossing_length);
    std::vector<double> reach(mesh.num_faces());
    for(Face_index f : mesh.faces())
      if(m_component[f.idx()] == none) {
        distance.start_at(center(f, distance));
        join_faces(distance, reach);
      }
    std::vector<double> loop_length(mesh.num_edges());
    for(Edge_index e : mesh.edges())
      loop_length[e.idx()] = crossing_length[e.idx()] + reach[mesh.face(mesh.halfedge(e)).idx()] +
                             reach[mesh.face(mesh.opposite(mesh.halfedge(e))).idx()];
    grow_tree(loop_length);
    m_is_seam = m_is_open;
    close_ends(mesh, is_terminal, m_is_seam);
  }

  // the number of components, except for isolated vertices
  std::size_t number_of_components() const { return m_root.size(); }
  std::size_t component(Face_index f) const { return m_component[f.idx()]; }
  // the central face of a component
  Face_index root(std::size_t c) const { return m_root[c]; }

  // the halfedges through which faces are reached, in this order, each in the new face; null for a
  // root
  struct Step
  {
    Halfedge_index entry;
    Face_index face;
  };
  const std::vector<Step>& steps() const { return m_steps; }

  // whether the faces of `e` are not joined
  bool is_open(Edge_index e) const { return m_is_open[e.idx()] != 0; }
  // after open edges have been closed again from the ends of their graph
  bool is_seam(Edge_index e) const { return m_is_seam[e.idx()] != 0; }

  // the open edges of a component that are not in the tree, those with the shortest loops first
  const std::vector<Edge_index>& generators(std::size_t c) const { return m_generators[c]; }

  // The halfedges of the generators of a component, in the order in which a walk clockwise around
  // the tree crosses them: as if all vertices were one.
  std::vector<Halfedge_index> relation(std::size_t c) const
  {
    std::vector<Halfedge_index> result;
    if(m_generators[c].empty())
      return result;
    const Halfedge_index start = m_mesh.halfedge(m_generators[c].front());
    Halfedge_index h = start;
    do {
      const Edge_index e(h);
      if(m_is_open[e.idx()] && !m_is_in_tree[e.idx()])
        result.push_back(h);
      h = m_mesh.next(m_is_in_tree[e.idx()] ? h : m_mesh.opposite(h));
    } while(h != start);
    return result;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // A face of which no other is very far away: of some faces far from each other the greatest
  // distance is least there. After a few rounds it gets hardly better.
  static Face_index center(Face_index start, Dual_distances& distance)
  {
    constexpr int rounds = 6;
    distance.start_at(start);
    const std::vector<Face_index> faces = distance.order();
    std::vector<double> greatest(faces.size(), 0);
    Face_index result = start;
    for(int i = 0; i < rounds; ++i) {
      distance.start_at(distance.order().back());
      std::size_t best = 0;
      for(std::size_t k = 0; k < faces.size(); ++k) {
        greatest[k] = (std::max)(greatest[k], distance[faces[k]]);
        if(greatest[k] < greatest[best])
          best = k;
      }
      result = faces[best];
      distance.start_at(result);
    }
    return result;
  }

  void join_faces(const Dual_distances& distance, std::vector<double>& reach)
  {
    for(Face_index f : distance.order()) {
      m_component[f.idx()] = m_root.size();
      reach[f.idx()] = distance[f];
      m_steps.push_back({distance.entry(f), f});
      if(distance.entry(f).is_valid())
        m_is_open[Edge_index(distance.entry(f)).idx()] = 0;
    }
    m_root.push_back(distance.order().front());
  }

  // Kruskal's algorithm, the longest loops first
  void grow_tree(const std::vector<double>& loop_length)
  {
    std::vector<Edge_index> edges;
    for(Edge_index e : m_mesh.edges())
      if(is_open(e))
        edges.push_back(e);
    std::stable_sort(edges.begin(), edges.end(), [&](Edge_index a, Edge_index b) {
      return loop_length[a.idx()] > loop_length[b.idx()];
    });
    m_generators.resize(m_root.size());
    boost::disjoint_sets_with_storage<> sets(m_mesh.num_vertices());
    for(Vertex_index v : m_mesh.vertices())
      sets.make_set(v.idx());
    for(Edge_index e : edges) {
      const auto a = sets.find_set(m_mesh.vertex(e, 0).idx()),
                 b = sets.find_set(m_mesh.vertex(e, 1).idx());
      if(a == b)
        m_generators[component(m_mesh.face(m_mesh.halfedge(e)))].push_back(e);
      else {
        sets.link(a, b);
        m_is_in_tree[e.idx()] = 1;
      }
    }
    for(auto& generators : m_generators)
      std::reverse(generators.begin(), generators.end());
  }

  const Delta_complex& m_mesh;
  std::vector<Face_index> m_root;
  std::vector<std::size_t> m_component;
  std::vector<Step> m_steps;
  std::vector<char> m_is_open, m_is_in_tree, m_is_seam;
  std::vector<std::vector<Edge_index>> m_generators;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_TREE_COTREE_H
