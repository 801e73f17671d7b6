// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_HYPERBOLIC_SCALE_FACTORS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_HYPERBOLIC_SCALE_FACTORS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Hyperbolic_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Scale_factors.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/component_areas.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns variables that all vertices of a component share. With them, small hyperbolic triangles
// would have the area of the component by Gauss and Bonnet. Circles have tanh(R/2) of at most one
// half.
inline Eigen::VectorXd hyperbolic_start(const Doubled_problem& problem)
{
  const auto& t = problem.triangulation();
  const std::vector<double> target = problem.curvature_excess(),
                            area = component_areas(
                              problem, t.mesh(),
                              [&](Halfedge_index h) { return t.length(Edge_index(h)); }),
                            radii = problem.radii<double>();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(Eigen::Index(problem.size()));
  for(std::size_t v = 0; v < problem.size(); ++v) {
    double& w = result[Eigen::Index(v)];
    // A length l = sinh(x/2) is half of x for small x.
    if(const std::size_t c = problem.components()[v]; target[c] > 0 && area[c] > 0)
      w = std::log(target[c] / (4 * area[c])) / 2;
    if(!radii.empty())
      w = (std::min)(w, -std::log(2 * radii[v]));
  }
  return result;
}

// Computes the scale factors of a doubled problem with hyperbolic faces. With circles, they follow
// from the variables of the energy.
class Hyperbolic_scale_factors : public Scale_factors<Hyperbolic_triangle>
{
  typedef Scale_factors<Hyperbolic_triangle> Base;

public:
  // Prepares the search.
  // \throws Invalid_input if a prescribed scale factor makes a circle too large
  explicit Hyperbolic_scale_factors(Doubled_problem& problem)
    : Base(problem, hyperbolic_start(problem)), m_problem(problem)
  {
    const std::vector<double> radii = problem.radii<double>();
    for(std::size_t v = 0; v < problem.size(); ++v)
      if(const Vertex_index w = problem.originals()[v];
         has_circle(w, radii) && problem.is_fixed()[v])
        prescribe_variable(w, radii[v]);
  }

  Eigen::VectorXd values() const
  {
    const std::vector<double> u = scale_factors(
      std::vector<double>(Base::values().data(), Base::values().data() + Base::values().size()));
    return Eigen::Map<const Eigen::VectorXd>(u.data(), Eigen::Index(u.size()));
  }

  template <typename FT>
  std::vector<FT> precise_values() const
  {
    return scale_factors(Base::precise_values<FT>());
  }

  template <typename FT, typename Visitor>
  std::vector<FT> refine(const Doubled_problem::Triangulation& triangulation, Visitor& visitor)
  {
    return scale_factors(Base::refine<FT>(triangulation, visitor));
  }

private:
  // Returns whether a vertex with faces has a circle.
  template <typename FT>
  bool has_circle(Vertex_index v, const std::vector<FT>& radii) const
  {
    return !radii.empty() && radii[v.idx()] > 0 && !m_problem.is_isolated(v);
  }

  void prescribe_variable(Vertex_index v, double radius)
  {
    const double u = m_problem.scale_factor(v.idx());
    if(!(2 * radius * std::exp(u) < 1))
      throw Intrinsic_triangulations::Invalid_input(
        "with the prescribed scale factor, the circle at vertex " + std::to_string(v.idx()) +
        " is too large for the hyperbolic plane");
    m_problem.set_condition(
      v, Vertex_condition::log_scale(Hyperbolic_triangle<double>::variable(u, radius)));
  }

  template <typename FT>
  std::vector<FT> scale_factors(std::vector<FT> variables) const
  {
    const std::vector<FT> radii = m_problem.radii<FT>();
    for(std::size_t v = 0; v < variables.size(); ++v)
      if(has_circle(m_problem.originals()[v], radii))
        variables[v] = Hyperbolic_triangle<FT>::log_scale(variables[v], radii[v]);
    return variables;
  }

  Doubled_problem& m_problem;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_HYPERBOLIC_SCALE_FACTORS_H
