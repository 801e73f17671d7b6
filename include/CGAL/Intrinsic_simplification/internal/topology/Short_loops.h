// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_SHORT_LOOPS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_SHORT_LOOPS_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>
#include <CGAL/Intrinsic_triangulations/Loop_search.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Finds short curves of edges that do not separate the surface.
//
// If no loop shorter than $l$ passes through a center, no loop shorter than $l - 2 d$ passes
// through another center at the distance $d$. So searches extend beyond the requested length. If
// they find no loop, the centers near by need no search.
class Short_loops
{
  typedef Intrinsic_triangulations::Loop_search<Surface_surgery> Search;
  typedef Search::Signature Signature;

public:
  struct Loop
  {
    double length;
    std::vector<Halfedge_index> halfedges;
  };

  explicit Short_loops(const Surface_surgery& surface)
    : m_mesh(surface.mesh()), m_search(surface, Intrinsic_triangulations::Boundary_loops::filled)
  {}

  // Returns loops of at most `maximum_length` that have no common vertex and together do not
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
         seen.insert(m_search.signatures().of(loop.halfedges)).second) {
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
  bool is_inside(Vertex_index v) const { return !m_mesh.is_border(v); }

  std::vector<Loop> loops_through_centers(double maximum_length)
  {
    std::vector<Loop> result;
    std::vector<bool> is_done(m_mesh.num_vertices(), false);
    for(Vertex_index center : m_search.centers([&](Vertex_index v) { return is_inside(v); })) {
      if(is_done[center])
        continue;
      Loop loop = shortest(center, 1.5 * maximum_length);
      const double covered =
        loop.halfedges.empty() ? maximum_length / 4 : (loop.length - maximum_length) / 2;
      for(Vertex_index v : m_ball)
        if(m_search.distance(v) < covered)
          is_done[v] = true;
      if(!loop.halfedges.empty() && loop.length <= maximum_length)
        result.push_back(std::move(loop));
    }
    return result;
  }

  // Removes the longest loops, so that the remaining loops together do not separate. Across such a
  // loop, parts that are cut along all loops are joined again.
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

  // Returns the shortest loop found from `center`, or an empty one. No edge beyond half of its
  // length closes a shorter loop.
  Loop shortest(Vertex_index center, double maximum_length)
  {
    m_ball.clear();
    double least = maximum_length;
    Halfedge_index best;
    m_search.search(
      center, [&](Vertex_index v) { return is_inside(v); },
      [&](Vertex_index v) {
        if(2 * m_search.distance(v) > least)
          return false;
        m_ball.push_back(v);
        return true;
      },
      [&](Halfedge_index h, double length, Signature) {
        if(best.is_valid() ? length < least : length <= least) {
          least = length;
          best = h;
        }
      });
    m_visits += m_ball.size();
    if(!best.is_valid())
      return {0, {}};
    const std::vector<Halfedge_index> loop = m_search.loop(best);
    return {m_search.length(loop), loop};
  }

  const Delta_complex& m_mesh;
  Search m_search;
  std::size_t m_visits = 0;
  std::vector<Vertex_index> m_ball;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_TOPOLOGY_SHORT_LOOPS_H
