// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_LENGTH_CROSS_RATIOS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_LENGTH_CROSS_RATIOS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the length cross ratio of the edge of `h` between the vertices k and m: jk im / (ki mj),
// where h is ij.
template <typename Length>
auto length_cross_ratio(Halfedge_index h, const Delta_complex& mesh, const Length& length)
{
  const Halfedge_index o = mesh.opposite(h);
  return length(mesh.next(h)) / length(mesh.prev(h)) *
         (length(mesh.next(o)) / length(mesh.prev(o)));
}

// Returns the greatest relative error of a length cross ratio, for the edges of halfedges that
// count. It compares the lengths of halfedges in an image with their lengths on the surface, up to
// scale factors.
template <typename Counts, typename In_image, typename Ideal>
double greatest_cross_ratio_error(const Delta_complex& mesh, const Counts& counts,
                                  const In_image& in_image, const Ideal& ideal)
{
  double result = 0;
  for(Edge_index e : mesh.edges())
    if(const Halfedge_index h = mesh.halfedge(e); counts(h)) {
      const auto ratio = length_cross_ratio(h, mesh, in_image) / length_cross_ratio(h, mesh, ideal);
      result = greater_error(result, std::abs(static_cast<double>(ratio) - 1));
    }
  return result;
}

// Returns the greatest error for points in the plane, and one at infinity, whose distances are all
// equal. `length` returns the prescribed length of an edge. Edges on a border do not count. Neither
// does an edge if `is_known()` is false for a side of its faces.
template <typename FT, typename Length, typename Is_known>
double max_stereographic_cross_ratio_error(const Delta_complex& mesh, const Length& length,
                                           const std::vector<std::array<FT, 2>>& position,
                                           Vertex_index at_infinity, const Is_known& is_known)
{
  using std::sqrt;
  typedef Difference_of<FT> Number;
  typedef Distance_of<FT> Distance;
  std::vector<Distance> distance(mesh.num_edges(), Distance(1));
  for(Edge_index e : mesh.edges()) {
    const Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    if(v == at_infinity || w == at_infinity)
      continue;
    const auto &p = position[v.idx()], &q = position[w.idx()];
    const Number x = converted<Number>(FT(p[0] - q[0])), y = converted<Number>(FT(p[1] - q[1]));
    distance[e.idx()] = converted<Distance>(Number(sqrt(Number(x * x + y * y))));
  }
  const auto counts = [&](Halfedge_index h) {
    const auto is_side_known = [&](Halfedge_index side) { return is_known(Edge_index(side)); };
    const Halfedge_index o = mesh.opposite(h);
    return !mesh.is_border(Edge_index(h)) && is_side_known(mesh.next(h)) &&
           is_side_known(mesh.prev(h)) && is_side_known(mesh.next(o)) &&
           is_side_known(mesh.prev(o));
  };
  return greatest_cross_ratio_error(
    mesh, counts, [&](Halfedge_index h) { return distance[Edge_index(h).idx()]; },
    [&](Halfedge_index h) { return converted<Distance>(length(Edge_index(h))); });
}

// Returns whether stored positions in the plane, in the range of squares, determine their distance
// with the digits promised for a cross ratio.
inline bool has_known_distance(const std::array<Double_double, 2>& p,
                               const std::array<Double_double, 2>& q)
{
  double size = 0, distance = 0;
  for(std::size_t c = 0; c < 2; ++c) {
    size = (std::max)({size, std::abs(p[c].high()), std::abs(q[c].high())});
    distance = (std::max)(distance, std::abs(static_cast<double>(p[c] - q[c])));
  }
  return size < tolerance::greatest_position && distance > tolerance::least_known_distance * size;
}

template <typename FT, typename Length>
double max_stereographic_cross_ratio_error(const Delta_complex& mesh, const Length& length,
                                           const std::vector<std::array<FT, 2>>& position,
                                           Vertex_index at_infinity)
{
  return max_stereographic_cross_ratio_error(mesh, length, position, at_infinity,
                                             [](Edge_index) { return true; });
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_VERIFICATION_LENGTH_CROSS_RATIOS_H
