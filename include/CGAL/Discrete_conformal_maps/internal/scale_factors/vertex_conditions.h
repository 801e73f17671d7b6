// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_VERTEX_CONDITIONS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_VERTEX_CONDITIONS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Vertex_condition.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the conditions at the vertices of `g`, by their indices. By default they are flat inside,
// and `on_boundary` on the boundary.
template <typename Graph, typename NamedParameters>
std::vector<Vertex_condition> vertex_conditions(const Graph& g, const Delta_complex& mesh,
                                                const NamedParameters& np,
                                                const Vertex_condition& on_boundary)
{
  using CGAL::parameters::get_parameter;
  std::vector<Vertex_condition> result(mesh.num_vertices());
  constexpr bool has_map =
    !CGAL::parameters::is_default_parameter<NamedParameters,
                                            internal_np::vertex_condition_map_t>::value;
  if constexpr(has_map) {
    std::size_t number = 0;
    for(auto v : vertices(g))
      result[number++] = get(get_parameter(np, internal_np::vertex_condition_map), v);
  } else
    for(Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v) && mesh.is_border(v))
        result[v.idx()] = on_boundary;
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_VERTEX_CONDITIONS_H
