// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WITHOUT_CONES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WITHOUT_CONES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Abstract_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Cone_placement.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Scale_bounds.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Symmetric_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/component_areas.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

typedef Symmetric_energy<Conformal_energy<double, Flat_triangle<double>>> Flat_energy;

template <typename FT>
Symmetric_energy<Conformal_energy<FT, Flat_triangle<FT>>> flat_energy(Doubled_problem& problem)
{
  return symmetric_energy<FT, Flat_triangle<FT>>(problem, problem.triangulation());
}

// Returns scale factors after the normalization of the map: components without prescribed scale
// factors keep their area. If their area is out of range, zero is in the middle instead.
inline Eigen::VectorXd normalized(const Eigen::VectorXd& u, Doubled_problem& problem,
                                  const Scale_bounds& bounds)
{
  const std::vector<std::size_t> fixed = problem.number_of_fixed();
  if(std::count(fixed.begin(), fixed.end(), 0) == 0)
    return u;
  Eigen::VectorXd result = bounds.centered(u);
  try {
    Flat_energy energy = flat_energy<double>(problem);
    energy.evaluate(u);
    const auto& Delaunay = problem.triangulation();
    const auto& scaled = energy.energy();
    const std::vector<double> curved = component_areas(
                                problem, Delaunay.mesh(),
                                [&](Halfedge_index h) { return Delaunay.length(Edge_index(h)); }),
                              flat =
                                component_areas(problem, scaled.surface().mesh(),
                                                [&](Halfedge_index h) { return scaled.length(h); });
    for(std::size_t v = 0; v < problem.size(); ++v)
      if(const std::size_t c = problem.components()[v]; fixed[c] == 0)
        if(const double change = std::log(curved[c] / flat[c]) / 2; std::isfinite(change))
          result[Eigen::Index(v)] = u[Eigen::Index(v)] + change;
  } catch(const Intrinsic_triangulations::Error&) { // lengths are out of range
  }
  return result;
}

// Finds the components with estimates out of bounds whose scale factors are within bounds without
// cones. Estimates are much too great on rough surfaces. Components that need cones are left out.
class Search_without_cones
{
  typedef Eigen::VectorXd Vector;

public:
  Search_without_cones(Doubled_problem& problem, const Scale_bounds& bounds, Flat_energy& energy,
                       double bound)
    : m_problem(problem),
      m_bounds(bounds),
      m_energy(energy),
      m_bound(bound),
      m_is_found(problem.components().size(), 0)
  {}

  // Returns for each component whether it has been found.
  const std::vector<char>& components() const { return m_is_found; }
  // Returns scale factors at the minimum on these components.
  const Vector& log_scale() const { return m_log_scale; }
  const Minimization_result& minimization() const { return m_minimization; }

  // Searches from scale factors `start`, and ends if all components are certainly out of bounds.
  // `placement` has the estimates.
  void run(Cone_placement& placement, const Minimization_domain& domain, const Vector& start,
           Any_visitor& visitor)
  {
    m_is_open = components_in_question(placement.estimate());
    if(std::count(m_is_open.begin(), m_is_open.end(), 1) == 0)
      return;
    const Shared_order order = *m_problem.order(); // the order of further searches
    try {
      if(!estimates_are_right(placement) && finds_minimum(domain, start, visitor)) {
        const std::vector<char> is_beyond =
          m_bounds.components_beyond(m_bound, normalized(m_log_scale, m_problem, m_bounds));
        for(std::size_t c = 0; c < m_is_open.size(); ++c)
          m_is_found[c] = m_is_open[c] && !is_beyond[c];
      }
    } catch(const Intrinsic_triangulations::Error&) { // the estimates decide
    }
    *m_problem.order() = order;
  }

private:
  // Returns for each component whether it needs no cones, but would get some by its estimate.
  std::vector<char> components_in_question(const Vector& estimate) const
  {
    const std::vector<double> excess = m_problem.curvature_excess();
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    std::vector<char> result = m_bounds.components_beyond(m_bound, estimate);
    for(std::size_t c = 0; c < result.size(); ++c)
      result[c] =
        fixed[c] >= Doubled_problem::needed_cones(excess[c]) &&
        (fixed[c] > 0 ? result[c] != 0 : m_bounds.farthest_from_mean(c, estimate).second > m_bound);
    return result;
  }

  // Returns whether the scale factors at the minimum are certainly out of bounds. The distance of
  // the minimum is less than twice the last step.
  bool are_beyond(const Vector& u, double step) const
  {
    const std::vector<char> is_beyond =
      m_bounds.components_beyond(m_bound + 2 * step, m_bounds.centered(u));
    return std::equal(m_is_open.begin(), m_is_open.end(), is_beyond.begin(),
                      [](char open, char beyond) { return !open || beyond; });
  }

  // Returns whether a further step with the same factorization shows that the estimates are good,
  // and certainly out of bounds.
  bool estimates_are_right(Cone_placement& placement)
  {
    if(m_problem.has_prescribed_scale())
      return false;
    const Vector& estimate = placement.estimate();
    const Vector gradient = gradient_at(estimate), step = placement.step(gradient),
                 corrected = estimate + step;
    return max_norm(step) <= tolerance::step_at_start &&
           max_norm(gradient_at(corrected)) < max_norm(gradient) &&
           are_beyond(corrected, 2 * max_norm(step));
  }

  // Returns the gradient on the components in question.
  Vector gradient_at(const Vector& u)
  {
    Vector result = m_energy.free_gradient_at(u);
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(!m_is_open[m_problem.components()[v]])
        result[Eigen::Index(v)] = 0;
    return result;
  }

  // Returns whether the minimum on the components in question is found before they are certainly
  // out of bounds.
  bool finds_minimum(Minimization_domain domain, const Vector& start, Any_visitor& visitor)
  {
    m_log_scale = start;
    domain.is_fixed.resize(m_problem.size(), 0);
    for(std::size_t v = 0; v < m_problem.size(); ++v) {
      if(m_problem.is_fixed()[v])
        m_log_scale[Eigen::Index(v)] = m_problem.scale_factor(v);
      domain.is_fixed[v] |= !m_is_open[m_problem.components()[v]];
    }
    Energy_reference<Flat_energy> any_energy(m_energy);
    const auto minimizer = Newton_minimizer().ending_where(
      [this](const Vector& u, double step) { return are_beyond(u, step); });
    m_minimization = minimizer(any_energy, m_log_scale, domain, visitor);
    return m_minimization.status == Minimization_status::converged;
  }

  Doubled_problem& m_problem;
  const Scale_bounds& m_bounds;
  Flat_energy& m_energy;
  double m_bound;
  std::vector<char> m_is_open, m_is_found; // of each component
  Vector m_log_scale;
  Minimization_result m_minimization;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SEARCH_WITHOUT_CONES_H
