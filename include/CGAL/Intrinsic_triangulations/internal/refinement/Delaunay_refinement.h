// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_DELAUNAY_REFINEMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_DELAUNAY_REFINEMENT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Dijkstra_search.h>
#include <CGAL/Intrinsic_triangulations/Edge_stack.h>
#include <CGAL/Intrinsic_triangulations/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/refinement/Circumcenter_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/refinement/Refinement_queue.h>
#include <CGAL/Intrinsic_triangulations/internal/refinement/Small_angle_vertices.h>
#include <CGAL/Intrinsic_triangulations/internal/refinement/Vertex_surroundings.h>
#include <CGAL/Intrinsic_triangulations/internal/refinement/superfluous_sides.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

struct Refinement_limits
{
  std::size_t insertions;
  std::size_t flips; // before the first insertion, and after each
};

// Implements Chew's second algorithm on a surface (Algorithm 5). It inserts the circumcenter of a
// bad face. If a boundary or constrained edge hides the circumcenter, it splits the edge and
// removes circumcenters near by.
//
// `Bounds` has the members is_too_thin(f), is_too_large(f) and is_not_simplicial(f). Only faces
// that are too thin can be excused. The visitor is notified of every change.
template <typename Traits, typename Bounds, typename Visitor>
class Delaunay_refinement
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;
  typedef typename Triangulation::Edge_length_map Edge_length_map;
  typedef Circumcenter_walk<Edge_length_map> Walk;
  typedef Refinement_queue::Candidate Candidate;

public:
  Delaunay_refinement(Triangulation& tri, const Bounds& bounds, const Refinement_limits& limits,
                      Visitor& visitor, bool is_exact)
    : m_tri(tri),
      m_mesh(tri.mesh()),
      m_bounds(bounds),
      m_limits(limits),
      m_visitor(visitor),
      m_inserter(tri, is_exact),
      m_small_angle_vertices(tri, bounds.small_angle(), is_exact),
      m_walk(tri.intrinsic()),
      m_search(m_mesh.num_vertices()),
      m_stack(m_mesh.num_edges())
  {}

  // Refines until the queue is empty. Every candidate leads to an insertion, whose number is
  // limited, or changes nothing and is dropped. Returns whether all decisions are certain. With
  // `stops_if_filter_fails`, it ends at the first uncertain decision.
  bool run(bool stops_if_filter_fails, Refinement_result& result)
  {
    m_result = &result;
    m_stops_if_filter_fails = stops_if_filter_fails;
    for(Face_index f : m_mesh.faces())
      push_if_bad(f);
    while(!m_queue.empty() && !is_stopped()) {
      const Candidate c = m_queue.pop();
      if(!is_current(c))
        continue;
      if(result.insertions == m_limits.insertions) {
        result.status = Refinement_status::insertion_limit;
        break;
      }
      refine(c);
    }
    return !m_has_filter_failed;
  }

private:
  // Returns a side of `f` whose split makes the triangulation simplicial, or null.
  Halfedge_index side_to_split(Face_index f) const
  {
    return m_bounds.is_not_simplicial(f) ? superfluous_side(f, m_tri) : Halfedge_index();
  }

  bool is_fixed(Halfedge_index h) const
  {
    return m_mesh.is_border(m_mesh.opposite(h)) || m_tri.is_constrained(m_mesh.edge(h));
  }

  // Returns what `f` returns for the layout of faces of T2.
  template <typename Function>
  auto with_layout(const Function& f) const
  {
    const auto surface = m_tri.intrinsic();
    if constexpr(has_exact_decisions<Traits>())
      if(m_inserter.is_exact())
        return f(Layout_by_decisions(m_inserter.exact().decisions(), surface));
    return f(Layout_by_lengths(surface));
  }

  bool has_bad_shape(Face_index f) const
  {
    const auto courses = [this]() -> const auto& { return m_inserter.courses(); };
    return m_bounds.is_too_large(f) ||
           (m_bounds.is_too_thin(f) && !m_small_angle_vertices.excuse(f, courses));
  }

  void push_if_bad(Face_index f)
  {
    if(has_bad_shape(f))
      m_queue.push_bad_shape(
        f, version(f), with_layout([f](const auto& layout) { return layout.circumradius(f); }));
    else if(side_to_split(f).is_valid())
      m_queue.push_other(f, version(f));
  }

  // Returns the number of changes of a face.
  std::size_t& version(Face_index f)
  {
    if(f.idx() >= m_version.size())
      m_version.resize(m_mesh.num_faces());
    return m_version[f.idx()];
  }

  bool is_current(const Candidate& c)
  {
    return !m_mesh.is_removed(c.face) && version(c.face) == c.version &&
           (c.has_bad_shape ? has_bad_shape(c.face) : side_to_split(c.face).is_valid());
  }

  void fail() { m_has_filter_failed = true; }
  bool is_stopped() const { return m_has_filter_failed && m_stops_if_filter_fails; }

  // Inserts a vertex to improve a face. The face is unchanged if rounded numbers leave no room for
  // the new vertex. Exceptions of the visitor are passed to the caller.
  void refine(const Candidate& c)
  {
    try {
      c.has_bad_shape ? insert_circumcenter(c.face) : make_simplicial(c.face);
    } catch(const Numerical_error&) {
      if(m_is_visited)
        throw;
      fail();
    }
  }

  template <typename Call>
  void visit(const Call& call)
  {
    m_is_visited = true;
    call();
    m_is_visited = false;
  }

  // ---- Simplicial triangulations ----

  // Surrounds a corner that has too few neighbors, or else splits a side. The parts of a Delaunay
  // edge are Delaunay, and keep edges of other vertices from running around the surface beside it.
  void make_simplicial(Face_index f)
  {
    for(Halfedge_index h : sides(f, m_mesh)) {
      const Vertex_index v = m_mesh.source(h);
      if(!m_mesh.is_border(v) && with_surroundings(v, [](const auto& surroundings) {
           return surroundings.is_pointed_without_neighbors();
         }))
        return surround(v);
    }
    if(!split_at_middle(side_to_split(f), f).is_valid())
      fail();
  }

  // Returns what `f` returns for the surroundings of `v`.
  template <typename Function>
  auto with_surroundings(Vertex_index v, const Function& f) const
  {
    return with_layout([&](const auto& layout) {
      return f(Vertex_surroundings<Edge_length_map, std::decay_t<decltype(layout)>>(
        v, m_tri.intrinsic(), layout));
    });
  }

  // Inserts three vertices around `v`, at angles of a third of its angle sum, nearer than all other
  // vertices. So they are and remain its neighbors. An edge that cannot be crossed is split instead
  // if it is as near.
  void surround(Vertex_index v)
  {
    const FT distance =
      with_surroundings(v,
                        [](const auto& surroundings) { return surroundings.shortest_outgoing(); }) /
      2;
    Halfedge_index outgoing = first_outgoing_halfedge(v, m_mesh);
    for(FT part : {FT(1) / 6, FT(1) / 3, FT(1) / 3}) {
      if(m_result->insertions == m_limits.insertions)
        return;
      const typename Walk::End end = walk_at_angle(outgoing, part, distance);
      if(end == Walk::End::blocked &&
         split_at_middle(m_walk.halfedge(), m_mesh.face(outgoing)).is_valid())
        return;
      outgoing = end == Walk::End::blocked || end == Walk::End::lost ? Halfedge_index()
                                                                     : insert_neighbor(v, end);
      if(!outgoing.is_valid())
        return fail();
    }
  }

  // Inserts a vertex where the walk from `v` has ended. Returns the halfedge to it, or null if
  // rounding has moved the point to a vertex, or hides it from `v`, its nearest neighbor.
  Halfedge_index insert_neighbor(Vertex_index v, typename Walk::End end)
  {
    const std::size_t before = m_mesh.number_of_vertices();
    const Vertex_index m =
      m_inserter.insert(end == Walk::End::on_edge ? m_walk.location_on_edge() : m_walk.location());
    if(m_mesh.number_of_vertices() == before)
      return {};
    add_vertex(m);
    m_is_free[m.idx()] = false;
    return with_surroundings(v,
                             [m](const auto& surroundings) { return surroundings.outgoing_to(m); });
  }

  // Walks over this distance from the source of `outgoing`. The direction is this part of the angle
  // around the vertex, see `Vertex_surroundings::direction()`.
  typename Walk::End walk_at_angle(Halfedge_index outgoing, const FT& part, const FT& distance)
  {
    const auto is_fixed = [this](Halfedge_index h) { return this->is_fixed(h); };
    const auto direction =
      with_surroundings(m_mesh.source(outgoing), [&](const auto& surroundings) {
        return surroundings.direction(outgoing, part);
      });
    return with_layout([&](const auto& layout) {
      return m_walk.walk(direction.first, std::polar(distance, direction.second), is_fixed, layout);
    });
  }

  // Splits the edge of `h` if this is possible, and tests `f` again. Returns the new vertex, or
  // null.
  Vertex_index split_at_middle(Halfedge_index h, Face_index f)
  {
    if(!m_inserter.can_be_split(h))
      return {};
    const Vertex_index m = m_inserter.split_edge(h, FT(1) / 2);
    m_changed.push_back(f);
    add_vertex(m);
    m_is_free[m.idx()] = false;
    return m;
  }

  void insert_circumcenter(Face_index f)
  {
    const auto is_fixed = [this](Halfedge_index h) { return this->is_fixed(h); };
    switch(with_layout([&](const auto& layout) { return m_walk.walk(f, is_fixed, layout); })) {
      case Walk::End::inside: return insert_at_center(f);
      case Walk::End::on_edge:
        if(m_inserter.is_exact() && !m_tri.coordinates().is_shared(m_mesh.edge(m_walk.halfedge())))
          return insert_at_center(f);
        return split(m_walk.halfedge(), m_walk.along(), f);
      case Walk::End::blocked: return split_fixed(m_walk.halfedge(), f);
      case Walk::End::lost: fail();
    }
  }

  void insert_at_center(Face_index f)
  {
    add_center(m_inserter.insert(m_walk.location(), m_walk.closeness()), f);
  }

  // Adds a vertex in the circumcircle of `f`. The face remains only if rounding has misplaced the
  // vertex, or makes a face appear Delaunay that is not.
  void add_center(Vertex_index m, Face_index f)
  {
    const std::size_t before = version(f);
    add_vertex(m);
    m_has_filter_failed = m_has_filter_failed || version(f) == before;
  }

  void split(Halfedge_index h, const FT& t, Face_index f)
  {
    const FT& closeness = m_walk.closeness();
    add_center(m_inserter.can_be_split(h) ? m_inserter.split_edge(h, t, closeness)
                                          : m_inserter.insert(m_walk.location_on_edge(), closeness),
               f);
  }

  // Splits the edge that hides the circumcenter of `f`. This need not change `f`, but `f` will be
  // processed again. The circle is empty, so a short edge beyond other faces is no chord that hides
  // the center. Rounded lengths would split this edge and its neighbors endlessly.
  void split_fixed(Halfedge_index h, Face_index f)
  {
    const FT radius = m_tri.length(m_mesh.edge(h));
    const bool is_too_short =
      !m_inserter.is_exact() && m_mesh.face(h) != f && radius <= m_walk.closeness();
    const Vertex_index m = is_too_short ? Vertex_index() : split_at_middle(h, f);
    if(!m.is_valid())
      return fail();
    if(!is_stopped())
      remove_free_vertices(m, radius);
  }

  void add_vertex(Vertex_index m)
  {
    ++m_result->insertions;
    visit([&] { m_visitor.after_insertion(m, m_inserter); });
    m_is_free.resize((std::max)(m_is_free.size(), std::size_t(m.idx()) + 1), false);
    m_is_free[m.idx()] = can_be_free(m);
    for_each_outgoing_halfedge(m, m_mesh, [this](Halfedge_index h) {
      if(!m_mesh.is_border(h))
        note_change(m_mesh.face(h));
    });
    restore_Delaunay();
  }

  // Returns whether `v` may be removed. Rounding can move a circumcenter to a vertex of the input,
  // or to a fixed edge. Such vertices are kept.
  bool can_be_free(Vertex_index v) const
  {
    bool result = m_tri.is_inserted(v);
    for_each_outgoing_halfedge(v, m_mesh,
                               [&](Halfedge_index h) { result = result && !is_fixed(h); });
    return result;
  }

  // Returns the vertices whose distance from `center` along edges is at most `radius`, the closest
  // ones first.
  std::vector<Vertex_index> ball(Vertex_index center, const FT& radius)
  {
    std::vector<Vertex_index> result;
    m_search.resize(m_mesh.num_vertices());
    m_search.restart();
    m_search.reach(center, FT(0));
    for(Vertex_index v = m_search.next(); v.is_valid(); v = m_search.next()) {
      result.push_back(v);
      for_each_outgoing_halfedge(v, m_mesh, [&, distance = m_search.distance(v)](Halfedge_index h) {
        if(const FT reached = distance + m_tri.length(Edge_index(h)); reached <= radius)
          m_search.reach(m_mesh.target(h), reached, h);
      });
    }
    return result;
  }

  // Removes free vertices. Vertices within the ball of half the length are within the ball along
  // edges of the whole length.
  void remove_free_vertices(Vertex_index m, const FT& radius)
  {
    const auto after_flip = [this](Halfedge_index h) { note_flip(h); };
    for(Vertex_index v : ball(m, radius))
      if(v.idx() < m_is_free.size() && m_is_free[v.idx()]) {
        const Face_index f = m_inserter.remove(v, after_flip);
        if(f.is_valid()) {
          note_change(f);
          m_is_free[v.idx()] = false;
          ++m_result->removals;
          visit([&] { m_visitor.after_removal(v, f); });
        }
      }
    restore_Delaunay();
  }

  void note_change(Face_index f)
  {
    m_changed.push_back(f);
    ++version(f);
    for(Halfedge_index h : sides(f, m_mesh))
      m_stack.push(m_mesh.edge(h));
  }

  void note_flip(Halfedge_index h)
  {
    visit([&] { m_visitor.after_flip(h); });
    note_change(m_mesh.face(h));
    note_change(m_mesh.face(m_mesh.opposite(h)));
  }

  // Flips edges until all are Delaunay. Rounded lengths could lead to endless flips, so their
  // number is limited to a thousand flips per edge. This exceeds the flips that some vertices make
  // necessary.
  void restore_Delaunay()
  {
    const std::size_t before = m_result->flips;
    const std::size_t limit = (std::min)(m_limits.flips, std::size_t(1000) * m_mesh.num_edges());
    while(!m_stack.empty()) {
      const Edge_index e = m_stack.pop();
      if(m_mesh.is_removed(e) || m_inserter.is_Delaunay(e))
        continue;
      if(m_result->flips - before == limit) {
        fail();
        if(is_stopped())
          return;
        throw Flip_limit_exceeded(
          "not Delaunay after an insertion and as many flips as are allowed");
      }
      const Halfedge_index h = m_mesh.halfedge(e);
      m_inserter.flip(h);
      ++m_result->flips;
      note_flip(h);
    }
    push_changed();
  }

  // Pushes each changed face once, because most faces have been changed more than once.
  void push_changed()
  {
    std::sort(m_changed.begin(), m_changed.end());
    m_changed.erase(std::unique(m_changed.begin(), m_changed.end()), m_changed.end());
    for(Face_index f : m_changed)
      if(!m_mesh.is_removed(f))
        push_if_bad(f);
    m_changed.clear();
  }

  Triangulation& m_tri;
  const Delta_complex& m_mesh;
  const Bounds& m_bounds;
  Refinement_limits m_limits;
  Visitor& m_visitor;
  bool m_is_visited = false; // while the visitor is called
  bool m_stops_if_filter_fails = false;
  bool m_has_filter_failed = false;
  Vertex_inserter<Traits> m_inserter;
  Small_angle_vertices<Traits> m_small_angle_vertices;
  Walk m_walk;
  Dijkstra_search<Vertex_index, FT> m_search;
  Refinement_result* m_result = nullptr;
  Refinement_queue m_queue;
  Edge_stack m_stack;
  std::vector<Face_index> m_changed;
  std::vector<std::size_t> m_version;
  std::vector<char> m_is_free; // vertices that may be removed
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_DELAUNAY_REFINEMENT_H
