// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_EDGE_COURSES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_EDGE_COURSES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_course.h>
#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Numbers the crossings on all edges of T2.
template <typename Integer>
Edge_marks number_crossings(const Integer_coordinates<Integer>& coordinates,
                            const Delta_complex& mesh, Concurrency concurrency)
{
  std::vector<Delta_complex::size_type> count(mesh.num_edges(), 0);
  for_each_in_chunks<Edge_index>(concurrency, mesh, [&](Edge_index e) {
    count[e.idx()] = countable(coordinates.crossings(first_halfedge(e)));
  });
  return Edge_marks(std::move(count));
}

// Stores the courses of all halfedges of T2, or computes them when they are read, from the integer
// coordinates alone. To compute a course, each crossing is followed to an end of its edge of T1.
// Once this has taken more steps than the number of crossings, all courses are stored. Crossings of
// flipped edges count again, because each flip would have updated a course. Following takes
// quadratic time if edges of T1 cross a large part of T2.
//
// Objects that compute courses must not be read by several threads at once.
template <typename Traits>
class Edge_courses
{
  typedef Triangulation_pair<Traits> Pair;
  typedef typename Pair::Coordinates Coordinates;
  typedef typename Pair::Integer Integer;
  typedef Delta_complex::size_type size_type;
  typedef Edge_course::Exits Exits;

public:
  // Constructs an object that computes courses when they are read.
  explicit Edge_courses(const Pair& pair)
    : m_pair(&pair), m_most_steps(static_cast<double>(pair.mesh().num_edges()))
  {}

  // Stores all courses. Complexity: linear in the edges and crossings.
  Edge_courses(const Pair& pair, Concurrency concurrency) : m_pair(&pair) { store(concurrency); }

  // Allocates courses at the indices `marks`, which must be set before they are read.
  Edge_courses(const Pair& pair, const Edge_marks& marks) : m_pair(&pair) { allocate(marks); }

  size_type count(Halfedge_index h) const { return m_pair->number_of_crossings(h); }

  Edge_course operator()(Halfedge_index h) const
  {
    const std::size_t n = count(h);
    if(!m_is_stored && static_cast<double>(m_steps) > m_most_steps)
      store_if_faster();
    return m_is_stored ? stored(h, n) : Edge_course(n, [&](Exits& exits) { compute(h, exits); });
  }

  // Returns the exit with this index, for the first halfedge of its edge.
  Halfedge_index exit(size_type mark) const { return m_exits[mark]; }

  // Sets the exit with this index, which belongs to the course of `h`.
  void set(size_type mark, Halfedge_index h, Halfedge_index exit)
  {
    m_exits[mark] = oriented_like(h, exit);
  }

  // ---- Changes of T2 ----

  // Updates the courses after the edge of `h` has been flipped.
  void after_flip(Halfedge_index h)
  {
    if(m_is_stored)
      update(Edge_index(h));
    else
      m_most_steps += static_cast<double>(count(h));
  }

  // Discards stored courses, so that flips take constant time.
  void discard()
  {
    m_is_stored = false;
    m_exits = {};
  }

  // Stores the position of the course of an edge.
  struct Storage
  {
    std::size_t layout; // all courses have moved where this has changed
    size_type first;
    std::size_t size; // of all courses
  };

  Storage storage(Edge_index e) const
  {
    return {m_layout, m_is_stored ? m_first[e] : unknown, m_exits.size()};
  }

  // Updates the courses after the last flip, of the edge `e`, has been undone. Before the flip, the
  // course of `e` was stored at `before`, and its exits have not been overwritten.
  void after_undo(Edge_index e, const Storage& before)
  {
    if(m_is_stored && before.layout != m_layout)
      update(e);
    else if(m_is_stored) {
      m_first[e] = before.first;
      m_exits.resize(before.size);
    }
  }

  // Updates the courses after the vertex `m` has been inserted into a face.
  void after_insertion(Vertex_index m)
  {
    const Delta_complex& mesh = m_pair->mesh();
    const Halfedge_index a = first_outgoing_halfedge(m, mesh), b = next_around_source(a, mesh);
    after_cut({a, b, next_around_source(b, mesh)});
  }

  // Updates the courses after a vertex has been inserted into an edge, whose second part is `h`.
  void after_split(Halfedge_index h)
  {
    const Delta_complex& mesh = m_pair->mesh();
    const Halfedge_index o = mesh.opposite(h), im = first_part(h, mesh);
    split(im, h);
    if(!mesh.is_border(im) && !mesh.is_border(o))
      after_cut({mesh.next(im), mesh.next(o)});
    else
      after_cut({mesh.next(mesh.is_border(o) ? im : o)});
  }

private:
  static constexpr size_type unknown = (std::numeric_limits<size_type>::max)();

  const Coordinates& coordinates() const { return m_pair->coordinates(); }

  // Stores the courses of new edges, in a face from which edges were removed or beside an edge that
  // was split.
  void after_cut(std::initializer_list<Halfedge_index> cuts)
  {
    m_first.resize(m_pair->mesh().num_edges(), unknown);
    for(Halfedge_index h : cuts)
      m_first[Edge_index(h)] = unknown;
    for(Halfedge_index h : cuts)
      update(Edge_index(h));
  }

  // Splits the course of an edge into the courses of `im` and `mj`. The halfedge `mj` has the index
  // of the whole edge. If the new vertex lies on an edge of T1, one crossing is removed.
  void split(Halfedge_index im, Halfedge_index mj)
  {
    m_first.resize(m_pair->mesh().num_edges(), unknown);
    const std::size_t first = count(im), second = count(mj);
    if(first + second == 0)
      return;
    const bool is_at_crossing = on_edge(m_pair->inserted_vertex(m_pair->mesh().source(mj)));
    const std::size_t n = first + second + is_at_crossing;
    const Edge_course whole = stored(mj, n);
    Exits of_im(first), of_mj(second);
    for(std::size_t m = 0; m < first; ++m)
      set(of_im, im, m, whole[m]);
    for(std::size_t m = 0; m < second; ++m)
      set(of_mj, mj, m, whole[n - second + m]);
    for(const auto& [h, exits] : {std::pair(im, &of_im), std::pair(mj, &of_mj)}) {
      append(Edge_index(h), exits->size());
      std::copy(exits->begin(), exits->end(), m_exits.end() - std::ptrdiff_t(exits->size()));
    }
  }

  Edge_course stored(Halfedge_index h, std::size_t n) const
  {
    const Halfedge_index* first = n == 0 ? nullptr : m_exits.data() + m_first[Edge_index(h)];
    return Edge_course(first, n, n > 0 && !is_first_halfedge(h));
  }

  void compute(Halfedge_index h, Exits& exits) const
  {
    for(std::size_t m = 0; m < exits.size(); ++m) {
      typename Coordinates::Crossing c{h, Integer(m)};
      do
        ++m_steps;
      while(coordinates().advance(c, m_pair->mesh()) != Coordinates::Turn::ends);
      exits[m] = coordinates().outgoing_at_end(c, m_pair->mesh(), m_pair->outgoing_halfedges());
    }
  }

  // ---- Storage ----

  void allocate(const Edge_marks& marks) const
  {
    const std::size_t edges = m_pair->mesh().num_edges();
    m_first.resize(edges);
    for(std::size_t e = 0; e < edges; ++e)
      m_first[e] = marks.before(Edge_index(static_cast<size_type>(e)));
    m_exits.resize(marks.size());
    m_most_exits = 2 * m_exits.size() + 16 * edges;
    m_is_stored = true;
    ++m_layout;
  }

  void store(Concurrency concurrency) const
  {
    const Delta_complex& mesh = m_pair->mesh();
    allocate(number_crossings(coordinates(), mesh, concurrency));
    for_each_in_chunks<Edge_index>(concurrency, mesh, [&](Edge_index e) {
      const Halfedge_index h = first_halfedge(e), o = opposite(h);
      const size_type n = count(h);
      if(n == 1 && coordinates().curves_leaving(h, mesh) == 1 &&
         coordinates().curves_leaving(o, mesh) == 1) {
        // This curve crosses no other edge, so either end is possible.
        m_exits[m_first[e]] = opposite(coordinates().outgoing_in_corner(
          mesh.prev(h), Integer(0), mesh, m_pair->outgoing_halfedges()));
      } else if(n > 0)
        for(Halfedge_index side : {h, o})
          store_curves(mesh.prev(side));
    });
  }

  // The test visits all edges, so the next one follows after twice as many steps.
  void store_if_faster() const
  {
    double crossings = 0;
    for(Edge_index e : m_pair->mesh().edges())
      crossings += static_cast<double>(coordinates().crossings(first_halfedge(e)));
    const double steps = static_cast<double>(m_steps);
    if(steps > crossings)
      store(Concurrency());
    m_most_steps = (std::max)(crossings, 2 * steps);
  }

  // Stores the crossings of curves that start inside the corner at the source of `outgoing`, each
  // from one end.
  void store_curves(Halfedge_index outgoing) const
  {
    const Delta_complex& mesh = m_pair->mesh();
    coordinates().for_each_curve_end(
      outgoing, mesh, m_pair->outgoing_halfedges(), [&](const Integer& k, Halfedge_index start) {
        if(!is_first_halfedge(start))
          return;
        auto c = coordinates().first_crossing(outgoing, k, mesh);
        do {
          const Halfedge_index h = c.halfedge;
          const auto m = along_first_halfedge(h, static_cast<size_type>(c.number), count(h));
          m_exits[m_first[Edge_index(h)] + m] = oriented_like(h, opposite(start));
        } while(coordinates().advance(c, mesh) != Coordinates::Turn::ends);
      });
  }

  // ---- Updates ----

  // Sets exit `m` of the course of `h`, stored for the first halfedge of its edge.
  static void set(Exits& exits, Halfedge_index h, std::size_t m, Halfedge_index exit)
  {
    const auto n = static_cast<size_type>(exits.size());
    exits[along_first_halfedge(h, static_cast<size_type>(m), n)] = oriented_like(h, exit);
  }

  // Recomputes the course of an edge from the courses around it.
  void update(Edge_index e)
  {
    const Halfedge_index h = first_halfedge(e);
    if(const size_type n = count(h); n > 0) {
      append(e, n);
      copy_from_beyond(h);
      copy_from_beyond(opposite(h));
    }
  }

  // Copies parts of the courses of the other two sides of the face of `h`. Curves that cut off the
  // corner at the source or target of `h` cross the side at this corner; the others end. A side
  // without a known course is skipped: its curves cross the face of `h`, too.
  void copy_from_beyond(Halfedge_index h)
  {
    const Delta_complex& mesh = m_pair->mesh();
    const Halfedge_index ji = mesh.opposite(h), il = mesh.next(ji), lj = mesh.prev(ji);
    const auto at_source = static_cast<std::size_t>(coordinates().curves_around(lj, mesh)),
               at_target = static_cast<std::size_t>(coordinates().curves_around(il, mesh));
    const std::size_t n = count(h);
    copy_part(il, 0, h, 0, at_source);
    copy_part(lj, count(lj) - at_target, h, n - at_target, at_target);
    for(std::size_t m = at_source; m < n - at_target; ++m)
      *part(h, m, 1) =
        oriented_like(h, coordinates().outgoing_in_corner(lj, Integer(n - at_target - 1 - m), mesh,
                                                          m_pair->outgoing_halfedges()));
  }

  // Returns the memory of `k` exits of the course of `h`, from exit `m` on.
  Halfedge_index* part(Halfedge_index h, std::size_t m, std::size_t k)
  {
    return m_exits.data() + m_first[Edge_index(h)] + (is_first_halfedge(h) ? m : count(h) - m - k);
  }

  // Copies `k` exits, unless the course of `from` is unknown.
  void copy_part(Halfedge_index from, std::size_t first, Halfedge_index h, std::size_t to,
                 std::size_t k)
  {
    if(k == 0 || m_first[Edge_index(from)] == unknown)
      return;
    const Halfedge_index* const begin = part(from, first, k);
    Halfedge_index* const result = part(h, to, k);
    if(is_first_halfedge(from) == is_first_halfedge(h))
      std::copy_n(begin, k, result);
    else
      for(std::size_t m = 0; m < k; ++m)
        result[m] = opposite(begin[k - 1 - m]);
  }

  // Allocates `n` exits for the first halfedge of an edge.
  void append(Edge_index e, std::size_t n)
  {
    m_first[e] = unknown;
    if(m_exits.size() + n > m_most_exits)
      compact();
    m_first[e] = countable(m_exits.size());
    m_exits.resize(m_exits.size() + n);
  }

  // Removes the exits that belong to no edge.
  void compact()
  {
    std::vector<Halfedge_index> exits;
    for(Edge_index e : m_pair->mesh().edges()) {
      const size_type n = count(first_halfedge(e)), old = std::exchange(m_first[e], unknown);
      if(n == 0 || old == unknown)
        continue;
      m_first[e] = countable(exits.size());
      exits.insert(exits.end(), m_exits.begin() + old, m_exits.begin() + old + n);
    }
    m_exits = std::move(exits);
    m_most_exits = 2 * m_exits.size() + 16 * m_first.size();
    ++m_layout;
  }

  const Pair* m_pair;
  mutable bool m_is_stored = false;
  mutable std::size_t m_steps = 0; // the steps taken to follow crossings
  mutable double m_most_steps = 0; // after which storing may be faster
  mutable std::size_t m_most_exits = 0;
  mutable std::size_t m_layout = 0;
  mutable std::vector<size_type> m_first;      // the exits of each edge, or unknown
  mutable std::vector<Halfedge_index> m_exits; // of first halfedges
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_EDGE_COURSES_H
