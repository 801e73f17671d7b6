// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_SHORT_LOOPS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_SHORT_LOOPS_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>
#include <CGAL/Intrinsic_triangulations/internal/topology/Loop_signatures.h>
#include <CGAL/Intrinsic_triangulations/internal/topology/tree_loop.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

using Intrinsic_triangulations::internal::Loop_signatures;

// Finds short curves of edges that do not separate the surface. The shortest one through a vertex
// consists of two shortest paths from there and an edge between their ends.
//
// Such a curve has an edge with a signature that is not zero; so one end of each of these edges,
// the centers, is where searches begin. If there is nothing shorter than $l$ through a center,
// there is nothing shorter than $l - 2 d$ through another one at the distance $d$. So searches go
// beyond the length that is asked for, and where they find nothing the centers near by need none.
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

  explicit Short_loops(const Surface_surgery& surface)
    : m_surface(surface),
      m_mesh(surface.mesh()),
      m_signatures(m_mesh),
      m_label(m_mesh.num_vertices())
  {}

  // Returns loops of at most `maximum_length` that have no vertex in common and together do not
  // separate, the shortest ones first. None passes a vertex of the boundary.
  std::vector<Loop> disjoint_loops(double maximum_length)
  {
    std::vector<Loop> all = loops_through_centers(maximum_length), result;
    std::stable_sort(all.begin(), all.end(),
                     [](const Loop& a, const Loop& b) { return a.length < b.length; });
    std::vector<bool> is_used(m_mesh.num_vertices(), false);
    std::unordered_set<Signature> seen; // a loop separates together with another of its class
    for(Loop& loop : all)
      if(std::none_of(loop.halfedges.begin(), loop.halfedges.end(),
                      [&](Halfedge_index h) { return is_used[m_mesh.target(h)]; }) &&
         seen.insert(m_signatures.of(loop.halfedges)).second) {
        for(Halfedge_index h : loop.halfedges)
          is_used[m_mesh.target(h)] = true;
        result.push_back(std::move(loop));
      }
    leave_connected(result);
    return result;
  }

  // Returns the number of vertices that all searches so far have reached.
  std::size_t number_of_visits() const { return m_visits; }

private:
  double length(Halfedge_index h) const { return get(m_surface.length_map(), Edge_index(h)); }

  std::vector<Loop> loops_through_centers(double maximum_length)
  {
    std::vector<Loop> result;
    std::vector<bool> is_done(m_mesh.num_vertices(), false);
    for(Vertex_index center : centers()) {
      if(is_done[center])
        continue;
      Loop loop = shortest(center, 1.5 * maximum_length);
      const double covered =
        loop.halfedges.empty() ? maximum_length / 4 : (loop.length - maximum_length) / 2;
      for(Vertex_index v : m_ball)
        if(m_label[v].distance < covered)
          is_done[v] = true;
      if(!loop.halfedges.empty() && loop.length <= maximum_length)
        result.push_back(std::move(loop));
    }
    return result;
  }

  // Removes the longest loops without which the others, together, do not separate: those across
  // which what is cut along all loops is put together again.
  void leave_connected(std::vector<Loop>& loops) const
  {
    std::vector<bool> is_cut(m_mesh.num_edges(), false);
    for(const Loop& loop : loops)
      for(Halfedge_index h : loop.halfedges)
        is_cut[Edge_index(h)] = true;
    boost::disjoint_sets_with_storage<> parts(m_mesh.num_faces());
    const auto join = [&](Halfedge_index h) {
      const auto left = parts.find_set(m_mesh.face(h).idx());
      const auto right = parts.find_set(m_mesh.face(opposite(h)).idx());
      parts.link(left, right);
      return left != right;
    };
    for(Edge_index e : m_mesh.edges())
      if(!is_cut[e] && !m_mesh.is_border(e))
        join(m_mesh.halfedge(e, 0));
    std::vector<Loop> result;
    for(auto loop = loops.rbegin(); loop != loops.rend(); ++loop)
      if(!join(loop->halfedges.front()))
        result.push_back(std::move(*loop));
    std::reverse(result.begin(), result.end());
    loops = std::move(result);
  }

  // one end of each edge with a signature, unless such an edge ends on the boundary
  std::vector<Vertex_index> centers() const
  {
    std::vector<Vertex_index> result;
    std::vector<bool> is_center(m_mesh.num_vertices(), false);
    for(Edge_index e : m_mesh.edges()) {
      const Vertex_index v = m_mesh.vertex(e, 0), w = m_mesh.vertex(e, 1);
      if(m_signatures[e] == 0 || is_center[v] || is_center[w] || m_mesh.is_border(v) ||
         m_mesh.is_border(w))
        continue;
      is_center[v] = true;
      result.push_back(v);
    }
    return result;
  }

  // Returns the shortest loop that is found from `center`, empty if there is none. No edge beyond
  // half of its length closes a shorter one.
  Loop shortest(Vertex_index center, double maximum_length)
  {
    start(center);
    double least = maximum_length;
    Halfedge_index best;
    while(!m_queue.empty() && 2 * m_queue.top().first <= least) {
      const Vertex_index v = m_queue.top().second;
      m_queue.pop();
      if(m_label[v].is_final)
        continue;
      m_label[v].is_final = true;
      m_ball.push_back(v);
      for_each_spoke(v, m_mesh, [&, a = m_label[v]](Halfedge_index h) {
        const Label& b = m_label[m_mesh.target(h)];
        const Signature s = a.signature ^ m_signatures[Edge_index(h)];
        const double reached = a.distance + length(h);
        if(b.round != m_round || !b.is_final)
          push(m_mesh.target(h), reached, h, s);
        else if(const double l = reached + b.distance;
                s != b.signature && (best.is_valid() ? l < least : l <= least)) {
          least = l;
          best = h;
        }
      });
    }
    m_visits += m_ball.size();
    return best.is_valid() ? loop_across(best) : Loop{0, {}};
  }

  void start(Vertex_index center)
  {
    ++m_round;
    m_ball.clear();
    m_queue = Queue();
    push(center, 0, Halfedge_index(), 0);
  }

  void push(Vertex_index v, double distance, Halfedge_index last, Signature signature)
  {
    Label& label = m_label[v];
    if((label.round == m_round && label.distance <= distance) || m_mesh.is_border(v))
      return;
    label = {m_round, distance, last, signature, false};
    m_queue.push({distance, v});
  }

  Loop loop_across(Halfedge_index h) const
  {
    Loop result{0, Intrinsic_triangulations::internal::tree_loop(
                     h, [&](Vertex_index v) { return m_label[v].last; }, m_mesh)};
    for(Halfedge_index x : result.halfedges)
      result.length += length(x);
    return result;
  }

  const Surface_surgery& m_surface;
  const Delta_complex& m_mesh;
  Loop_signatures m_signatures;
  std::size_t m_round = 0;
  std::size_t m_visits = 0;
  std::vector<Label> m_label;
  std::vector<Vertex_index> m_ball;
  typedef std::pair<double, Vertex_index> Entry;
  typedef std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Queue;
  Queue m_queue;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_SHORT_LOOPS_H
