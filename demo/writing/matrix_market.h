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

// Returns a matrix in the Matrix Market coordinate format, or the lower triangle of a symmetric or
// Hermitian matrix. Numbers are the shortest that are read back as the same numbers. The comment
// has one or more lines, or is empty.
std::string matrix_market(const Eigen::SparseMatrix<double>& matrix, Matrix_symmetry symmetry,
                          const std::string& comment = "");
std::string matrix_market(const Eigen::SparseMatrix<std::complex<double>>& matrix,
                          Matrix_symmetry symmetry);

#endif // INTRINSIC_MATRIX_MARKET_H
