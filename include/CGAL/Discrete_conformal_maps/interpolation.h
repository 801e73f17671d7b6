// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERPOLATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERPOLATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Triple_subdivision.h>

#include <cstddef>

namespace CGAL {
namespace Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsSubdivision
/// pulls a function that is linear on the faces of \f$T^A\f$ (such as the positions in space) onto
/// the subdivision, on which it is piecewise linear too. At vertices of \f$T^A\f$ the values are
/// the same, to the bit. Complexity: linear.
///
/// \param subdivision the subdivision
/// \param input the connectivity of \f$T^A\f$
/// \param value a readable property map from the vertices of \f$T^A\f$ to the values of the
///        function: numbers, or points or vectors of a kernel
/// \param result a writable property map from the vertices of the subdivision to values; isolated
///        vertices of \f$T^A\f$ keep their values
template <typename FT, typename Point, typename ValueMap, typename ResultMap>
void interpolate(const Triple_subdivision<FT, Point>& subdivision, const Delta_complex& input,
                 const ValueMap& value, ResultMap result)
{
  for(Vertex_index v : subdivision.mesh().vertices()) {
    if(subdivision.is_input_vertex(v)) {
      put(result, v, get(value, v));
      continue;
    }
    const auto& [f, weight] = subdivision.place_on_A(v);
    const auto side = Intrinsic_triangulations::sides(f, input);
    const auto& origin = get(value, input.source(side[0]));
    auto sum = origin;
    for(std::size_t s = 1; s < 3; ++s)
      sum = sum + weight[s] * (get(value, input.source(side[s])) - origin);
    put(result, v, sum);
  }
}

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERPOLATION_H
