// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_LEAST_SQUARES_SHIFT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_LEAST_SQUARES_SHIFT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Dirichlet_solver.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Shifts points on a line such that the differences between some of them change as wanted, in the
// sense of weighted least squares. First all differences are added, then changes are asked for. A
// sum is the difference from a mirror image.
class Least_squares_shift
{
public:
  typedef Eigen::VectorXd Vector;

  Least_squares_shift(std::size_t number_of_points, std::size_t number_of_differences)
    : m_diagonal(Vector::Zero(static_cast<Eigen::Index>(number_of_points))),
      m_is_held(number_of_points, 1)
  {
    m_entries.reserve(2 * number_of_differences + number_of_points);
  }

  // `x[j] - sign * x[i]`
  void add(int i, int j, double weight, int sign = 1)
  {
    for(const auto& [from, to] : {std::pair(i, j), std::pair(j, i)}) {
      m_entries.emplace_back(from, to, -sign * weight);
      m_diagonal[from] += weight;
      m_is_held[static_cast<std::size_t>(from)] = 0;
    }
  }

  // Point `i` stays; so do those without differences. After all differences have been added, one of
  // every component that they connect must be held, unless there is a sum in it.
  void fix(int i) { m_is_held[static_cast<std::size_t>(i)] = 1; }

  // `order` is that of the points
  void factorize(const std::shared_ptr<Shared_order>& order)
  {
    for(Eigen::Index i = 0; i < m_diagonal.size(); ++i)
      m_entries.emplace_back(static_cast<int>(i), static_cast<int>(i), m_diagonal[i]);
    Eigen::SparseMatrix<double> matrix(m_diagonal.size(), m_diagonal.size());
    matrix.setFromTriplets(m_entries.begin(), m_entries.end());
    std::vector<Eigen::Triplet<double>>().swap(m_entries); // the factor comes in its place
    m_solver.emplace(matrix, m_is_held, order);
  }

  // Adds to a right side that `x[j] - sign * x[i]`, with this weight, is to change by `change`.
  static void add_to_right_side(Vector& right_side, int i, int j, double weight, double change,
                                int sign = 1)
  {
    right_side[j] += weight * change;
    right_side[i] -= sign * weight * change;
  }

  // Returns how each point is shifted. \pre `factorize()` has been called
  Vector solve(const Vector& right_side) { return m_solver->solve(right_side); }

private:
  std::vector<Eigen::Triplet<double>> m_entries; // beside the diagonal
  Vector m_diagonal;
  std::vector<char> m_is_held;
  std::optional<Dirichlet_solver> m_solver;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_LEAST_SQUARES_SHIFT_H
