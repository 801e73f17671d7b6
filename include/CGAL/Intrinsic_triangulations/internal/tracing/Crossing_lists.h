// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_LISTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_LISTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_crossings.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The halfedges of T1 that cross each edge of T2, in order, while T2 changes. So everything that an
// insertion needs is at hand, however far the edges of T1 run. Of a shared edge the list has the
// halfedge of T1 along it.
template <typename Traits>
class Crossing_lists
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::Integer Integer;
  typedef Delta_complex::size_type size_type;
  typedef typename Triangulation::Coordinates Coordinates;
  typedef boost::container::small_vector<Halfedge_index, 4> List;

public:
  explicit Crossing_lists(const Triangulation& tri) : m_tri(tri), m_list(tri.mesh().num_edges())
  {
    const Input_crossings crossings(tri.coordinates(), tri.mesh(), tri.spokes());
    for(Edge_index e : tri.mesh().edges()) {
      m_list[e].resize(crossings.count(e));
      for(std::size_t m = 0; m < m_list[e].size(); ++m)
        m_list[e][m] = crossings(first_halfedge(e), m);
      set_if_shared(e);
    }
  }

  // The halfedge of T1 that crosses the halfedge `h` of T2 as its crossing `m` from left to right,
  // or that lies along `h`.
  Halfedge_index operator()(Halfedge_index h, std::size_t m) const
  {
    return at(h, m, m_list[Edge_index(h)]);
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
    const List& old = m_list[Edge_index(h)];
    update(Edge_index(h), old.empty() ? Halfedge_index() : old.front());
  }

  // to be called after edges have been made, in a face that others have left or beside one that was
  // split
  void after_cut(std::initializer_list<Halfedge_index> cuts)
  {
    m_list.resize(m_tri.mesh().num_edges());
    for(Halfedge_index h : cuts)
      m_list[Edge_index(h)].clear();
    for(Halfedge_index h : cuts)
      update(Edge_index(h), Halfedge_index());
  }

  // to be called after an edge has been split into `im` and `mj`; the second has the number of the
  // whole
  void after_split(Halfedge_index im, Halfedge_index mj)
  {
    m_list.resize(m_tri.mesh().num_edges());
    const List whole = m_list[Edge_index(mj)];
    const std::size_t first = count_of(im), second = count_of(mj);
    m_list[Edge_index(im)].resize(first);
    m_list[Edge_index(mj)].resize(second);
    for(std::size_t m = 0; m < first; ++m)
      set(im, m, at(mj, m, whole));
    for(std::size_t m = 0; m < second; ++m)
      set(mj, m, at(mj, whole.size() - second + m, whole));
  }

  // to be called after the edge `e` may have become shared
  void set_if_shared(Edge_index e)
  {
    if(m_tri.coordinates().is_shared(e))
      m_list[e].assign(1, m_tri.input_halfedge(first_halfedge(e)));
  }

private:
  static std::size_t place(Halfedge_index h, std::size_t m, const List& list)
  {
    return along_first_halfedge(h, static_cast<size_type>(m), static_cast<size_type>(list.size()));
  }
  // item `m` of the list of the edge of `h`, as seen from `h`
  static Halfedge_index at(Halfedge_index h, std::size_t m, const List& list)
  {
    return directed_as(h, list[place(h, m, list)]);
  }

  // the length of the list that the edge of `h` should have
  std::size_t count_of(Halfedge_index h) const
  {
    const Integer& n = m_tri.coordinates().normal_coordinate(Edge_index(h));
    return n < 0 ? 1 : static_cast<std::size_t>(n);
  }

  // the inverse of operator()
  void set(Halfedge_index h, std::size_t m, Halfedge_index input)
  {
    List& list = m_list[Edge_index(h)];
    list[place(h, m, list)] = directed_as(h, input);
  }

  // Makes the list of an edge from those around it. A shared edge across it is in none of those: it
  // is `diagonal`.
  void update(Edge_index e, Halfedge_index diagonal)
  {
    if(m_tri.coordinates().is_shared(e))
      return set_if_shared(e);
    const Halfedge_index h = first_halfedge(e);
    m_list[e].assign(count_of(h), diagonal);
    copy_from_beyond(h);
    copy_from_beyond(opposite(h));
  }

  // The curves that cross `h` and then cut off the corner at its source or target are those that
  // cross the other side there; the rest ends.
  void copy_from_beyond(Halfedge_index h)
  {
    const Delta_complex& mesh = m_tri.mesh();
    const Coordinates& coordinates = m_tri.coordinates();
    const Halfedge_index ji = mesh.opposite(h), il = mesh.next(ji), lj = mesh.prev(ji);
    const auto at_source = static_cast<std::size_t>(coordinates.curves_around(lj, mesh));
    const auto at_target = static_cast<std::size_t>(coordinates.curves_around(il, mesh));
    copy(il, 0, h, 0, at_source);
    copy(lj, count_of(lj) - at_target, h, count_of(h) - at_target, at_target);
  }

  // Copies `n` crossings; none if the list they come from is not known yet.
  void copy(Halfedge_index from, std::size_t first, Halfedge_index to, std::size_t place,
            std::size_t n)
  {
    if(m_list[Edge_index(from)].size() == count_of(from))
      for(std::size_t m = 0; m < n; ++m)
        set(to, place + m, (*this)(from, first + m));
  }

  const Triangulation& m_tri;
  std::vector<List> m_list;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_LISTS_H
