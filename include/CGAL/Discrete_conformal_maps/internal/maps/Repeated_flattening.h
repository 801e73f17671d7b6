// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_REPEATED_FLATTENING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_REPEATED_FLATTENING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/maps/Flattening.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/Map_parameters.h>
#include <CGAL/Discrete_conformal_maps/internal/maps/with_digits_as_needed.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Vertex_circles.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Flattens a surface, with other digits at each call. Calls share their limit of work. Scale
// factors that one call has found with bounded differences are the start of the next one.
template <typename Shape>
class Repeated_flattening
{
  typedef Intrinsic_triangulations::Intrinsic_triangulation<> Surface;

public:
  Repeated_flattening(const Surface& input, const Map_parameters& parameters, Any_visitor& visitor)
    : m_first_shape(input, parameters),
      m_shape(m_first_shape),
      m_parameters(parameters),
      m_circles(parameters.radii),
      m_visitor(visitor),
      m_work(std::make_shared<Search_work>(has_start() ? tolerance::parts_of_work_from_start : 1))
  {}

  bool has_circles() const { return m_circles.exist(); }

  // Returns the map. The start may be too imprecise for needles, or too far from the map: if it
  // leads to no map, the search restarts without it.
  Planar_conformal_map operator()(const Surface& surface, Exactness exactness)
  {
    const bool is_resumed = !m_found.empty();
    auto map = flattened(surface, exactness);
    if(map.status() == Map_status::success || !(is_resumed || may_have_misled(map)))
      return map;
    m_found.clear();
    m_shape = m_first_shape;
    if(!is_resumed)
      forget_start();
    return flattened(surface, exactness);
  }

private:
  bool has_start() const
  {
    const std::vector<double>& u = m_parameters.log_scale;
    return std::any_of(u.begin(), u.end(), [](double x) { return x != 0; });
  }

  // Returns whether the start may be the reason for a failure. It is not if there is no map, or if
  // the minimizer of a caller allows few steps.
  bool may_have_misled(const Planar_conformal_map& map) const
  {
    return has_start() && map.status() != Map_status::no_minimum &&
           map.status() != Map_status::triangle_inequality &&
           (!m_parameters.minimizer ||
            map.minimization().status != Minimization_status::iteration_limit);
  }

  // Searches from scale factors of zero from now on, with the whole work of a search.
  void forget_start()
  {
    std::fill(m_parameters.log_scale.begin(), m_parameters.log_scale.end(), 0);
    m_work = std::make_shared<Search_work>();
  }

  Planar_conformal_map flattened(Surface surface, Exactness exactness)
  {
    m_shape.prescribe(m_parameters.conditions);
    Doubled_problem problem(std::move(surface), m_parameters.conditions, m_parameters.flipping,
                            exactness, m_circles);
    problem.set_concurrency(m_parameters.concurrency);
    problem.share_work(m_work);
    Flattening flattening(problem, m_visitor);
    flattening.start_from(m_parameters.log_scale);
    flattening.resume(m_found);
    Shape shape = m_shape;
    flattening.attempt([&] {
      shape.solve(problem, flattening, [&] {
        flattening.find_scale_factors(minimizer_of(m_parameters), m_parameters.cones);
      });
    });
    m_found = flattening.found_with_bounds();
    m_shape = m_found.empty() ? m_first_shape : shape;
    return flattening.finish(Named_layout{m_parameters.layout}, shape);
  }

  const Shape m_first_shape;
  Shape m_shape; // with the scale factors that were found
  Map_parameters m_parameters;
  Vertex_circles m_circles;
  Any_visitor& m_visitor;
  std::vector<Double_double> m_found;
  std::shared_ptr<Search_work> m_work;
};

template <typename Shape, typename Visitor>
Planar_conformal_map flattened(Intrinsic_triangulations::Intrinsic_triangulation<> input,
                               Map_parameters parameters, Visitor visitor)
{
  Repeated_flattening<Shape> find(input, parameters, visitor);
  if(!parameters.has_exact_decisions)
    return with_digits_as_needed(std::move(input), find, !find.has_circles());
  if(find.has_circles())
    throw Intrinsic_triangulations::Invalid_input("decisions about circles cannot be exact");
  return find(input, Exactness::decisions);
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MAPS_REPEATED_FLATTENING_H
