// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERPOLATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERPOLATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Subdivision_base.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns the value at a point of a function that is linear on a simplex. It uses the first `size`
// vertices and the barycentric coordinates of the point, which sum up to one.
template <typename ValueMap, typename Vertices, typename Weights>
auto linear_value(const ValueMap& value, const Vertices& vertex, const Weights& weight,
                  std::size_t size)
{
  const auto& first = get(value, vertex[0]);
  auto sum = first;
  for(std::size_t c = 1; c < size; ++c)
    sum = sum + weight[c] * (get(value, vertex[c]) - first);
  return sum;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// computes the values on a subdivision of a function that is linear on the faces of one
/// triangulation. It is also linear on the faces of the subdivision. Vertices of that triangulation
/// keep their values, bitwise. Complexity: linear.
///
/// \param side the triangulation on whose faces the function is linear
/// \param subdivision the subdivision
/// \param value a readable property map from the vertices of that triangulation to the values of
///        the function: numbers, or points or vectors of a kernel
/// \param result a writable property map from the vertices of the subdivision to values
/// \tparam Subdivision a class derived from `Subdivision_base`
/// \tparam NamedParameters a sequence of named parameters
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{concurrency_tag}
///     \cgalParamDescription{whether several threads are used, which then read and write values of
///                           both maps at the same time; see \ref it_parallel}
///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
///                    `CGAL::Parallel_if_available_tag`}
///     \cgalParamDefault{`CGAL::Sequential_tag`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
template <typename Subdivision, typename ValueMap, typename ResultMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void interpolate(typename Subdivision::Side side, const Subdivision& subdivision,
                 const ValueMap& value, ResultMap result,
                 const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto interpolate_at = [&](Vertex_index v) {
    const auto w = subdivision.weights(side, v);
    put(result, v, internal::linear_value(value, w.vertex, w.weight, w.size));
  };
  for_each_in_chunks<Vertex_index>(concurrency_of(np), subdivision.mesh(), interpolate_at);
}

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// computes the values at the vertices of \f$T_2\f$ of a function that is linear on the faces of
/// \f$T_1\f$. Vertices of \f$T_1\f$ keep their values, bitwise. Complexity: linear.
///
/// \param pair the two triangulations
/// \param value a readable property map from the vertices of \f$T_1\f$ to the values of the
///        function: numbers, or points or vectors of a kernel
/// \param result a writable property map from the vertices of \f$T_2\f$ to values
template <typename Traits, typename ValueMap, typename ResultMap>
void interpolate(const Triangulation_pair<Traits>& pair, const ValueMap& value, ResultMap result)
{
  const Delta_complex& input = pair.input_mesh();
  for(Vertex_index v : pair.mesh().vertices()) {
    if(!pair.is_inserted(v)) {
      put(result, v, get(value, v));
      continue;
    }
    const auto& [face, weight] = face_location(pair.inserted_vertex(v), input);
    const auto side = sides(face, input);
    const std::array<Vertex_index, 3> corner{input.source(side[0]), input.source(side[1]),
                                             input.source(side[2])};
    put(result, v, internal::linear_value(value, corner, weight, 3));
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERPOLATION_H
