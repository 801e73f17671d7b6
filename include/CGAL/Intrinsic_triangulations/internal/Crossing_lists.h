// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CROSSING_LISTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CROSSING_LISTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/Input_crossings.h>

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The halfedges of T1 that cross each edge of T2, in order, while T2 changes. So everything that an
// insertion needs is at hand, however far the edges of T1 run. Of a shared edge the list has the
// halfedge of T1 along it.
template <typename Traits>
class Crossing_lists
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::Integer Integer;
  typedef typename Triangulation::Coordinates Coordinates;
  typedef std::vector<Halfedge_index> List;

public:
  explicit Crossing_lists(const Triangulation& tri) : m_tri(tri), m_list(tri.mesh().num_edges())
  {
    const Input_crossings crossings(tri.coordinates(), tri.mesh(), tri.spokes());
    for(Edge_index e : tri.mesh().edges()) {
      for(std::size_t m = 0; m < crossings.count(e); ++m)
        m_list[e].push_back(crossings(e, m));
      set_if_shared(e);
    }
  }

  // The halfedge of T1 that crosses the halfedge `h` of T2 as its number `m` from left to right, or
  // that lies along `h`.
  Halfedge_index operator()(Halfedge_index h, std::size_t m) const
  {
    const List& list = m_list[Edge_index(h)];
    return is_even(h) ? list[m] : twin(list[list.size() - 1 - m]);
  }

  // the number of crossings on the edge of `h`
  std::size_t count(Halfedge_index h) const
  {
    const Edge_index e(h);
    return m_tri.coordinates().is_shared(e) ? 0 : m_list[e].size();
  }

  // to be called after the edge of `h` has been flipped
  void after_flip(Halfedge_index h)
  {
    List old;
    old.swap(m_list[Edge_index(h)]);
    update(Edge_index(h), old);
  }

  // to be called after edges have been made, in a face that others have left or beside one that was split
  void after_cut(std::initializer_list<Halfedge_index> cuts)
  {
    m_list.resize(m_tri.mesh().num_edges());
    for(Halfedge_index h : cuts)
      m_list[Edge_index(h)].clear();
    for(Halfedge_index h : cuts)
      update(Edge_index(h), {});
  }

  // to be called after an edge has been split into `im` and `mj`; the second has the number of the whole
  void after_split(Halfedge_index im, Halfedge_index mj)
  {
    m_list.resize(m_tri.mesh().num_edges());
    const List whole = m_list[Edge_index(mj)];
    const std::size_t first = count_of(im), second = count_of(mj), n = whole.size();
    const auto at = [&](std::size_t m) { return is_even(mj) ? whole[m] : twin(whole[n - 1 - m]); };
    set(im, first, [&](std::size_t m) { return at(m); });
    set(mj, second, [&](std::size_t m) { return at(n - second + m); });
  }

  // to be called after the edge `e` may have become shared
  void set_if_shared(Edge_index e)
  {
    if(m_tri.coordinates().is_shared(e))
      m_list[e].assign(1, m_tri.input_halfedge(Halfedge_index(2 * e.idx())));
  }

private:
  static bool is_even(Halfedge_index h) { return h.idx() % 2 == 0; }
  static Halfedge_index twin(Halfedge_index h) { return Halfedge_index(h.idx() ^ 1); }

  // the length of the list that the edge of `h` should have
  std::size_t count_of(Halfedge_index h) const
  {
    const Integer& n = m_tri.coordinates().normal_coordinate(Edge_index(h));
    return n < 0 ? 1 : static_cast<std::size_t>(n);
  }

  template <typename At>
  void set(Halfedge_index h, std::size_t n, const At& at)
  {
    List& list = m_list[Edge_index(h)];
    list.resize(n);
    for(std::size_t m = 0; m < n; ++m)
      list[is_even(h) ? m : n - 1 - m] = is_even(h) ? at(m) : twin(at(m));
  }

  // Makes the list of an edge from those around it. `old` is what it was before a flip.
  void update(Edge_index e, const List& old)
  {
    if(m_tri.coordinates().is_shared(e))
      return set_if_shared(e);
    const Halfedge_index h(2 * e.idx());
    const std::size_t n = count_of(h);
    List list(n);
    for(std::size_t m = 0; m < n; ++m) {
      list[m] = crossing_beyond(h, m);
      if(!list[m].is_valid())
        list[m] = twin_if_needed(crossing_beyond(twin(h), n - 1 - m));
      if(!list[m].is_valid())
        list[m] = old.front();
    }
    m_list[e].swap(list);
  }

  static Halfedge_index twin_if_needed(Halfedge_index h) { return h.is_valid() ? twin(h) : h; }

  // The halfedge of T1 that crosses the halfedge `h` as its number `m`, from the edge that it crosses
  // next; null if it ends before, or the list of that edge is not known yet.
  Halfedge_index crossing_beyond(Halfedge_index h, std::size_t m) const
  {
    typename Coordinates::Crossing c{h, static_cast<Integer>(m)};
    if(m_tri.coordinates().advance(c, m_tri.mesh()) == Coordinates::Turn::ends ||
       m_list[Edge_index(c.halfedge)].size() != count_of(c.halfedge))
      return Halfedge_index();
    return (*this)(c.halfedge, static_cast<std::size_t>(c.number));
  }

  const Triangulation& m_tri;
  std::vector<List> m_list;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CROSSING_LISTS_H
