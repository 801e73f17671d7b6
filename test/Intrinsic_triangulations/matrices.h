// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_MATRICES_H
#define INTRINSIC_TRIANGULATIONS_TEST_MATRICES_H

#include "testing.h"

#include <Eigen/SparseCore>

// This file defines vectors, and sizes of vectors and matrices.
namespace Test_surfaces {

inline Eigen::VectorXd random_numbers(std::size_t n, double bound, unsigned int seed)
{
  CGAL::Random random(seed);
  Eigen::VectorXd result(static_cast<Eigen::Index>(n));
  for(double& x : result)
    x = bound * random.get_double(-1, 1);
  return result;
}

inline Eigen::VectorXd ones(const Eigen::SparseMatrix<double>& m)
{
  return Eigen::VectorXd::Ones(m.cols());
}

inline double largest(const Eigen::VectorXd& v)
{
  return v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff();
}

inline double largest(const Eigen::SparseMatrix<double>& m)
{
  return m.nonZeros() == 0 ? 0 : m.coeffs().cwiseAbs().maxCoeff();
}

inline double largest_distance(const Eigen::SparseMatrix<double>& a,
                               const Eigen::SparseMatrix<double>& b)
{
  return largest(Eigen::SparseMatrix<double>(a - b));
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_MATRICES_H
