// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ITERATIVE_MINIMIZER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ITERATIVE_MINIMIZER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Descent.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL::Discrete_conformal_maps::internal {

// Implements a model of `ConvexMinimizer` with the steps of an `Iteration<Energy, Visitor>`.
template <template <typename, typename> class Iteration>
class Iterative_minimizer
{
public:
  template <typename Energy, typename Visitor>
  Minimization_result operator()(Energy& energy, Eigen::VectorXd& u,
                                 const Minimization_domain& domain, Visitor&& visitor) const
  {
    CGAL_precondition(static_cast<std::size_t>(u.size()) == energy.size());
    const Free_variables variables(domain, energy.size());
    Iteration<Energy, Visitor> iteration(energy, u, variables, m_limits, visitor);
    return iteration.run();
  }

  template <typename Energy>
  Minimization_result operator()(Energy& energy, Eigen::VectorXd& u,
                                 const Minimization_domain& domain = Minimization_domain()) const
  {
    return (*this)(energy, u, domain, Default_minimization_visitor());
  }

  // Returns a copy that ends at a point with `is_enough(point, step length)`, once Newton's method
  // converges quadratically.
  template <typename Is_enough>
  Iterative_minimizer ending_where(const Is_enough& is_enough) const
  {
    Iterative_minimizer result = *this;
    result.m_limits.is_enough = is_enough;
    return result;
  }

  // Returns a copy that uses a factorization again, up to `corrections` times, after a step of full
  // length that makes the gradient much smaller.
  Iterative_minimizer correcting_steps(std::size_t corrections) const
  {
    Iterative_minimizer result = *this;
    result.m_limits.corrections = corrections;
    return result;
  }

protected:
  Iterative_minimizer(double gradient_tolerance, std::size_t maximum_number_of_iterations)
    : m_limits{gradient_tolerance, maximum_number_of_iterations}
  {
    CGAL_precondition(gradient_tolerance >= 0);
  }

private:
  Minimization_limits m_limits;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ITERATIVE_MINIMIZER_H
