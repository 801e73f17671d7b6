// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SEGMENT_LISTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SEGMENT_LISTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores pieces of paths along edges. Pieces on one edge have an order, from the left of its first
// halfedge to the right.
class Segment_lists
{
public:
  typedef std::uint32_t Index;
  static constexpr Index null = (std::numeric_limits<Index>::max)();

  struct Segment
  {
    Halfedge_index halfedge;
    Index path, previous, next; // null at the ends of a path
    bool is_removed;
    // Stores whether the angle to the next segment is known to be at least pi, before and after
    // flips.
    bool is_straight_on_left, is_straight_on_right;

    bool is_straight(bool on_left) const
    {
      return on_left ? is_straight_on_left : is_straight_on_right;
    }
  };

  // Allocates lists for segments on edges with indices less than `edges`.
  explicit Segment_lists(std::size_t edges) : m_on_edge(edges) {}

  // Returns the number of segments that have been added.
  std::size_t size() const { return m_segment.size(); }

  void clear()
  {
    for(const Segment& s : m_segment)
      m_on_edge[Edge_index(s.halfedge).idx()].clear();
    m_segment.clear();
  }

  const Segment& operator[](Index s) const { return m_segment[s]; }

  bool is_free(Edge_index e) const { return m_on_edge[e.idx()].empty(); }

  // Returns the segment that is next to the face of `h`, on the edge of `h`.
  Index outermost(Halfedge_index h) const
  {
    const auto& list = m_on_edge[Edge_index(h).idx()];
    return is_first_halfedge(h) ? list.front() : list.back();
  }

  // Returns whether no other segment is between two segments on one edge.
  bool are_neighbors(Index s, Index t) const
  {
    const auto& list = m_on_edge[Edge_index(m_segment[s].halfedge).idx()];
    const auto i = std::find(list.begin(), list.end(), s),
               j = std::find(list.begin(), list.end(), t);
    return j - i == 1 || i - j == 1;
  }

  // Adds a segment along `h`, which is not on the edge yet.
  Index add(Halfedge_index h, Index path)
  {
    m_segment.push_back({h, path, null, null, false, false, false});
    return static_cast<Index>(m_segment.size() - 1);
  }

  // Adds a segment along `h`, next to the face of `side`, one of the halfedges of this edge.
  Index add(Halfedge_index h, Index path, Halfedge_index side)
  {
    const Index s = add(h, path);
    auto& list = m_on_edge[Edge_index(h).idx()];
    list.insert(is_first_halfedge(side) ? list.begin() : list.end(), s);
    return s;
  }

  // Inserts the segment, whose path is linked, into the list of its edge. Paths that meet and part
  // again do not cross. Otherwise, the segment is on the right of paths that never part from it.
  template <typename P>
  void insert(Index s, const Surface_mesh<P>& mesh)
  {
    const Halfedge_index h = m_segment[s].halfedge, first = first_halfedge(Edge_index(h));
    auto& list = m_on_edge[Edge_index(h).idx()];
    auto after_those_on_left = list.begin(), position = list.begin();
    for(; position != list.end(); ++position) {
      const int side = compare(s, *position, first, mesh);
      if(side > 0)
        break;
      if(side < 0)
        after_those_on_left = position + 1;
    }
    list.insert(h == first ? position : after_those_on_left, s);
  }

  void remove(Index s)
  {
    auto& list = m_on_edge[Edge_index(m_segment[s].halfedge).idx()];
    list.erase(std::find(list.begin(), list.end(), s));
    m_segment[s].is_removed = true;
  }

  // Links two segments, which may be null.
  void link(Index s, Index t)
  {
    if(s != null) {
      m_segment[s].next = t;
      m_segment[s].is_straight_on_left = m_segment[s].is_straight_on_right = false;
    }
    if(t != null)
      m_segment[t].previous = s;
  }

  void set_straight(Index s, bool on_left)
  {
    (on_left ? m_segment[s].is_straight_on_left : m_segment[s].is_straight_on_right) = true;
  }

private:
  // Stores the halfedge that the path of `s` follows after `h`, and its segment; null at its end.
  struct Step
  {
    Index segment;
    Halfedge_index halfedge;
  };

  Step next(const Step& step) const
  {
    const Segment& s = m_segment[step.segment];
    const bool is_forward = s.halfedge == step.halfedge;
    const Index t = is_forward ? s.next : s.previous;
    if(t == null)
      return {t, step.halfedge};
    return {t, is_forward ? m_segment[t].halfedge : opposite(m_segment[t].halfedge)};
  }

  // Returns 1 if `s` turns left of `t` after the halfedge `h` of both, -1 if it turns right, and 0
  // if one ends.
  template <typename P>
  int compare_ahead(Index s, Index t, Halfedge_index h, const Surface_mesh<P>& mesh) const
  {
    Step a{s, h}, b{t, h};
    for(std::size_t steps = 0; steps <= m_segment.size(); ++steps) {
      const Halfedge_index back = opposite(a.halfedge);
      a = next(a);
      b = next(b);
      if(a.segment == null || b.segment == null)
        return 0;
      if(a.halfedge != b.halfedge)
        return rank(a.halfedge, back, mesh) > rank(b.halfedge, back, mesh) ? 1 : -1;
    }
    return 0;
  }

  template <typename P>
  int compare(Index s, Index t, Halfedge_index h, const Surface_mesh<P>& mesh) const
  {
    const int ahead = compare_ahead(s, t, h, mesh);
    return ahead != 0 ? ahead : -compare_ahead(s, t, opposite(h), mesh);
  }

  // Returns the number of outgoing halfedges from `back` to `h`, counterclockwise around their
  // source.
  template <typename P>
  static std::size_t rank(Halfedge_index h, Halfedge_index back, const Surface_mesh<P>& mesh)
  {
    std::size_t i = 0, at_h = 0, at_back = 0;
    for_each_outgoing_halfedge(mesh.source(h), mesh, [&](Halfedge_index x) {
      at_h = x == h ? i : at_h;
      at_back = x == back ? i : at_back;
      ++i;
    });
    return at_h >= at_back ? at_h - at_back : at_h + i - at_back;
  }

  std::vector<Segment> m_segment;
  // Stores the segments on each edge, from the side of its first halfedge to the other.
  std::vector<boost::container::small_vector<Index, 2>> m_on_edge;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SEGMENT_LISTS_H
