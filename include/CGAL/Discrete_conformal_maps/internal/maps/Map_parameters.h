// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_PARAMETERS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_PARAMETERS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/Vertex_condition.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Cone_choice.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Vertex_circles.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/vertex_conditions.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>

#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// The named parameters of maps, in types that do not depend on the types of the arguments. The
// algorithms behind these parameters are compiled once.
struct Map_parameters
{
  std::vector<Vertex_condition> conditions; // by the vertices of the surface
  std::vector<double> log_scale;            // to start from
  Vertex_circles circles;
  Cone_choice cones{};
  Flipping flipping = Flipping::to_Delaunay;
  bool has_exact_decisions = false;
  Any_minimizer minimizer = Newton_minimizer();
  Intrinsic_triangulations::Concurrency concurrency;
};

// scale factors to start from
template <typename Graph, typename NamedParameters>
std::vector<double> initial_log_scales(const Graph& g, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  std::vector<double> result;
  for([[maybe_unused]] auto v : vertices(g))
    if constexpr(CGAL::parameters::is_default_parameter<
                   NamedParameters, internal_np::initial_log_scale_map_t>::value)
      result.push_back(0);
    else
      result.push_back(get(get_parameter(np, internal_np::initial_log_scale_map), v));
  return result;
}

// Returns the parameters of a map of `g`, whose triangulation is `surface`. Unless conditions are
// given, vertices on the boundary have the condition `on_boundary`.
template <typename Graph, typename NamedParameters>
Map_parameters map_parameters(const Graph& g, const Delta_complex& surface,
                              const NamedParameters& np, const Vertex_condition& on_boundary)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Map_parameters result;
  result.conditions = vertex_conditions(g, surface, np, on_boundary);
  result.log_scale = initial_log_scales(g, np);
  result.circles = vertex_circles(g, np);
  result.cones = cone_choice(false, np);
  result.flipping =
    choose_parameter(get_parameter(np, internal_np::flipping), Flipping::to_Delaunay);
  result.has_exact_decisions =
    choose_parameter(get_parameter(np, internal_np::exact_decisions), false);
  result.minimizer =
    choose_parameter(get_parameter(np, internal_np::minimizer), Newton_minimizer());
  result.concurrency = Intrinsic_triangulations::concurrency_of(np);
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_PARAMETERS_H
