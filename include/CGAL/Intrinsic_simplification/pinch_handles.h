// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_PINCH_HANDLES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_PINCH_HANDLES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>
#include <CGAL/Intrinsic_triangulations/Loop_search.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification {

namespace internal {

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

// Cuts along edge loops that have no common vertex, round by round.
class Handle_pincher
{
public:
  Handle_pincher(Surface_surgery& surface, double maximum_length)
    : m_surface(surface), m_maximum(maximum_length)
  {}

  // Cuts with growing bounds on the length of edge loops. So searches are short if handles are
  // small, and few searches are long.
  std::size_t operator()()
  {
    const std::size_t genus = Intrinsic_triangulations::topological_type(m_surface.mesh()).genus;
    const double all = total_length();
    double bound = first_bound * all / static_cast<double>(m_surface.mesh().number_of_edges());
    std::size_t result = 0;
    for(bool is_last = false; !is_last && result < genus; bound *= 2) {
      is_last = !(bound < m_maximum && bound < all);
      result += pinch_up_to(is_last ? m_maximum : bound, genus - result);
    }
    return result;
  }

  // Returns the effort: the number of searches for loops, and of vertices that they reached.
  std::size_t number_of_searches() const { return m_searches; }
  std::size_t number_of_visits() const { return m_visits; }

private:
  // The first bound has this number of mean edge lengths.
  static constexpr double first_bound = 4;

  std::size_t pinch_up_to(double bound, std::size_t genus)
  {
    std::size_t result = 0;
    for(bool is_going_on = true; is_going_on && result < genus;) {
      const std::size_t pinched = pinch_round(bound);
      is_going_on = pinched > 0;
      result += pinched;
    }
    return result;
  }

  double total_length() const
  {
    double result = 0;
    for(Edge_index e : m_surface.mesh().edges())
      result += get(m_surface.length_map(), e);
    return result;
  }

  std::size_t pinch_round(double bound)
  {
    Short_loops search(m_surface);
    const auto loops = search.disjoint_loops(bound);
    ++m_searches;
    m_visits += search.number_of_visits();
    for(const auto& loop : loops) {
      const auto [left, right] = m_surface.cut(loop.halfedges);
      m_surface.close(left);
      m_surface.close(right);
    }
    return loops.size();
  }

  Surface_surgery& m_surface;
  double m_maximum;
  std::size_t m_searches = 0;
  std::size_t m_visits = 0;
};

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationApplications
/// removes handles with a closed curve of edges around or through them whose length is at most
/// `maximum_length`. It cuts the surface along such curves, the shortest ones first, and closes
/// both sides by disks, see `Surface_surgery`. No curve separates the surface. So each cut lowers
/// the genus by one, and components and boundary loops remain. Faces and edges beside the curves do
/// not change.
///
/// The search visits the vertices in turn. From each vertex it finds the shortest curve that does
/// not separate the surface and consists of two shortest paths and an edge between them
/// \cgalCite{EW05}. The greatest length of curves doubles, from a few edges up to the bound. Curves
/// without common vertices are cut in one round. The next round searches the new surface, including
/// disks.
///
/// A handle remains if all short curves around it pass a vertex of the boundary. It also remains if
/// no curve of edges around it is short enough; refine the surface if edges are long beside the
/// handle. The length alone does not distinguish handles from tunnels, and a thin torus is a handle
/// too. To cut along geodesics, make them edges (`Intrinsic_triangulations::Edge_paths`), and call
/// `Surface_surgery::retriangulate()` and `Surface_surgery::cut()`.
/// \returns the number of handles that were cut
///
/// Complexity: \f$O(n \log n)\f$ for each round. Each length has few rounds, since disjoint curves
/// are cut in one round. A search is not repeated near vertices at which a search failed. So
/// searches reach each vertex a few times in a round, unless many curves have about the length of
/// the bound.
inline std::size_t pinch_handles(Surface_surgery& surface, double maximum_length)
{
  return internal::Handle_pincher(surface, maximum_length)();
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_PINCH_HANDLES_H
