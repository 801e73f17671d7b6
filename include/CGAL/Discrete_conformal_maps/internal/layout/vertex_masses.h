// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_VERTEX_MASSES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_VERTEX_MASSES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Limits the shares of vertices of the total mass of the double. A center of mass exists if every
// share is less than a half. Loops of the triangulation can give one vertex more. Then all masses
// increase by the same number, so that this vertex has `greatest_share`.
inline void limit_shares(std::vector<double>& mass, const Doubled_problem& problem)
{
  constexpr double greatest_share = 0.45;
  double total = 0, points = 0;
  for(Vertex_index v : problem.surface().vertices())
    if(!problem.surface().is_isolated(v)) {
      total += problem.number_of_copies(v.idx()) * mass[v.idx()];
      points += problem.number_of_copies(v.idx());
    }
  const double greatest = *std::max_element(mass.begin(), mass.end());
  const double excess = greatest - greatest_share * total;
  if(!(excess > 0))
    return;
  const double addition = excess / (greatest_share * points - 1);
  for(Vertex_index v : problem.surface().vertices())
    if(!problem.surface().is_isolated(v))
      mass[v.idx()] += addition;
}

// Returns the mass of each vertex of the surface. It is a third of the total area of its faces in
// the double, before `limit_shares()`.
inline std::vector<double> vertex_masses(const Doubled_problem& problem)
{
  const auto& triangulation = problem.triangulation();
  const Delta_complex& mesh = problem.surface();
  std::vector<double> result(mesh.num_vertices(), 0);
  for(Face_index f : mesh.faces()) {
    const auto side = sides(f, mesh);
    const auto length = [&](std::size_t s) {
      return triangulation.input_length(mesh.edge(side[s]));
    };
    const double area = std::sqrt(Intrinsic_triangulations::squared_quadrupled_area(
                          length(0), length(1), length(2))) /
                        4;
    for(Halfedge_index h : side)
      result[mesh.target(h).idx()] += area / (3 * problem.part(mesh.target(h).idx()));
  }
  limit_shares(result, problem);
  return result;
}

// Returns candidates for the vertex at infinity, the best one first. Vertices with large masses are
// the best ones, because all other vertices are visible from them. If the surface has a boundary,
// only boundary vertices are candidates.
inline std::vector<Vertex_index> vertices_at_infinity(const Doubled_problem& problem,
                                                      const std::vector<double>& mass)
{
  std::vector<Vertex_index> all, on_boundary;
  for(Vertex_index v : problem.surface().vertices()) {
    if(!problem.surface().is_isolated(v))
      all.push_back(v);
    if(problem.is_on_boundary(v))
      on_boundary.push_back(v);
  }
  std::vector<Vertex_index>& result = on_boundary.empty() ? all : on_boundary;
  std::stable_sort(result.begin(), result.end(),
                   [&](Vertex_index v, Vertex_index w) { return mass[v.idx()] > mass[w.idx()]; });
  return result;
}

// Returns whether the surface has an interior vertex.
inline bool has_vertices_inside(const Doubled_problem& problem)
{
  const auto vertices = problem.surface().vertices();
  return std::any_of(vertices.begin(), vertices.end(), [&](Vertex_index v) {
    return !problem.surface().is_isolated(v) && !problem.is_on_boundary(v);
  });
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_VERTEX_MASSES_H
