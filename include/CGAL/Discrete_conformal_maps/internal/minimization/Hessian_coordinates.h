// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_HESSIAN_COORDINATES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_HESSIAN_COORDINATES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Reordered_matrix.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace CGAL::Discrete_conformal_maps::internal {

// Coordinates y of the variables that move in which a Hessian L L^T is the identity: L^T x = y. A
// method that knows gradients only makes few steps in them.
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

  // the variables of the point with the coordinates `y`
  Eigen::VectorXd variables(const Eigen::VectorXd& y) const
  {
    return m_factor.permutationPinv() * m_factor.matrixU().solve(y);
  }

  // the derivatives by the coordinates
  Eigen::VectorXd gradient(const Eigen::VectorXd& by_variables) const
  {
    return m_factor.matrixL().solve(m_factor.permutationP() * by_variables);
  }

private:
  const Free_variables::Indices& m_free;
  Eigen::SimplicialLLT<Matrix, Eigen::Upper> m_factor;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_HESSIAN_COORDINATES_H
