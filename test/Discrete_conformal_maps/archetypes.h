// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_TEST_ARCHETYPES_H
#define DISCRETE_CONFORMAL_MAPS_TEST_ARCHETYPES_H

#include "../Intrinsic_triangulations/testing.h"

#include <CGAL/Discrete_conformal_maps/Minimization.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

// These models of concepts have only the required members.
namespace archetypes {

namespace DCM = CGAL::Discrete_conformal_maps;

struct No_value
{
  No_value() = default;
  No_value(const No_value&) = delete;
  No_value& operator=(const No_value&) = delete;
};

// Represents the sum of cosh(u_i - i) and of (u_i - u_(i + 1) + 1)^2 / 2, whose minimum is at u_i =
// i.
class Energy_archetype : No_value
{
public:
  typedef double FT;

  explicit Energy_archetype(Eigen::Index size) : m_gradient(size), m_hessian(size, size) {}

  std::size_t size() const { return static_cast<std::size_t>(m_gradient.size()); }

  void evaluate(const Eigen::VectorXd& u)
  {
    const Eigen::Index n = u.size();
    m_value = 0;
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(n, n);
    for(Eigen::Index i = 0; i < n; ++i) {
      m_value += std::cosh(u[i] - double(i));
      m_gradient[i] = std::sinh(u[i] - double(i));
      hessian(i, i) = std::cosh(u[i] - double(i));
    }
    for(Eigen::Index i = 0; i + 1 < n; ++i) {
      const double d = u[i] - u[i + 1] + 1;
      m_value += d * d / 2;
      m_gradient[i] += d;
      m_gradient[i + 1] -= d;
      hessian.block<2, 2>(i, i) += (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
    }
    m_hessian = hessian.sparseView();
    m_hessian.makeCompressed();
  }

  double value() const { return m_value; }
  const Eigen::VectorXd& gradient() const { return m_gradient; }
  const Eigen::SparseMatrix<double>& Hessian() const { return m_hessian; }
  double gradient_error() const { return 1e-14; } // some fifty roundings of numbers up to one

private:
  double m_value = 0;
  Eigen::VectorXd m_gradient;
  Eigen::SparseMatrix<double> m_hessian;
};

struct Minimization_visitor_archetype : No_value
{
  std::size_t calls = 0;

  void after_iteration(std::size_t iteration, double gradient_norm, double step_length)
  {
    EXPECT_EQ(iteration, ++calls);
    EXPECT_GE(gradient_norm, 0);
    EXPECT_GE(step_length, 0);
  }
};

// Finds the minimum of the archetype.
template <typename Minimizer>
void expect_minimum(const Minimizer& minimizer)
{
  constexpr Eigen::Index size = 9;
  Energy_archetype energy(size);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(size);
  Minimization_visitor_archetype visitor;
  const DCM::Minimization_result result = minimizer(energy, u, DCM::Minimization_domain(), visitor);
  EXPECT_EQ(result.status, DCM::Minimization_status::converged);
  EXPECT_EQ(result.iterations, visitor.calls);
  // No eigenvalue of the Hessian is less than one.
  for(Eigen::Index i = 0; i < size; ++i)
    EXPECT_NEAR(u[i], double(i), 3 * (result.gradient_norm + result.gradient_error));
}

} // namespace archetypes

#endif // DISCRETE_CONFORMAL_MAPS_TEST_ARCHETYPES_H
