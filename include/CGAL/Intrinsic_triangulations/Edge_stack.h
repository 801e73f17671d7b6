// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EDGE_STACK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EDGE_STACK_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <boost/container/vector.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// a stack of edges that are still to be examined, without duplicates.
class Edge_stack
{
public:
  /// prepares for edges with indices less than `number_of_edges`.
  explicit Edge_stack(std::size_t number_of_edges)
    : m_edges(number_of_edges + 1, boost::container::default_init), m_waits(number_of_edges, 0)
  {}

  /// returns whether no edge waits.
  bool empty() const { return m_size == 0; }

  /// adds `e` unless it waits already.
  void push(Edge_index e)
  {
    if(e.idx() >= m_waits.size()) {
      m_waits.resize(e.idx() + 1, 0);
      m_edges.resize(m_waits.size() + 1, boost::container::default_init);
    }
    push_if(true, e);
  }

  /// adds `e` if `is_wanted`, unless it waits already. There is no branch, since `is_wanted` is
  /// unpredictable, and mispredictions would take most of the time.
  /// \pre `e` is one of the edges that existed at the start
  void push_if(bool is_wanted, Edge_index e)
  {
    const bool is_pushed = is_wanted & !m_waits[e.idx()];
    m_edges[m_size] = e.idx();
    m_size += is_pushed;
    m_waits[e.idx()] |= is_pushed;
  }

  /// removes the edge that was added last, and returns it.
  Edge_index pop()
  {
    const Edge_index e(m_edges[--m_size]);
    m_waits[e.idx()] = false;
    return e;
  }

private:
  boost::container::vector<Delta_complex::size_type> m_edges; // one more than there can be
  std::vector<unsigned char> m_waits;
  std::size_t m_size = 0;
};

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// returns the four other edges of the two faces at `h`.
inline std::array<Edge_index, 4> edges_around(Halfedge_index h, const Delta_complex& mesh)
{
  const Halfedge_index o = opposite(h);
  return {mesh.edge(mesh.next(h)), mesh.edge(mesh.prev(h)), mesh.edge(mesh.next(o)),
          mesh.edge(mesh.prev(o))};
}

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// returns more flips than real data need: a thousand for each edge, plus a hundred million. The
/// constant allows small triangulations that are sheared far: a ring of \f$n\f$ vertices takes
/// \f$n^2\f$ flips for each turn.
inline std::size_t default_flip_limit(std::size_t number_of_edges)
{
  return 100000000 + 1000 * number_of_edges;
}

namespace internal {

inline void check_flip_limit(bool is_exceeded)
{
  if(is_exceeded)
    throw Flip_limit_exceeded("not Delaunay after as many flips as are allowed");
}

// Stores the result of a run of flips. It ends at its limit, at a failure of the filter, or when
// all edges are Delaunay.
struct Flipping_result
{
  enum class End
  {
    Delaunay,
    limit,
    doubt
  };

  std::size_t flips = 0;
  End end = End::Delaunay;
  bool is_exact = false; // whether lengths of type `double` did not suffice

  bool is_Delaunay() const { return end == End::Delaunay; }

  // Adds a run that follows this one.
  Flipping_result& operator+=(const Flipping_result& next)
  {
    return *this = {flips + next.flips, next.end, is_exact || next.is_exact};
  }
};

// Flips edges until none waits. It starts with edges that wait in `stack`, and continues with edges
// around flipped ones. An edge is not flipped if `is_good(e)`. It need not wait if `is_certain(e)`,
// which should be branch-free. `flip(h)` returns whether the edge of `h` could be flipped.
template <typename Is_certain, typename Is_good, typename Flip>
Flipping_result flip_within_limit(const Delta_complex& mesh, Edge_stack& stack, std::size_t limit,
                                  const Is_certain& is_certain, const Is_good& is_good,
                                  const Flip& flip)
{
  std::size_t flips = 0;
  while(!stack.empty()) {
    const Edge_index e = stack.pop();
    if(is_good(e))
      continue;
    const Halfedge_index h = mesh.halfedge(e);
    if(flips == limit)
      return {flips, Flipping_result::End::limit};
    if(!flip(h))
      return {flips, Flipping_result::End::doubt};
    ++flips;
    for(Edge_index side : edges_around(h, mesh))
      stack.push_if(!is_certain(side), side);
  }
  return {flips};
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// checks a number of flips.
/// \throws Flip_limit_exceeded if no further flip is allowed
inline void check_flip_limit(std::size_t flips, std::size_t number_of_edges)
{
  internal::check_flip_limit(flips >= default_flip_limit(number_of_edges));
}

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// flips edges until `is_good(h)` holds for all that can be flipped. It starts with edges that
/// wait in `stack`, and continues with edges around flipped ones. `flip(h)` must turn the edge of
/// `h`.
/// \throws Flip_limit_exceeded if more than `limit` flips are needed
template <typename Is_good, typename Flip>
void flip_waiting(const Delta_complex& mesh, Edge_stack& stack, const Is_good& is_good,
                  const Flip& flip, std::size_t limit)
{
  const auto never = [](Edge_index) { return false; };
  const auto stays = [&](Edge_index e) {
    const Halfedge_index h = mesh.halfedge(e);
    return is_good(h) || flip_status(h, mesh) != Operation_status::possible;
  };
  const auto flipped = [&](Halfedge_index h) { return flip(h), true; };
  const auto result = internal::flip_within_limit(mesh, stack, limit, never, stays, flipped);
  internal::check_flip_limit(!result.is_Delaunay());
}

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// flips edges until `is_good(h)` holds for all that can be flipped, with at most
/// `default_flip_limit()` flips.
template <typename Is_good, typename Flip>
void flip_waiting(const Delta_complex& mesh, Edge_stack& stack, const Is_good& is_good,
                  const Flip& flip)
{
  flip_waiting(mesh, stack, is_good, flip, default_flip_limit(mesh.num_edges()));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EDGE_STACK_H
