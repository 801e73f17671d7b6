// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERPOLATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERPOLATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/internal/side_access.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// pulls a piecewise linear function from one triangulation onto the common subdivision, on which it is
/// piecewise linear too. Complexity: linear.
///
/// \param side the triangulation on whose faces the function is linear
/// \param subdivision the subdivision
/// \param tri the triangulation of which it is the subdivision
/// \param value a readable property map from the vertices of the triangulations to the values of the
///        function: numbers, or points or vectors of a kernel
/// \param result a writable property map from the vertices of the subdivision to values
template <typename Traits, typename Point, typename ValueMap, typename ResultMap>
void interpolate(Side side, const Common_subdivision<Traits, Point>& subdivision,
                 const Intrinsic_triangulation<Traits>& tri, const ValueMap& value,
                 ResultMap result)
{
  const Delta_complex& mesh = internal::mesh_of(side, tri);
  for(Vertex_index v : subdivision.mesh().vertices()) {
    if(subdivision.is_input_vertex(v)) {
      put(result, v, get(value, v));
      continue;
    }
    const auto& p = subdivision.place(side, v);
    const auto& from = get(value, mesh.source(p.halfedge));
    put(result, v, from + p.t * (get(value, mesh.target(p.halfedge)) - from));
  }
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERPOLATION_H
