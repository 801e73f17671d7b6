// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_MINIMIZATION_RESULT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_MINIMIZATION_RESULT_H

#include <CGAL/license/Discrete_conformal_maps.h>

namespace CGAL {
namespace Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// how a minimization has ended.
enum class Minimization_status
{
  converged,       ///< the gradient is as small as was asked for, or as rounding allows
  rounding_limit,  ///< the gradient is small, but not as small as was asked for, and no step helps
  iteration_limit, ///< all steps that were allowed have been used
  no_descent       ///< far from a minimum no step was found that leads down
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
  }
  return "unknown";
}

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// what a minimization has done.
struct Minimization_result
{
  Minimization_status status = Minimization_status::no_descent; ///< how it has ended
  int iterations = 0;                                           ///< the number of steps
  int evaluations = 0; ///< how often the gradient was computed
  double gradient_norm =
    0; ///< the greatest entry of the gradient at the end, of variables that are free
  double gradient_error = 0; ///< a bound for its rounding error
};

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// a visitor that does nothing.
///
/// \cgalModels `MinimizationVisitor`
struct Default_minimization_visitor
{
  /// is called after each step.
  void after_step(int /* iteration */, double /* gradient_norm */) {}
};

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_MINIMIZATION_RESULT_H
