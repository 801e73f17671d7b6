// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_MIXED_CHOLESKY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_MIXED_CHOLESKY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The following functions convert real or complex numbers between many digits and `double`.
template <typename Real>
Real real_part(const Real& x)
{
  return x;
}
template <typename Real>
Real real_part(const std::complex<Real>& x)
{
  return x.real();
}
template <typename Real>
Real conjugate(const Real& x)
{
  return x;
}
template <typename Real>
std::complex<Real> conjugate(const std::complex<Real>& x)
{
  return std::conj(x);
}
template <typename Real>
double rounded(const Real& x)
{
  return CGAL::to_double(x);
}
template <typename Real>
std::complex<double> rounded(const std::complex<Real>& x)
{
  return {CGAL::to_double(x.real()), CGAL::to_double(x.imag())};
}
// Computes the Cholesky factorization of a Hermitian matrix of numbers with many digits, given by
// its upper triangle. Rows with large diagonal entries would lose significant digits in `double`,
// and are eliminated with all digits. The rest is factorized in `double`. Such rows belong to
// vertices that nearly coincide, or that lie almost on a border edge.
template <typename Scalar, typename Rounded>
class Mixed_Cholesky
{
public:
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> Columns;
  typedef typename Eigen::NumTraits<Scalar>::Real Real;

  // Returns an order that depends only on the sparsity pattern.
  static Eigen::VectorXi fill_reducing_order(const Matrix& matrix)
  {
    const Rounded_matrix pattern = matrix.unaryExpr([](const Scalar&) { return Rounded(1); });
    return Cholesky<Rounded>::fill_reducing_order(pattern);
  }

  void analyze(const Matrix&, bool /* has_many_solutions */ = false) {}

  // Returns false if the matrix is not positive definite.
  bool factorize(const Matrix& upper)
  {
    set_numbers(upper);
    std::vector<Row> row(m_first.size());
    Updates rest;
    distribute(upper, row);
    m_columns.assign(m_first.size(), {});
    for(std::size_t k = 0; k < m_first.size(); ++k)
      if(!eliminate(k, row, rest))
        return false;
    return factorize_rest(upper, rest);
  }

  Vector solve(const Vector& right_side) const
  {
    Vector x = right_side;
    for(std::size_t k = 0; k < m_first.size(); ++k)
      for(const auto& [p, factor] : m_columns[k].factors)
        x[p] -= factor * x[m_first[k]];
    solve_rest(x);
    for(std::size_t k = m_first.size(); k-- > 0;) {
      Scalar& value = x[m_first[k]];
      value /= m_columns[k].pivot;
      for(const auto& [p, factor] : m_columns[k].factors)
        value -= conjugate(factor) * x[p];
    }
    return x;
  }

  Columns solve_columns(Columns right_sides) const
  {
    for(Eigen::Index k = 0; k < right_sides.cols(); ++k)
      right_sides.col(k) = solve(right_sides.col(k));
    return right_sides;
  }

private:
  typedef Eigen::SparseMatrix<Rounded> Rounded_matrix;
  typedef Eigen::Matrix<Rounded, Eigen::Dynamic, 1> Rounded_vector;
  typedef std::map<int, Scalar> Row;
  typedef std::map<std::pair<int, int>, Scalar> Updates; // of the upper triangle of the rest

  struct Column
  {
    Real pivot;
    std::vector<std::pair<int, Scalar>> factors;
  };

  bool is_first(int i) const { return m_number[index(i)] < 0; }
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  // Splits the rows into rows that are eliminated first and the rest.
  void set_numbers(const Matrix& upper)
  {
    m_first.clear();
    m_rest.clear();
    m_number.assign(static_cast<std::size_t>(upper.rows()), -1);
    std::vector<char> is_large(m_number.size(), 0);
    for(int j = 0; j < upper.outerSize(); ++j)
      for(typename Matrix::InnerIterator entry(upper, j); entry; ++entry)
        if(entry.row() == j && real_part(entry.value()) > Real(greatest_rounded_weight()))
          is_large[index(j)] = 1;
    for(int i = 0; i < upper.rows(); ++i)
      if(is_large[index(i)])
        m_first.push_back(i);
      else {
        m_number[index(i)] = static_cast<int>(m_rest.size());
        m_rest.push_back(i);
      }
  }

  // Returns which of two rows is eliminated first.
  bool is_before(int i, int j) const { return is_first(i) != is_first(j) ? is_first(i) : i < j; }

  // Copies the matrix for the elimination with all digits. An entry is stored with the row that is
  // eliminated first, in the column of the other row.
  void distribute(const Matrix& upper, std::vector<Row>& row) const
  {
    std::vector<int> place(m_number.size(), -1);
    for(std::size_t k = 0; k < m_first.size(); ++k)
      place[index(m_first[k])] = static_cast<int>(k);
    for(int j = 0; j < upper.outerSize(); ++j)
      for(typename Matrix::InnerIterator entry(upper, j); entry; ++entry) {
        const int i = static_cast<int>(entry.row());
        if(!is_first(i) && !is_first(j))
          continue;
        if(is_before(i, j) || i == j)
          row[index(place[index(i)])][j] = conjugate(entry.value());
        else
          row[index(place[index(j)])][i] = entry.value();
      }
  }

  // Subtracts the contribution of a row that is eliminated from all later rows.
  bool eliminate(std::size_t k, std::vector<Row>& row, Updates& rest)
  {
    const int s = m_first[k];
    Column& column = m_columns[k];
    column.pivot = real_part(row[k][s]);
    if(!(column.pivot > 0) || !CGAL::is_finite(column.pivot))
      return false;
    for(const auto& [p, value] : row[k])
      if(p != s)
        column.factors.emplace_back(p, Scalar(value / column.pivot));
    for(const auto& [p, factor_p] : column.factors)
      for(const auto& [q, factor_q] : column.factors)
        if(p == q || is_before(p, q))
          subtract(p, q, Scalar(factor_q * conjugate(factor_p) * column.pivot), row, rest);
    row[k].clear();
    return true;
  }

  // Subtracts from the entry in row q of column p.
  void subtract(int p, int q, const Scalar& value, std::vector<Row>& row, Updates& rest) const
  {
    if(is_first(p)) {
      const auto place = std::lower_bound(m_first.begin(), m_first.end(), p);
      row[static_cast<std::size_t>(place - m_first.begin())][q] -= value;
    } else
      rest[{p, q}] -= conjugate(value);
  }

  bool factorize_rest(const Matrix& upper, Updates& rest)
  {
    std::vector<Eigen::Triplet<Rounded>> entries;
    const auto add = [&](int i, int j, const Scalar& value) {
      entries.emplace_back(m_number[index(i)], m_number[index(j)], rounded(value));
      if(i != j)
        entries.emplace_back(m_number[index(j)], m_number[index(i)], rounded(conjugate(value)));
    };
    for(int j = 0; j < upper.outerSize(); ++j)
      for(typename Matrix::InnerIterator entry(upper, j); entry; ++entry) {
        const int i = static_cast<int>(entry.row());
        if(is_first(i) || is_first(j))
          continue;
        const auto update = rest.find({i, j});
        add(i, j, update == rest.end() ? entry.value() : Scalar(entry.value() + update->second));
        if(update != rest.end())
          rest.erase(update);
      }
    for(const auto& [place, value] : rest)
      add(place.first, place.second, value);
    Rounded_matrix matrix(static_cast<Eigen::Index>(m_rest.size()),
                          static_cast<Eigen::Index>(m_rest.size()));
    matrix.setFromTriplets(entries.begin(), entries.end());
    try {
      m_factorization = std::make_unique<Factorization<Rounded>>(matrix, "rest");
    } catch(const Numerical_error&) {
      return false;
    }
    return true;
  }

  void solve_rest(Vector& x) const
  {
    Rounded_vector y(static_cast<Eigen::Index>(m_rest.size()));
    for(std::size_t k = 0; k < m_rest.size(); ++k)
      y[static_cast<Eigen::Index>(k)] = rounded(x[m_rest[k]]);
    y = m_factorization->solve(y);
    for(std::size_t k = 0; k < m_rest.size(); ++k)
      x[m_rest[k]] = Scalar(y[static_cast<Eigen::Index>(k)]);
  }

  std::vector<int> m_first, m_rest; // rows that are eliminated with all digits, and the others
  std::vector<int> m_number;        // of each row among the rest; -1 if it is eliminated first
  std::vector<Column> m_columns;
  std::unique_ptr<Factorization<Rounded>> m_factorization;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_MIXED_CHOLESKY_H
