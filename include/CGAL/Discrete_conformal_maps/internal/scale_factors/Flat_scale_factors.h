// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_SCALE_FACTORS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_SCALE_FACTORS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Cone_choice.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Cone_exchange.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Cone_placement.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Scale_bounds.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Scale_factors.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Search_without_cones.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the scale factors of a doubled problem with flat faces, and the cones that it needs.
class Flat_scale_factors : public Scale_factors<Flat_triangle>
{
  typedef Eigen::VectorXd Vector;

public:
  explicit Flat_scale_factors(Doubled_problem& problem)
    : Scale_factors<Flat_triangle>(problem, Vector::Zero(Eigen::Index(problem.size()))),
      m_problem(problem),
      m_bounds(problem),
      m_has_no_cones(problem.components().size(), 0)
  {}

  const std::vector<Vertex_index>& cones() const { return m_cones; }

  // Places cones until a linear estimate of the scale factors lies within a bound. Components whose
  // scale factors lie within it without cones get none.
  void place_cones(const Cone_choice& choice, Any_visitor& visitor)
  {
    if(m_problem.has_needles())
      place_cones<Decimal_115>(choice, visitor);
    else
      place_cones<double>(choice, visitor);
  }
  template <typename FT>
  void place_cones(const Cone_choice& choice, Any_visitor& visitor)
  {
    const double bound = choice.maximum_log_scale;
    auto energy = flat_energy<FT>(m_problem);
    energy.evaluate(Vector::Zero(Eigen::Index(m_problem.size())));
    const Vector at_zero = energy.gradient();
    Cone_placement placement(energy.Hessian(), with_pins(), m_problem.components(),
                             m_problem.order());
    placement.estimate(balanced(at_zero));
    if constexpr(std::is_same_v<FT, double>)
      find_components_without_cones(energy, placement, bound, visitor);
    place_first_cones(placement, bound);
    placement.estimate(balanced(at_zero));
    for(std::size_t c; (c = worst_component(placement.estimate(), bound)) != none;) {
      const std::size_t v = placement.worst(c, m_bounds.may_be_cone());
      placement.add(v);
      add_cone(v);
    }
    if(choice.is_exchanged)
      exchange_cones(placement, balanced(at_zero), bound);
    if constexpr(std::is_same_v<FT, double>)
      start_from_estimate(energy, m_problem.free_part(at_zero), placement, bound);
  }

  // Makes the vertex with the greatest scale factor a cone if it is out of bounds. Returns whether
  // it does. With needles, all scale factors start from zero. Otherwise, a cone beside near
  // vertices would move relatively far from them, so that their angles would be lost.
  bool add_cone_if_beyond(double bound)
  {
    const std::size_t v = m_bounds.vertex_beyond(bound, normalized(values(), m_problem, m_bounds));
    if(v == none)
      return false;
    if(m_problem.has_needles()) {
      add_cone(v);
      start_from(std::vector<double>(m_problem.size(), 0));
    } else if(m_problem.flipping() == Flipping::none || is_extended() || is_wide() ||
              !start_with_cone(v, bound))
      add_cone(v);
    return true;
  }

  // Returns `minimizer`, or Newton's method with an earlier end. It ends when the scale factors of
  // the minimum are certainly out of bounds, so that a cone can be added. The distance of the
  // minimum is less than half of the last step.
  Any_minimizer ending_beyond(double bound, const Any_minimizer& minimizer) const
  {
    const auto* newton = minimizer.target<Newton_minimizer>();
    if(!newton)
      return minimizer;
    return newton
      ->ending_where([this, bound](const Vector& change, double step) {
        return m_bounds.certainly_beyond(bound, values() + change, step) != none;
      })
      .correcting_steps(std::isfinite(bound) ? tolerance::corrections : 0);
  }

private:
  static constexpr std::size_t none = Scale_bounds::none;

  static Vertex_index vertex(std::size_t v)
  {
    return Vertex_index(static_cast<Delta_complex::size_type>(v));
  }

  void find_components_without_cones(Flat_energy& energy, Cone_placement& placement, double bound,
                                     Any_visitor& visitor)
  {
    Search_without_cones search(m_problem, m_bounds, energy, bound);
    search.run(placement, domain(), values(), visitor);
    m_has_no_cones = search.components();
    m_without_cones = search.log_scale();
    m_result = search.minimization().after(m_result);
  }

  // Returns the vertices with prescribed scale factors, and one of every component without them.
  std::vector<char> with_pins() const
  {
    std::vector<char> result = m_problem.is_fixed();
    std::vector<std::size_t> count = m_problem.number_of_fixed();
    for(std::size_t v = 0; v < result.size(); ++v)
      if(count[m_problem.components()[v]]++ == 0)
        result[v] = 1;
    return result;
  }

  void add_cone(std::size_t v)
  {
    m_problem.set_condition(vertex(v), Vertex_condition::log_scale(0));
    m_cones.push_back(vertex(v));
  }

  // Starts from the estimate, the first step of Newton's method from scale factors of zero, where
  // the energy has the gradient `at_zero`. If its slope lets the minimizer accept it, it need not
  // be computed again.
  void start_from_estimate(Flat_energy& energy, const Vector& at_zero, Cone_placement& placement,
                           double bound)
  {
    if(m_problem.flipping() == Flipping::none || !values().isZero(0) ||
       m_problem.has_prescribed_scale())
      return;
    Vector start = placement.estimate();
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_has_no_cones[m_problem.components()[v]])
        start[Eigen::Index(v)] = m_without_cones[Eigen::Index(v)];
    Free_variables(domain(), m_problem.size()).remove_means(start);
    const double slope = at_zero.dot(start);
    if(energy.free_gradient_at(start).dot(start) <= -slope / 2)
      start_near(start, energy, placement, bound);
  }

  // Makes `v` a cone, and starts from scale factors with the same curvatures elsewhere, to first
  // order. Leaves the others unchanged if their gradient is then less. Returns false if rounding
  // prevents the cone.
  bool start_with_cone(std::size_t v, double bound)
  {
    Flat_energy energy = flat_energy<double>(m_problem);
    energy.evaluate(values());
    try {
      Cone_placement placement(energy.Hessian(), with_pins(), m_problem.components(),
                               m_problem.order());
      placement.set_estimate(values());
      add_cone(v, placement);
      Vector unchanged = values();
      unchanged[Eigen::Index(v)] = 0;
      const double norm = max_norm(energy.free_gradient_at(unchanged));
      if(max_norm(energy.free_gradient_at(placement.estimate())) < norm)
        start_near(placement.estimate(), energy, placement, bound);
    } catch(const Intrinsic_triangulations::Numerical_error&) {
      return m_problem.is_fixed()[v];
    }
    return true;
  }

  // Removes and moves the cones that have been placed.
  void exchange_cones(Cone_placement& placement, const Vector& defect, double bound)
  {
    std::vector<std::vector<Eigen::Index>> cones(m_problem.components().size());
    for(Vertex_index v : std::exchange(m_cones, {})) {
      cones[m_problem.components()[v.idx()]].push_back(Eigen::Index(v.idx()));
      m_problem.set_condition(v, Vertex_condition::curvature(0));
    }
    std::vector<std::size_t> result;
    for(std::size_t c = 0; c < cones.size(); ++c)
      if(!cones[c].empty()) {
        if(cones[c].size() <= tolerance::exchanged_cones)
          cones[c] =
            Cone_exchange(exchangeable(c, m_problem, m_bounds, placement, defect), cones[c])
              .cones_within(bound);
        result.insert(result.end(), cones[c].begin(), cones[c].end());
      }
    for(std::size_t v : result)
      add_cone(v);
    placement.restart(result, defect);
  }

  void add_cone(std::size_t v, Cone_placement& placement)
  {
    if(m_problem.number_of_fixed()[m_problem.components()[v]] == 0)
      placement.move_to_first(v);
    else
      placement.add(v);
    add_cone(v);
  }

  // Starts from scale factors near `u`, at which the energy is evaluated, with a smaller gradient.
  // If lengths change little, the Laplacian changes little. On a smooth surface it hardly changes.
  // So the factorization of the placement finds them. Cones that are certainly needed are placed
  // meanwhile.
  void start_near(Vector u, Flat_energy& energy, Cone_placement& placement, double bound)
  {
    const Free_variables variables(domain(), m_problem.size());
    Vector gradient = m_problem.free_part(energy.gradient());
    double norm = max_norm(gradient);
    for(double ratio = 0; ratio <= tolerance::contraction_at_start;) {
      Vector step = placement.step(gradient);
      variables.remove_means(step);
      const double length = max_norm(step), slope = gradient.dot(step);
      if(!(length <= tolerance::step_at_start))
        break;
      gradient = energy.free_gradient_at(u + step);
      ratio = max_norm(gradient) / norm;
      if(!(ratio < 1 && gradient.dot(step) <= -slope / 2))
        break;
      u += step;
      norm *= ratio;
      const std::size_t v =
        ratio <= tolerance::contraction ? m_bounds.certainly_beyond(bound, u, length) : none;
      if(v != none) {
        placement.set_estimate(u);
        add_cone(v, placement);
        u = placement.estimate();
        gradient = energy.free_gradient_at(u);
        norm = max_norm(gradient);
      }
    }
    start_from({u.begin(), u.end()});
  }

  // Returns `defect`, with a sum of zero on components without prescribed scale factors.
  Vector balanced(Vector defect) const
  {
    const auto& component = m_problem.components();
    const std::vector<double> excess = m_problem.curvature_excess();
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    std::vector<double> size(component.size(), 0);
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      size[component[v]] += m_problem.number_of_copies(v);
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(fixed[component[v]] == 0)
        defect[Eigen::Index(v)] += m_problem.part(v) * excess[component[v]] / size[component[v]];
    return defect;
  }

  // Places a cone in each component without prescribed scale factors at the estimate farthest from
  // its mean value, unless it needs none.
  void place_first_cones(Cone_placement& placement, double bound)
  {
    const std::vector<double> excess = m_problem.curvature_excess();
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    for(std::size_t c = 0; c < fixed.size(); ++c)
      if(fixed[c] == 0 && !m_has_no_cones[c])
        place_first_cone(c, placement, excess[c], bound);
  }

  void place_first_cone(std::size_t c, Cone_placement& placement, double excess, double bound)
  {
    const auto [v, distance] = m_bounds.farthest_from_mean(c, placement.estimate());
    if(v != none && (Doubled_problem::needed_cones(excess) > 0 || distance > bound)) {
      placement.add_first(v);
      add_cone(v);
    }
  }

  // Returns a component with cones whose estimate is out of bounds, or that needs more cones.
  std::size_t worst_component(const Vector& estimate, double bound) const
  {
    const std::vector<double> excess = m_problem.curvature_excess();
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    for(std::size_t v = 0; v < m_problem.size(); ++v) {
      const std::size_t c = m_problem.components()[v];
      const double u = std::abs(estimate[Eigen::Index(v)]);
      if(m_bounds.may_be_cone()[v] && fixed[c] > 0 && !m_has_no_cones[c] &&
         (u > bound || (u > 0 && fixed[c] < Doubled_problem::needed_cones(excess[c]))))
        return c;
    }
    return none;
  }

  Doubled_problem& m_problem;
  Scale_bounds m_bounds;
  std::vector<char> m_has_no_cones; // of each component: whether it is known to need none
  Vector m_without_cones;           // scale factors of these components
  std::vector<Vertex_index> m_cones;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_SCALE_FACTORS_H
