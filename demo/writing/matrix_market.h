// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MATRIX_MARKET_H
#define INTRINSIC_MATRIX_MARKET_H

#include <Eigen/SparseCore>

#include <complex>
#include <string>

enum class Matrix_symmetry
{
  GENERAL,
  SYMMETRIC,
  HERMITIAN
};

// A matrix in the Matrix Market coordinate format; of a symmetric or Hermitian one the lower
// triangle. Numbers are the shortest that are read back as the same numbers. The comment is one
// line or more, or empty.
std::string matrix_market(const Eigen::SparseMatrix<double>& matrix, Matrix_symmetry symmetry,
                          const std::string& comment = "");
std::string matrix_market(const Eigen::SparseMatrix<std::complex<double>>& matrix,
                          Matrix_symmetry symmetry);

#endif // INTRINSIC_MATRIX_MARKET_H
