// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_NEWTON_DIRECTION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_NEWTON_DIRECTION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Hessian_solver.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Laplacian_elimination.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Cholesky.h>

#include <Eigen/SparseCore>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns numbers that are added to the diagonal of a Hessian to prevent steps beyond a bound, see
// `Newton_direction`. Entries of the gradient that vanish still need a positive diagonal. The lift,
// relative to the diagonal, compensates rounding in the factorization.
inline Eigen::VectorXd damping(const Eigen::SparseMatrix<double>& hessian,
                               const Eigen::VectorXd& gradient, double bound, double lift)
{
  const double least = tolerance::damping * max_norm(gradient);
  return gradient.cwiseAbs().cwiseMax(least) / bound + lift * hessian.diagonal();
}

// Returns numbers added to the diagonal of a Hessian that has constants on a component in its
// kernel. One diagonal entry is doubled, which ties the variable to a fixed one. If the gradient
// sums to zero, this does not change the other entries of the solution up to a constant. The
// variable with the strongest ties is chosen, for accuracy.
inline Eigen::VectorXd grounding(const Eigen::SparseMatrix<double>& hessian,
                                 const Free_variables& variables)
{
  const Eigen::VectorXd diagonal = hessian.diagonal();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(diagonal.size());
  for(const Free_variables::Indices& component : variables.floating_components()) {
    Eigen::Index strongest = component.front();
    for(Eigen::Index i : component)
      if(diagonal[i] > diagonal[strongest])
        strongest = i;
    result[strongest] = diagonal[strongest] > 0 ? diagonal[strongest] : 1;
  }
  return result;
}

// Returns the differences between the diagonal entries of a Hessian and the weights of their rows.
// They are zero for Laplacians. For hyperbolic faces they are positive up to rounding.
inline Eigen::VectorXd excess_of_diagonal(const Eigen::SparseMatrix<double>& hessian,
                                          const Free_variables& variables)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(hessian.cols());
  if(!variables.has_zero_row_sums())
    for(Eigen::Index column = 0; column < hessian.outerSize(); ++column) {
      for(Eigen::SparseMatrix<double>::InnerIterator i(hessian, column); i; ++i)
        result[column] += i.value();
      result[column] = (std::max)(result[column], 0.);
    }
  return result;
}

// Finds directions in which a convex function falls, from its gradient and Hessian.
//
// If the Hessian alone is singular, or gives a step that is too long (max norm), the entries |g_i|
// / bound are added to its diagonal. Consider a Hessian with positive diagonal and non-positive
// off-diagonals, as a Laplacian has. Then no entry of the step is above the bound (maximum
// principle). If the function is almost linear, the step gets the allowed length. Otherwise it
// hardly changes. The added numbers vanish with the gradient.
class Newton_direction
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef Hessian_solver<Intrinsic_triangulations::Cholesky<double>> Solver;

  explicit Newton_direction(const Free_variables& variables,
                            std::shared_ptr<Shared_order> order = std::make_shared<Shared_order>())
    : m_variables(&variables), m_solver(variables.indices(), std::move(order))
  {}

  const Solver& solver() const { return m_solver; }

  // Returns false if no such direction exists. The Hessian is then not positive semidefinite, even
  // up to rounding.
  bool find(const Matrix& hessian, const Eigen::VectorXd& gradient,
            const Eigen::VectorXd& /* point */, double bound)
  {
    const Eigen::VectorXd ground = grounding(hessian, *m_variables);
    m_is_stiff = m_variables->has_zero_row_sums() &&
                 Laplacian_elimination<double>::is_needed(hessian, m_variables->indices());
    const auto damped = [&](double lift) {
      return solve(hessian, ground + damping(hessian, gradient, bound, lift), gradient);
    };
    if(m_is_damped && damped(0) && length() > bound / 2)
      return limit(bound); // as in the step before
    m_is_damped = !solve(hessian, ground, gradient) || length() > bound;
    for(double lift = 0; m_is_damped && !damped(lift); lift = tolerance::next_lift(lift))
      if(lift > tolerance::greatest_lift)
        return false;
    return limit(bound);
  }

  // Solves with the last factorization.
  bool find_again(const Eigen::VectorXd& gradient)
  {
    if(m_is_stiff) {
      const std::vector<double> solution = m_elimination.solve(-gradient);
      m_direction = Eigen::Map<const Eigen::VectorXd>(solution.data(), gradient.size());
    } else
      m_direction = m_solver.solve(-gradient);
    m_variables->remove_means(m_direction);
    return m_direction.allFinite() && gradient.dot(m_direction) <= 0;
  }

  const Eigen::VectorXd& direction() const { return m_direction; }
  double length() const { return max_norm(m_direction); }
  bool is_damped() const { return m_is_damped; }

private:
  bool solve(const Matrix& hessian, const Eigen::VectorXd& diagonal,
             const Eigen::VectorXd& gradient)
  {
    const bool is_factorized =
      m_is_stiff ? m_elimination.factorize(hessian, diagonal, m_solver.order(hessian))
                 : m_solver.factorize(hessian, diagonal);
    return is_factorized && find_again(gradient);
  }

  bool limit(double bound)
  {
    if(const double l = length(); l > bound)
      m_direction *= bound / l;
    return true;
  }

  const Free_variables* m_variables;
  Solver m_solver;
  Laplacian_elimination<double> m_elimination; // instead, if weights are very different
  bool m_is_stiff = false;
  Eigen::VectorXd m_direction;
  bool m_is_damped = false;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_NEWTON_DIRECTION_H
