// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DIJKSTRA_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DIJKSTRA_SEARCH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// runs Dijkstra's algorithm on the vertices of a surface along edges, or on its faces across
/// edges. It runs step by step: the caller determines where each step leads, and when the search
/// ends. The time of a search depends only on the elements that it reaches. Among equally close
/// vertices (faces), the one with the least index comes first. Its path is the path that was found
/// first.
///
/// With bounds for the rest of paths it is the algorithm A*: the element with the least sum of
/// distance and bound comes first. An element that comes before its distance is final comes again.
///
/// \tparam Index `Vertex_index` or `Face_index`
/// \tparam FT the number type of distances
template <typename Index, typename FT>
class Dijkstra_search
{
public:
  /// prepares for searches among indices less than `size`.
  explicit Dijkstra_search(std::size_t size) { resize(size); }

  /// allows indices less than `size`.
  void resize(std::size_t size) { m_label.resize(size); }

  /// clears the last search. Complexity: constant.
  void restart()
  {
    ++m_round;
    m_queue.clear();
  }

  /// proposes a path to `x` of the length `distance` whose last halfedge is `entry`, null for a
  /// source. From `x` to a target, it is at least `rest`. Returns whether the path is shorter than
  /// all earlier ones.
  bool reach(Index x, const FT& distance, Halfedge_index entry = Halfedge_index(),
             const FT& rest = FT(0))
  {
    Label& label = m_label[x.idx()];
    if(label.round == m_round && label.distance <= distance)
      return false;
    label = {m_round, distance, entry, false};
    m_queue.push_back({distance + rest, x});
    std::push_heap(m_queue.begin(), m_queue.end(), std::greater<Entry>());
    return true;
  }

  /// replaces the last halfedge of the path to `x` by the last halfedge of another path of the
  /// same length.
  void set_entry(Index x, Halfedge_index entry) { m_label[x.idx()].entry = entry; }

  /// returns the closest vertex (face) with a known path that has not been returned before; null if
  /// none is left. Its distance is final if no bounds for the rest are given.
  Index next()
  {
    const Index x = peek();
    if(x.is_valid()) {
      m_label[x.idx()].is_final = true;
      pop();
    }
    return x;
  }

  /// returns what `next()` will return.
  Index peek()
  {
    while(!m_queue.empty() && m_label[m_queue.front().second.idx()].is_final)
      pop();
    return m_queue.empty() ? Index() : m_queue.front().second;
  }

  /// returns a bound for the number of vertices (faces) to which a path is known and which `next()`
  /// has not returned.
  std::size_t number_of_open() const { return m_queue.size(); }

  /// returns whether `next()` has returned `x` in this search.
  bool is_final(Index x) const { return is_reached(x) && m_label[x.idx()].is_final; }

  /// returns whether a path to `x` is known in this search.
  bool is_reached(Index x) const { return m_label[x.idx()].round == m_round; }

  /// returns the length of the last path to `x`, in this search or an earlier one that reached
  /// `x`.
  const FT& distance(Index x) const { return m_label[x.idx()].distance; }

  /// returns the last halfedge of this path.
  Halfedge_index entry(Index x) const { return m_label[x.idx()].entry; }

private:
  // A label of an earlier search has another `round`.
  struct Label
  {
    std::size_t round = 0;
    FT distance = FT(0);
    Halfedge_index entry;
    bool is_final = false;
  };

  typedef std::pair<FT, Index> Entry;

  void pop()
  {
    std::pop_heap(m_queue.begin(), m_queue.end(), std::greater<Entry>());
    m_queue.pop_back();
  }

  std::size_t m_round = 1;
  std::vector<Label> m_label;
  std::vector<Entry> m_queue; // a heap, the least distance first
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DIJKSTRA_SEARCH_H
