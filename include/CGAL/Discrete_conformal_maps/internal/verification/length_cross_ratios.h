// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_LENGTH_CROSS_RATIOS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_LENGTH_CROSS_RATIOS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Map_promise.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// The length cross ratio of the edge of `h` between the vertices k and m: jk im / (ki mj), where h
// is ij.
template <typename Length>
double length_cross_ratio(Halfedge_index h, const Delta_complex& mesh, const Length& length)
{
  const Halfedge_index o = mesh.opposite(h);
  return length(mesh.next(h)) / length(mesh.prev(h)) *
         (length(mesh.next(o)) / length(mesh.prev(o)));
}

// The greatest relative error of a length cross ratio, of the edges of halfedges that count,
// between the lengths of halfedges in an image and those that they should be, up to scale factors.
template <typename Counts, typename In_image, typename Ideal>
double greatest_cross_ratio_error(const Delta_complex& mesh, const Counts& counts,
                                  const In_image& in_image, const Ideal& ideal)
{
  double result = 0;
  for(Edge_index e : mesh.edges())
    if(const Halfedge_index h = mesh.halfedge(e); counts(h))
      result = greater_error(
        result,
        std::abs(length_cross_ratio(h, mesh, in_image) / length_cross_ratio(h, mesh, ideal) - 1));
  return result;
}

// That of points in the plane, and one at infinity, whose distances are all the same. `length`
// gives what the length of an edge should be. An edge of a border does not count.
template <typename FT, typename Length>
double max_stereographic_cross_ratio_error(const Delta_complex& mesh, const Length& length,
                                           const std::vector<std::array<FT, 2>>& position,
                                           Vertex_index at_infinity)
{
  using std::sqrt;
  std::vector<double> distance(mesh.num_edges(), 1.);
  for(Edge_index e : mesh.edges()) {
    const Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    if(v == at_infinity || w == at_infinity)
      continue;
    const auto &p = position[v.idx()], &q = position[w.idx()];
    const FT x = p[0] - q[0], y = p[1] - q[1], square = x * x + y * y;
    distance[e.idx()] = static_cast<double>(FT(sqrt(square)));
  }
  return greatest_cross_ratio_error(
    mesh, [&](Halfedge_index h) { return !mesh.is_border(Edge_index(h)); },
    [&](Halfedge_index h) { return distance[Edge_index(h).idx()]; },
    [&](Halfedge_index h) { return length(Edge_index(h)); });
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_LENGTH_CROSS_RATIOS_H
