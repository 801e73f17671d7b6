// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_NEWTON_MINIMIZER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_NEWTON_MINIMIZER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization_result.h>
#include <CGAL/Discrete_conformal_maps/internal/Dirichlet_solver.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {

namespace internal {

// One run of Newton's method.
template <typename Energy, typename Visitor>
class Newton_run
{
  typedef Eigen::VectorXd Vector;

public:
  Newton_run(Energy& energy, Vector& x, const std::vector<char>& is_fixed, Visitor& visitor)
    : m_energy(energy), m_x(x), m_is_fixed(is_fixed), m_visitor(visitor)
  {}

  Minimization_result operator()(double tolerance, int maximum_number_of_iterations)
  {
    m_gradient = free_gradient_at(m_x);
    m_best = {m_x, norm()};
    m_result.status = Minimization_status::iteration_limit;
    while(m_result.iterations < maximum_number_of_iterations) {
      const bool is_converged = norm() <= (std::max)(tolerance, m_energy.gradient_error());
      const bool goes_on = step();
      if(norm() < m_best.norm)
        m_best = {m_x, norm()};
      if(is_converged || !goes_on) { // one step beyond convergence is cheap
        m_result.status = is_converged    ? Minimization_status::converged
                          : m_stalled > 0 ? Minimization_status::rounding_limit
                                          : Minimization_status::no_descent;
        break;
      }
    }
    return finish();
  }

private:
  struct Point
  {
    Vector x;
    double norm;
  };

  double norm() const { return m_gradient.size() == 0 ? 0 : m_gradient.cwiseAbs().maxCoeff(); }

  Vector free_gradient_at(const Vector& x)
  {
    ++m_result.evaluations;
    m_energy.evaluate(x);
    Vector result = m_energy.gradient();
    for(std::size_t i = 0; i < m_is_fixed.size(); ++i)
      if(m_is_fixed[i])
        result[static_cast<Eigen::Index>(i)] = 0;
    return result;
  }

  // Goes one step; says whether it makes sense to go on.
  bool step()
  {
    m_solver.factorize(m_energy.Hessian(), m_is_fixed);
    const Vector direction = -m_solver.solve(m_gradient);
    const double slope = m_gradient.dot(direction), before = norm();
    if(!(slope < 0) || !search(direction, slope))
      return false;
    ++m_result.iterations;
    m_visitor.after_step(m_result.iterations, norm());
    // at the limit of rounding the gradient wanders
    m_stalled = norm() < 0.5 * before || norm() > rounding_level ? 0 : m_stalled + 1;
    return m_stalled < 5;
  }

  // Goes along `direction` until the slope, which is `slope` < 0 at the start and increases, has nearly
  // vanished, or is still negative. Values of the energy would lose all digits near the minimum.
  bool search(const Vector& direction, double slope)
  {
    double t = (std::min)(1., longest_step / direction.cwiseAbs().maxCoeff());
    for(int trial = 0; trial < 60; ++trial) {
      const Vector x = m_x + t * direction;
      double end = std::numeric_limits<double>::infinity();
      try {
        const Vector gradient = free_gradient_at(x);
        end = gradient.dot(direction);
        if(end <= -0.2 * slope || gradient.cwiseAbs().maxCoeff() < 0.5 * norm()) {
          m_x = x;
          m_gradient = gradient;
          return true;
        }
      } catch(const Intrinsic_triangulations::Numerical_error&) { // too far
      }
      t *= (std::min)((std::max)(slope / (slope - end), 0.1), 0.9);
    }
    m_stalled += norm() < rounding_level;
    return false;
  }

  Minimization_result finish()
  {
    m_x = m_best.x;
    m_gradient = free_gradient_at(m_x);
    m_result.gradient_norm = norm();
    m_result.gradient_error = m_energy.gradient_error();
    return m_result;
  }

  static constexpr double longest_step = 20;     // a factor of e^20
  static constexpr double rounding_level = 1e-5; // below it, Newton's method converges at once

  Energy& m_energy;
  Vector& m_x;
  const std::vector<char>& m_is_fixed;
  Visitor& m_visitor;
  Dirichlet_solver m_solver;
  Vector m_gradient; // zero where variables are fixed
  Point m_best;
  int m_stalled = 0; // steps in a row that have not made a small gradient smaller
  Minimization_result m_result;
};

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// Newton's method with a line search (Section 4.3.3), for convex functions that are twice continuously
/// differentiable.
///
/// The line search looks at slopes alone, which increase along a line. The gradient is made as small as
/// rounding allows.
///
/// \cgalModels `ConvexMinimizer`
class Newton_minimizer
{
public:
  /// \param gradient_tolerance the entry of the gradient, in radians, at which minimization may stop; where
  ///        rounding errors are greater, these count
  /// \param maximum_number_of_iterations the number of steps that are allowed
  explicit Newton_minimizer(double gradient_tolerance = 1e-13,
                            int maximum_number_of_iterations = 300)
    : m_gradient_tolerance(gradient_tolerance),
      m_maximum_number_of_iterations(maximum_number_of_iterations)
  {}

  /// minimizes `energy`. Each step takes a sparse Cholesky factorization; the order of elimination is
  /// found once.
  /// \tparam Energy a model of `ConvexEnergy`
  /// \tparam Visitor a model of `MinimizationVisitor`
  /// \param energy the function; at the end it is at the minimum
  /// \param x where to start, and at the end the point with the smallest gradient that was met
  /// \param is_fixed the variables that stay. Without them, the Hessian is positive definite.
  /// \param visitor is told every step; what it throws stops the minimization
  template <typename Energy, typename Visitor = Default_minimization_visitor>
  Minimization_result operator()(Energy& energy, Eigen::VectorXd& x,
                                 const std::vector<char>& is_fixed,
                                 Visitor&& visitor = Visitor()) const
  {
    return internal::Newton_run<Energy, Visitor>(energy, x, is_fixed, visitor)(
      m_gradient_tolerance, m_maximum_number_of_iterations);
  }

private:
  double m_gradient_tolerance;
  int m_maximum_number_of_iterations;
};

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_NEWTON_MINIMIZER_H
