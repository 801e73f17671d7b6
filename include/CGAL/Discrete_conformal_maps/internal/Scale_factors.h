// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Conformal_energy.h>
#include <CGAL/Discrete_conformal_maps/Flattening_status.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/Cone_placement.h>
#include <CGAL/Discrete_conformal_maps/internal/Doubled_problem.h>

#ifdef CGAL_USE_MPFR
#include <boost/multiprecision/mpfr.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {
namespace internal {

// takes over where double has too few digits
#ifdef CGAL_USE_MPFR // many times as fast
typedef boost::multiprecision::mpfr_float_backend<34, boost::multiprecision::allocate_stack>
  Extended_backend;
#else
typedef boost::multiprecision::cpp_bin_float<34> Extended_backend;
#endif
typedef boost::multiprecision::number<Extended_backend, boost::multiprecision::et_off> Extended;

// The scale factors of a doubled problem.
class Scale_factors
{
  typedef Eigen::VectorXd Vector;

public:
  explicit Scale_factors(Doubled_problem& problem)
    : m_problem(problem), m_u(Vector::Zero(Eigen::Index(problem.size())))
  {}

  // the scale factors: the sum of both, where double has too few digits for them
  const Vector& values() const { return m_u; }
  const std::vector<Extended>& extended_values() const { return m_extended; }
  bool is_extended() const { return !m_extended.empty(); }

  const Minimization_result& result() const { return m_result; }
  // of the vertices where curvatures are prescribed
  double max_curvature_error() const { return m_max_curvature_error; }
  const std::vector<Vertex_index>& cones() const { return m_cones; }
  Flattening_status status() const { return m_status; }
  // whether all faces have the triangle inequality, but for rounding
  bool has_layout() const { return m_has_layout; }

  // by the vertices of the surface itself
  void start_from(const std::vector<double>& log_scale)
  {
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      m_u[Eigen::Index(v)] =
        log_scale[m_problem.front(Vertex_index(Delta_complex::size_type(v))).idx()];
  }

  // Places cones until a linear estimate of the scale factors lies within a bound.
  void place_cones(double bound)
  {
    const Conformal_energy<> energy(m_problem.triangulation().mesh(),
                                    m_problem.triangulation().length_map(),
                                    m_problem.target_defect(), m_problem.flipping());
    place_first_cones(energy, bound);
    const std::vector<Vertex_index> twin = twins();
    Cone_placement placement(energy.Hessian(), energy.gradient(), with_pins(), twin);
    for(std::size_t c; (c = worst_component(placement.estimate(), bound)) != none;) {
      const std::size_t v = placement.worst(m_problem.components(), c);
      placement.add(v);
      add_cone(v);
    }
  }

  // Minimizes the energy; if double has too few digits for `tolerance`, in extended precision.
  template <typename Minimizer, typename Visitor>
  void minimize(const Minimizer& minimizer, double tolerance, Visitor& visitor)
  {
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_problem.is_fixed()[v])
        m_u[Eigen::Index(v)] = m_problem.scale_factor(v);
    Conformal_energy<> energy = energy_at_start<double>();
    run(energy, minimizer, visitor);
    if(is_rounded(tolerance) && !has_no_solution())
      minimize_extended(minimizer, tolerance, visitor);
  }

  // Makes a cone of the vertex with the greatest scale factor, if it is out of bounds. Says whether it has.
  bool add_cone_if_beyond(double bound)
  {
    Eigen::Index v = 0;
    if(m_u.size() == 0 || m_u.cwiseAbs().maxCoeff(&v) <= bound ||
       m_problem.is_fixed()[std::size_t(v)])
      return false;
    add_cone(std::size_t(v));
    return true;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // rounding counts as well
  bool is_within(double tolerance) const
  {
    return m_max_curvature_error <= tolerance && m_result.gradient_error <= tolerance;
  }

  template <typename FT>
  Conformal_energy<FT> energy_at_start() const
  {
    Conformal_energy<FT> result(m_problem.triangulation().mesh(),
                                m_problem.triangulation().length_map(), m_problem.target_defect(),
                                m_problem.flipping());
    result.evaluate(m_u);
    return result;
  }

  // The minimizer moves by numbers in double, which lose fewer digits the closer the origin is.
  template <typename Minimizer, typename Visitor>
  void minimize_extended(const Minimizer& minimizer, double tolerance, Visitor& visitor)
  {
    Conformal_energy<Extended> energy = energy_at_start<Extended>();
    double before = 0;
    do {
      before = (std::max)(m_max_curvature_error, m_result.gradient_error);
      run(energy, minimizer, visitor);
    } while(!is_within(tolerance) && !has_no_solution() &&
            (std::max)(m_max_curvature_error, m_result.gradient_error) < before / 2);
    m_extended = energy.scale_factors();
  }

  template <typename FT, typename Minimizer, typename Visitor>
  void run(Conformal_energy<FT>& energy, const Minimizer& minimizer, Visitor& visitor)
  {
    energy.move_origin();
    Vector x = Vector::Zero(m_u.size());
    const Minimization_result last = minimizer(energy, x, domain(), visitor);
    const std::size_t iterations = m_result.iterations + last.iterations,
                      evaluations = m_result.evaluations + last.evaluations;
    m_result = last;
    m_result.iterations = iterations;
    m_result.evaluations = evaluations;
    m_has_layout =
      m_problem.flipping() == Flipping::to_Delaunay || energy.number_of_flat_faces() == 0;
    m_status = status(x);
    m_max_curvature_error = 0;
    for(std::size_t v = 0; v < m_problem.size(); ++v) {
      const auto i = static_cast<Eigen::Index>(v);
      m_u[i] = static_cast<double>(energy.scale_factors()[v]);
      if(!m_problem.is_fixed()[v])
        m_max_curvature_error = (std::max)(m_max_curvature_error, std::abs(energy.gradient()[i]));
    }
  }

  // Whether more digits might give less than the tolerance; not if the minimizer was content with more, or has
  // not been allowed to go on.
  bool is_rounded(double tolerance) const
  {
    const bool has_been_stopped = m_result.status != Minimization_status::converged &&
                                  m_result.status != Minimization_status::iteration_limit;
    return m_result.gradient_error > tolerance ||
           (m_max_curvature_error > tolerance && has_been_stopped);
  }

  // In a fixed triangulation it need not be rounding that stops the minimization.
  bool has_no_solution() const
  {
    return m_status == Flattening_status::no_minimum ||
           (m_status == Flattening_status::triangle_inequality &&
            m_result.status == Minimization_status::iteration_limit);
  }

  // after a minimization that has led in this direction
  Flattening_status status(const Vector& direction) const
  {
    if(m_problem.flipping() == Flipping::none && falls_without_end(direction))
      return Flattening_status::no_minimum;
    if(!m_has_layout)
      return Flattening_status::triangle_inequality;
    return m_result.status == Minimization_status::converged ? Flattening_status::success
                                                             : Flattening_status::not_converged;
  }

  // Far along a direction, every face of a fixed triangulation has the angle pi where its entry is least. A
  // convex energy that falls even there has no minimum.
  bool falls_without_end(const Vector& direction) const
  {
    const Delta_complex& mesh = m_problem.triangulation().mesh();
    const Vector target = m_problem.target_defect();
    const double pi = boost::math::constants::pi<double>();
    double slope = 0, size = 0;
    const auto add = [&](double x) {
      slope += x;
      size += std::abs(x);
    };
    for(Vertex_index v : mesh.vertices())
      if(!m_problem.is_fixed()[v.idx()])
        add((2 * pi - target[Eigen::Index(v.idx())]) * direction[Eigen::Index(v.idx())]);
    for(Face_index f : mesh.faces()) {
      double least = std::numeric_limits<double>::infinity();
      for(Halfedge_index h : Intrinsic_triangulations::internal::sides(f, mesh))
        least = (std::min)(least, direction[Eigen::Index(mesh.source(h).idx())]);
      add(-pi * least);
    }
    return slope < -1e-12 * size; // rounding
  }

  Minimization_domain domain() const
  {
    Minimization_domain result{m_problem.is_fixed(), {}};
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      result.component.push_back(m_problem.components()[v]);
    return result;
  }

  // The Laplacian does not see constants on a component without prescribed scale factors: one vertex is held.
  std::vector<char> with_pins() const
  {
    std::vector<char> result = m_problem.is_fixed();
    std::vector<std::size_t> count = m_problem.number_of_fixed();
    for(std::size_t v = 0; v < result.size(); ++v)
      if(count[m_problem.components()[v]]++ == 0)
        result[v] = 1;
    return result;
  }

  std::vector<Vertex_index> twins() const
  {
    std::vector<Vertex_index> result(m_problem.size());
    for(Vertex_index v : m_problem.surface_vertices()) {
      result[v.idx()] = m_problem.mirrored(v);
      result[m_problem.mirrored(v).idx()] = v;
    }
    return result;
  }

  void add_cone(std::size_t v)
  {
    const Vertex_index cone = m_problem.front(Vertex_index(Delta_complex::size_type(v)));
    m_problem.set_condition(cone, Vertex_condition::log_scale(0));
    m_cones.push_back(cone);
  }

  // A component without prescribed scale factors gets a cone where the estimate is farthest from its middle,
  // unless it needs none.
  void place_first_cones(const Conformal_energy<>& energy, double bound)
  {
    const auto& component = m_problem.components();
    const std::vector<double> excess = m_problem.curvature_excess();
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    std::vector<double> size(component.size(), 0);
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      ++size[component[v]];
    Vector balanced = energy.gradient();
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(fixed[component[v]] == 0)
        balanced[Eigen::Index(v)] += excess[component[v]] / size[component[v]];
    Dirichlet_solver solver(energy.Hessian(), with_pins());
    const Vector estimate = solver.solve(-balanced);
    for(std::size_t c = 0; c < component.size(); ++c)
      if(fixed[c] == 0 && size[c] > 1)
        place_first_cone(c, estimate, excess[c], bound);
  }

  void place_first_cone(std::size_t c, const Vector& estimate, double excess, double bound)
  {
    std::size_t least = none, greatest = none;
    double sum = 0, count = 0;
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_problem.components()[v] == c) {
        const double u = estimate[Eigen::Index(v)];
        sum += u;
        ++count;
        if(least == none || u < estimate[Eigen::Index(least)])
          least = v;
        if(greatest == none || u > estimate[Eigen::Index(greatest)])
          greatest = v;
      }
    const double below = sum / count - estimate[Eigen::Index(least)],
                 above = estimate[Eigen::Index(greatest)] - sum / count;
    if(Doubled_problem::needed_cones(excess) > 0 || (std::max)(below, above) > bound)
      add_cone(above > below ? greatest : least);
  }

  // a component with cones whose estimate is out of bounds, or that needs more of them
  std::size_t worst_component(const Vector& estimate, double bound) const
  {
    const std::vector<double> excess = m_problem.curvature_excess();
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    for(std::size_t v = 0; v < m_problem.size(); ++v) {
      const std::size_t c = m_problem.components()[v];
      const double u = std::abs(estimate[Eigen::Index(v)]);
      if(fixed[c] > 0 &&
         (u > bound || (u > 0 && fixed[c] < Doubled_problem::needed_cones(excess[c]))))
        return c;
    }
    return none;
  }

  Doubled_problem& m_problem;
  Vector m_u;
  std::vector<Extended> m_extended;
  Minimization_result m_result;
  Flattening_status m_status = Flattening_status::success;
  bool m_has_layout = true;
  double m_max_curvature_error = 0;
  std::vector<Vertex_index> m_cones;
};

} // namespace internal
} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_H
