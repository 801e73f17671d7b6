// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_SHORT_LOOPS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_SHORT_LOOPS_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>
#include <CGAL/Intrinsic_simplification/internal/topology/Loop_signatures.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Finds short curves of edges that do not separate the surface. The shortest one through a vertex
// consists of two shortest paths from there and an edge between their ends.
class Short_loops
{
  typedef Loop_signatures::Signature Signature;

  struct Label
  {
    std::size_t round = 0;
    double distance = 0;
    Halfedge_index last; // of the path that leads here
    Signature signature = 0;
    bool is_final = false;
  };

public:
  struct Loop
  {
    double length;
    std::vector<Halfedge_index> halfedges;
  };

  Short_loops(const Surface_surgery& surface, double maximum_length)
    : m_surface(surface),
      m_mesh(surface.mesh()),
      m_signatures(m_mesh),
      m_maximum(maximum_length),
      m_label(m_mesh.num_vertices())
  {}

  // Returns short loops that have no vertex in common and together do not separate, the shortest
  // ones first. None passes a vertex of the boundary.
  std::vector<Loop> disjoint_loops()
  {
    std::vector<Loop> all, result;
    for(Vertex_index v : m_mesh.vertices())
      if(!m_mesh.is_isolated(v) && !m_mesh.is_border(v))
        if(Loop loop = shortest(v); !loop.halfedges.empty())
          all.push_back(std::move(loop));
    std::stable_sort(all.begin(), all.end(),
                     [](const Loop& a, const Loop& b) { return a.length < b.length; });
    std::vector<bool> is_used(m_mesh.num_vertices(), false);
    Independent_signatures independent;
    for(Loop& loop : all)
      if(std::none_of(loop.halfedges.begin(), loop.halfedges.end(),
                      [&](Halfedge_index h) { return is_used[m_mesh.target(h)]; }) &&
         independent.add(m_signatures.of(loop.halfedges))) {
        for(Halfedge_index h : loop.halfedges)
          is_used[m_mesh.target(h)] = true;
        result.push_back(std::move(loop));
      }
    return result;
  }

private:
  double length(Halfedge_index h) const { return get(m_surface.length_map(), Edge_index(h)); }

  // Returns the shortest loop that is found from `center`, empty if there is none.
  Loop shortest(Vertex_index center)
  {
    find_ball(center);
    double least = m_maximum;
    Halfedge_index best;
    for(Vertex_index v : m_ball)
      for_each_spoke(v, m_mesh, [&](Halfedge_index h) {
        const Label &a = m_label[v], &b = m_label[m_mesh.target(h)];
        if(b.round != m_round || !b.is_final ||
           (a.signature ^ b.signature ^ m_signatures[Edge_index(h)]) == 0)
          return;
        const double l = a.distance + length(h) + b.distance;
        if(best.is_valid() ? l < least : l <= least) {
          least = l;
          best = h;
        }
      });
    return best.is_valid() ? loop_across(best) : Loop{0, {}};
  }

  // Labels the vertices up to half of the greatest length, without those of the boundary.
  void find_ball(Vertex_index center)
  {
    ++m_round;
    m_ball.clear();
    push(center, 0, Halfedge_index(), 0);
    while(!m_queue.empty()) {
      const auto [distance, v] = m_queue.top();
      m_queue.pop();
      Label& label = m_label[v];
      if(label.is_final)
        continue;
      label.is_final = true;
      m_ball.push_back(v);
      for_each_spoke(v, m_mesh, [&, d = distance, s = label.signature](Halfedge_index h) {
        if(const double reached = d + length(h); reached <= m_maximum / 2)
          push(m_mesh.target(h), reached, h, s ^ m_signatures[Edge_index(h)]);
      });
    }
  }

  void push(Vertex_index v, double distance, Halfedge_index last, Signature signature)
  {
    Label& label = m_label[v];
    if((label.round == m_round && label.distance <= distance) || m_mesh.is_border(v))
      return;
    label = {m_round, distance, last, signature, false};
    m_queue.push({distance, v});
  }

  std::vector<Halfedge_index> path_to(Vertex_index v) const
  {
    std::vector<Halfedge_index> result;
    for(Halfedge_index h = m_label[v].last; h.is_valid(); h = m_label[m_mesh.source(h)].last)
      result.push_back(h);
    std::reverse(result.begin(), result.end());
    return result;
  }

  // closed by `h`, without what its two paths have in common
  Loop loop_across(Halfedge_index h) const
  {
    const auto there = path_to(m_mesh.source(h)), back = path_to(m_mesh.target(h));
    std::size_t common = 0;
    while(common < (std::min)(there.size(), back.size()) && there[common] == back[common])
      ++common;
    Loop result{0, {there.begin() + static_cast<std::ptrdiff_t>(common), there.end()}};
    result.halfedges.push_back(h);
    for(std::size_t i = back.size(); i-- > common;)
      result.halfedges.push_back(opposite(back[i]));
    for(Halfedge_index x : result.halfedges)
      result.length += length(x);
    return result;
  }

  const Surface_surgery& m_surface;
  const Delta_complex& m_mesh;
  Loop_signatures m_signatures;
  double m_maximum;
  std::size_t m_round = 0;
  std::vector<Label> m_label;
  std::vector<Vertex_index> m_ball;
  typedef std::pair<double, Vertex_index> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_SHORT_LOOPS_H
