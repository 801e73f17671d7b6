// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_RECORDED_CHANGES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_RECORDED_CHANGES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Flattened_star.h>
#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_history.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Intrinsic_simplification::internal {

// Stores the data of a flip of ij to lk: the new length, and the positions where the two cross,
// measured from i and l.
struct Flip_geometry
{
  double length, s, t;
};

// Rounding can place the crossing beyond an end of ij. Then this end is the crossing. Its position
// on lk follows from the feet of k and l on ij, which are at `foot_k` and `foot_l`. On thin faces,
// areas do not determine this position. The old position stays if the new one is farther from lk.
inline Flip_geometry with_crossing_on_edge(Flip_geometry g, double foot_k, double foot_l,
                                           double height_per_length)
{
  const double end = std::clamp(g.s, 0., 1.);
  if(end != g.s && foot_k != foot_l) {
    const double t = std::clamp((end - foot_l) / (foot_k - foot_l), 0., 1.);
    if(std::abs(t - g.t) * height_per_length < std::abs(end - g.s))
      g.t = t;
  }
  g.s = end;
  return g;
}

inline Flip_geometry flip_geometry(const Intrinsic_triangulations::Diamond<double>& d)
{
  namespace IT = Intrinsic_triangulations;
  const double at_k = IT::quadrupled_area(d.ij, d.jk, d.ki);
  const double at_l = IT::quadrupled_area(d.ij, d.lj, d.il);
  const double foot_k = IT::scaled_foot(d.jk, d.ki), foot_l = IT::scaled_foot(d.lj, d.il);
  const double length = IT::Euclidean_geometry_traits<double>::Compute_flipped_length()(d);
  const double both = at_k + at_l, scale = 2 * d.ij * d.ij; // feet are measured from the midpoint
  const double s =
    both > 0 ? (foot_k * at_l + foot_l * at_k) / (scale * both) : (foot_k + foot_l) / (2 * scale);
  return with_crossing_on_edge({length, 0.5 + s, both > 0 ? at_l / both : 0.5},
                               0.5 + foot_k / scale, 0.5 + foot_l / scale, both / scale);
}

// Flips the edge of `h` and records it.
inline void flip(Halfedge_index h, const Flip_geometry& geometry, Intrinsic_surface& surface,
                 Surface_history& history)
{
  history.add_flip(h, surface.mesh(), geometry.s, geometry.t);
  surface.flip(h, geometry.length);
}

// Inserts a vertex into the face of `h` and records it. Its barycentric coordinates and the
// lengths of its edges are in the order of the corners of the face. Returns the halfedge to the
// first corner.
inline Halfedge_index insert(Face_index f, const std::array<double, 3>& weight,
                             const std::array<double, 3>& length, Intrinsic_surface& surface,
                             Surface_history& history)
{
  const Halfedge_index a = surface.split_face(surface.mesh().halfedge(f), length);
  history.add_insertion(a, surface.mesh(), Face_corner(f, 0), weight[0], weight[1]);
  return a;
}

// Inserts a vertex into the boundary edge of `h` at `t`, see `Intrinsic_surface`, and records it.
inline void insert_on_border(Halfedge_index h, double t, const std::array<double, 3>& length,
                             Intrinsic_surface& surface, Surface_history& history)
{
  const Delta_complex& mesh = surface.mesh();
  const Face_corner whole(mesh.next(h), mesh);
  surface.split_border_edge(h, length);
  history.add_insertion(h, mesh, whole, t, 0);
}

// Flattens the center of a star and records it. Directions are unchanged.
inline void scale(const Flattened_star& star, Intrinsic_surface& surface, Surface_history& history)
{
  history.add_scaling(star.center(), std::exp(-star.scale_factor()), star.scale_factor() != 0,
                      surface.mesh());
  for(std::size_t n = 0; n < star.size(); ++n)
    surface.set_length(surface.mesh().edge(star[n].halfedge), star.flat_length(n));
}

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_RECORDED_CHANGES_H
