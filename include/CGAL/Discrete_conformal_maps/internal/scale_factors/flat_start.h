// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_START_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_START_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Scale_factors.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>

#include <set>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns a vertex and its neighbors in T_2, as vertices of the surface.
inline std::set<Vertex_index> closed_neighborhood(Vertex_index v, const Doubled_problem& problem)
{
  const Delta_complex& mesh = problem.triangulation().mesh();
  std::set<Vertex_index> result{problem.original(v)};
  for_each_outgoing_halfedge(
    v, mesh, [&](Halfedge_index h) { result.insert(problem.original(mesh.target(h))); });
  return result;
}

// Returns scale factors that make a sphere flat except at a vertex and its neighbors in T_2. These
// vertices share the curvature of 4 pi equally. The list is empty if rounding or limits keep the
// minimizer from them. Far from these vertices, the metric resembles the plane into which the
// sphere unfolds from the first one. No bounds hold for its scale factors, so that they are found
// even if limbs of the sphere are long. The problem has no prescribed curvatures, neither before
// nor afterwards.
inline std::vector<Double_double> flat_start(Doubled_problem& problem, Vertex_index at_infinity,
                                             Any_visitor& visitor)
{
  const std::set<Vertex_index> cones = closed_neighborhood(at_infinity, problem);
  double copies = 0;
  for(Vertex_index v : cones)
    copies += problem.number_of_copies(v.idx());
  if(!(copies > 2)) // a curvature is less than a full turn
    return {};
  const auto prescribe = [&](double curvature) {
    for(Vertex_index v : cones)
      problem.set_condition(v, Vertex_condition::curvature(problem.part(v.idx()) * curvature));
  };
  prescribe(4 * CGAL_PI / copies);
  Scale_factors<Flat_triangle> scale(problem, Eigen::VectorXd::Zero(Eigen::Index(problem.size())));
  scale.limit_work();
  bool is_found = false;
  try {
    scale.minimize(Newton_minimizer(tolerance::gradient, tolerance::steps_to_start),
                   tolerance::curvature_at_start, visitor);
    is_found = scale.status() == Map_status::success;
  } catch(const Intrinsic_triangulations::Error&) {
    // Searches without this start follow.
  }
  prescribe(0);
  return is_found ? scale.precise_values<Double_double>() : std::vector<Double_double>();
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_START_H
