// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgDiscreteConformalMapsConcepts
/// \cgalConcept
///
/// observes every step of a minimization: to show progress, or to stop it by an exception.
///
/// \cgalHasModel `CGAL::Discrete_conformal_maps::Default_minimization_visitor`
class MinimizationVisitor
{
public:
  /// is called after every step. An exception leaves the minimizer; the caller has the best point
  /// so far then.
  /// \param iteration the number of steps taken
  /// \param gradient_norm the greatest entry of the gradient
  /// \param step_length the length of the step, in the norm of the minimizer
  void after_iteration(std::size_t iteration, double gradient_norm, double step_length);
};
