// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_BOUNDED_DIRECTION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_BOUNDED_DIRECTION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_direction.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents variables with lower bounds, and fixed variables. Every direction changes the
// function.
class Bounded_variables
{
public:
  typedef Free_variables::Indices Indices;
  typedef Eigen::VectorXd Vector;

  Bounded_variables(const Minimization_domain& domain, const Vector& lower_bound)
    : m_fixed(domain, static_cast<std::size_t>(lower_bound.size())), m_lower_bound(lower_bound)
  {
    CGAL_precondition(m_fixed.floating_components().empty());
  }

  const Indices& indices() const { return m_fixed.indices(); }
  const Vector& lower_bound() const { return m_lower_bound; }

  void set_fixed_to_zero(Vector& v) const { m_fixed.set_fixed_to_zero(v); }
  double remove_means(Vector&) const { return 0; }

  // Returns the point with variables moved to their bounds if they are below them, or within some
  // rounding errors. Functions may not distinguish them.
  Vector feasible(const Vector& point) const
  {
    Vector result = point;
    for(const Eigen::Index i : indices()) {
      const double l = m_lower_bound[i];
      const double margin = tolerance::variable * std::abs(l);
      if(std::isfinite(l) && result[i] <= l + margin)
        result[i] = l;
    }
    return result;
  }

  // Returns the norm of the gradient. If a variable is at its bound, only a negative derivative
  // counts.
  double norm(const Vector& gradient, const Vector& point) const
  {
    double result = 0;
    for(const Eigen::Index i : indices()) {
      const double g = gradient[i];
      if(!(point[i] == m_lower_bound[i] && g > 0))
        result = std::abs(g) <= result ? result : std::abs(g); // keeps NaN
    }
    return result;
  }

private:
  Free_variables m_fixed;
  Vector m_lower_bound;
};

// Finds directions that lead to the minimum of a quadratic function under lower bounds, from the
// gradient and Hessian of a convex function. The Hessian may be damped as in `Newton_direction`.
// The maximum principle also holds with bounds.
//
// Block principal pivoting finds the variables that reach their bounds (Judice and Pires 1994): all
// variables that violate a condition change sides. For a Laplacian this takes few rounds. If their
// number does not decrease, only the last one changes, which always terminates (Murty 1974).
class Bounded_direction
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef Eigen::VectorXd Vector;
  typedef Newton_direction::Solver Solver;

  explicit Bounded_direction(const Bounded_variables& variables,
                             std::shared_ptr<Shared_order> order = std::make_shared<Shared_order>())
    : m_variables(variables), m_solver(variables.indices(), std::move(order))
  {}

  const Solver& solver() const { return m_solver; }

  // Returns false if no such direction exists. The Hessian is then not positive semidefinite, even
  // up to rounding.
  bool find(const Matrix& hessian, const Vector& gradient, const Vector& point, double bound)
  {
    m_slack = m_variables.lower_bound() - point;
    const auto damped = [&](double lift) {
      return minimize(hessian, damping(hessian, gradient, bound, lift), gradient, infinity);
    };
    if(m_is_damped && damped(0) && length() > bound / 2)
      return true; // as in the step before
    m_is_damped = !minimize(hessian, Vector::Zero(gradient.size()), gradient, bound);
    for(double lift = 0; m_is_damped && !damped(lift); lift = tolerance::next_lift(lift))
      if(lift > tolerance::greatest_lift)
        return false;
    return true;
  }

  // Solves with the last factorization, without the variables at bounds.
  bool find_again(const Vector& gradient)
  {
    m_direction = solve_free(gradient);
    return m_direction.allFinite() && gradient.dot(m_direction) <= 0;
  }

  const Vector& direction() const { return m_direction; }
  double length() const { return max_norm(m_direction); }
  bool is_damped() const { return m_is_damped; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // Minimizes the quadratic function with `diagonal` added to the Hessian. Returns false if the sum
  // has no factorization, or if the step seems to be longer than `bound`.
  bool minimize(const Matrix& hessian, const Vector& diagonal, const Vector& gradient, double bound)
  {
    start(gradient);
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for(int round = 0, patience = 10; round < 1000; ++round) {
      if(!solve(hessian, diagonal, gradient) || length() > bound)
        return false;
      const std::vector<Eigen::Index> wrong = violations(hessian, diagonal, gradient);
      if(wrong.empty())
        break;
      patience = wrong.size() < fewest ? 10 : patience - 1;
      fewest = (std::min)(fewest, wrong.size());
      for(std::size_t k = patience > 0 ? 0 : wrong.size() - 1; k < wrong.size(); ++k)
        m_is_active[std::size_t(wrong[k])] ^= 1;
    }
    for(const Eigen::Index i : m_variables.indices())
      m_direction[i] = (std::max)(m_direction[i], m_slack[i]);
    return gradient.dot(m_direction) <= 0;
  }

  // Starts the search. First all variables at their bounds are active. Later the active set
  // consists of the previous one and of variables that their bounds hold.
  void start(const Vector& gradient)
  {
    const bool is_first = m_is_active.empty();
    m_is_active.resize(std::size_t(gradient.size()), 0);
    for(const Eigen::Index i : m_variables.indices())
      if(m_slack[i] == 0)
        m_is_active[std::size_t(i)] = is_first || gradient[i] > 0;
  }

  // Solves for the other variables. Active variables move to their bounds. Weights beyond all
  // others exclude them.
  bool solve(const Matrix& hessian, const Vector& diagonal, const Vector& gradient)
  {
    const double weight = 1e30 * (1 + hessian.diagonal().maxCoeff() + diagonal.maxCoeff());
    Vector to_bounds = Vector::Zero(gradient.size()), weighted = diagonal;
    for(const Eigen::Index i : m_variables.indices())
      if(is_active(i)) {
        to_bounds[i] = m_slack[i];
        weighted[i] = weight;
      }
    if(!m_solver.factorize(hessian, weighted))
      return false;
    m_direction = to_bounds + solve_free(gradient + hessian * to_bounds);
    return m_direction.allFinite();
  }

  // Returns the solution with the last factorization.
  Vector solve_free(const Vector& gradient)
  {
    Vector result = -gradient;
    set_active_to_zero(result);
    result = m_solver.solve(result);
    set_active_to_zero(result);
    return result;
  }

  void set_active_to_zero(Vector& v) const
  {
    for(const Eigen::Index i : m_variables.indices())
      if(is_active(i))
        v[i] = 0;
  }

  // Returns how far an inactive variable would move below its bound.
  double greatest_depth() const
  {
    double result = 0;
    for(const Eigen::Index i : m_variables.indices())
      if(!is_active(i))
        result = (std::max)(result, m_slack[i] - m_direction[i]);
    return result;
  }

  // Returns the variables that violate a condition of the minimum by more than rounding. If some
  // are below their bounds, the lowest suffice: others will follow them.
  std::vector<Eigen::Index> violations(const Matrix& hessian, const Vector& diagonal,
                                       const Vector& gradient) const
  {
    const Vector slope = gradient + hessian * m_direction + diagonal.cwiseProduct(m_direction);
    const Vector size = gradient.cwiseAbs() + hessian.cwiseAbs() * m_direction.cwiseAbs() +
                        diagonal.cwiseProduct(m_direction.cwiseAbs());
    const double margin = tolerance::cancellation,
                 depth = (std::max)(margin * length(), 0.8 * greatest_depth());
    std::vector<Eigen::Index> result;
    for(const Eigen::Index i : m_variables.indices())
      if(is_active(i) ? slope[i] < -margin * size[i] : m_slack[i] - m_direction[i] > depth)
        result.push_back(i);
    return result;
  }

  bool is_active(Eigen::Index i) const { return m_is_active[static_cast<std::size_t>(i)] != 0; }

  const Bounded_variables& m_variables;
  Solver m_solver;
  Vector m_slack; // how far down variables can go: negative or zero
  std::vector<char> m_is_active;
  Vector m_direction;
  bool m_is_damped = false;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_BOUNDED_DIRECTION_H
