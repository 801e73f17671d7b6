// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EVOLVING_SURFACE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EVOLVING_SURFACE_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Flattened_star.h>
#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_simplification/Removal_status.h>
#include <CGAL/Intrinsic_simplification/Surface_history.h>
#include <CGAL/Intrinsic_simplification/internal/operations/Star_polygon.h>
#include <CGAL/Intrinsic_simplification/internal/operations/recorded_changes.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <CGAL/Named_function_parameters.h>

#include <array>
#include <complex>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Flattens a vertex with loops in place and flips the loops away; all can be undone.
class Loop_flipper
{
public:
  // Returns whether no loop remains at the center of `star`. Appends the change of scale and the
  // flips to `history`.
  bool operator()(const Flattened_star& star, Intrinsic_surface& surface, Surface_history& history)
  {
    m_start = history.size();
    m_undo.clear();
    scale(star, surface, history);
    // A flip decreases the degree, unless both new ends are at the center, too.
    for(std::size_t limit = 10 * star.size(); limit > 0; --limit) {
      const Loops loops = find_loops(star.center(), surface);
      if(loops.count == 0)
        return true;
      if(!loops.flippable.is_valid())
        return false;
      flip_loop(loops.flippable, surface, history);
    }
    return false;
  }

  // Restores the state before the last call.
  void undo(const Flattened_star& star, Intrinsic_surface& surface, Surface_history& history) const
  {
    for(std::size_t n = m_undo.size(); n-- > 0;)
      undo_flip(m_undo[n], surface);
    for(std::size_t n = 0; n < star.size(); ++n)
      surface.set_length(surface.mesh().edge(star[n].halfedge), star[n].length);
    history.truncate(m_start);
  }

private:
  struct Loops
  {
    std::size_t count;
    Halfedge_index flippable; // null if there is none
  };

  // Stores a halfedge before its flip.
  struct Undo
  {
    Halfedge_index halfedge;
    double length;
    std::array<std::complex<double>, 2> direction;
    std::array<Halfedge_index, 2> of_face, of_vertex;
  };

  static Loops find_loops(Vertex_index v, const Intrinsic_surface& surface)
  {
    Loops result{0, Delta_complex::null_halfedge()};
    const Delta_complex& mesh = surface.mesh();
    for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
      if(mesh.target(h) != v)
        return;
      ++result.count;
      if(!result.flippable.is_valid() && surface.is_flippable(h))
        result.flippable = h;
    });
    return result;
  }

  void flip_loop(Halfedge_index h, Intrinsic_surface& surface, Surface_history& history)
  {
    const Delta_complex& mesh = surface.mesh();
    const Halfedge_index o = opposite(h);
    m_undo.push_back({h,
                      surface.length(h),
                      {surface.direction(h), surface.direction(o)},
                      {mesh.halfedge(mesh.face(h)), mesh.halfedge(mesh.face(o))},
                      {mesh.halfedge(mesh.source(h)), mesh.halfedge(mesh.target(h))}});
    flip(h, flip_geometry(surface.diamond(h)), surface, history);
  }

  // Undoes a flip by three more flips.
  static void undo_flip(const Undo& undo, Intrinsic_surface& surface)
  {
    Delta_complex& mesh = surface.mesh();
    const Halfedge_index h = undo.halfedge, o = opposite(h);
    for(int turn = 0; turn < 3; ++turn)
      Intrinsic_triangulations::flip_edge(h, mesh);
    surface.set_length(mesh.edge(h), undo.length);
    surface.set_direction(h, undo.direction[0]);
    surface.set_direction(o, undo.direction[1]);
    mesh.set_halfedge(mesh.face(h), undo.of_face[0]);
    mesh.set_halfedge(mesh.face(o), undo.of_face[1]);
    mesh.set_halfedge(mesh.source(h), undo.of_vertex[0]);
    mesh.set_halfedge(mesh.target(h), undo.of_vertex[1]);
  }

  std::vector<Undo> m_undo;
  Surface_history::Time m_start = 0;
};
template <typename Visitor>
class Refinement_follower;
} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// a surface from which vertices are removed, with the history that maps points of the original
/// surface to points of the current one.
///
/// Elements keep their indices; removed elements leave gaps. Vertices have the indices of the
/// input. Vertices that `refine()` inserts have greater indices.
/// \cgalModels `IntrinsicSurface`
class Evolving_surface
{
public:
  /// the type of the input.
  typedef Intrinsic_surface::Triangulation Triangulation;
  /// the type of indices of elements.
  typedef Delta_complex::size_type size_type;

  /// starts with the intrinsic triangulation \f$T_2\f$ of `tri`, and keeps its constrained edges.
  /// The surface stores `tri` until `make_Delaunay()` has been called. Complexity: linear.
  /// \pre `tri` has no garbage
  explicit Evolving_surface(Triangulation tri)
    : m_surface(tri), m_start(std::move(tri)), m_is_protected(mesh().num_vertices(), 0)
  {}

  /// starts with a mesh. For parameters and exceptions see
  /// `Intrinsic_triangulations::Intrinsic_triangulation`.
  template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Evolving_surface(const Graph& g,
                            const NamedParameters& np = CGAL::parameters::default_values());

  /// returns the current connectivity and lengths.
  const Intrinsic_surface& surface() const { return m_surface; }
  /// returns the current connectivity.
  const Delta_complex& mesh() const { return m_surface.mesh(); }
  /// returns the current lengths of the edges.
  Intrinsic_surface::Length_map length_map() const { return m_surface.length_map(); }

  /// returns all operations so far.
  const Surface_history& history() const { return m_history; }

  /// makes `v` a vertex that cannot be removed.
  void protect(Vertex_index v)
  {
    m_is_protected.resize(mesh().num_vertices(), 0);
    m_is_protected[v] = 1;
  }
  /// returns whether `v` has been protected.
  bool is_protected(Vertex_index v) const
  {
    return v.idx() < m_is_protected.size() && m_is_protected[v] != 0;
  }

  /// computes the flattened star of `v`. Complexity: linear in the degree of `v`.
  /// \returns whether `v` can be removed. For a vertex with a loop, only `remove()` decides it
  Removal_status flatten(Vertex_index v, Flattened_star& star) const
  {
    return is_protected(v) ? Removal_status::protected_vertex : star.flatten(v, m_surface);
  }

  /// flips edges until all are Delaunay. Rounding of stored lengths may prevent it. Unless the
  /// surface has changed before, `make_exactly_Delaunay()` is called then, with the triangulation
  /// from which the surface was made. Complexity: linear in the edges and flips.
  /// \throws Intrinsic_triangulations::Flip_limit_exceeded if there are more than a million flips
  ///   plus a thousand for each edge
  /// \throws Intrinsic_triangulations::Numerical_error if an edge has no positive finite length
  /// \throws Intrinsic_triangulations::Overflow_error if the history has too many elements
  ///
  /// After an exception the surface is valid.
  void make_Delaunay()
  {
    std::optional<Triangulation> start = std::exchange(m_start, std::nullopt);
    const bool can_start_again = start && m_history.size() == 0;
    for(Edge_index e : mesh().edges())
      m_waiting.push_back(e);
    try {
      flip_waiting_edges([](Vertex_index) {});
    } catch(const Intrinsic_triangulations::Error&) {
      if(!can_start_again)
        throw;
      m_surface = Intrinsic_surface(*start);
      m_history = Surface_history();
      make_exactly_Delaunay(*start);
    }
  }

  /// flips edges until all are Delaunay, by exact decisions about the metric of `tri`, from which
  /// the surface was made. Both get the same flips, and the surface gets the lengths of `tri`.
  /// Complexity: linear in the edges and flips.
  ///
  /// Exceptions are the exceptions of `Intrinsic_triangulations::make_Delaunay()`. After an
  /// exception the surface is valid.
  /// \pre the triangulation \f$T_2\f$ of `tri` is the triangulation of the surface, with the same
  ///   indices
  void make_exactly_Delaunay(Triangulation& tri)
  {
    Flip_follower follower{tri, *this};
    Intrinsic_triangulations::make_Delaunay(
      tri, Intrinsic_triangulations::parameters::visitor(std::ref(follower)).exact_decisions(true));
    for(Edge_index e : mesh().edges())
      m_surface.set_length(e, tri.length(e));
  }

  /// removes the center of `star` (Section 5.1). It scales the center, flips its edges until three
  /// are left, and removes it. Then it flips changed edges until they are Delaunay. Complexity:
  /// linear in the degree of the center and the flips, for bounded degrees.
  /// \param star the flattened star; its scale factor is refined
  /// \param touch is called with each vertex whose star may have changed, possibly more than once
  /// \returns whether the vertex has been removed. Otherwise the surface has not changed.
  /// \throws Intrinsic_triangulations::Flip_limit_exceeded and
  ///   Intrinsic_triangulations::Numerical_error as `make_Delaunay()`, if a million flips plus a
  ///   thousand for each changed edge do not suffice; the vertex has been removed then
  /// \throws Intrinsic_triangulations::Overflow_error if the history has too many elements
  /// \pre `flatten(star.center(), star) == Removal_status::possible`, and nothing has changed since
  template <typename Touch>
  Removal_status remove(Flattened_star& star, const Touch& touch)
  {
    if(!star.sharpen())
      return Removal_status::not_flattenable;
    if(star.has_loop())
      return remove_with_loops(star, touch);
    if(!m_polygon.plan(star))
      return Removal_status::not_separable;
    remove_as_planned(star, touch);
    return Removal_status::possible;
  }

  /// removes the center of `star` without notification of changed stars.
  Removal_status remove(Flattened_star& star)
  {
    return remove(star, [](Vertex_index) {});
  }

private:
  template <typename Visitor>
  friend class internal::Refinement_follower;

  // Flips the edges of the surface that have been flipped in another triangulation.
  struct Flip_follower : Intrinsic_triangulations::Default_flip_visitor
  {
    Flip_follower(const Triangulation& tri, Evolving_surface& surface) : tri(tri), surface(surface)
    {}

    void after_flip(Halfedge_index h)
    {
      internal::Flip_geometry geometry = internal::flip_geometry(surface.m_surface.diamond(h));
      geometry.length = tri.length(tri.mesh().edge(h));
      internal::flip(h, geometry, surface.m_surface, surface.m_history);
    }

    const Triangulation& tri;
    Evolving_surface& surface;
  };

  // If its loops have been flipped away, the star equals the star of a flat vertex.
  template <typename Touch>
  Removal_status remove_with_loops(const Flattened_star& star, const Touch& touch)
  {
    if(!m_loop_flipper(star, m_surface, m_history) ||
       m_flat_star.flatten(star.center(), m_surface) != Removal_status::possible ||
       !m_polygon.plan(m_flat_star)) {
      m_loop_flipper.undo(star, m_surface, m_history);
      return Removal_status::not_separable;
    }
    for(std::size_t n = 0; n < star.size(); ++n)
      touch(star[n].neighbor);
    remove_as_planned(m_flat_star, touch);
    return Removal_status::possible;
  }

  template <typename Touch>
  void remove_as_planned(const Flattened_star& star, const Touch& touch)
  {
    for(std::size_t n = 0; n < star.size(); ++n)
      touch(star[n].neighbor);
    for(std::size_t n = 0; n < star.number_of_corners(); ++n)
      m_waiting.push_back(mesh().edge(mesh().next(star[n].halfedge)));
    apply_scaling(star);
    cut_ears();
    remove_center(star);
    flip_waiting_edges(touch);
  }

  void apply_scaling(const Flattened_star& star)
  {
    internal::scale(star, m_surface, m_history);
    for(std::size_t n = 0; n < star.size(); ++n)
      m_surface.place_between_neighbors(opposite(star[n].halfedge));
  }

  void cut_ears()
  {
    for(const internal::Star_flip& flip : m_polygon.flips()) {
      internal::flip(flip.halfedge, flip.geometry, m_surface, m_history);
      m_waiting.push_back(mesh().edge(flip.halfedge));
    }
  }

  // On the boundary, the first border edge replaces both.
  void remove_center(const Flattened_star& star)
  {
    const Halfedge_index a = first_outgoing_halfedge(star.center(), mesh());
    m_history.add_removal(a, mesh(), m_polygon.weight(a),
                          m_polygon.weight(next_around_source(a, mesh())));
    Intrinsic_triangulations::remove_degree_3_vertex(star.center(), m_surface.mesh());
    if(!star.is_border())
      return;
    m_surface.set_length(mesh().edge(a), star.flat_length(0) + star.flat_length(star.size() - 1));
    m_surface.set_direction(a, star[star.size() - 1].direction_back);
  }

  template <typename Touch>
  void flip_waiting_edges(const Touch& touch)
  {
    for(std::size_t limit = 1000000 + 1000 * m_waiting.size(); !m_waiting.empty();) {
      const Edge_index e = m_waiting.back();
      m_waiting.pop_back();
      if(m_surface.is_Delaunay(e))
        continue;
      if(limit-- == 0)
        stop_flipping<Intrinsic_triangulations::Flip_limit_exceeded>(
          "not Delaunay after as many flips as are allowed");
      flip(mesh().halfedge(e), touch);
    }
  }

  template <typename Exception>
  [[noreturn]] void stop_flipping(const char* message)
  {
    m_waiting.clear();
    throw Exception(message);
  }

  template <typename Touch>
  void flip(Halfedge_index h, const Touch& touch)
  {
    const internal::Flip_geometry geometry = internal::flip_geometry(m_surface.diamond(h));
    if(!Intrinsic_surface::Traits::Is_length()(geometry.length))
      stop_flipping<Intrinsic_triangulations::Numerical_error>(
        "a flip gives no positive finite length");
    internal::flip(h, geometry, m_surface, m_history);
    const Halfedge_index o = opposite(h);
    for(Halfedge_index side : {mesh().next(h), mesh().prev(h), mesh().next(o), mesh().prev(o)}) {
      m_waiting.push_back(mesh().edge(side));
      touch(mesh().target(side));
    }
  }

  Intrinsic_surface m_surface;
  Surface_history m_history;
  std::optional<Triangulation> m_start; // the surface before the first flips
  std::vector<char> m_is_protected;     // of each vertex
  internal::Star_polygon m_polygon;
  internal::Loop_flipper m_loop_flipper;
  Flattened_star m_flat_star;        // of a vertex whose loops have been flipped away
  std::vector<Edge_index> m_waiting; // edges that may not be Delaunay
};

// This constructor is not inline, so that the compiled library can contain it.
template <typename Graph, typename NamedParameters>
Evolving_surface::Evolving_surface(const Graph& g, const NamedParameters& np)
  : Evolving_surface(Triangulation(g, np))
{}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EVOLVING_SURFACE_H
