// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERPOLATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERPOLATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

// The place of a vertex of the subdivision on `side`: the vertices of an edge or face and their
// weights.
template <typename FT>
struct Interpolation_weights
{
  std::size_t size;
  std::array<Vertex_index, 3> vertex;
  std::array<FT, 3> weight;
};

template <typename Traits, typename Point>
Interpolation_weights<typename Traits::FT>
interpolation_weights(Side side, Vertex_index v,
                      const Common_subdivision<Traits, Point>& subdivision,
                      const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::FT FT;
  const Delta_complex& mesh = tri.surface(side).mesh();
  if(v.idx() < mesh.number_of_vertices())
    return {1, {v}, {FT(1)}};
  if(subdivision.is_intrinsic_vertex(v) && !tri.inserted_vertex(v).along.is_valid()) {
    const auto& [f, b] = tri.inserted_vertex(v).location;
    const auto side_of_face = sides(f, mesh);
    return {
      3,
      {mesh.source(side_of_face[0]), mesh.source(side_of_face[1]), mesh.source(side_of_face[2])},
      b};
  }
  const auto& p = subdivision.place(side, v);
  return {2, {mesh.source(p.halfedge), mesh.target(p.halfedge)}, {1 - p.t, p.t}};
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// pulls a piecewise linear function from one triangulation onto the common subdivision, on which
/// it is piecewise linear too. Complexity: linear.
///
/// \param side the triangulation on whose faces the function is linear
/// \param subdivision the subdivision
/// \param tri the triangulation of which it is the subdivision
/// \param value a readable property map from the vertices of that triangulation to the values of
///        the function: numbers, or points or vectors of a kernel
/// \param result a writable property map from the vertices of the subdivision to values
template <typename Traits, typename Point, typename ValueMap, typename ResultMap>
void interpolate(Side side, const Common_subdivision<Traits, Point>& subdivision,
                 const Intrinsic_triangulation<Traits>& tri, const ValueMap& value,
                 ResultMap result)
{
  for(Vertex_index v : subdivision.mesh().vertices()) {
    const auto w = internal::interpolation_weights(side, v, subdivision, tri);
    const auto& first = get(value, w.vertex[0]);
    auto sum = first;
    for(std::size_t c = 1; c < w.size; ++c)
      sum = sum + w.weight[c] * (get(value, w.vertex[c]) - first);
    put(result, v, sum);
  }
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERPOLATION_H
