// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_FLIP_RECORD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_FLIP_RECORD_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <array>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the part of T2 that a flip of the edge of `h` changes, as it is before the flip. Later
// flips are undone in reverse order. Then every index and every number is bitwise restored.
template <typename Traits>
class Flip_record
{
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  Flip_record(Halfedge_index h, const Triangulation& tri)
    : m_h(h),
      m_n(tri.coordinates().normal_coordinate(Edge_index(h))),
      m_r{tri.coordinates().roundabout(h), tri.coordinates().roundabout(opposite(h))},
      m_length(tri.length(Edge_index(h))),
      m_of_vertex{tri.mesh().halfedge(tri.mesh().source(h)),
                  tri.mesh().halfedge(tri.mesh().target(h))},
      m_of_face{tri.mesh().halfedge(tri.mesh().face(h)),
                tri.mesh().halfedge(tri.mesh().face(opposite(h)))}
  {}

  Halfedge_index halfedge() const { return m_h; }

  // Undoes the flip. Complexity: constant.
  void undo(Triangulation& tri) const
  {
    Delta_complex& mesh = tri.m_mesh;
    const Halfedge_index o = opposite(m_h);
    flip_back(m_h, mesh);
    mesh.set_halfedge(mesh.source(m_h), m_of_vertex[0]);
    mesh.set_halfedge(mesh.target(m_h), m_of_vertex[1]);
    mesh.set_halfedge(mesh.face(m_h), m_of_face[0]);
    mesh.set_halfedge(mesh.face(o), m_of_face[1]);
    tri.m_coordinates.set(Edge_index(m_h), m_n);
    tri.m_coordinates.set(m_h, m_r[0]);
    tri.m_coordinates.set(o, m_r[1]);
    tri.m_length[Edge_index(m_h)] = m_length;
  }

private:
  // Turns the edge of `h` clockwise, but does not set the halfedges of vertices.
  static void flip_back(Halfedge_index h, Delta_complex& mesh)
  {
    const Halfedge_index o = opposite(h);
    const Halfedge_index ki = mesh.next(h), il = mesh.prev(h), lj = mesh.next(o), jk = mesh.prev(o);
    mesh.set_target(h, mesh.target(lj));
    mesh.set_target(o, mesh.target(ki));
    set_triangle(h, jk, ki, mesh.face(h), mesh);
    set_triangle(o, il, lj, mesh.face(o), mesh);
  }

  Halfedge_index m_h;
  typename Traits::Integer m_n;
  std::array<Delta_complex::size_type, 2> m_r;
  typename Traits::FT m_length;
  std::array<Halfedge_index, 2> m_of_vertex, m_of_face; // of both ends and both sides
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_FLIP_RECORD_H
