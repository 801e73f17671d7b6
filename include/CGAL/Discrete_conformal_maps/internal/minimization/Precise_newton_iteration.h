// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_PRECISE_NEWTON_ITERATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_PRECISE_NEWTON_ITERATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Laplacian_elimination.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_direction.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Newton's method for an energy whose Hessian is a Laplacian, with steps in the digits of the
// energy. Scale factors of vertices much closer to each other than to others are nearly equal: a
// step in `double` that all of them take would change their differences by more than their
// distances allow. What a step gains there is no part of the slope along it that rounding leaves,
// but entries of the gradient are angles whatever the distances are: their squares decide how long
// a step is, so that the gradient falls everywhere.
template <typename Energy>
class Precise_newton_iteration
{
  typedef typename Energy::FT FT;
  typedef Eigen::VectorXd Vector;

public:
  Precise_newton_iteration(Energy& energy, const Minimization_domain& domain)
    : m_energy(energy),
      m_variables(domain, energy.size()),
      m_solver(m_variables.indices(), energy.shared_order())
  {
    move_to(energy.scale_factors());
  }

  // Takes steps until no entry of the gradient is above `tolerance`, or above its rounding error.
  template <typename Visitor>
  Minimization_result run(double tolerance, std::size_t maximum_number_of_steps, Visitor& visitor)
  {
    Minimization_status status = Minimization_status::converged;
    while(m_norm > (std::max)(tolerance, m_energy.gradient_error()) &&
          status == Minimization_status::converged)
      if(m_result.iterations == maximum_number_of_steps)
        status = Minimization_status::iteration_limit;
      else {
        status = step();
        visitor.after_iteration(++m_result.iterations, m_norm, m_length);
      }
    m_result.status = status;
    m_result.gradient_norm = m_norm;
    m_result.gradient_error = m_energy.gradient_error();
    return m_result;
  }

private:
  static constexpr double greatest_entry = 10; // of a step that is not damped

  void move_to(const std::vector<FT>& u)
  {
    m_energy.set_origin(u);
    m_energy.evaluate(Vector::Zero(Eigen::Index(m_energy.size())));
    ++m_result.evaluations;
    m_gradient = m_energy.gradient();
    m_variables.set_fixed_to_zero(m_gradient);
    m_norm =
      m_gradient.allFinite() ? max_norm(m_gradient) : std::numeric_limits<double>::infinity();
    m_variables.remove_means(m_gradient);
  }

  // A step is good if it takes from the gradient a quarter of what a quadratic function would lose.
  Minimization_status step()
  {
    if(!find_direction())
      return Minimization_status::not_finite;
    const std::vector<FT> base = m_energy.scale_factors();
    const double norm = m_gradient.norm();
    double t = 1;
    for(int trial = 0; trial < 40; ++trial, t /= 2) {
      std::vector<FT> u = base;
      for(std::size_t v = 0; v < u.size(); ++v)
        u[v] += FT(t) * m_direction[v];
      move_to(u);
      if(m_gradient.norm() <= (1 - t / 4) * norm) // not if it is NaN
        return Minimization_status::converged;
    }
    move_to(base);
    return Minimization_status::rounding_limit;
  }

  bool find_direction()
  {
    const auto& hessian = m_energy.Hessian();
    if(!m_gradient.allFinite() || !hessian.coeffs().allFinite())
      return false;
    const Vector ground = grounding(hessian, m_variables);
    return solve(ground) && (m_length <= greatest_entry ||
                             solve(ground + damping(hessian, m_gradient, greatest_entry, 0)));
  }

  bool solve(const Vector& ground)
  {
    const auto& hessian = m_energy.Hessian();
    ++m_result.factorizations;
    if(!m_elimination.factorize(hessian, ground, m_solver.order(hessian)))
      return false;
    m_direction = m_elimination.solve(-m_gradient);
    m_length = 0;
    for(const FT& x : m_direction)
      m_length = (std::max)(m_length, std::abs(static_cast<double>(x)));
    return true;
  }

  Energy& m_energy;
  Free_variables m_variables;
  Newton_direction::Solver m_solver; // of which the order is used
  Laplacian_elimination<FT> m_elimination;
  std::vector<FT> m_direction;
  double m_length = 0;
  Vector m_gradient; // without the part that no step can change
  double m_norm = 0; // with it
  Minimization_result m_result;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_PRECISE_NEWTON_ITERATION_H
