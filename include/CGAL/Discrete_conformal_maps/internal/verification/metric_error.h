// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_METRIC_ERROR_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_METRIC_ERROR_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <cmath>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the angle opposite to `h` in its face. Its cosine and sine are normalized.
template <typename FT>
Corner<FT> unit_corner_facing(Halfedge_index h, const Delta_complex& mesh,
                              const std::vector<FT>& length)
{
  using std::sqrt;
  const auto of = [&](Halfedge_index x) { return length[Edge_index(x).idx()]; };
  const Corner<FT> corner =
    Flat_triangle<FT>({of(h), of(mesh.next(h)), of(mesh.prev(h))}).corner(2).scaled();
  const FT size = sqrt(corner.cosine * corner.cosine + corner.sine * corner.sine);
  return {corner.cosine / size, corner.sine / size};
}

// Returns the relative excess of the length of the other diagonal by Ptolemy's relation over its
// length in the plane. For opposite angles of a sum t, this is half of 2 a c b d (1 + cos t) / (a c
// + b d)^2 (Bretschneider's formula). A diagonal that is Delaunay may have another length in the
// ideal polyhedron.
template <typename FT>
double ideal_length_error(Halfedge_index h, const Delta_complex& mesh,
                          const std::vector<FT>& length)
{
  const Halfedge_index o = mesh.opposite(h);
  const Corner<FT> sum = unit_corner_facing(h, mesh, length) * unit_corner_facing(o, mesh, length);
  if(sum.sine >= 0)
    return 0;
  const auto of = [&](Halfedge_index x) { return length[Edge_index(x).idx()]; };
  const FT p = of(mesh.next(h)) * of(mesh.next(o)), q = of(mesh.prev(h)) * of(mesh.prev(o));
  return static_cast<double>(p / (p + q) * (q / (p + q)) * (1 + sum.cosine));
}

// Returns the error of T_2 with lengths in `double`, compared with the exact surface, on which its
// edges have the lengths `exact`. It is the greatest relative error of a length. Lengths of edges
// that cross edges that should have been flipped count, too.
template <typename FT>
double metric_error(const Intrinsic_triangulations::Intrinsic_triangulation<>& t,
                    const std::vector<FT>& exact)
{
  double result = 0;
  for(Edge_index e : t.mesh().edges()) {
    const double error = static_cast<double>(FT(t.length(e)) / exact[e.idx()] - 1);
    result = greater_error(result, std::abs(error));
    if(const Halfedge_index h = t.mesh().halfedge(e); !t.mesh().is_border(e))
      result = greater_error(result, ideal_length_error(h, t.mesh(), exact));
  }
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_METRIC_ERROR_H
