// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_SCALE_FACTORS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_FLAT_SCALE_FACTORS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Abstract_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Cone_choice.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Cone_exchange.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Cone_placement.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Scale_bounds.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Scale_factors.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/component_areas.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
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
    auto energy = energy_at_zero<FT>();
    Cone_placement placement(energy->Hessian(), with_pins(), m_problem.components(),
                             m_problem.order());
    placement.estimate(balanced(energy->gradient()));
    if constexpr(std::is_same_v<FT, double>) {
      const auto copied_edges = [this] { return m_problem.triangulation().mesh().num_edges(); };
      const std::size_t before = copied_edges();
      find_components_without_cones(placement, bound, visitor);
      if(copied_edges() != before) // the second copy has been extended
        energy = energy_at_zero<FT>();
    }
    place_first_cones(placement, bound);
    placement.estimate(balanced(energy->gradient()));
    for(std::size_t c; (c = worst_component(placement.estimate(), bound)) != none;) {
      const std::size_t v = placement.worst(c, m_bounds.may_be_cone());
      placement.add(v);
      add_cone(v);
    }
    if(choice.is_exchanged)
      exchange_cones(placement, balanced(energy->gradient()), bound);
    if constexpr(std::is_same_v<FT, double>)
      start_from_estimate(*energy, placement, bound);
  }

  // Makes the vertex with the greatest scale factor a cone if it is out of bounds. Returns whether
  // it does. With needles, all scale factors start from zero. Otherwise, a cone beside near
  // vertices would move relatively far from them, so that their angles would be lost.
  bool add_cone_if_beyond(double bound)
  {
    const std::size_t v = m_bounds.vertex_beyond(bound, normalized(values()));
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

  // Returns the energy, evaluated at scale factors of zero.
  template <typename FT>
  auto energy_at_zero()
  {
    typedef Symmetric_energy<Conformal_energy<FT, Flat_triangle<FT>>> Energy_in_FT;
    auto result = std::make_unique<Energy_in_FT>(
      symmetric_energy<FT, Flat_triangle<FT>>(m_problem, m_problem.triangulation()));
    result->evaluate(Vector::Zero(Eigen::Index(m_problem.size())));
    return result;
  }

  // Finds the components with estimates out of bounds whose scale factors are within bounds
  // without cones. Estimates are much too great on rough surfaces. Components that need cones are
  // left out. The search ends if all others are certainly out of bounds.
  void find_components_without_cones(Cone_placement& placement, double bound, Any_visitor& visitor)
  {
    const std::vector<char> is_open = components_in_question(placement.estimate(), bound);
    if(std::count(is_open.begin(), is_open.end(), 1) == 0)
      return;
    // The distance of the minimum is less than twice the last step.
    const auto are_beyond = [&](const Vector& u, double step) {
      const std::vector<char> is_beyond =
        m_bounds.components_beyond(bound + 2 * step, m_bounds.centered(u));
      return std::equal(is_open.begin(), is_open.end(), is_beyond.begin(),
                        [](char open, char beyond) { return !open || beyond; });
    };
    const Shared_order order = *m_problem.order(); // the order of further searches
    try {
      if(const auto corrected = corrected_estimate(is_open, placement);
         corrected && are_beyond(corrected->first, 2 * corrected->second))
        return;
      if(const auto u = minimum_on(is_open, Newton_minimizer().ending_where(are_beyond), visitor)) {
        const std::vector<char> is_beyond = m_bounds.components_beyond(bound, normalized(*u));
        for(std::size_t c = 0; c < is_open.size(); ++c)
          m_has_no_cones[c] = is_open[c] && !is_beyond[c];
        m_without_cones = *u;
      }
    } catch(const Intrinsic_triangulations::Error&) { // the estimates decide
    }
    *m_problem.order() = order;
  }

  // Returns the estimates after a further step with the same factorization, and the length of this
  // step, if it shows that the estimates are good.
  std::optional<std::pair<Vector, double>> corrected_estimate(const std::vector<char>& components,
                                                              Cone_placement& placement)
  {
    if(has_prescribed_scale())
      return std::nullopt;
    Energy energy =
      symmetric_energy<double, Flat_triangle<double>>(m_problem, m_problem.triangulation());
    const auto gradient_on_components = [&](const Vector& u) {
      Vector result = gradient_at(u, energy);
      for(std::size_t v = 0; v < m_problem.size(); ++v)
        if(!components[m_problem.components()[v]])
          result[Eigen::Index(v)] = 0;
      return result;
    };
    const Vector& estimate = placement.estimate();
    const Vector gradient = gradient_on_components(estimate), step = placement.step(gradient),
                 result = estimate + step;
    if(!(max_norm(step) <= tolerance::step_at_start) ||
       !(max_norm(gradient_on_components(result)) < max_norm(gradient)))
      return std::nullopt;
    return std::pair(result, max_norm(step));
  }

  // Returns for each component whether it needs no cones, but would get some by its estimate.
  std::vector<char> components_in_question(const Vector& estimate, double bound) const
  {
    const std::vector<double> excess = m_problem.curvature_excess();
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    std::vector<char> result = m_bounds.components_beyond(bound, estimate);
    for(std::size_t c = 0; c < result.size(); ++c)
      result[c] =
        fixed[c] >= Doubled_problem::needed_cones(excess[c]) &&
        (fixed[c] > 0 ? result[c] != 0 : m_bounds.farthest_from_mean(c, estimate).second > bound);
    return result;
  }

  // Returns scale factors at the minimum on some components, if it is found, or where the minimizer
  // ends.
  template <typename Minimizer>
  std::optional<Vector> minimum_on(const std::vector<char>& components, const Minimizer& minimizer,
                                   Any_visitor& visitor)
  {
    Minimization_domain part = domain();
    part.is_fixed.resize(m_problem.size(), 0);
    Vector u = values();
    for(std::size_t v = 0; v < m_problem.size(); ++v) {
      if(m_problem.is_fixed()[v])
        u[Eigen::Index(v)] = m_problem.scale_factor(v);
      part.is_fixed[v] |= !components[m_problem.components()[v]];
    }
    Energy energy =
      symmetric_energy<double, Flat_triangle<double>>(m_problem, m_problem.triangulation());
    Energy_reference<Energy> any_energy(energy);
    const Minimization_result last = minimizer(any_energy, u, part, visitor);
    m_result = last.after(m_result);
    return last.status == Minimization_status::converged ? std::optional(u) : std::nullopt;
  }

  // Returns scale factors after the normalization of the map: components without prescribed scale
  // factors keep their area. If their area is out of range, zero is in the middle instead.
  Vector normalized(const Vector& u)
  {
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    if(std::count(fixed.begin(), fixed.end(), 0) == 0)
      return u;
    Vector result = m_bounds.centered(u);
    try {
      const auto& Delaunay = m_problem.triangulation();
      const std::vector<double> curved =
        component_areas(m_problem, Delaunay.mesh(),
                        [&](Halfedge_index h) { return Delaunay.length(Edge_index(h)); });
      Energy energy = symmetric_energy<double, Flat_triangle<double>>(m_problem, Delaunay);
      energy.evaluate(u);
      const auto& scaled = energy.energy();
      const std::vector<double> flat = component_areas(
        m_problem, scaled.surface().mesh(), [&](Halfedge_index h) { return scaled.length(h); });
      for(std::size_t v = 0; v < m_problem.size(); ++v)
        if(const std::size_t c = m_problem.components()[v]; fixed[c] == 0)
          if(const double change = std::log(curved[c] / flat[c]) / 2; std::isfinite(change))
            result[Eigen::Index(v)] = u[Eigen::Index(v)] + change;
    } catch(const Intrinsic_triangulations::Error&) { // lengths are out of range
    }
    return result;
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

  typedef Symmetric_energy<Conformal_energy<>> Energy;

  // Returns the gradient with respect to the variables.
  Vector free_gradient(const Energy& energy) const
  {
    Vector result = energy.gradient();
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_problem.is_fixed()[v])
        result[Eigen::Index(v)] = 0;
    return result;
  }
  Vector gradient_at(const Vector& u, Energy& energy) const
  {
    energy.evaluate(u);
    return free_gradient(energy);
  }

  // Starts from the estimate, the first step of Newton's method from scale factors of zero, at
  // which the energy is evaluated. If its slope lets the minimizer accept it, it need not be
  // computed again.
  void start_from_estimate(Energy& energy, Cone_placement& placement, double bound)
  {
    if(m_problem.flipping() == Flipping::none || !values().isZero(0) || has_prescribed_scale())
      return;
    Vector start = placement.estimate();
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_has_no_cones[m_problem.components()[v]])
        start[Eigen::Index(v)] = m_without_cones[Eigen::Index(v)];
    Free_variables(domain(), m_problem.size()).remove_means(start);
    const double slope = free_gradient(energy).dot(start);
    if(gradient_at(start, energy).dot(start) <= -slope / 2)
      start_near(start, energy, placement, bound);
  }

  // Makes `v` a cone, and starts from scale factors with the same curvatures elsewhere, to first
  // order. Leaves the others unchanged if their gradient is then less. Returns false if rounding
  // prevents the cone.
  bool start_with_cone(std::size_t v, double bound)
  {
    auto energy =
      symmetric_energy<double, Flat_triangle<double>>(m_problem, m_problem.triangulation());
    energy.evaluate(values());
    try {
      Cone_placement placement(energy.Hessian(), with_pins(), m_problem.components(),
                               m_problem.order());
      placement.set_estimate(values());
      add_cone(v, placement);
      Vector unchanged = values();
      unchanged[Eigen::Index(v)] = 0;
      const double norm = max_norm(gradient_at(unchanged, energy));
      if(max_norm(gradient_at(placement.estimate(), energy)) < norm)
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
  void start_near(Vector u, Energy& energy, Cone_placement& placement, double bound)
  {
    const Free_variables variables(domain(), m_problem.size());
    Vector gradient = free_gradient(energy);
    double norm = max_norm(gradient);
    for(double ratio = 0; ratio <= tolerance::contraction_at_start;) {
      Vector step = placement.step(gradient);
      variables.remove_means(step);
      const double length = max_norm(step), slope = gradient.dot(step);
      if(!(length <= tolerance::step_at_start))
        break;
      gradient = gradient_at(u + step, energy);
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
        gradient = gradient_at(u, energy);
        norm = max_norm(gradient);
      }
    }
    start_from({u.begin(), u.end()});
  }

  // Returns whether a scale factor other than zero is prescribed.
  bool has_prescribed_scale() const
  {
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_problem.scale_factor(v) != 0)
        return true;
    return false;
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
