// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_CERES_ITERATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_CERES_ITERATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Descent.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Reordered_matrix.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <optional>

namespace CGAL::Discrete_conformal_maps::internal {

// Transforms variables to coordinates y in which a Hessian L L^T is the identity: L^T x = y. A
// method that uses only gradients needs few steps in them.
class Hessian_coordinates
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;

  explicit Hessian_coordinates(const Free_variables::Indices& free) : m_free(free) {}

  // Returns false if the Hessian is not finite, or far from positive semidefinite.
  bool set(const Matrix& Hessian)
  {
    Reordered_matrix free;
    free.set_pattern(Hessian, m_free);
    const Eigen::VectorXd diagonal = Hessian.diagonal();
    const double greatest = max_norm(diagonal);
    for(double lift = tolerance::damping; lift <= tolerance::greatest_lift;
        lift = tolerance::next_lift(lift)) {
      free.set_values(Hessian, Eigen::VectorXd::Constant(diagonal.size(), lift * greatest), m_free);
      m_factor.compute(free.upper());
      if(m_factor.info() == Eigen::Success)
        return true;
    }
    return false;
  }

  // Returns the variables of the point with the coordinates `y`.
  Eigen::VectorXd variables(const Eigen::VectorXd& y) const
  {
    return m_factor.permutationPinv() * m_factor.matrixU().solve(y);
  }

  // Returns the derivatives with respect to the coordinates.
  Eigen::VectorXd gradient(const Eigen::VectorXd& by_variables) const
  {
    return m_factor.matrixL().solve(m_factor.permutationP() * by_variables);
  }

private:
  const Free_variables::Indices& m_free;
  Eigen::SimplicialLLT<Matrix, Eigen::Upper> m_factor;
};

// Runs Ceres on the free variables, each time from the best point so far. The coordinates make the
// Hessian at that point the identity, and values are relative to that point. So each run gains as
// many digits as the last one had left. Exceptions do not pass through Ceres: they are thrown after
// it has returned.
template <typename Energy, typename Visitor>
class Ceres_iteration
{
public:
  Ceres_iteration(Energy& energy, Eigen::VectorXd& best, const Free_variables& variables,
                  const Minimization_limits& limits, Visitor& visitor)
    : m_descent(energy, best, variables, limits),
      m_visitor(visitor),
      m_coordinates(variables.indices())
  {}

  Minimization_result run()
  {
    Minimization_result result = m_descent.result(minimize());
    result.iterations = m_iterations;
    result.factorizations = result.symbolic_analyses = result.orderings = m_factorizations;
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

  // After this number of iterations, the Hessian at the start is outdated.
  static constexpr std::size_t iterations_of_run = 30;

  Status minimize()
  {
    if(const std::optional<Status> end = m_descent.start())
      return *end;
    while(m_descent.best_norm() > m_descent.tolerance()) {
      if(m_descent.is_at_limit(m_iterations))
        return Status::iteration_limit;
      const double before = m_descent.best_norm();
      if(!start_run())
        return Status::not_finite;
      if(solve() == ceres::NO_CONVERGENCE)
        continue;
      if(!(m_descent.best_norm() < before / 2))
        return failure();
      m_descent.move_to_best();
    }
    return Status::converged;
  }

  // Starts a run. Returns false if no coordinates exist.
  bool start_run()
  {
    m_start = m_descent.point();
    m_start_gradient = m_descent.gradient();
    m_start_value = static_cast<double>(m_descent.energy().value());
    m_iterations_before = m_iterations;
    ++m_factorizations;
    return m_coordinates.set(m_descent.energy().Hessian());
  }

  // Solves; the energy is then evaluated at the end of the run.
  ceres::TerminationType solve()
  {
    Callback callback(*this);
    ceres::GradientProblemSolver::Options options;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations =
      static_cast<int>((std::min)(m_descent.limits().iterations - m_iterations, iterations_of_run));
    options.function_tolerance = 0;
    options.parameter_tolerance = 0;
    options.gradient_tolerance = 0;
    options.min_line_search_step_size = (std::numeric_limits<double>::min)();
    options.callbacks.push_back(&callback);
    ceres::GradientProblemSolver::Summary summary;
    Eigen::VectorXd parameters = Eigen::VectorXd::Zero(number_of_parameters());
    const ceres::GradientProblem problem(new Function(*this));
    ceres::Solve(options, problem, parameters.data(), &summary);
    if(m_exception)
      std::rethrow_exception(m_exception);
    m_descent.move_to(point_at(parameters));
    return summary.termination_type;
  }

  // Returns the status of a failure. Ceres stops if no value along a line is less than the last.
  // Rounding is the reason if the values have hardly changed.
  Status failure() const
  {
    if(std::abs(m_last_change) <= tolerance::cancellation * std::abs(m_start_value))
      return Status::rounding_limit;
    return m_saw_not_finite ? Status::not_finite : Status::no_descent;
  }

  int number_of_parameters() const
  {
    return static_cast<int>(m_descent.variables().indices().size());
  }

  bool evaluate(const double* y, double* value, double* gradient)
  {
    const bool is_finite =
      m_descent.move_to(point_at(Eigen::Map<const Eigen::VectorXd>(y, number_of_parameters())));
    *value = value_since_start();
    if(!is_finite || !std::isfinite(*value)) {
      m_saw_not_finite = true;
      return false;
    }
    m_descent.keep_if_best();
    if(gradient)
      Eigen::Map<Eigen::VectorXd>(gradient, number_of_parameters()) =
        m_coordinates.gradient(m_descent.gradient()(m_descent.variables().indices()));
    return true;
  }

  Eigen::VectorXd point_at(const Eigen::VectorXd& coordinates) const
  {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(m_start.size());
    step(m_descent.variables().indices()) = m_coordinates.variables(coordinates);
    m_descent.variables().remove_means(step);
    return m_start + step;
  }

  // Returns the change of the value. If the values have no digits for their difference, the mean of
  // the slopes determines it.
  double value_since_start() const
  {
    const double difference = static_cast<double>(m_descent.energy().value()) - m_start_value;
    if(!(std::abs(difference) <= tolerance::growth * std::abs(m_start_value)))
      return difference;
    return (m_start_gradient + m_descent.gradient()).dot(m_descent.point() - m_start) / 2;
  }

  ceres::CallbackReturnType after_iteration(const ceres::IterationSummary& summary)
  {
    if(summary.iteration == 0) // the start
      return ceres::SOLVER_CONTINUE;
    m_iterations = m_iterations_before + static_cast<std::size_t>(summary.iteration);
    m_last_change = summary.cost_change;
    m_visitor.after_iteration(m_iterations, m_descent.norm(), summary.step_norm);
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
  Hessian_coordinates m_coordinates;
  Eigen::VectorXd m_start, m_start_gradient; // of the run
  double m_start_value = 0;
  std::size_t m_iterations = 0, m_iterations_before = 0; // in all, and before the run
  std::size_t m_factorizations = 0;
  double m_last_change = 0; // of the value
  bool m_saw_not_finite = false;
  std::exception_ptr m_exception;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_CERES_ITERATION_H
