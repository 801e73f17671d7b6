// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EDGE_LENGTHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EDGE_LENGTHS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/certificates/Ball.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/NT_converter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns a distance. Positions in single precision are exact, and their distances are not rounded
// to single precision.
template <typename FT, typename Point>
FT distance(const Point& p, const Point& q)
{
  typedef typename Kernel_traits<Point>::Kernel Kernel;
  if constexpr(std::is_same_v<typename Kernel::FT, float> && std::is_same_v<FT, double>) {
    typedef Simple_cartesian<double>::Point_3 Wide_point;
    return distance<double>(Wide_point(p.x(), p.y(), p.z()), Wide_point(q.x(), q.y(), q.z()));
  } else {
    const auto squared = typename Kernel::Compute_squared_distance_3()(p, q);
    return CGAL::sqrt(NT_converter<typename Kernel::FT, FT>()(squared));
  }
}

// Returns the root of an exact number, correct to a few units in the last place if it is rounded.
template <typename FT, typename K>
FT root_of(const K& square)
{
  if constexpr(std::is_floating_point_v<FT> && !std::is_floating_point_v<K>)
    return CGAL::sqrt(to_ball<FT>(square).x);
  else
    return CGAL::sqrt(FT(square));
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// computes the edge lengths of a mesh from the positions of its vertices. Complexity: linear.
///
/// \param g a model of `EdgeListGraph`
/// \param length a writable property map from the edges of `g` to a number type with square roots
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the positions of the vertices}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, g)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
template <typename Graph, typename LengthMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void compute_edge_lengths(const Graph& g, LengthMap length,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  typedef typename boost::property_traits<LengthMap>::value_type FT;
  const auto point = internal::vertex_points(g, np);
  for(auto e : edges(g))
    put(length, e, internal::distance<FT>(get(point, source(e, g)), get(point, target(e, g))));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EDGE_LENGTHS_H
