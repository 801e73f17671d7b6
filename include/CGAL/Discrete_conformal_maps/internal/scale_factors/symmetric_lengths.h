// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SYMMETRIC_LENGTHS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SYMMETRIC_LENGTHS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

// Flips round the lengths of an edge of a doubled surface and of its mirror image differently.
// Numbers with more digits resolve the difference. These functions make lengths symmetric for them.
namespace CGAL::Discrete_conformal_maps::internal {

// Returns for each edge one with the same length up to rounding, which joins copies of the same
// vertices. Mirror images have one edge in common. `original` contains the original of each vertex.
template <typename Triangulation>
std::vector<Edge_index> edges_of_equal_length(const Triangulation& t,
                                              const std::vector<Vertex_index>& original)
{
  struct Joined
  {
    Vertex_index v, w;
    double length;
    Edge_index edge;

    bool operator<(const Joined& other) const
    {
      return std::tie(v, w, length, edge) < std::tie(other.v, other.w, other.length, other.edge);
    }
  };
  std::vector<Joined> joined;
  for(Edge_index e : t.mesh().edges()) {
    const auto [v, w] =
      std::minmax(original[t.mesh().vertex(e, 0).idx()], original[t.mesh().vertex(e, 1).idx()]);
    joined.push_back({v, w, t.length(e), e});
  }
  std::sort(joined.begin(), joined.end());
  std::vector<Edge_index> result(joined.size());
  const Joined* first = nullptr;
  for(const Joined& next : joined) {
    if(first == nullptr || first->v != next.v || first->w != next.w ||
       next.length - first->length > tolerance::mirrored_length * first->length)
      first = &next;
    result[next.edge.idx()] = first->edge;
  }
  return result;
}

// Returns the length of an edge, such that Ptolemy's relation yields the lengths of mirror images.
// `equal` contains the edges of equal length. The diagonals of a trapezoid across the boundary are
// mirror images of each other, and only one of them is an edge.
template <typename FT, typename Triangulation>
FT symmetric_length(Edge_index e, const Triangulation& t, const std::vector<Vertex_index>& original,
                    const std::vector<Edge_index>& equal)
{
  using std::abs;
  using std::sqrt;
  const Delta_complex& mesh = t.mesh();
  const auto length = [&](Halfedge_index h) { return FT(t.length(equal[mesh.edge(h).idx()])); };
  const auto origin = [&](Vertex_index v) { return original[v.idx()]; };
  const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
  const FT rounded = length(h);
  const Vertex_index i = origin(mesh.source(h)), j = origin(mesh.target(h));
  if(i == j || mesh.is_border(e))
    return rounded;
  const Vertex_index k = origin(mesh.target(mesh.next(h))), l = origin(mesh.target(mesh.next(o)));
  if(std::minmax(i, j) != std::minmax(k, l))
    return rounded;
  const FT diagonal = sqrt(
    FT(length(mesh.next(h)) * length(mesh.next(o)) + length(mesh.prev(h)) * length(mesh.prev(o))));
  return abs(FT(diagonal - rounded)) <= tolerance::mirrored_length * rounded ? diagonal : rounded;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SYMMETRIC_LENGTHS_H
