// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_FLAT_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_FLAT_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/Cut_graph.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

// The faces of a flat surface with cones, unfolded into the plane one after the other. Directions are
// turned by the angles of faces, so that small faces beside large ones do not suffer from differences of
// positions.
template <typename FT>
class Flat_layout
{
  struct Vector
  {
    FT x, y;

    friend Vector operator+(const Vector& v, const Vector& w) { return {v.x + w.x, v.y + w.y}; }
    friend Vector operator*(const FT& s, const Vector& v) { return {s * v.x, s * v.y}; }
    friend Vector turned(const Vector& v, const Vector& by)
    {
      return {v.x * by.x - v.y * by.y, v.x * by.y + v.y * by.x};
    }
  };

public:
  // `length` has the lengths of all edges
  Flat_layout(const Delta_complex& mesh, const std::vector<FT>& length, const Cut_graph& cut)
    : m_mesh(mesh),
      m_length(length),
      m_position(mesh.num_halfedges(), Vector{FT(0), FT(0)}),
      m_direction(mesh.num_halfedges())
  {
    for(const Cut_graph::Step& step : cut.steps()) {
      const Halfedge_index h = step.entry.is_valid() ? step.entry : mesh.halfedge(step.face);
      start(h, step.entry.is_valid());
      place(h);
    }
    for(Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v))
        unite_corners(v, cut);
  }

  // the position of the source of `h` in the face of `h`
  std::complex<double> position(Halfedge_index h) const
  {
    const Vector& p = m_position[h.idx()];
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
  }

private:
  const FT& length(Halfedge_index h) const { return m_length[Edge_index(h).idx()]; }

  // takes the place of the halfedge `h` from the face beyond it, or from nowhere
  void start(Halfedge_index h, bool is_entry)
  {
    const Halfedge_index o = m_mesh.opposite(h);
    m_position[h.idx()] = is_entry ? m_position[m_mesh.next(o).idx()] : Vector{FT(0), FT(0)};
    m_direction[h.idx()] = is_entry ? FT(-1) * m_direction[o.idx()] : Vector{FT(1), FT(0)};
  }

  // the rest of the face
  void place(Halfedge_index h)
  {
    const Halfedge_index n = m_mesh.next(h), p = m_mesh.prev(h);
    m_position[n.idx()] = m_position[h.idx()] + length(h) * m_direction[h.idx()];
    m_direction[n.idx()] = turned(m_direction[h.idx()], turn(n));
    m_direction[p.idx()] = turned(m_direction[n.idx()], turn(p));
    // along the shorter way
    m_position[p.idx()] = length(n) < length(p)
                            ? m_position[n.idx()] + length(n) * m_direction[n.idx()]
                            : m_position[h.idx()] + (-length(p)) * m_direction[p.idx()];
  }

  // how the boundary of a face turns at the source of `h`: by pi less the angle there
  Vector turn(Halfedge_index h) const
  {
    using std::sqrt;
    const FT &a = length(h), &b = length(m_mesh.prev(h)), &opposite = length(m_mesh.next(h));
    const FT cosine = Intrinsic_triangulations::doubled_corner_product(opposite, a, b);
    const FT sine = sqrt(Intrinsic_triangulations::squared_quadrupled_area(opposite, a, b));
    const FT norm = sqrt(cosine * cosine + sine * sine);
    return {-cosine / norm, sine / norm};
  }

  // Corners between which there is no seam are one point: rounding has made them a little different.
  void unite_corners(Vertex_index v, const Cut_graph& cut)
  {
    const Halfedge_index start = Intrinsic_triangulations::first_spoke(v, m_mesh);
    Halfedge_index first = start;
    do {
      if(cut.is_seam(Edge_index(first)))
        break;
      first = Intrinsic_triangulations::next_spoke(first, m_mesh);
    } while(first != start);
    Halfedge_index h = first;
    Vector position = m_position[h.idx()];
    do {
      if(cut.is_seam(Edge_index(h)))
        position = m_position[h.idx()];
      m_position[h.idx()] = position;
      h = Intrinsic_triangulations::next_spoke(h, m_mesh);
    } while(h != first);
  }

  const Delta_complex& m_mesh;
  const std::vector<FT>& m_length;
  std::vector<Vector> m_position;  // of the source of each halfedge
  std::vector<Vector> m_direction; // of each halfedge
};

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_FLAT_LAYOUT_H
