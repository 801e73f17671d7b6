// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_UNFOLDED_FACES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_UNFOLDED_FACES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Intrinsic_triangulations/Cut_graph.h>
#include <CGAL/Intrinsic_triangulations/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

using Intrinsic_triangulations::internal::Plane_vector;

using Intrinsic_triangulations::Cut_graph;

// Unfolds the faces of a flat surface with cones into the plane, one after the other. Directions
// are rotated by the angles of faces, and not computed from positions. Thus rounding of positions
// beside large faces does not affect small faces. Corners without a seam between them are one
// point.
//
// A planar layout is a function object. `layout(faces, order)` moves the points of unfolded faces,
// because rounding has shifted faces that were reached on different paths. `order` is the
// elimination order of the vertices. Models: `Incremental_layout`, `Least_squares_layout` and
// `Spectral_layout`.
template <typename FT_>
class Unfolded_faces
{
public:
  typedef FT_ FT;
  typedef Plane_vector<FT> Vector;

  // `length` contains the lengths of all edges.
  Unfolded_faces(const Delta_complex& mesh, const std::vector<FT>& length, const Cut_graph& cut)
    : m_mesh(mesh),
      m_length(length),
      m_cut(cut),
      m_direction(mesh.num_halfedges()),
      m_point(mesh.num_halfedges())
  {
    std::vector<Vector> position(mesh.num_halfedges(), Vector{FT(0), FT(0)});
    for(const Cut_graph::Step& step : cut.steps()) {
      const Halfedge_index h = step.entry.is_valid() ? step.entry : mesh.halfedge(step.face);
      start(h, step.entry.is_valid(), position);
      place(h, position);
    }
    for(Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v))
        unite_corners(v, position);
  }

  const Delta_complex& mesh() const { return m_mesh; }
  const Cut_graph& cut() const { return m_cut; }

  // Returns the index of the point at the source of `h` in the face of `h`.
  Delta_complex::size_type point(Halfedge_index h) const { return m_point[h.idx()]; }
  const Vector& position(Halfedge_index h) const { return positions[point(h)]; }

  const FT& length(Halfedge_index h) const { return m_length[Edge_index(h).idx()]; }

  // Returns the vector of `h` in its face. It is free of the errors of positions.
  Vector side(Halfedge_index h) const { return length(h) * m_direction[h.idx()]; }

  // Frees the memory of directions. Sides no longer exist after the call.
  void drop_sides() { std::vector<Vector>().swap(m_direction); }

  // Calls `visit(h)` for the sides of all faces, in the order in which the faces were joined.
  template <typename Visit>
  void for_each_side(const Visit& visit) const
  {
    for(const Cut_graph::Step& step : m_cut.steps())
      for(Halfedge_index h : sides(step.face, m_mesh))
        visit(h);
  }

  std::vector<Vector> positions;      // the positions of all points
  std::vector<Vertex_index> vertices; // the vertex of each point

private:
  // Positions the source of the halfedge `h` as in the face beyond it, or at the origin.
  void start(Halfedge_index h, bool is_entry, std::vector<Vector>& position)
  {
    const Halfedge_index o = m_mesh.opposite(h);
    if(is_entry)
      position[h.idx()] = position[m_mesh.next(o).idx()];
    m_direction[h.idx()] = is_entry ? FT(-1) * m_direction[o.idx()] : Vector{FT(1), FT(0)};
  }

  // Positions the other corners of the face.
  void place(Halfedge_index h, std::vector<Vector>& position)
  {
    const Halfedge_index n = m_mesh.next(h), p = m_mesh.prev(h);
    position[n.idx()] = position[h.idx()] + length(h) * m_direction[h.idx()];
    m_direction[n.idx()] = m_direction[h.idx()] * turn(n);
    m_direction[p.idx()] = m_direction[n.idx()] * turn(p);
    // The position is computed along the shorter side.
    position[p.idx()] = length(n) < length(p)
                          ? position[n.idx()] + length(n) * m_direction[n.idx()]
                          : position[h.idx()] + (-length(p)) * m_direction[p.idx()];
  }

  // Returns the exterior angle of a face at the source of `h`, as a unit vector.
  Vector turn(Halfedge_index h) const
  {
    using std::sqrt;
    const std::array<FT, 3> side =
      in_range(std::array<FT, 3>{length(m_mesh.next(h)), length(h), length(m_mesh.prev(h))});
    const FT cosine = Intrinsic_triangulations::doubled_corner_product(side[0], side[1], side[2]);
    const FT sine =
      sqrt(Intrinsic_triangulations::squared_quadrupled_area(side[0], side[1], side[2]));
    const FT norm = sqrt(cosine * cosine + sine * sine);
    return {-cosine / norm, sine / norm};
  }

  // Unites corners that no seam separates. Their positions differ slightly by rounding.
  void unite_corners(Vertex_index v, const std::vector<Vector>& position)
  {
    m_cut.for_each_corner(v, [&](Halfedge_index h, Halfedge_index first) {
      if(h == first) {
        positions.push_back(position[h.idx()]);
        vertices.push_back(v);
      }
      m_point[h.idx()] = Delta_complex::size_type(positions.size() - 1);
    });
  }

  const Delta_complex& m_mesh;
  const std::vector<FT>& m_length;
  const Cut_graph& m_cut;
  std::vector<Vector> m_direction;               // the direction of each halfedge
  std::vector<Delta_complex::size_type> m_point; // the point at the source of each halfedge
};

// Leaves the points at their unfolded positions. Errors add up from face to face.
struct Incremental_layout
{
  template <typename FT>
  void operator()(Unfolded_faces<FT>& /* faces */, const Shared_order& /* order */) const
  {}
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_UNFOLDED_FACES_H
