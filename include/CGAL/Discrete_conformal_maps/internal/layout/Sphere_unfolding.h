// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SPHERE_UNFOLDING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SPHERE_UNFOLDING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Conformal_barycenter.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Stereographic_triangulation.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Unfolded_sphere.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Partially_decorated_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Spherical_scale_factors.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/flat_start.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/length_cross_ratios.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Names the purpose of an unfolded sphere.
enum class Unfolding_use
{
  map,
  rough_start,  // the start of a search, with few digits
  precise_start // the start of a search, with the digits of `Double_double`
};

// Unfolds a sphere from one of its vertices. Increases the number of digits until the result is
// good.
class Sphere_unfolding
{
public:
  // `mass` contains the mass of each vertex of the surface itself.
  Sphere_unfolding(Doubled_problem& problem, const std::vector<double>& mass,
                   Vertex_index at_infinity, Unfolding_use use = Unfolding_use::map)
    : m_problem(problem), m_mass(mass), m_at_infinity(at_infinity), m_use(use)
  {
    m_result.layout.at_infinity = at_infinity;
    m_result.log_scale.assign(problem.size(), 0.);
  }

  Unfolded_sphere run(Any_visitor& visitor)
  {
    try {
      unfold(visitor);
    } catch(const Intrinsic_triangulations::Error& e) {
      m_result.cause = e.what(); // an earlier result remains
    }
    if(m_version != m_problem.version()) {
      m_result.layout = Spherical_layout(); // the last layout belongs to a smaller copy
      m_result.layout.at_infinity = m_at_infinity;
    }
    return std::move(m_result);
  }

private:
  // Returns whether the result is good. The tolerance is far above rounding errors.
  bool is_good() const
  {
    return is_rough() ? m_result.layout.exists : m_result.is_good(tolerance::good_cross_ratio);
  }

  bool is_rough() const { return m_use == Unfolding_use::rough_start; }

  void unfold(Any_visitor& visitor)
  {
    if(m_problem.has_needles() && search_on_exact_surface(visitor))
      return;
    Spherical_scale_factors<double> rounded(m_problem, m_at_infinity);
    const bool is_found = search(
      rounded, is_rough() ? tolerance::gradient_without_circles : tolerance::gradient, visitor);
    if((is_found && m_use != Unfolding_use::precise_start) || m_problem.is_measured() || is_rough())
      return; // lengths of the exact surface or a better start follow
    if(!is_found && !is_near_minimum(rounded) && search_from_flat_start(visitor))
      return;
    Spherical_scale_factors<Double_double> precise(m_problem, m_at_infinity);
    if(rounded.result().status != Minimization_status::not_finite)
      precise.set_start(rounded);
    if(!search_with_more_digits(precise, visitor))
      search_beyond_range(visitor);
  }

  // Searches on the exact surface, whose needles have more digits. Beyond the range of
  // `Double_double`, numbers with a wide exponent are tried before `Decimal_115`, because their
  // steps cost less. Returns whether the result is good.
  bool search_on_exact_surface(Any_visitor& visitor)
  {
    Spherical_scale_factors<double> rounded(m_problem, m_at_infinity);
    visitor.start(Flattening_stage::optimize);
    rounded.minimize(tolerance::gradient, visitor);
    auto precise = near_start(rounded);
    if(descend(precise, tolerance::parts_of_work_for_sphere, visitor))
      return true;
    if(is_in_range(precise))
      return search_in_groups(precise, near_start(rounded), visitor);
    Spherical_scale_factors<Wide_number<Double_double>> wide(m_problem, m_at_infinity);
    return descend(wide, tolerance::parts_of_work, visitor) ||
           descend_with_most_digits(wide, visitor);
  }

  // Continues after a search that has found no good result. Unless it has ended close to a minimum,
  // groups of near vertices move first. Returns whether the result is good.
  bool search_in_groups(const Spherical_scale_factors<Double_double>& last,
                        Spherical_scale_factors<Double_double> start, Any_visitor& visitor)
  {
    if(is_near_minimum(last) || !start.move_groups(tolerance::parts_of_work_for_sphere, visitor))
      return descend_with_most_digits(last, visitor);
    return descend(start, tolerance::parts_of_work_for_sphere, visitor) ||
           descend_with_most_digits(start, visitor);
  }

  // Returns a start on the exact surface from a search in `double`, if this has not failed.
  Spherical_scale_factors<Double_double> near_start(const Spherical_scale_factors<double>& rounded)
  {
    Spherical_scale_factors<Double_double> result(m_problem, m_at_infinity);
    if(rounded.result().status != Minimization_status::not_finite)
      result.set_start_of_groups(rounded);
    return result;
  }

  // Returns whether a search has ended where its numbers have not exceeded their range.
  template <typename FT>
  static bool is_in_range(const Spherical_scale_factors<FT>& scale)
  {
    return std::isfinite(scale.result().gradient_norm);
  }

  // Returns whether a search has ended so close to a minimum that more digits lead to it.
  template <typename FT>
  static bool is_near_minimum(const Spherical_scale_factors<FT>& scale)
  {
    return scale.result().gradient_norm <= tolerance::curvature_near_minimum;
  }

  // Continues with the digits of `Decimal_115`, close to a minimum or else from an estimate. This
  // is the only search on surfaces beyond the range of `FT`, and may take long on them. Returns
  // whether the result is good.
  template <typename FT>
  bool descend_with_most_digits(const Spherical_scale_factors<FT>& precise, Any_visitor& visitor)
  {
    Spherical_scale_factors<Decimal_115> most_precise(m_problem, m_at_infinity);
    if(is_near_minimum(precise))
      most_precise.set_start(precise);
    return descend(most_precise,
                   is_in_range(precise) ? tolerance::parts_of_work_for_sphere
                                        : tolerance::parts_of_work,
                   visitor);
  }

  // Minimizes the energy of `scale`. Returns whether the result is good.
  template <typename FT>
  bool descend(Spherical_scale_factors<FT>& scale, double parts_of_work, Any_visitor& visitor)
  {
    visitor.start(Flattening_stage::optimize);
    scale.descend(parts_of_work, visitor);
    visitor.start(Flattening_stage::layout);
    store_scale_factors(scale);
    return is_good();
  }

  // Starts from a metric that is flat far from infinity. Only curvatures near infinity change
  // then, in few steps, even if scale factors are beyond the range of `double`. Returns whether the
  // result is good.
  bool search_from_flat_start(Any_visitor& visitor)
  {
    const std::vector<Double_double> flat = flat_start(m_problem, m_at_infinity, visitor);
    if(flat.empty())
      return false;
    Spherical_scale_factors<Wide_number<Double_double>> scale(m_problem, m_at_infinity);
    scale.set_start(flat);
    return descend(scale, tolerance::parts_of_work_from_start, visitor) ||
           (is_near_minimum(scale) && descend_with_most_digits(scale, visitor));
  }

  // Finds scale factors beyond the range of `double`. Returns whether the result is good.
  bool search_beyond_range(Any_visitor& visitor)
  {
    Spherical_scale_factors<Wide_number<double>> rounded(m_problem, m_at_infinity);
    visitor.start(Flattening_stage::optimize);
    rounded.minimize(tolerance::gradient, visitor);
    Spherical_scale_factors<Wide_number<Double_double>> precise(m_problem, m_at_infinity);
    precise.set_start(rounded);
    return search_with_more_digits(precise, visitor);
  }

  // Searches for scale factors up to rounding. If the search comes close to them, but not to a good
  // layout, it continues with the digits of `Decimal_115`. Returns whether the result is good.
  template <typename FT>
  bool search_with_more_digits(Spherical_scale_factors<FT>& scale, Any_visitor& visitor)
  {
    return search(scale, tolerance::extended_gradient, visitor) ||
           (is_near_minimum(scale) && descend_with_most_digits(scale, visitor));
  }

  // Searches for scale factors up to `tolerance`. Returns whether the result is good.
  template <typename FT>
  bool search(Spherical_scale_factors<FT>& scale, double tolerance, Any_visitor& visitor)
  {
    visitor.start(Flattening_stage::optimize);
    scale.minimize(tolerance, visitor);
    visitor.start(Flattening_stage::layout);
    store_scale_factors(scale);
    return is_good();
  }

  template <typename FT>
  void store_scale_factors(const Spherical_scale_factors<FT>& scale)
  {
    const double greatest =
      is_rough() ? tolerance::curvature_without_circles : tolerance::layout_angle;
    const bool is_enough =
      scale.angle_error() <= greatest && scale.result().gradient_error <= greatest;
    if(is_enough || !m_result.layout.exists) {
      m_result.minimization = scale.result();
      m_result.angle_error = scale.angle_error();
    }
    while(is_enough) {
      Partially_decorated_surface<FT> surface(
        m_problem.triangulation().mesh(),
        m_problem.template symmetric_lengths<FT>(m_problem.triangulation()), m_at_infinity);
      surface.scale(m_problem.expanded(scale.values()));
      if(!m_problem.has_exceeded(surface.flips()))
        return lay_out(surface, scale);
      m_problem.extend(surface.flips());
    }
  }

  // Lays out with as many digits as necessary.
  template <typename FT>
  void lay_out(const Partially_decorated_surface<FT>& surface,
               const Spherical_scale_factors<FT>& scale)
  {
    m_above_bound.clear();
    m_u.clear();
    m_result.in_plane.clear();
    for(std::size_t v = 0; v < m_problem.size(); ++v) {
      m_above_bound.push_back(static_cast<double>(scale.values()[v] - scale.bounds()[v]));
      m_u.push_back(static_cast<double>(scale.values()[v]));
      m_result.in_plane.push_back(
        {converted<Double_double>(scale.values()[v]), m_above_bound.back() == 0});
    }
    if(std::is_same<FT, double>::value && is_good_in<double>(surface))
      return;
    if(!is_good_in<Double_double>(surface) && !std::is_same<FT, double>::value)
      lay_out(surface.mesh(), surface.flips(), lengths<Decimal_1500>(surface));
  }

  // Lays out the sphere with numbers of this type. Returns whether the result is good.
  template <typename Position_FT, typename FT>
  bool is_good_in(const Partially_decorated_surface<FT>& surface)
  {
    try {
      lay_out(surface.mesh(), surface.flips(), lengths<Position_FT>(surface));
    } catch(const Intrinsic_triangulations::Numerical_error& e) {
      m_result.cause = e.what();
    }
    return is_good();
  }

  // Returns the scaled lengths of the edges.
  template <typename Length, typename FT>
  static std::vector<Length> lengths(const Partially_decorated_surface<FT>& surface)
  {
    std::vector<Length> result;
    for(Edge_index e : surface.mesh().edges())
      result.push_back(converted<Length>(surface.scaled_length(e)));
    return result;
  }

  // Lays out the vertices in the plane. After the inverse stereographic projection, the center of
  // mass of the vertices is the center of the sphere, and the triangulation is convex. `mesh` is
  // the triangulation after `flips`.
  template <typename FT>
  void lay_out(const Delta_complex& mesh, const std::vector<Halfedge_index>& flips,
               const std::vector<FT>& length)
  {
    auto position = Plane_layout<FT>(mesh, length, m_at_infinity, m_problem).positions();
    const FT plane_scale = center(position);
    for(Vertex_index v : mesh.vertices())
      if(mesh.is_isolated(v))
        position[v.idx()] = {FT(0), FT(0)};
    Stereographic_triangulation<FT> triangulation(mesh, position, m_at_infinity);
    const std::vector<Halfedge_index> to_convex = triangulation.make_convex();
    Spherical_layout& layout = m_result.layout;
    layout.exists = true;
    layout.is_extended = !std::is_same<FT, double>::value;
    layout.certificate = triangulation.certificate();
    layout.in_plane = in_range_of_squares(position);
    m_version = m_problem.version();
    m_result.flips = flips;
    m_result.flips.insert(m_result.flips.end(), to_convex.begin(), to_convex.end());
    m_result.log_scale =
      spherical_log_scales(m_u, plane_scale, position, m_at_infinity, m_problem.surface());
    if(!is_rough())
      compare(position);
  }

  // Moves the center of mass of all vertices to the center of the sphere. Returns the factor by
  // which the plane is scaled down. The mirror images of the vertices of a disk have masses, too,
  // so that the real line remains the axis of the disk.
  template <typename Point>
  auto center(std::vector<Point>& points) const
  {
    std::vector<double> mass = m_mass;
    std::vector<Point> position(points.begin(), points.begin() + std::ptrdiff_t(mass.size()));
    for(Vertex_index v : m_problem.surface().vertices())
      if(m_problem.number_of_copies(v.idx()) > 1) {
        position.push_back({points[v.idx()][0], -points[v.idx()][1]});
        mass.push_back(mass[v.idx()]);
      }
    typedef typename Point::value_type FT;
    const Conformal_barycenter<FT> center(position, mass, m_at_infinity.idx());
    for(Point& p : points)
      p = {(p[0] - center.base()[0]) / center.height(),
           (m_problem.has_no_copies() ? FT(p[1] - center.base()[1]) : p[1]) / center.height()};
    return center.height();
  }

  // Compares the result with the ideal polyhedron, and its scale factors with their bounds.
  template <typename FT>
  void compare(const std::vector<std::array<FT, 2>>& position)
  {
    typedef Distance_of<FT> Length;
    Ptolemy_surface<Length> ideal(
      m_problem.triangulation().mesh(),
      m_problem.template symmetric_lengths<Length>(m_problem.triangulation()));
    ideal.replay(m_result.flips);
    const Delta_complex& mesh = ideal.mesh();
    m_result.cross_ratio_error = max_stereographic_cross_ratio_error(
      mesh, [&](Edge_index e) { return ideal.length(e); }, position, m_at_infinity);
    std::vector<char> is_wrong(m_problem.size(), 0);
    for(std::size_t v = 0; v < is_wrong.size(); ++v)
      is_wrong[v] = !(m_above_bound[v] >= 0);
    for(Halfedge_index h : mesh.halfedges())
      if(const std::size_t v = m_problem.original(mesh.target(h)).idx();
         mesh.source(h) == m_at_infinity)
        is_wrong[v] |= m_above_bound[v] > tolerance::bound;
    m_result.layout.bound_violations = std::size_t(std::count(is_wrong.begin(), is_wrong.end(), 1));
  }

  Doubled_problem& m_problem;
  const std::vector<double>& m_mass;
  Vertex_index m_at_infinity;
  Unfolding_use m_use;
  std::vector<double> m_u, m_above_bound; // the scale factors, and what they exceed their bounds by
  std::size_t m_version = 0;              // of the triangulation that was laid out
  Unfolded_sphere m_result;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_SPHERE_UNFOLDING_H
