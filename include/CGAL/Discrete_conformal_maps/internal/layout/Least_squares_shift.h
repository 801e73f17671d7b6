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
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Shifts points in the plane such that the vectors between some of them change as wanted, in the
// sense of weighted least squares.
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

  // the vector from point `i` to point `j` is to change by `change`
  void add(int i, int j, double weight, const std::complex<double>& change)
  {
    add_to_row(j, i, weight, change);
    add_to_row(i, j, weight, -change);
    m_is_held[static_cast<std::size_t>(i)] = m_is_held[static_cast<std::size_t>(j)] = 0;
  }

  // Point `i` stays; so do those without vectors. One of every connected component must be held,
  // after all vectors have been added.
  void hold(int i) { m_is_held[static_cast<std::size_t>(i)] = 1; }

  void solve()
  {
    for(Eigen::Index i = 0; i < m_diagonal.size(); ++i)
      m_entries.emplace_back(static_cast<int>(i), static_cast<int>(i), m_diagonal[i]);
    Eigen::SparseMatrix<double> matrix(m_x.size(), m_x.size());
    matrix.setFromTriplets(m_entries.begin(), m_entries.end());
    m_entries = {}; // the factor comes in its place
    Dirichlet_solver solver(matrix, m_is_held);
    m_x = solver.solve(m_x);
    m_y = solver.solve(m_y);
  }

  // how point `i` is shifted. \pre `solve()` has been called
  std::complex<double> operator()(std::size_t i) const
  {
    return {m_x[static_cast<Eigen::Index>(i)], m_y[static_cast<Eigen::Index>(i)]};
  }

private:
  void add_to_row(int i, int j, double weight, const std::complex<double>& change)
  {
    m_entries.emplace_back(i, j, -weight);
    m_diagonal[i] += weight;
    m_x[i] += weight * change.real();
    m_y[i] += weight * change.imag();
  }

  std::vector<Eigen::Triplet<double>> m_entries; // beside the diagonal
  Vector m_diagonal;
  Vector m_x, m_y; // the right sides, then the solution
  std::vector<char> m_is_held;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_LEAST_SQUARES_SHIFT_H
