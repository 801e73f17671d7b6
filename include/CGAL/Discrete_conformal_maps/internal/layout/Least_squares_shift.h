// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_LEAST_SQUARES_SHIFT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_LEAST_SQUARES_SHIFT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Dirichlet_solver.h>

#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Shifts points in the plane such that the vectors between some of them change as wanted, in the
// sense of weighted least squares. First all vectors are added, then changes are asked for.
class Least_squares_shift
{
  typedef Eigen::VectorXd Vector;

public:
  Least_squares_shift(std::size_t number_of_points, std::size_t number_of_vectors)
    : m_diagonal(Vector::Zero(static_cast<Eigen::Index>(number_of_points))),
      m_x(m_diagonal),
      m_y(m_x),
      m_is_held(number_of_points, 1)
  {
    m_entries.reserve(2 * number_of_vectors + number_of_points);
  }

  // a vector from point `i` to point `j`
  void add(int i, int j, double weight)
  {
    for(const auto& [from, to] : {std::pair(i, j), std::pair(j, i)}) {
      m_entries.emplace_back(from, to, -weight);
      m_diagonal[from] += weight;
      m_is_held[static_cast<std::size_t>(from)] = 0;
    }
  }

  // Point `i` stays; so do those without vectors. One of every connected component must be held,
  // after all vectors have been added.
  void hold(int i) { m_is_held[static_cast<std::size_t>(i)] = 1; }

  // `order` is that of the points
  void factorize(const std::shared_ptr<Shared_order>& order)
  {
    for(Eigen::Index i = 0; i < m_diagonal.size(); ++i)
      m_entries.emplace_back(static_cast<int>(i), static_cast<int>(i), m_diagonal[i]);
    Eigen::SparseMatrix<double> matrix(m_x.size(), m_x.size());
    matrix.setFromTriplets(m_entries.begin(), m_entries.end());
    std::vector<Eigen::Triplet<double>>().swap(m_entries); // the factor comes in its place
    m_solver.emplace(matrix, m_is_held, order);
  }

  // the vector from `i` to `j`, with this weight, is to change by `change`
  void want(int i, int j, double weight, const std::complex<double>& change)
  {
    m_x[j] += weight * change.real();
    m_y[j] += weight * change.imag();
    m_x[i] -= weight * change.real();
    m_y[i] -= weight * change.imag();
  }

  // Returns how each point is shifted. \pre `factorize()` has been called
  std::vector<std::complex<double>> solve()
  {
    const Vector x = m_solver->solve(m_x), y = m_solver->solve(m_y);
    m_x.setZero();
    m_y.setZero();
    std::vector<std::complex<double>> result;
    for(Eigen::Index i = 0; i < x.size(); ++i)
      result.emplace_back(x[i], y[i]);
    return result;
  }

private:
  std::vector<Eigen::Triplet<double>> m_entries; // beside the diagonal
  Vector m_diagonal;
  Vector m_x, m_y; // the right sides
  std::vector<char> m_is_held;
  std::optional<Dirichlet_solver> m_solver;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_LEAST_SQUARES_SHIFT_H
