// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_LOOP_FLIPPER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_LOOP_FLIPPER_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Flattened_star.h>
#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_history.h>
#include <CGAL/Intrinsic_simplification/internal/operations/recorded_changes.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

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

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_LOOP_FLIPPER_H
