// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/matrix_market.h"

#include "writing/Text.h"

#include <array>
#include <sstream>

namespace {

constexpr std::array<std::string_view, 3> symmetry_names = {"general", "symmetric", "hermitian"};

constexpr std::string_view field_name(double) { return "real"; }
constexpr std::string_view field_name(const std::complex<double>&) { return "complex"; }

Text& operator<<(Text& text, const std::complex<double>& z)
{
  return text << z.real() << ' ' << z.imag();
}

template <class Scalar>
void add_entries(Text& text, const Eigen::SparseMatrix<Scalar>& matrix)
{
  typedef typename Eigen::SparseMatrix<Scalar>::InnerIterator Entry_iterator;
  text << std::int64_t(matrix.rows()) << ' ' << std::int64_t(matrix.cols()) << ' '
       << std::int64_t(matrix.nonZeros()) << '\n';
  for(Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for(Entry_iterator it(matrix, column); it; ++it)
      text << std::int64_t(it.row() + 1) << ' ' << std::int64_t(it.col() + 1) << ' ' << it.value()
           << '\n';
}

void add_comment(Text& text, const std::string& comment)
{
  std::istringstream lines(comment);
  for(std::string line; std::getline(lines, line);)
    text << "% " << line << '\n';
}

template <class Scalar>
std::string text_of(const Eigen::SparseMatrix<Scalar>& matrix, Matrix_symmetry symmetry,
                    const std::string& comment = "")
{
  Text text;
  text << "%%MatrixMarket matrix coordinate " << field_name(Scalar()) << ' '
       << symmetry_names[static_cast<std::size_t>(symmetry)] << '\n';
  add_comment(text, comment);
  if(symmetry == Matrix_symmetry::GENERAL)
    add_entries(text, matrix);
  else
    add_entries<Scalar>(text, matrix.template triangularView<Eigen::Lower>());
  return text.take();
}

} // namespace

std::string matrix_market(const Eigen::SparseMatrix<double>& matrix, Matrix_symmetry symmetry,
                          const std::string& comment)
{
  return text_of(matrix, symmetry, comment);
}

std::string matrix_market(const Eigen::SparseMatrix<std::complex<double>>& matrix,
                          Matrix_symmetry symmetry)
{
  return text_of(matrix, symmetry);
}
