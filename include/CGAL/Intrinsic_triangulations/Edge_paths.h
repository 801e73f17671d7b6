// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EDGE_PATHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EDGE_PATHS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Fan.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Fan_flipping.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Segment_lists.h>

#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// states how shortening has ended.
enum class Shortening_status
{
  geodesic, ///< all paths are geodesics
  blocked   ///< angles below \f$\pi\f$ are left: each contains a constrained edge, or an edge
            ///< of a path that crosses or ends at another one
};

/// \ingroup PkgIntrinsicTriangulationsPaths
/// returns a short sentence for `status`.
inline const char* to_string(Shortening_status status)
{
  switch(status) {
    case Shortening_status::geodesic: return "the paths are geodesics";
    case Shortening_status::blocked: return "paths are blocked by others or by constrained edges";
  }
  return "unknown";
}

/// \ingroup PkgIntrinsicTriangulationsPaths
/// paths and loops along edges of \f$T_2\f$, which flips of edges shorten to geodesics
/// \cgalCite{SC20b}.
///
/// If a path has an angle of less than \f$\pi\f$ on one side, the edges in this angle are flipped
/// as long as possible. The path moves to the shorter arc on the other side of their triangles. At
/// the end both angles at every vertex between the ends are at least \f$\pi\f$; on the boundary,
/// the angle inside the surface is. The paths are then geodesics along edges of \f$T_2\f$, each
/// isotopic to its start. `path_on_input()` follows them over \f$T_1\f$.
///
/// Paths may share vertices and edges, also with themselves. Segments on one edge lie side by side,
/// and paths do not cross while they move. Paths that come together and part again are ordered so
/// that they do not cross, if that is possible. Paths that never part lie in the order in which
/// they are added, to the right. The ends of paths are fixed. A loop that contracts to a point
/// becomes empty.
///
/// Decisions about angles and flips are exact with exact traits. With `double` the surface of
/// \f$T_1\f$ decides, too; an angle within \f$10^{-24}\f$ of \f$\pi\f$ counts as \f$\pi\f$. Edges
/// of \f$T_2\f$ must then be straight at the start (`certify_Delaunay()`). In both cases lengths
/// have a relative error of at most \f$2^{-40}\f$. With other number types an angle is less than
/// \f$\pi\f$ if it is less by more than the rounding of lengths. The path must also get shorter by
/// more than rounding errors.
///
/// \tparam Traits a model of `IntrinsicGeometryTraits`, Euclidean
template <typename Traits>
class Edge_paths
{
  typedef internal::Segment_lists Segments;
  typedef Segments::Index Index;
  typedef internal::Fan_flipping<Traits> Flipping;

public:
  /// the triangulation.
  typedef Intrinsic_triangulation<Traits> Triangulation;
  /// the number type of lengths.
  typedef typename Traits::FT FT;

  /// prepares for paths on the second triangulation of `tri`, which is referred to and flipped by
  /// `shorten()` only. It must not be flipped in the meantime. Lengths of type `double` of edges
  /// that are not in \f$T_1\f$ are recomputed. Complexity: linear.
  /// \throws Numerical_error if a length is not positive and finite
  explicit Edge_paths(Triangulation& tri)
    : m_tri(tri), m_mesh(tri.mesh()), m_flattener(tri), m_segment(m_mesh.num_edges())
  {}

  /// \name Paths
  /// @{

  /// adds a path and returns its index. Parts that are followed in both directions are removed.
  /// \pre each halfedge starts where the one before ends
  std::size_t add_path(const std::vector<Halfedge_index>& halfedges)
  {
    return add(halfedges, false);
  }

  /// adds a loop and returns its index. Parts that are followed in both directions are removed.
  /// \pre each halfedge starts where the one before ends, and the first one where the last one ends
  std::size_t add_loop(const std::vector<Halfedge_index>& halfedges)
  {
    return add(halfedges, true);
  }

  /// returns whether path `i` is a loop.
  bool is_loop(std::size_t i) const { return m_path[i].is_loop; }

  /// returns the halfedges of \f$T_2\f$ along path `i`; none if it has contracted to a point.
  std::vector<Halfedge_index> halfedges(std::size_t i) const
  {
    std::vector<Halfedge_index> result;
    for(const Index s : segments(i))
      result.push_back(halfedge(s));
    return result;
  }

  /// returns the length of path `i`.
  FT length(std::size_t i) const
  {
    FT sum(0);
    for(Halfedge_index h : halfedges(i))
      sum += m_tri.length(m_mesh.edge(h));
    return sum;
  }

  /// @}
  /// \name Shortening
  /// @{

  /// shortens all paths to geodesics. Least angles come first.
  ///
  /// Complexity: finite, since lengths decrease. In practice, an edge of a path takes a few flips.
  /// \throws Numerical_error if a flipped edge has no positive finite length
  /// \throws Overflow_error if a normal coordinate is out of range
  ///
  /// After an exception the paths are shorter or unchanged, and still paths of \f$T_2\f$.
  Shortening_status shorten()
  {
    for(bool has_moved = true; has_moved;) {
      has_moved = false;
      for(std::size_t i = 0; i < m_path.size(); ++i)
        for(const Index s : segments(i))
          note(s, m_segment[s].next);
      while(!m_queue.empty()) {
        const auto [angle, s, t, is_left, is_certain] = m_queue.top();
        m_queue.pop();
        if(!m_segment[s].is_removed && !m_segment[t].is_removed && m_segment[s].next == t)
          has_moved = straighten(s, t, is_left, is_certain) || has_moved;
      }
    }
    return is_geodesic() ? Shortening_status::geodesic : Shortening_status::blocked;
  }

  /// returns whether no path has an angle of less than \f$\pi\f$ between its ends.
  bool is_geodesic() const
  {
    for(std::size_t i = 0; i < m_path.size(); ++i)
      for(const Index s : segments(i))
        if(const Index t = m_segment[s].next;
           t != Segments::null && (is_not_straight(s, t, true) || is_not_straight(s, t, false)))
          return false;
    return true;
  }

  /// removes all paths and undoes all flips: \f$T_2\f$ becomes the triangulation for which this
  /// object was made, with the same indices and numbers. Complexity: linear in the flips and the
  /// paths.
  void rewind()
  {
    m_flattener.rewind();
    m_segment.clear();
    m_path.clear();
    m_queue = {};
    m_idle_moves = 0;
  }

  /// returns the number of flips since the last `rewind()`.
  std::size_t number_of_flips() const { return m_flattener.number_of_flips(); }

  /// @}

private:
  typedef internal::Fan Fan;
  typedef std::vector<Halfedge_index> Halfedges;
  // Stores an angle, two segments, whether it is on their left, and whether it is certainly less
  // than pi.
  typedef std::tuple<FT, Index, Index, bool, bool> Joint;

  static constexpr std::size_t greatest_number_of_idle_moves = 1000;

  struct Path
  {
    Index first; // null if it is a point
    bool is_loop;
  };

  Halfedge_index halfedge(Index s) const { return m_segment[s].halfedge; }

  std::vector<Index> segments(std::size_t path) const
  {
    std::vector<Index> result;
    const Index first = m_path[path].first;
    for(Index s = first; s != Segments::null;) {
      result.push_back(s);
      s = m_segment[s].next == first ? Segments::null : m_segment[s].next;
    }
    return result;
  }

  // Removes parts of a path that are followed in both directions. Such parts have no sides: paths
  // beside them could be ordered so that they cross.
  static Halfedges without_spurs(const Halfedges& halfedges, bool is_loop)
  {
    Halfedges result;
    for(Halfedge_index h : halfedges)
      if(!result.empty() && result.back() == opposite(h))
        result.pop_back();
      else
        result.push_back(h);
    auto first = result.begin(), last = result.end();
    while(is_loop && last - first > 1 && *first == opposite(*(last - 1))) {
      ++first;
      --last;
    }
    return {first, last};
  }

  std::size_t add(const Halfedges& halfedges, bool is_loop)
  {
    CGAL_precondition(is_connected(halfedges, is_loop));
    const Index path = static_cast<Index>(m_path.size());
    const Index first = static_cast<Index>(m_segment.size());
    const Halfedges outgoing = without_spurs(halfedges, is_loop);
    for(Halfedge_index h : outgoing) {
      const Index s = m_segment.add(h, path);
      m_segment.link(s == first ? Segments::null : s - 1, s);
    }
    const Index end = static_cast<Index>(m_segment.size());
    if(is_loop && first < end)
      m_segment.link(end - 1, first);
    for(Index s = first; s < end; ++s)
      m_segment.insert(s, m_mesh);
    m_path.push_back({first < end ? first : Segments::null, is_loop});
    return path;
  }

  bool is_connected(const Halfedges& halfedges, bool is_loop) const
  {
    for(std::size_t i = is_loop ? 0 : 1; i < halfedges.size(); ++i)
      if(m_mesh.target(halfedges[(i == 0 ? halfedges.size() : i) - 1]) !=
         m_mesh.source(halfedges[i]))
        return false;
    return true;
  }

  // ---- Joints ----

  // Returns the ends of the fan on one side of a joint.
  internal::Fan_ends fan_ends(Index s, Index t, bool is_left) const
  {
    const Halfedge_index out = halfedge(t), back = opposite(halfedge(s));
    return is_left ? internal::Fan_ends{out, back} : internal::Fan_ends{back, out};
  }

  bool is_spur(Index s, Index t) const { return halfedge(t) == m_mesh.opposite(halfedge(s)); }

  bool is_not_straight(Index s, Index t, bool is_left) const
  {
    if(is_spur(s, t))
      return true;
    return !m_segment[s].is_straight(is_left) &&
           m_flattener.is_less_than_pi(fan_ends(s, t, is_left));
  }

  // Pushes the joint into the queue, for each side that may have an angle of less than pi.
  void note(Index s, Index t)
  {
    if(s == Segments::null || t == Segments::null)
      return;
    if(is_spur(s, t)) {
      m_queue.push({FT(0), s, t, true, true});
      return;
    }
    for(bool is_left : {true, false})
      if(!m_segment[s].is_straight(is_left))
        note(s, t, is_left);
  }

  void note(Index s, Index t, bool is_left)
  {
    const internal::Fan_ends ends = fan_ends(s, t, is_left);
    const auto sum = internal::corner_sum(ends, m_tri.intrinsic(), Flipping::length_error());
    const Uncertain<bool> is_less_than_pi = sum.is_less_than_pi();
    if(certainly(is_less_than_pi))
      m_queue.push({sum.angle(), s, t, is_left, true});
    else if(const Fan outgoing = is_certain(is_less_than_pi) ? Fan() : fan(ends); !outgoing.empty())
      m_queue.push({angle(outgoing), s, t, is_left, false});
    else
      m_segment.set_straight(s, is_left);
  }

  Fan fan(internal::Fan_ends ends) const { return internal::fan(ends, m_mesh); }

  FT angle(const Fan& outgoing) const
  {
    return internal::fan_angle(outgoing, m_tri.intrinsic(), Flipping::length_error()).angle;
  }

  // Returns whether the edges inside the fan can be flipped: no path runs along them, and they are
  // not constrained.
  bool is_free(const Fan& outgoing) const
  {
    for(std::size_t i = 1; i + 1 < outgoing.size(); ++i)
      if(const Edge_index e = m_mesh.edge(outgoing[i]);
         !m_segment.is_free(e) || m_tri.is_constrained(e))
        return false;
    return true;
  }

  // ---- Moves ----

  // Returns whether the path has moved. Flips keep the angle, so a certain decision stays certain.
  bool straighten(Index s, Index t, bool is_left, bool is_certain)
  {
    if(is_spur(s, t))
      return cut_spur(s, t);
    Fan outgoing = fan(fan_ends(s, t, is_left));
    const Index at_out = is_left ? t : s, at_in = is_left ? s : t;
    if(m_segment.outermost(outgoing.front()) != at_out ||
       m_segment.outermost(m_mesh.opposite(outgoing.back())) != at_in || !is_free(outgoing))
      return false;
    if(!is_certain && !m_flattener.is_less_than_pi({outgoing.front(), outgoing.back()})) {
      m_segment.set_straight(s, is_left);
      return false;
    }
    const bool is_bent = m_flattener.flip_out(outgoing, s == t);
    const Fan arc = outer_arc(outgoing, s == t);
    if(!is_shorter(arc, s, t)) {
      m_segment.set_straight(s, true); // up to rounding, by length
      m_segment.set_straight(s, false);
      return false;
    }
    replace(s, t, arc, is_left, is_bent);
    return true;
  }

  bool cut_spur(Index s, Index t)
  {
    if(s == t || !m_segment.are_neighbors(s, t))
      return false;
    replace(s, t, {}, true, false);
    return true;
  }

  // Returns the sides opposite to the apex of the fan, counterclockwise. A loop of one edge has the
  // face of this edge at both ends of the fan, and moves to the sides between them.
  Fan outer_arc(const Fan& outgoing, bool is_one_edge) const
  {
    Fan result;
    const std::size_t skipped = is_one_edge ? 1 : 0;
    for(std::size_t i = skipped; i + 1 + skipped < outgoing.size(); ++i)
      result.push_back(m_mesh.next(outgoing[i]));
    return result;
  }

  // Returns whether the path may move, because it does not become longer. Moves that gain no more
  // than rounding errors, as beside short edges, are limited in number unless decisions are exact.
  bool is_shorter(const Fan& arc, Index s, Index t)
  {
    const auto length = [&](Halfedge_index h) { return m_tri.length(m_mesh.edge(h)); };
    const FT before = length(halfedge(s)) + (s == t ? FT(0) : length(halfedge(t)));
    FT after(0);
    for(Halfedge_index h : arc)
      after += length(h);
    const FT tolerance = 2 * Flipping::length_error() * before;
    return after < before - tolerance ||
           (after <= before + tolerance &&
            (internal::Is_exact<Traits>::value ||
             m_idle_moves++ < greatest_number_of_idle_moves + m_mesh.number_of_edges()));
  }

  // Replaces two segments, or a loop of one segment, by an arc around the vertex between them. The
  // vertex is on the left of the halfedges of the arc. Its angles on this side are at least pi if
  // it `is_bent`.
  void replace(Index s, Index t, const Fan& arc, bool is_left, bool is_bent)
  {
    const Index path = m_segment[s].path;
    const bool is_whole_loop = m_path[path].is_loop && m_segment[t].next == s;
    Index previous = is_whole_loop ? Segments::null : m_segment[s].previous;
    const Index next = is_whole_loop ? Segments::null : m_segment[t].next;
    const bool is_first = m_path[path].first == s || m_path[path].first == t;
    m_segment.remove(s);
    if(t != s)
      m_segment.remove(t);
    std::vector<Index> added;
    for(std::size_t i = 0; i < arc.size(); ++i) {
      const Halfedge_index h = is_left ? arc[arc.size() - 1 - i] : arc[i];
      added.push_back(m_segment.add(is_left ? m_mesh.opposite(h) : h, path, h));
    }
    if(is_whole_loop)
      previous = added.empty() ? Segments::null : added.back();
    for(Index a : added) {
      m_segment.link(previous, a);
      previous = a;
    }
    if(!is_whole_loop)
      m_segment.link(previous, next);
    if(is_first)
      m_path[path].first = !added.empty() ? added.front() : next;
    for(std::size_t i = 1; is_bent && i < added.size(); ++i)
      m_segment.set_straight(added[i - 1], !is_left);
    for(const Index a : added)
      note(m_segment[a].previous, a);
    note(previous, next);
  }

  Triangulation& m_tri;
  const Delta_complex& m_mesh;
  mutable internal::Fan_flattener<Traits> m_flattener; // decisions are remembered
  Segments m_segment;
  std::vector<Path> m_path;
  std::priority_queue<Joint, std::vector<Joint>, std::greater<Joint>> m_queue;
  std::size_t m_idle_moves = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EDGE_PATHS_H
