// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_REFINEMENT_FOLLOWER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_REFINEMENT_FOLLOWER_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/internal/operations/recorded_changes.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// The barycentric coordinates of a point in a triangle, from its distances to the corners and the
// sides of the triangle that begin there.
inline std::array<double, 3> weights_from_lengths(const std::array<double, 3>& spoke,
                                                  const std::array<double, 3>& side)
{
  std::array<double, 3> area; // opposite to each corner
  for(std::size_t c = 0; c < 3; ++c)
    area[c] = Intrinsic_triangulations::quadrupled_area(spoke[(c + 1) % 3], side[(c + 1) % 3],
                                                        spoke[(c + 2) % 3]);
  const double sum = area[0] + area[1] + area[2];
  if(!(sum > 0)) // all points on a line: any place is correct
    return {1. / 3, 1. / 3, 1. / 3};
  return {area[0] / sum, area[1] / sum, area[2] / sum};
}

// Makes all changes of an intrinsic triangulation on an evolving surface too, and records them. At
// first the triangulation is a level of the surface. Other visitors are called after that.
template <typename Visitor>
class Refinement_follower
{
  typedef Evolving_surface::Triangulation Triangulation;
  typedef std::vector<Halfedge_index> Spokes;

public:
  Refinement_follower(Triangulation& tri, Evolving_surface& evolving, Visitor& visitor)
    : m_tri(tri),
      m_evolving(evolving),
      m_visitor(visitor),
      m_start(surface()),
      m_start_time(history().size())
  {
    attach();
  }

  // ---- The visitor ----

  void after_flip(Halfedge_index h)
  {
    Flip_geometry geometry = flip_geometry(surface().diamond(image(h)));
    geometry.length = length(h);
    flip(image(h), geometry, surface(), history());
    m_visitor.after_flip(h);
  }

  void before_exact_flips()
  {
    start_anew();
    m_visitor.before_exact_flips();
  }

  void before_exact_refinement()
  {
    start_anew();
    m_visitor.before_exact_refinement();
  }

  // A place that is rounded to a vertex is not a new one.
  template <typename Traits>
  void after_insertion(Vertex_index v,
                       const Intrinsic_triangulations::Vertex_inserter<Traits>& inserter)
  {
    if(m_tri.is_inserted(v) && !m_vertex[v].is_valid())
      insert(v);
    m_visitor.after_insertion(v, inserter);
  }

  // boundary vertices stay
  void after_removal(Vertex_index v, Face_index f)
  {
    const Vertex_index w = m_vertex[v];
    CGAL_assertion(!surface().mesh().is_border(w));
    const Halfedge_index a = first_spoke(w, surface().mesh());
    std::array<double, 3> spoke, side;
    Halfedge_index h = a;
    for(std::size_t n = 0; n < 3; ++n) {
      spoke[n] = surface().length(h);
      side[n] = surface().length(surface().mesh().next(h));
      h = next_spoke(h, surface().mesh());
    }
    const auto weight = weights_from_lengths(spoke, side);
    history().add_removal(a, surface().mesh(), weight[0], weight[1]);
    Intrinsic_triangulations::remove_degree_3_vertex(w, surface().mesh());
    m_visitor.after_removal(v, f);
  }

  void after_renumbering() { m_visitor.after_renumbering(); }

  // ---- The result ----

  // Lengths that have been computed from the start are better than those of flips.
  void take_lengths()
  {
    for(Edge_index e : mesh().edges())
      surface().set_length(surface().mesh().edge(m_halfedge[e]), m_tri.length(e));
  }

  Face_index image(Face_index f) const { return surface().mesh().face(image(mesh().halfedge(f))); }

  Vertex_index image(Vertex_index v) const
  {
    return surface().mesh().source(image(first_spoke(v, mesh())));
  }

private:
  const Delta_complex& mesh() const { return m_tri.mesh(); }
  Intrinsic_surface& surface() { return m_evolving.m_surface; }
  const Intrinsic_surface& surface() const { return m_evolving.m_surface; }
  Surface_history& history() { return m_evolving.m_history; }

  double length(Halfedge_index h) const { return m_tri.length(mesh().edge(h)); }

  // the halfedge of the surface
  Halfedge_index image(Halfedge_index h) const
  {
    return Intrinsic_triangulations::directed_as(h, m_halfedge[mesh().edge(h)]);
  }

  void set_image(Halfedge_index h, Halfedge_index on_surface)
  {
    m_halfedge[mesh().edge(h)] = Intrinsic_triangulations::directed_as(h, on_surface);
  }

  // elements of the triangulation have the order of those of the surface
  void attach()
  {
    m_halfedge =
      m_tri.add_property_map<Edge_index, Halfedge_index>("e:on_surface", Halfedge_index());
    m_vertex = m_tri.add_property_map<Vertex_index, Vertex_index>("v:on_surface", Vertex_index());
    auto e = mesh().edges().begin();
    for(Edge_index on_surface : surface().mesh().edges())
      m_halfedge[*e++] = surface().mesh().halfedge(on_surface, 0);
  }

  void start_anew()
  {
    surface() = m_start;
    history().truncate(m_start_time);
    attach();
  }

  void insert(Vertex_index v)
  {
    const Spokes spokes = spokes_at(v);
    if(mesh().is_border(v))
      insert_on_edge(spokes);
    else if(spokes.size() == 3)
      insert_into_face(spokes, first_side(spokes));
    else
      insert_on_inner_edge(spokes, first_side(spokes));
    note_spokes(v, spokes);
  }

  Spokes spokes_at(Vertex_index v) const
  {
    Spokes result;
    for_each_spoke(v, mesh(), [&](Halfedge_index h) { result.push_back(h); });
    return result;
  }

  // the side opposite to the new vertex that follows spoke `n`, on the surface as it was
  Halfedge_index side(const Spokes& spokes, std::size_t n) const
  {
    return image(mesh().next(spokes[n % spokes.size()]));
  }

  // The spoke before the first side of a face of the surface: for three spokes, the first side of
  // all; for four, one that is followed by another in its face.
  std::size_t first_side(const Spokes& spokes) const
  {
    const Delta_complex& before = surface().mesh();
    std::size_t n = 0;
    if(spokes.size() == 3)
      while(side(spokes, n) != before.halfedge(before.face(side(spokes, 0))))
        ++n;
    else
      while(before.next(side(spokes, n)) != side(spokes, n + 1))
        ++n;
    return n;
  }

  void insert_into_face(const Spokes& spokes, std::size_t first)
  {
    std::array<double, 3> spoke, sides;
    for(std::size_t n = 0; n < 3; ++n) {
      spoke[n] = length(spokes[(first + n) % 3]);
      sides[n] = surface().length(side(spokes, first + n));
    }
    internal::insert(surface().mesh().face(side(spokes, 0)), weights_from_lengths(spoke, sides),
                     spoke, surface(), history());
  }

  // Inserts the vertex into a face without area at first: then its edge is flipped.
  void insert_on_inner_edge(const Spokes& spokes, std::size_t first)
  {
    const auto spoke = [&](std::size_t n) { return length(spokes[(first + n) % 4]); };
    const Halfedge_index start = side(spokes, first),
                         edge = surface().mesh().next(side(spokes, first + 1));
    const double t = spoke(2) / (spoke(0) + spoke(2));
    const std::size_t c = Intrinsic_triangulations::side_number(start, surface().mesh());
    std::array<double, 3> weight, new_length;
    for(std::size_t n = 0; n < 3; ++n) {
      weight[(c + n) % 3] = n == 0 ? t : n == 1 ? 0 : 1 - t;
      new_length[(c + n) % 3] = spoke(n);
    }
    internal::insert(surface().mesh().face(start), weight, new_length, surface(), history());
    flip(edge, {spoke(3), t, 1}, surface(), history());
  }

  void insert_on_edge(const Spokes& spokes)
  {
    const std::array<double, 3> spoke{length(spokes[0]), length(spokes[2]), length(spokes[1])};
    insert_on_border(surface().mesh().next(side(spokes, 1)), spoke[1] / (spoke[0] + spoke[1]),
                     spoke, surface(), history());
  }

  // the spokes of the new vertex on the surface, which has them now
  void note_spokes(Vertex_index v, const Spokes& spokes)
  {
    const Delta_complex& after = surface().mesh();
    Halfedge_index h = after.prev(side(spokes, 0));
    m_vertex[v] = after.source(h);
    for(Halfedge_index spoke : spokes) {
      set_image(spoke, h);
      surface().constrain(after.edge(h), m_tri.is_constrained(mesh().edge(spoke)));
      if(!after.is_border(h))
        h = next_spoke(h, after);
    }
  }

  Triangulation& m_tri;
  Evolving_surface& m_evolving;
  Visitor& m_visitor;
  Intrinsic_surface m_start;
  Surface_history::Time m_start_time;
  Delta_complex::Property_map<Edge_index, Halfedge_index> m_halfedge; // of the first halfedges
  Delta_complex::Property_map<Vertex_index, Vertex_index> m_vertex;   // of inserted vertices
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_REFINEMENT_FOLLOWER_H
