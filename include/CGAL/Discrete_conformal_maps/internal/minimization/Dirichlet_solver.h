// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DIRICHLET_SOLVER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DIRICHLET_SOLVER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Laplacian_elimination.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_direction.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Solves systems with a symmetric positive semidefinite matrix. Rows and columns of some variables
// are omitted; the remaining matrix is positive definite, up to rounding. Solutions are accurate
// enough for estimates and corrections.
class Dirichlet_solver
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef Eigen::VectorXd Vector;

  Dirichlet_solver(const Matrix& matrix, const std::vector<char>& is_fixed,
                   std::shared_ptr<Shared_order> order = std::make_shared<Shared_order>())
    : m_solver(free_variables(is_fixed), std::move(order))
  {
    // The lift, relative to the diagonal, compensates rounding if weights differ by many orders of
    // magnitude.
    for(double lift = 0; !m_solver.factorize(matrix, lift * matrix.diagonal());
        lift = tolerance::next_lift(lift)) {
      const auto& order = m_solver.order(matrix);
      if(Laplacian_elimination<double>::is_needed(matrix, order) &&
         m_elimination.factorize(matrix, Vector::Zero(matrix.cols()), order)) {
        m_is_stiff = true;
        return;
      }
      if(lift > tolerance::greatest_Laplacian_lift)
        throw Intrinsic_triangulations::Numerical_error(
          "the Laplacian has no factorization as a positive definite matrix");
    }
  }

  // Returns the solution, which is zero for fixed variables.
  Vector solve(const Vector& right_side)
  {
    if(!m_is_stiff)
      return m_solver.solve(right_side);
    const std::vector<double> solution = m_elimination.solve(right_side);
    return Eigen::Map<const Vector>(solution.data(), right_side.size());
  }

private:
  typedef Newton_direction::Solver Solver;

  static Solver::Order free_variables(const std::vector<char>& is_fixed)
  {
    Solver::Order result;
    for(std::size_t i = 0; i < is_fixed.size(); ++i)
      if(!is_fixed[i])
        result.push_back(static_cast<Eigen::Index>(i));
    return result;
  }

  Solver m_solver;
  Laplacian_elimination<double> m_elimination; // instead, if weights are very different
  bool m_is_stiff = false;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DIRICHLET_SOLVER_H
