// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_REFINE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_REFINE_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/internal/operations/recorded_changes.h>
#include <CGAL/Intrinsic_simplification/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/assertions.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Returns the position of the foot of a point on a side, from 0 to 1, from the distances of the
// point to both ends.
inline double foot_on_side(double side, double to_first, double to_second)
{
  const double foot = Intrinsic_triangulations::scaled_foot(to_second, to_first);
  return std::clamp(0.5 + foot / (2 * side * side), 0., 1.);
}

// Returns the barycentric coordinates of a point in a triangle, from its distances to the corners
// and to the sides that begin at them. They are quotients of areas. On thin triangles, areas do not
// determine the position along the longest side; then the foot of the point determines it.
inline std::array<double, 3> weights_from_lengths(const std::array<double, 3>& outgoing_length,
                                                  const std::array<double, 3>& side)
{
  std::array<double, 3> weight; // at first the areas opposite to each corner
  for(std::size_t c = 0; c < 3; ++c)
    weight[c] = Intrinsic_triangulations::quadrupled_area(
      outgoing_length[(c + 1) % 3], side[(c + 1) % 3], outgoing_length[(c + 2) % 3]);
  const double sum = weight[0] + weight[1] + weight[2];
  for(double& w : weight)
    w = sum > 0 ? w / sum : 1. / 3;
  const std::size_t i = std::size_t(std::max_element(side.begin(), side.end()) - side.begin()),
                    j = (i + 1) % 3, k = (i + 2) % 3;
  const double foot_of_k = foot_on_side(side[i], side[k], side[j]);
  const double foot = foot_on_side(side[i], outgoing_length[i], outgoing_length[j]);
  if(std::abs(weight[j] + weight[k] * foot_of_k - foot) > rounding()) {
    if(weight[k] * foot_of_k > foot)
      weight[k] = foot / foot_of_k;
    if(weight[k] * (1 - foot_of_k) > 1 - foot)
      weight[k] = (1 - foot) / (1 - foot_of_k);
    weight[j] = (std::max)(foot - weight[k] * foot_of_k, 0.);
    weight[i] = (std::max)(1 - weight[j] - weight[k], 0.);
  }
  return weight;
}

// Applies all changes of an intrinsic triangulation to an evolving surface, too, and records them.
// At first the triangulation is a level of the surface. Other visitors are called afterwards.
template <typename Visitor>
class Refinement_follower
{
  typedef Evolving_surface::Triangulation Triangulation;
  typedef std::vector<Halfedge_index> Halfedges;

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
    restart_from_input();
    m_visitor.before_exact_flips();
  }

  void before_exact_refinement()
  {
    restart_from_input();
    m_visitor.before_exact_refinement();
  }

  // Records an insertion. A position that is rounded to a vertex is not a new vertex.
  template <typename Traits>
  void after_insertion(Vertex_index v,
                       const Intrinsic_triangulations::Vertex_inserter<Traits>& inserter)
  {
    if(m_tri.is_inserted(v) && !m_vertex[v].is_valid())
      insert(v);
    m_visitor.after_insertion(v, inserter);
  }

  // Boundary vertices are not removed.
  void after_removal(Vertex_index v, Face_index f)
  {
    const Vertex_index w = m_vertex[v];
    CGAL_assertion(!surface().mesh().is_border(w));
    const Halfedge_index a = first_outgoing_halfedge(w, surface().mesh());
    std::array<double, 3> outgoing_length, side;
    Halfedge_index h = a;
    for(std::size_t n = 0; n < 3; ++n) {
      outgoing_length[n] = surface().length(h);
      side[n] = surface().length(surface().mesh().next(h));
      h = next_around_source(h, surface().mesh());
    }
    const auto weight = weights_from_lengths(outgoing_length, side);
    history().add_removal(a, surface().mesh(), weight[0], weight[1]);
    Intrinsic_triangulations::remove_degree_3_vertex(w, surface().mesh());
    m_visitor.after_removal(v, f);
  }

  void after_renumbering() { m_visitor.after_renumbering(); }

  // ---- The result ----

  // Copies the lengths, because lengths that were computed from the start are more accurate than
  // lengths from flips.
  void take_lengths()
  {
    for(Edge_index e : mesh().edges())
      surface().set_length(surface().mesh().edge(m_halfedge[e]), m_tri.length(e));
  }

  Face_index image(Face_index f) const { return surface().mesh().face(image(mesh().halfedge(f))); }

  Vertex_index image(Vertex_index v) const
  {
    return surface().mesh().source(image(first_outgoing_halfedge(v, mesh())));
  }

private:
  const Delta_complex& mesh() const { return m_tri.mesh(); }
  Intrinsic_surface& surface() { return m_evolving.m_surface; }
  const Intrinsic_surface& surface() const { return m_evolving.m_surface; }
  Surface_history& history() { return m_evolving.m_history; }

  double length(Halfedge_index h) const { return m_tri.length(mesh().edge(h)); }

  Halfedge_index image(Halfedge_index h) const
  {
    return Intrinsic_triangulations::oriented_like(h, m_halfedge[mesh().edge(h)]);
  }

  void set_image(Halfedge_index h, Halfedge_index on_surface)
  {
    m_halfedge[mesh().edge(h)] = Intrinsic_triangulations::oriented_like(h, on_surface);
  }

  // Elements of the triangulation have the order of the elements of the surface.
  void attach()
  {
    m_halfedge =
      m_tri.add_property_map<Edge_index, Halfedge_index>("e:on_surface", Halfedge_index());
    m_vertex = m_tri.add_property_map<Vertex_index, Vertex_index>("v:on_surface", Vertex_index());
    auto e = mesh().edges().begin();
    for(Edge_index on_surface : surface().mesh().edges())
      m_halfedge[*e++] = surface().mesh().halfedge(on_surface, 0);
  }

  void restart_from_input()
  {
    surface() = m_start;
    history().truncate(m_start_time);
    attach();
  }

  void insert(Vertex_index v)
  {
    const Halfedges outgoing = outgoing_halfedges(v);
    if(mesh().is_border(v))
      insert_on_edge(outgoing);
    else if(outgoing.size() == 3)
      insert_into_face(outgoing, first_side(outgoing));
    else
      insert_on_inner_edge(outgoing, first_side(outgoing));
    note_outgoing_halfedges(v, outgoing);
  }

  Halfedges outgoing_halfedges(Vertex_index v) const
  {
    Halfedges result;
    for_each_outgoing_halfedge(v, mesh(), [&](Halfedge_index h) { result.push_back(h); });
    return result;
  }

  // Returns the side opposite to the new vertex that follows outgoing halfedge `n`, on the surface
  // before the insertion.
  Halfedge_index side(const Halfedges& outgoing, std::size_t n) const
  {
    return image(mesh().next(outgoing[n % outgoing.size()]));
  }

  // Returns the outgoing halfedge before the first side of a face of the surface. Of three
  // halfedges, it precedes the first side of all. Of four halfedges, it is followed by another one
  // in its face.
  std::size_t first_side(const Halfedges& outgoing) const
  {
    const Delta_complex& before = surface().mesh();
    std::size_t n = 0;
    if(outgoing.size() == 3)
      while(side(outgoing, n) != before.halfedge(before.face(side(outgoing, 0))))
        ++n;
    else
      while(before.next(side(outgoing, n)) != side(outgoing, n + 1))
        ++n;
    return n;
  }

  void insert_into_face(const Halfedges& outgoing, std::size_t first)
  {
    std::array<double, 3> outgoing_length, sides;
    for(std::size_t n = 0; n < 3; ++n) {
      outgoing_length[n] = length(outgoing[(first + n) % 3]);
      sides[n] = surface().length(side(outgoing, first + n));
    }
    internal::insert(surface().mesh().face(side(outgoing, 0)),
                     weights_from_lengths(outgoing_length, sides), outgoing_length, surface(),
                     history());
  }

  // Inserts the vertex into a face without area first. Then its edge is flipped.
  void insert_on_inner_edge(const Halfedges& outgoing, std::size_t first)
  {
    const auto outgoing_length = [&](std::size_t n) { return length(outgoing[(first + n) % 4]); };
    const Halfedge_index start = side(outgoing, first),
                         edge = surface().mesh().next(side(outgoing, first + 1));
    const double t = outgoing_length(2) / (outgoing_length(0) + outgoing_length(2));
    const std::size_t c = Intrinsic_triangulations::side_number(start, surface().mesh());
    std::array<double, 3> weight, new_length;
    for(std::size_t n = 0; n < 3; ++n) {
      weight[(c + n) % 3] = n == 0 ? t : n == 1 ? 0 : 1 - t;
      new_length[(c + n) % 3] = outgoing_length(n);
    }
    internal::insert(surface().mesh().face(start), weight, new_length, surface(), history());
    flip(edge, {outgoing_length(3), t, 1}, surface(), history());
  }

  void insert_on_edge(const Halfedges& outgoing)
  {
    const std::array<double, 3> outgoing_length{length(outgoing[0]), length(outgoing[2]),
                                                length(outgoing[1])};
    insert_on_border(surface().mesh().next(side(outgoing, 1)),
                     outgoing_length[1] / (outgoing_length[0] + outgoing_length[1]),
                     outgoing_length, surface(), history());
  }

  // Records the outgoing halfedges of the new vertex on the surface after the insertion.
  void note_outgoing_halfedges(Vertex_index v, const Halfedges& outgoing)
  {
    const Delta_complex& after = surface().mesh();
    Halfedge_index h = after.prev(side(outgoing, 0));
    m_vertex[v] = after.source(h);
    for(Halfedge_index new_halfedge : outgoing) {
      set_image(new_halfedge, h);
      surface().constrain(after.edge(h), m_tri.is_constrained(mesh().edge(new_halfedge)));
      if(!after.is_border(h))
        h = next_around_source(h, after);
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

// Returns the lengths of a level. Rounding can make a side longer than both other sides of its face
// together. Such a side gets the length of both, if this changes it by a rounding error.
inline std::vector<double> lengths_of_triangles(const Surface_level& level)
{
  constexpr int most_rounds = 100; // a side that gets shorter can be too short for its other face
  const Delta_complex& mesh = level.mesh();
  std::vector<double> result;
  for(Edge_index e : mesh.edges())
    result.push_back(get(level.length_map(), e));
  const auto length = [&](Halfedge_index h) -> double& { return result[Edge_index(h).idx()]; };
  bool has_changed = true;
  for(int round = 0; has_changed && round < most_rounds; ++round) {
    has_changed = false;
    for(Face_index f : mesh.faces())
      for(Halfedge_index h : Intrinsic_triangulations::sides(f, mesh)) {
        const double others = length(mesh.next(h)) + length(mesh.prev(h));
        if(length(h) > others && length(h) - others <= length_rounding * length(h)) {
          length(h) = others;
          has_changed = true;
        }
      }
  }
  return result;
}

// Returns an intrinsic triangulation that is a level of a surface, with its constraints.
// \throws Numerical_error if a triangle inequality fails by more than rounding
inline Evolving_surface::Triangulation constrained_triangulation(const Surface_level& level,
                                                                 const Intrinsic_surface& surface)
{
  std::vector<char> is_constrained;
  for(Edge_index e : surface.mesh().edges())
    is_constrained.push_back(surface.is_constrained(e) ? 1 : 0);
  const auto map = boost::make_function_property_map<Edge_index>(
    [&](Edge_index e) { return is_constrained[e] != 0; });
  const std::vector<double> length = lengths_of_triangles(level);
  try {
    return Evolving_surface::Triangulation(level.mesh(),
                                           Intrinsic_triangulations::parameters::edge_length_map(
                                             Surface_level::Length_map(length.data()))
                                             .edge_is_constrained_map(map));
  } catch(const Intrinsic_triangulations::Invalid_input& e) {
    throw Intrinsic_triangulations::Numerical_error(e.what());
  }
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// inserts vertices into a surface and flips it to Delaunay until every face satisfies the bounds
/// or is excused, as `Intrinsic_triangulations::refine()` does. The geometry of the surface does
/// not change. Operations are recorded like removals: maps, subdivisions and prolongations lead
/// through both.
///
/// \tparam NamedParameters a sequence of named parameters
/// \param surface the surface
/// \param np the parameters of `Intrinsic_triangulations::refine()`. The predicate and the visitor
///   get elements of an intrinsic triangulation of the surface, with indices without gaps.
///
/// Complexity: see `Intrinsic_triangulations::refine()`, plus linear in the elements.
/// \returns the numbers of operations, the status, and the faces of the surface that violate the
///   bounds, with the reason
/// \throws Intrinsic_triangulations::Numerical_error if the lengths of a face of the surface
///   violate the triangle inequality by rounding
///
/// Further exceptions are the exceptions of `Intrinsic_triangulations::refine()`. After an
/// exception the surface is valid.
template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
Intrinsic_triangulations::Refinement_result
refine(Evolving_surface& surface, const NamedParameters& np = CGAL::parameters::default_values())
{
  namespace IT = Intrinsic_triangulations;
  IT::Default_refinement_visitor silent;
  auto&& visitor = IT::internal::visitor_of(np, silent);
  typedef std::remove_reference_t<decltype(visitor)> Visitor;
  Evolving_surface::Triangulation tri =
    internal::constrained_triangulation(Surface_level(surface), surface.surface());
  internal::Refinement_follower<Visitor> follower(tri, surface, visitor);
  IT::Refinement_result result = IT::refine(tri, np.visitor(std::ref(follower)));
  follower.take_lengths();
  for(IT::Remaining_face& f : result.remaining) {
    f.face = follower.image(f.face);
    if(f.vertex.is_valid())
      f.vertex = follower.image(f.vertex);
  }
  return result;
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_REFINE_H
