// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DIFFERENCE_BOUNDED_NEWTON_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DIFFERENCE_BOUNDED_NEWTON_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Laplacian_elimination.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Newton_direction.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Newton's method for a convex energy whose Hessian is a Laplacian, with steps that bound the
// differences of neighbors. All variables together can move far in one step.
//
// If the step would change a difference by more than the bound, the weight between both neighbors
// is raised. The same flow then changes the difference by the bound. Some factorizations find such
// weights. The matrix is the Hessian plus a Laplacian. So the energy falls in the direction of
// the step. A step is shortened until its slope shows that it does not go far beyond the minimum on
// its line. Steps have the digits of the energy.
template <typename Energy>
class Difference_bounded_newton
{
  typedef typename Energy::FT FT;
  typedef std::vector<FT> Values;
  typedef Eigen::VectorXd Vector;
  typedef Eigen::SparseMatrix<double> Matrix;

public:
  Difference_bounded_newton(Energy& energy, const Minimization_domain& domain)
    : m_energy(energy),
      m_variables(domain, energy.size()),
      m_solver(m_variables.indices(), energy.shared_order())
  {}

  // Takes steps from the origin of the energy until no entry of the gradient is above `tolerance`.
  // Twice its rounding error is enough, if a map may have that. Flips count as steps.
  template <typename Visitor>
  Minimization_result run(double tolerance, std::size_t maximum_number_of_steps, Visitor& visitor)
  {
    Minimization_status status = move_to(m_energy.scale_factors())
                                   ? Minimization_status::converged
                                   : Minimization_status::not_finite;
    while(status == Minimization_status::converged && !is_within(tolerance))
      if(m_result.iterations == maximum_number_of_steps || has_worked_enough())
        status = Minimization_status::iteration_limit;
      else {
        status = step();
        visitor.after_iteration(++m_result.iterations, max_norm(m_gradient), m_length);
      }
    m_result.status = status;
    m_result.gradient_norm = max_norm(m_gradient);
    m_result.gradient_error = m_energy.gradient_error();
    return m_result;
  }

private:
  static constexpr double bound = 0.5; // of differences of neighbors
  static constexpr int number_of_raises = 5, number_of_trials = 12;
  // Where weights vanish, rounding alone determines differences.
  static constexpr double least_weight = 1e-17;

  // Returns whether the gradient is known at `u`.
  bool move_to(const Values& u)
  {
    ++m_result.evaluations;
    m_energy.set_origin(u);
    try {
      m_energy.evaluate(Vector::Zero(Eigen::Index(m_energy.size())));
    } catch(const Intrinsic_triangulations::Flip_limit_exceeded&) {
      return false;
    }
    m_gradient = m_energy.gradient();
    m_variables.set_fixed_to_zero(m_gradient);
    m_variables.remove_means(m_gradient);
    return m_gradient.allFinite() && m_energy.gradient_error() <= tolerance::curvature_at_start;
  }

  bool is_within(double tolerance) const
  {
    return max_norm(m_gradient) <= (std::max)(tolerance, (std::min)(tolerance::promised_angle / 2,
                                                                    2 * m_energy.gradient_error()));
  }

  bool has_worked_enough() const
  {
    const auto& surface = m_energy.energy().surface();
    return m_result.evaluations * surface.mesh().num_faces() + surface.number_of_flips() / 10 >
           tolerance::work_with_bounded_differences;
  }

  Minimization_status step()
  {
    Values direction;
    if(!find(direction))
      return Minimization_status::not_finite;
    const Values base = m_energy.scale_factors();
    Vector rounded(m_gradient.size());
    for(std::size_t v = 0; v < base.size(); ++v)
      rounded[Eigen::Index(v)] = static_cast<double>(direction[v]);
    const double slope = m_gradient.dot(rounded);
    double part = 1;
    bool is_known = false;
    for(int trial = 0; trial < number_of_trials; ++trial) {
      is_known = move(base, direction, part);
      const double beyond = is_known ? m_gradient.dot(rounded) : 0;
      m_length = part * max_norm(rounded);
      if(is_known && beyond <= -slope / 2)
        break;
      part *= is_known ? std::clamp(slope / (slope - beyond), 0.1, 0.9) : 0.1;
    }
    return is_known ? Minimization_status::converged : Minimization_status::rounding_limit;
  }

  bool move(Values u, const Values& direction, double part)
  {
    for(std::size_t v = 0; v < u.size(); ++v)
      u[v] += FT(part) * direction[v];
    return move_to(u);
  }

  // Returns whether there is a direction.
  bool find(Values& direction)
  {
    Matrix matrix = m_energy.Hessian();
    if(!matrix.coeffs().allFinite())
      return false;
    const Vector ground = grounding(matrix, m_variables);
    double greatest = 0;
    for(int i = 0; i <= number_of_raises; ++i) {
      ++m_result.factorizations;
      if(!m_elimination.factorize(matrix, ground, m_solver.order(matrix)))
        return false;
      direction = m_elimination.solve(-m_gradient);
      greatest = raise_weights(matrix, direction);
      if(greatest <= 1.5 * bound)
        return true;
    }
    for(FT& x : direction)
      x *= FT((std::min)(1., 4 * bound / greatest));
    return true;
  }

  // Raises weights between neighbors whose difference is beyond the bound. Returns the greatest
  // difference.
  static double raise_weights(Matrix& matrix, const Values& direction)
  {
    double greatest = 0;
    for(Eigen::Index column = 0; column < matrix.outerSize(); ++column)
      for(Matrix::InnerIterator i(matrix, column); i; ++i) {
        const double difference = std::abs(static_cast<double>(
          FT(direction[std::size_t(i.row())] - direction[std::size_t(column)])));
        greatest = (std::max)(greatest, difference);
        if(difference > 1.5 * bound)
          i.valueRef() = (std::min)(i.value(), -least_weight) * (difference / bound);
      }
    return greatest;
  }

  Energy& m_energy;
  Free_variables m_variables;
  Newton_direction::Solver m_solver; // only its order is used
  Laplacian_elimination<FT> m_elimination;
  Vector m_gradient;
  double m_length = 0; // of a step
  Minimization_result m_result;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_DIFFERENCE_BOUNDED_NEWTON_H
