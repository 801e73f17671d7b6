// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SPHERICAL_SCALE_FACTORS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SPHERICAL_SCALE_FACTORS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Bounded_Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Grouped_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Precise_newton_iteration.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Peacock_triangulation.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Spherical_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Symmetric_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the spherical energy of a surface, symmetric if it is doubled.
template <typename FT>
Symmetric_energy<Spherical_energy<FT>> spherical_energy(Doubled_problem& problem,
                                                        Vertex_index at_infinity)
{
  return {problem, problem.triangulation(),
          [&problem, at_infinity](const Doubled_problem::Triangulation& t) {
            return Spherical_energy<FT>(t.mesh(), problem.template symmetric_lengths<FT>(t),
                                        at_infinity);
          }};
}

// Computes the scale factors that unfold a sphere, without one of its vertices, into the plane
// (Section 4.4.4). They belong to the vertices of the surface that was possibly doubled.
template <typename FT>
class Spherical_scale_factors
{
  typedef Eigen::VectorXd Vector;
  typedef Symmetric_energy<Spherical_energy<FT>> Energy;

public:
  // A disk has its vertex at infinity on the boundary, because shortest geodesics within it then
  // exist.
  // \throws Numerical_error if the bounds are out of the range of `FT`
  Spherical_scale_factors(Doubled_problem& problem, Vertex_index at_infinity)
    : m_problem(problem),
      m_at_infinity(at_infinity),
      m_bound(Peacock_triangulation<FT>(
                problem.triangulation().mesh(),
                problem.template symmetric_lengths<FT>(problem.triangulation()), at_infinity)
                .distances())
  {
    m_bound.resize(problem.size());
    for(Vertex_index v : problem.surface().vertices())
      m_bound[v.idx()] = is_fixed(v) ? FT(0) : FT(-m_bound[v.idx()]);
    m_u = start();
  }

  // Returns the scale factors, which are zero at infinity and at isolated vertices.
  const std::vector<FT>& values() const { return m_u; }
  // Returns the lower bounds. At the bounds, vertices are neighbors of the vertex at infinity.
  const std::vector<FT>& bounds() const { return m_bound; }
  const Minimization_result& result() const { return m_result; }

  // Returns the greatest error of an angle sum that must be 2 pi, at vertices that are not at their
  // bounds. At vertices at their bounds, the sum need not be 2 pi. Their slope of the energy
  // behaves like a square root, and numbers may not resolve its zero. The bound leaves the square
  // root of a rounding unit in the gradient, which exceeds all other terms.
  double angle_error() const { return m_angle_error; }

  // Starts from scale factors of another precision instead of a guess.
  template <typename Other>
  void set_start(const Spherical_scale_factors<Other>& other)
  {
    for(std::size_t v = 0; v < m_u.size(); ++v)
      m_u[v] = other.values()[v] == other.bounds()[v]
                 ? m_bound[v]
                 : (std::max)(m_bound[v], converted<FT>(other.values()[v]));
  }

  // Starts from rounded scale factors. Near vertices get equal scale factors, because rounding has
  // left no digits of the angles between near vertices.
  void set_start_of_groups(const Spherical_scale_factors<double>& rounded)
  {
    set_start(rounded);
    const Groups groups = groups_of_near_vertices();
    std::vector<FT> sum(groups.count, FT(0));
    std::vector<double> size(groups.count, 0);
    for(std::size_t v = 0; v < m_u.size(); ++v) {
      sum[groups.of_vertex[v]] += m_u[v];
      ++size[groups.of_vertex[v]];
    }
    for(Vertex_index v : m_problem.surface().vertices())
      if(const std::size_t g = groups.of_vertex[v.idx()]; !is_fixed(v) && size[g] > 1)
        m_u[v.idx()] = (std::max)(m_bound[v.idx()], FT(sum[g] / FT(size[g])));
  }

  // Starts from the scale factors of a metric that is flat far from infinity, plus the least
  // constant with which they are within the bounds.
  void set_start(const std::vector<Double_double>& flat)
  {
    FT level = -std::numeric_limits<FT>::infinity();
    for(Vertex_index v : m_problem.surface().vertices())
      if(!is_fixed(v))
        level = (std::max)(level, FT(m_bound[v.idx()] - converted<FT>(flat[v.idx()])));
    for(Vertex_index v : m_problem.surface().vertices())
      if(const std::size_t i = v.idx(); !is_fixed(v))
        m_u[i] = (std::max)(m_bound[i], FT(converted<FT>(flat[i]) + level));
  }

  // Minimizes the energy under the bounds, beyond a sufficient gradient if possible. Rounding to
  // `double` limits only how far a step can change the scale factors. If scale factors have more
  // digits, a second run finds the digits. If rounding ends it early, short steps in all digits
  // follow. Without more digits, a second run leaves vertices at their bounds, see `angle_error()`.
  // The energy does not outlive the minimization, because a layout needs its memory.
  template <typename Visitor>
  void minimize(double tolerance, Visitor& visitor)
  {
    Energy energy = spherical_energy<FT>(m_problem, m_at_infinity);
    run(energy, tolerance, false, visitor);
    if(!is_rounded || m_result.status != Minimization_status::converged)
      run(energy, tolerance, is_rounded, visitor);
    if constexpr(has_more_digits)
      if(m_result.status != Minimization_status::converged)
        descend(energy, tolerance::parts_of_work_for_sphere, visitor);
    m_angle_error = angle_error(energy.gradient());
  }

  // Minimizes the energy with steps in all digits, and with one of so many parts of the work that
  // is left.
  template <typename Visitor>
  void descend(double parts_of_work, Visitor& visitor)
  {
    Energy energy = spherical_energy<FT>(m_problem, m_at_infinity);
    descend(energy, parts_of_work, visitor);
    m_angle_error = angle_error(energy.gradient());
  }

  // Minimizes the energy with steps in which near vertices move together. Steps of all vertices
  // start close to a minimum then. Returns whether near vertices exist.
  template <typename Visitor>
  bool move_groups(double parts_of_work, Visitor& visitor)
  {
    const Groups groups = groups_of_near_vertices();
    if(groups.count == m_u.size())
      return false;
    Energy energy = spherical_energy<FT>(m_problem, m_at_infinity);
    Minimization_domain domain;
    domain.is_fixed.resize(groups.count, 0);
    std::vector<FT> lower(groups.count, -std::numeric_limits<FT>::infinity());
    for(Vertex_index v : m_problem.surface().vertices()) {
      const std::size_t i = v.idx(), g = groups.of_vertex[i];
      domain.is_fixed[g] |= is_fixed(v);
      lower[g] = (std::max)(lower[g], FT(m_bound[i] - m_u[i]));
    }
    move_to_start(energy, parts_of_work);
    Grouped_energy<Energy> grouped(energy, groups.of_vertex, groups.count);
    Precise_newton_iteration<Grouped_energy<Energy>> newton(grouped, domain, std::move(lower));
    add_result(newton.run(tolerance::curvature_at_start, tolerance::steps_to_start, visitor));
    for(std::size_t v = 0; v < m_u.size(); ++v)
      m_u[v] = (std::max)(m_bound[v], energy.scale_factor(v));
    return true;
  }

private:
  // Ten or twenty iterations are usual. If bounds are active without effect, more digits may be
  // better.
  static constexpr std::size_t iteration_limit = 100;
  static constexpr bool is_rounded = std::is_same<FT, double>::value;
  static constexpr bool has_more_digits =
    std::numeric_limits<FT>::digits > std::numeric_limits<double>::digits;
  // A scale factor that is closer to its bound is the sum of the bound and a distance. The distance
  // has all digits of `double`, because the slope of the energy behaves like its square root.
  static constexpr double near_bound = 1;

  template <typename Visitor>
  void descend(Energy& energy, double parts_of_work, Visitor& visitor)
  {
    Minimization_domain domain;
    for(Vertex_index v : m_problem.surface().vertices())
      domain.is_fixed.push_back(is_fixed(v));
    move_to_start(energy, parts_of_work);
    Precise_newton_iteration<Energy> newton(energy, domain, m_bound);
    const Minimization_result last = newton.run(
      (std::max)(tolerance::rounding_of_gradient<FT>(), tolerance::most_precise_gradient),
      tolerance::steps_with_more_digits, visitor);
    m_u = energy.scale_factors();
    add_result(last);
  }

  void move_to_start(Energy& energy, double parts_of_work) const
  {
    limit_work(energy, parts_of_work);
    energy.set_origin(m_u);
    energy.evaluate(Vector::Zero(Eigen::Index(m_u.size())));
  }

  template <typename Visitor>
  void run(Energy& energy, double tolerance, bool stays_at_bounds, Visitor& visitor)
  {
    Vector lower(Eigen::Index(m_u.size())), x(lower.size());
    const std::vector<FT> origin = this->origin();
    Minimization_domain domain;
    for(Vertex_index v : m_problem.surface().vertices()) {
      const std::size_t i = v.idx();
      lower[Eigen::Index(i)] = static_cast<double>(m_bound[i] - origin[i]);
      x[Eigen::Index(i)] = static_cast<double>(m_u[i] - origin[i]);
      domain.is_fixed.push_back(is_fixed(v) || (stays_at_bounds && m_u[i] == m_bound[i]));
    }
    limit_work(energy, tolerance::parts_of_work_for_sphere);
    energy.set_origin(origin);
    const Minimization_result last =
      Bounded_Newton_minimizer(tolerance, iteration_limit)(energy, x, lower, domain, visitor);
    store_scale_factors(energy, x, lower);
    add_result(last);
  }

  void limit_work(Energy& energy, double parts_of_work) const
  {
    energy.limit_work(m_problem.work().end_of_part(tolerance::work_for_map, parts_of_work));
  }

  // Returns the scale factors to which a run adds numbers in `double`.
  std::vector<FT> origin() const
  {
    std::vector<FT> result(m_u.size(), FT(0));
    if(!is_rounded)
      for(std::size_t v = 0; v < m_u.size(); ++v)
        result[v] = m_u[v] - m_bound[v] < near_bound ? m_bound[v] : m_u[v];
    return result;
  }

  void add_result(const Minimization_result& last)
  {
    m_result = last.after(m_result);
    if(last.gradient_norm <= tolerance::gradient)
      m_result.status = Minimization_status::converged; // less than that is used, no more
  }

  // Stores the scale factors. At the bounds, they equal them bitwise.
  void store_scale_factors(const Energy& energy, const Vector& x, const Vector& lower)
  {
    for(std::size_t v = 0; v < m_u.size(); ++v) {
      const Eigen::Index i = Eigen::Index(v);
      m_u[v] = x[i] == lower[i] ? m_bound[v] : energy.scale_factor(v);
    }
  }

  double angle_error(const Vector& gradient) const
  {
    double result = 0;
    for(std::size_t v = 0; v < m_u.size(); ++v)
      if(m_u[v] != m_bound[v]) {
        const double error = std::abs(gradient[Eigen::Index(v)]) / m_problem.part(v);
        result = error <= result ? result : error; // keeps NaN
      }
    return result;
  }

  // Returns scale factors for a start. The neighbors of the vertex at infinity have their factors
  // as if they remained, the others are equal. With needles, these are very small. Then scale
  // factors of near vertices differ as little as their bounds, even if some are neighbors of the
  // vertex at infinity.
  std::vector<FT> start() const
  {
    FT sum(0), count(0), least = std::numeric_limits<FT>::infinity();
    std::vector<char> is_neighbor(m_bound.size(), 0);
    const Delta_complex& mesh = m_problem.triangulation().mesh();
    for(Halfedge_index h : mesh.halfedges())
      if(mesh.source(h) == m_at_infinity && mesh.target(h) != m_at_infinity) {
        const std::size_t i = m_problem.original(mesh.target(h)).idx();
        is_neighbor[i] = 1;
        sum += m_bound[i];
        count += 1;
        least = (std::min)(least, m_bound[i]);
      }
    const FT level = m_problem.has_needles() ? least : sum / count;
    std::vector<FT> result(m_bound.size(), FT(0));
    for(Vertex_index v : m_problem.surface().vertices())
      if(const std::size_t i = v.idx(); !is_fixed(v))
        result[i] = is_neighbor[i] ? m_bound[i] : (std::max)(m_bound[i], level);
    return result;
  }

  // Numbers groups of vertices, such that each vertex is in one.
  struct Groups
  {
    std::vector<std::size_t> of_vertex;
    std::size_t count;
  };

  // Groups vertices that are joined by an edge that is much shorter than the other edges of its
  // faces.
  Groups groups_of_near_vertices() const
  {
    boost::disjoint_sets_with_storage<> sets(m_u.size());
    const auto& t = m_problem.triangulation();
    for(Edge_index e : t.mesh().edges()) {
      const Halfedge_index h = t.mesh().halfedge(e);
      const std::size_t v = m_problem.original(t.mesh().source(h)).idx(),
                        w = m_problem.original(t.mesh().target(h)).idx();
      if(t.length(e) < tolerance::near_vertices * t.length(Edge_index(t.mesh().next(h))) &&
         v != m_at_infinity.idx() && w != m_at_infinity.idx())
        sets.union_set(v, w);
    }
    Groups result{{}, 0};
    std::vector<std::size_t> number(m_u.size(), m_u.size()); // of each root
    for(std::size_t v = 0; v < m_u.size(); ++v) {
      std::size_t& n = number[sets.find_set(v)];
      if(n == m_u.size())
        n = result.count++;
      result.of_vertex.push_back(n);
    }
    return result;
  }

  bool is_fixed(Vertex_index v) const
  {
    return v == m_at_infinity || m_problem.surface().is_isolated(v);
  }

  Doubled_problem& m_problem;
  Vertex_index m_at_infinity;
  std::vector<FT> m_bound, m_u;
  Minimization_result m_result;
  double m_angle_error = 0;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SPHERICAL_SCALE_FACTORS_H
