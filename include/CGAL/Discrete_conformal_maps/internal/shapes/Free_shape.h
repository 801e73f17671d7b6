// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FREE_SHAPE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FREE_SHAPE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>

#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

class Flattening;

// Represents the boundary of a surface without prescribed shape.
struct Free_shape
{
  Free_shape() = default;
  Free_shape(const Intrinsic_triangulations::Intrinsic_triangulation<>& /* surface */,
             const Map_parameters& /* parameters */)
  {}

  // Changes the conditions of vertices on the boundary as the shape requires.
  void prescribe(std::vector<Vertex_condition>& /* conditions */) const {}

  // Calls `find()`, which finds the scale factors, until the conditions of the problem are final.
  template <typename Find>
  void solve(Doubled_problem& /* problem */, Flattening& /* flattening */, const Find& find)
  {
    find();
  }

  // Returns further promises about a map, for components whose charts are whole.
  std::vector<Map_promise> promises(const Planar_conformal_map& /* map */,
                                    const std::vector<char>& /* is_whole */) const
  {
    return {};
  }
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SHAPES_FREE_SHAPE_H
