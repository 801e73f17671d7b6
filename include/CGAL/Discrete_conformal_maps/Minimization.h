// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_MINIMIZATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_MINIMIZATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Factorization_counts.h>

#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// the outcome of a minimization.
enum class Minimization_status
{
  converged,       ///< no entry of the gradient is above the tolerance
  rounding_limit,  ///< rounding keeps the gradient above the tolerance
  iteration_limit, ///< the limit of iterations was reached
  no_descent, ///< no step along the direction of search was good: the energy is not convex, or its
              ///< derivatives do not agree with each other
  unbounded,  ///< the energy has no minimum: the gradient does not sum to zero on a component
              ///< without fixed variables
  not_finite  ///< the gradient or the Hessian is infinite or NaN
};

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// returns the name of `status`.
inline const char* to_string(Minimization_status status)
{
  switch(status) {
    case Minimization_status::converged: return "converged";
    case Minimization_status::rounding_limit: return "rounding_limit";
    case Minimization_status::iteration_limit: return "iteration_limit";
    case Minimization_status::no_descent: return "no_descent";
    case Minimization_status::unbounded: return "unbounded";
    case Minimization_status::not_finite: return "not_finite";
  }
  return "unknown";
}

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// the result of a minimization.
struct Minimization_result : Factorization_counts
{
  Minimization_status status = Minimization_status::converged; ///< the outcome
  std::size_t iterations = 0;                                  ///< the number of steps taken
  std::size_t evaluations = 0; ///< the number of evaluations of the energy
  double gradient_norm = 0;    ///< the greatest entry of the final gradient
  double gradient_error =
    0; ///< the rounding error of this gradient: of its computation, and of the stored point

  /// returns the result of both minimizations if this one continued `first`: counts are added.
  Minimization_result after(const Minimization_result& first) const
  {
    Minimization_result result = *this;
    result.iterations += first.iterations;
    result.evaluations += first.evaluations;
    result += first;
    return result;
  }
};

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// describes which variables of an energy are free, and
/// along which directions the energy is constant.
struct Minimization_domain
{
  /// for each variable, whether it is fixed; empty if all are free
  std::vector<char> is_fixed;
  /// for each variable the index of its component, from 0. On a component without fixed variables,
  /// the energy does not change if the same number is added to all its variables. It changes in all
  /// other directions. Empty if the energy changes in every direction.
  std::vector<std::size_t> component;
};

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// a visitor that does nothing. A class derived from it redefines only the functions that it needs.
///
/// \cgalModels `MinimizationVisitor`
struct Default_minimization_visitor
{
  /// is called after every step.
  void after_iteration(std::size_t /* iteration */, double /* gradient_norm */,
                       double /* step_length */)
  {}
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_MINIMIZATION_H
