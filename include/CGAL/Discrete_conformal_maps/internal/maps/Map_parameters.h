// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_PARAMETERS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_PARAMETERS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Layout.h>
#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/Vertex_condition.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Cone_choice.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>

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
  typedef internal_np::vertex_condition_map_t Tag;
  std::vector<Vertex_condition> result(mesh.num_vertices());
  if constexpr(Intrinsic_triangulations::internal::has_parameter<NamedParameters, Tag>()) {
    std::size_t number = 0;
    for(auto v : vertices(g))
      result[number++] = get(CGAL::parameters::get_parameter(np, Tag()), v);
  } else
    for(Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v) && mesh.is_border(v))
        result[v.idx()] = on_boundary;
  return result;
}

// Stores the named parameters of maps, in types that do not depend on the types of the arguments.
// So the algorithms are compiled once.
struct Map_parameters
{
  std::vector<Vertex_condition> conditions; // by the vertices of the surface
  std::vector<double> log_scale;            // to start from
  std::vector<double> radii;                // of circles, if there are any
  Cone_choice cones{};
  Flipping flipping = Flipping::to_Delaunay;
  bool has_exact_decisions = false;
  Any_minimizer minimizer; // empty for a `Newton_minimizer`
  Intrinsic_triangulations::Concurrency concurrency;
  Layout layout = Layout::least_squares;
  std::size_t number_of_rounds = 100; // in which angles become the angles of a circle
  std::vector<char> is_corner;        // of a rectangle, by the vertices of the surface
};

// Returns the values of the property map that named parameters have for `Tag`, if they have one.
template <typename Tag, typename Graph, typename NamedParameters>
std::vector<double> vertex_values([[maybe_unused]] const Graph& g,
                                  [[maybe_unused]] const NamedParameters& np)
{
  std::vector<double> result;
  if constexpr(Intrinsic_triangulations::internal::has_parameter<NamedParameters, Tag>())
    for(auto v : vertices(g))
      result.push_back(get(CGAL::parameters::get_parameter(np, Tag()), v));
  return result;
}

// Returns the parameters of a map of `g`, whose triangulation is `surface`. Unless conditions are
// given, vertices on the boundary have the condition `on_boundary`.
template <typename Graph, typename NamedParameters>
Map_parameters map_parameters(const Graph& g, const Delta_complex& surface,
                              const NamedParameters& np, const Vertex_condition& on_boundary)
{
  namespace IT = Intrinsic_triangulations;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Map_parameters result;
  result.conditions = vertex_conditions(g, surface, np, on_boundary);
  result.log_scale = vertex_values<internal_np::initial_log_scale_map_t>(g, np);
  result.log_scale.resize(surface.num_vertices(), 0);
  result.radii = vertex_values<internal_np::vertex_radius_map_t>(g, np);
  result.cones = cone_choice(false, np);
  result.flipping =
    choose_parameter(get_parameter(np, internal_np::flipping), Flipping::to_Delaunay);
  result.has_exact_decisions =
    choose_parameter(get_parameter(np, internal_np::exact_decisions), false);
  if constexpr(IT::internal::has_parameter<NamedParameters, internal_np::minimizer_t>())
    result.minimizer = get_parameter(np, internal_np::minimizer);
  result.concurrency = IT::concurrency_of(np);
  result.layout = choose_parameter(get_parameter(np, internal_np::layout), Layout::least_squares);
  result.number_of_rounds = static_cast<std::size_t>(
    choose_parameter(get_parameter(np, internal_np::number_of_iterations), 100));
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_MAP_PARAMETERS_H
