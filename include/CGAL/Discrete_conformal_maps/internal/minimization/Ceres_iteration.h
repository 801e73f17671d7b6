// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_CERES_ITERATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_CERES_ITERATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Descent.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <optional>

namespace CGAL::Discrete_conformal_maps::internal {

// One run of Ceres on the variables that move. Exceptions do not pass through Ceres: they wait
// until it has returned.
template <typename Energy, typename Visitor>
class Ceres_iteration
{
public:
  Ceres_iteration(Energy& energy, Eigen::VectorXd& best, const Free_variables& variables,
                  const Minimization_limits& limits, Visitor& visitor)
    : m_descent(energy, best, variables, limits), m_visitor(visitor)
  {}

  Minimization_result run()
  {
    Minimization_result result = m_descent.result(minimize());
    result.iterations = m_iterations;
    return result;
  }

private:
  typedef Minimization_status Status;

  struct Function : ceres::FirstOrderFunction
  {
    explicit Function(Ceres_iteration& run) : run(run) {}
    bool Evaluate(const double* u, double* value, double* gradient) const override
    {
      return run.guard([&] { return run.evaluate(u, value, gradient); }, false);
    }
    int NumParameters() const override { return run.number_of_parameters(); }
    Ceres_iteration& run;
  };

  struct Callback : ceres::IterationCallback
  {
    explicit Callback(Ceres_iteration& run) : run(run) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override
    {
      return run.guard([&] { return run.after_iteration(summary); }, ceres::SOLVER_ABORT);
    }
    Ceres_iteration& run;
  };

  Status minimize()
  {
    if(const std::optional<Status> end = m_descent.start())
      return *end;
    if(m_descent.has_converged())
      return Status::converged;
    if(m_descent.limits().iterations == 0)
      return Status::iteration_limit;
    m_base = m_descent.point();
    const ceres::GradientProblemSolver::Summary summary = solve();
    if(m_exception)
      std::rethrow_exception(m_exception);
    return status(summary);
  }

  ceres::GradientProblemSolver::Summary solve()
  {
    Callback callback(*this);
    ceres::GradientProblemSolver::Options options;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = static_cast<int>(
      (std::min)(m_descent.limits().iterations, std::size_t(std::numeric_limits<int>::max())));
    options.function_tolerance = 0;
    options.parameter_tolerance = 0;
    options.gradient_tolerance = m_descent.limits().gradient_tolerance;
    options.callbacks.push_back(&callback);
    ceres::GradientProblemSolver::Summary summary;
    Eigen::VectorXd parameters = m_base(m_descent.variables().indices());
    const ceres::GradientProblem problem(new Function(*this));
    ceres::Solve(options, problem, parameters.data(), &summary);
    return summary;
  }

  // Ceres gives up when no value along a line is less than the last: for rounding, if the values
  // have hardly changed any more.
  Status status(const ceres::GradientProblemSolver::Summary& summary) const
  {
    if(m_descent.best_norm() <= m_descent.tolerance())
      return Status::converged;
    if(summary.termination_type == ceres::NO_CONVERGENCE)
      return Status::iteration_limit;
    const double size = (std::max)(std::abs(summary.initial_cost), std::abs(summary.final_cost));
    if(std::abs(m_last_change) <= tolerance::cancellation * size)
      return Status::rounding_limit;
    return m_saw_not_finite ? Status::not_finite : Status::no_descent;
  }

  int number_of_parameters() const
  {
    return static_cast<int>(m_descent.variables().indices().size());
  }

  bool evaluate(const double* u, double* value, double* gradient)
  {
    const Free_variables::Indices& free = m_descent.variables().indices();
    Eigen::VectorXd point = m_base;
    point(free) = Eigen::Map<const Eigen::VectorXd>(u, number_of_parameters());
    const bool is_finite = m_descent.move_to(point);
    *value = static_cast<double>(m_descent.energy().value());
    if(!is_finite || !std::isfinite(*value)) {
      m_saw_not_finite = true;
      return false;
    }
    m_descent.keep_if_best();
    if(gradient)
      Eigen::Map<Eigen::VectorXd>(gradient, number_of_parameters()) = m_descent.gradient()(free);
    return true;
  }

  ceres::CallbackReturnType after_iteration(const ceres::IterationSummary& summary)
  {
    if(summary.iteration == 0) // the start
      return ceres::SOLVER_CONTINUE;
    m_iterations = static_cast<std::size_t>(summary.iteration);
    m_last_change = summary.cost_change;
    m_visitor.after_iteration(m_iterations, summary.gradient_max_norm, summary.step_norm);
    return m_descent.best_norm() <= m_descent.tolerance() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                                          : ceres::SOLVER_CONTINUE;
  }

  template <typename Call, typename Result>
  Result guard(Call call, Result in_case_of_exception)
  {
    try {
      if(!m_exception)
        return call();
    } catch(...) {
      m_exception = std::current_exception();
    }
    return in_case_of_exception;
  }

  Descent<Energy> m_descent;
  Visitor& m_visitor;
  Eigen::VectorXd m_base; // the start, which has the values of the fixed variables
  std::size_t m_iterations = 0;
  double m_last_change = 0; // of the value
  bool m_saw_not_finite = false;
  std::exception_ptr m_exception;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_CERES_ITERATION_H
