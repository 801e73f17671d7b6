// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_UNFOLDED_SPHERE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_UNFOLDED_SPHERE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/Map_status.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Sphere_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/spherical_log_scales.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/stereographic_cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Partially_decorated_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Spherical_scale_factors.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// A sphere unfolded from one of its vertices, with more and more digits until the result is good.
class Unfolded_sphere
{
public:
  template <typename Visitor>
  Unfolded_sphere(Doubled_problem& problem, const std::vector<double>& mass,
                  Vertex_index at_infinity, Visitor& visitor)
    : m_problem(problem), m_mass(mass), m_at_infinity(at_infinity), m_log_scale(problem.size(), 0.)
  {
    try {
      unfold(visitor);
    } catch(const Intrinsic_triangulations::Numerical_error& e) {
      m_cause = e.what(); // what was taken before stays
    }
    if(m_number_of_edges != problem.triangulation().mesh().num_edges())
      m_position.clear(); // of a copy that has been made deeper since
  }

  // the message of the error that has ended the search for a good result; empty if none has
  const std::string& cause() const { return m_cause; }

  // whether there is any result
  bool is_laid_out() const { return !m_position.empty(); }
  Vertex_index vertex_at_infinity() const { return m_at_infinity; }
  // in the plane, after centering
  const std::vector<std::array<Extended, 2>>& positions() const { return m_position; }
  // the logarithmic scale factors of the polyhedron, at the vertices of the surface itself
  const std::vector<double>& values() const { return m_log_scale; }
  // from T^B to T^C
  const std::vector<Halfedge_index>& flips() const { return m_flips; }
  const Convexity_certificate& certificate() const { return m_certificate; }
  const Minimization_result& result() const { return m_minimization; }
  // in the plane, where all vertices are flat
  double max_curvature_error() const { return m_angle_error; }
  std::size_t bound_violations() const { return m_bound_violations; }
  bool is_extended() const { return m_is_extended; }

  // rounding alone stays far below that
  bool is_good() const
  {
    return is_certified() && m_cross_ratio_error <= tolerance::good_cross_ratio;
  }

  // of the search for scale factors
  Map_status status() const
  {
    return is_laid_out() ? Map_status::success : Map_status::not_converged;
  }

  double cross_ratio_error() const { return m_cross_ratio_error; }

  // Certified results come first, then those with less error.
  friend bool operator<(const Unfolded_sphere& a, const Unfolded_sphere& b)
  {
    return a.is_certified() != b.is_certified() ? a.is_certified()
                                                : a.m_cross_ratio_error < b.m_cross_ratio_error;
  }

private:
  template <typename Visitor>
  void unfold(Visitor& visitor)
  {
    visitor.start(Flattening_stage::optimize);
    Spherical_scale_factors<double> rounded(m_problem, m_at_infinity);
    rounded.minimize(tolerance::gradient, visitor);
    visitor.start(Flattening_stage::layout);
    store_scale_factors(rounded);
    if(is_good())
      return;
    visitor.start(Flattening_stage::optimize);
    Spherical_scale_factors<Extended> precise(m_problem, m_at_infinity);
    if(rounded.result().status != Minimization_status::not_finite)
      precise.set_start(rounded);
    precise.minimize(tolerance::extended_gradient, visitor);
    visitor.start(Flattening_stage::layout);
    store_scale_factors(precise);
  }

  bool is_certified() const
  {
    return is_laid_out() && m_certificate.is_convex() && m_bound_violations == 0;
  }

  template <typename FT>
  void store_scale_factors(const Spherical_scale_factors<FT>& scale)
  {
    const bool is_enough = scale.angle_error() <= tolerance::layout_angle &&
                           scale.result().gradient_error <= tolerance::layout_angle;
    if(is_enough || !is_laid_out()) {
      m_minimization = scale.result();
      m_angle_error = scale.angle_error();
    }
    if(!is_enough)
      return;
    std::vector<Halfedge_index> flips;
    do {
      Partially_decorated_surface<FT> surface(
        m_problem.triangulation().mesh(), m_problem.triangulation().length_map(), m_at_infinity);
      surface.scale(m_problem.expanded(scale.values()));
      flips = surface.flips();
      if(!m_problem.has_exceeded(flips))
        lay_out(surface, scale);
    } while(has_extended(flips));
  }

  bool has_extended(const std::vector<Halfedge_index>& flips)
  {
    if(!m_problem.has_exceeded(flips))
      return false;
    m_problem.extend(flips);
    return true;
  }

  // in `double` if that is enough
  template <typename FT>
  void lay_out(const Partially_decorated_surface<FT>& surface,
               const Spherical_scale_factors<FT>& scale)
  {
    if(std::is_same<FT, double>::value) {
      lay_out_in<double>(surface, scale);
      if(is_good())
        return;
    }
    lay_out_in<Extended>(surface, scale);
  }

  template <typename Position_FT, typename FT>
  void lay_out_in(const Partially_decorated_surface<FT>& surface,
                  const Spherical_scale_factors<FT>& scale)
  {
    const Delta_complex& mesh = surface.mesh();
    std::vector<Position_FT> length;
    for(Edge_index e : mesh.edges())
      length.push_back(Position_FT(surface.scaled_length(e)));
    const Sphere_layout<Position_FT> layout(mesh, length, m_at_infinity, m_mass, m_problem);
    m_is_extended = !std::is_same<Position_FT, double>::value;
    m_certificate = layout.certificate();
    m_flips = surface.flips();
    m_flips.insert(m_flips.end(), layout.flips().begin(), layout.flips().end());
    m_number_of_edges = mesh.num_edges();
    m_position.clear();
    for(const auto& p : layout.positions())
      m_position.push_back({Extended(p[0]), Extended(p[1])});
    m_log_scale = spherical_log_scales(scale.values(), Extended(layout.scale()), m_position,
                                       m_at_infinity, m_problem.surface());
    compare(layout.positions(), scale);
  }

  // Compares the result with the ideal polyhedron and the bounds.
  template <typename Point, typename FT>
  void compare(const std::vector<Point>& position, const Spherical_scale_factors<FT>& scale)
  {
    Ptolemy_surface<double> ideal(m_problem.triangulation().mesh(),
                                  m_problem.triangulation().length_map());
    ideal.replay(m_flips);
    const Delta_complex& mesh = ideal.mesh();
    m_cross_ratio_error = max_stereographic_cross_ratio_error(
      mesh, [&](Edge_index e) { return ideal.length(e); }, position, m_at_infinity);
    std::vector<char> is_wrong(m_problem.size(), 0);
    for(std::size_t v = 0; v < is_wrong.size(); ++v)
      is_wrong[v] = !(scale.values()[v] >= scale.bounds()[v]);
    for(Halfedge_index h : mesh.halfedges())
      if(const std::size_t v = m_problem.original(mesh.target(h)).idx();
         mesh.source(h) == m_at_infinity)
        is_wrong[v] |= scale.values()[v] - scale.bounds()[v] > tolerance::bound;
    m_bound_violations = std::size_t(std::count(is_wrong.begin(), is_wrong.end(), 1));
  }

  Doubled_problem& m_problem;
  const std::vector<double>& m_mass;
  Vertex_index m_at_infinity;
  std::vector<std::array<Extended, 2>> m_position;
  std::vector<double> m_log_scale;
  std::vector<Halfedge_index> m_flips;
  Convexity_certificate m_certificate;
  Minimization_result m_minimization;
  double m_angle_error = std::numeric_limits<double>::infinity();
  double m_cross_ratio_error = std::numeric_limits<double>::infinity();
  std::size_t m_bound_violations = 0;
  bool m_is_extended = false;
  std::size_t m_number_of_edges = 0; // of the triangulation that was laid out
  std::string m_cause;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_UNFOLDED_SPHERE_H
