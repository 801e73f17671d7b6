// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sparse Cholesky factorizations of both libraries are compared with dense products, and conjugate
// gradients with a factorization.

#include "testing.h"

#include <CGAL/Intrinsic_triangulations/Cholesky.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/conjugate_gradients.h>
#ifdef TEST_SUPERNODAL_CHOLESKY
#include <CGAL/Intrinsic_triangulations/internal/operators/Supernodal_Cholesky.h>
#endif

#include <Eigen/Dense>

namespace Test_factorization {

using namespace CGAL::Intrinsic_triangulations;
typedef std::complex<double> Complex;

double random_scalar(CGAL::Random& random, double*) { return random.get_double(-1, 1); }
Complex random_scalar(CGAL::Random& random, Complex*)
{
  return {random.get_double(-1, 1), random.get_double(-1, 1)};
}

// Returns a Hermitian matrix with a dominant diagonal, whose inverse has a norm of at most one.
template <typename Scalar>
Eigen::SparseMatrix<Scalar> definite_matrix(int size, CGAL::Random& random)
{
  std::vector<Eigen::Triplet<Scalar>> entries;
  std::vector<double> sum(static_cast<std::size_t>(size), 1);
  for(int k = 0; k < 3 * size; ++k) {
    const int i = random.get_int(0, size), j = random.get_int(0, size);
    if(i == j)
      continue;
    const Scalar x = random_scalar(random, static_cast<Scalar*>(nullptr));
    entries.emplace_back(i, j, x);
    entries.emplace_back(j, i, Eigen::numext::conj(x));
    for(const int r : {i, j})
      sum[static_cast<std::size_t>(r)] += std::abs(x);
  }
  for(int i = 0; i < size; ++i)
    entries.emplace_back(i, i, Scalar(sum[static_cast<std::size_t>(i)]));
  Eigen::SparseMatrix<Scalar> result(size, size);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

template <typename Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

template <typename Scalar>
Vector<Scalar> random_vector(int size, CGAL::Random& random)
{
  Vector<Scalar> result(size);
  for(Scalar& x : result)
    x = random_scalar(random, static_cast<Scalar*>(nullptr));
  return result;
}

template <typename Cholesky>
class Cholesky_factorization : public testing::Test
{};

#ifdef TEST_SUPERNODAL_CHOLESKY
typedef testing::Types<
  internal::Simplicial_Cholesky<double>, internal::Simplicial_Cholesky<Complex>,
  internal::Supernodal_Cholesky<double>, internal::Supernodal_Cholesky<Complex>>
  Factorizations;
#else
typedef testing::Types<internal::Simplicial_Cholesky<double>,
                       internal::Simplicial_Cholesky<Complex>>
  Factorizations;
#endif
TYPED_TEST_SUITE(Cholesky_factorization, Factorizations, );

TYPED_TEST(Cholesky_factorization, solves)
{
  typedef typename TypeParam::Matrix::Scalar Scalar;
  CGAL::Random random(1);
  for(const int size : {1, 2, 10, 100, 2000}) {
    const auto matrix = definite_matrix<Scalar>(size, random);
    const Vector<Scalar> b = random_vector<Scalar>(size, random);
    TypeParam cholesky;
    cholesky.analyze(matrix);
    ASSERT_TRUE(cholesky.factorize(matrix));
    EXPECT_LE((matrix * cholesky.solve(b) - b).cwiseAbs().maxCoeff(), 1e-12);
  }
}

// The matrix (A, B; B^T, -C) with positive definite A and C has a factorization in any order, with
// negative entries of D, but no Cholesky factorization.
TEST(Indefinite_factorization, solves_symmetric_quasidefinite_systems)
{
  CGAL::Random random(3);
  for(const int size : {2, 10, 500}) {
    auto matrix = definite_matrix<double>(size, random);
    for(int j = size / 2; j < size; ++j)
      for(decltype(matrix)::InnerIterator i(matrix, j); i; ++i)
        if(i.row() >= size / 2)
          i.valueRef() = -i.value();
    const Vector<double> b = random_vector<double>(size, random);
    internal::Indefinite_Cholesky<double> cholesky;
    cholesky.analyze(matrix);
    ASSERT_TRUE(cholesky.factorize(matrix));
    EXPECT_LE(
      (matrix.selfadjointView<Eigen::Upper>() * cholesky.solve(b) - b).cwiseAbs().maxCoeff(),
      1e-11);
    internal::Simplicial_Cholesky<double> definite;
    definite.analyze(matrix);
    EXPECT_FALSE(definite.factorize(matrix));
  }
}

// The factor of a band matrix is sparse.
TYPED_TEST(Cholesky_factorization, solves_for_sparse_right_sides)
{
  typedef typename TypeParam::Matrix::Scalar Scalar;
  CGAL::Random random(5);
  constexpr int size = 1000;
  std::vector<Eigen::Triplet<Scalar>> entries;
  for(int i = 0; i < size; ++i) {
    entries.emplace_back(i, i, Scalar(5));
    for(const int j : {i - 20, i - 1})
      if(j >= 0) {
        const Scalar x = random_scalar(random, static_cast<Scalar*>(nullptr));
        entries.emplace_back(i, j, x);
        entries.emplace_back(j, i, Eigen::numext::conj(x));
      }
  }
  typename TypeParam::Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  TypeParam cholesky;
  cholesky.analyze(matrix, true);
  ASSERT_TRUE(cholesky.factorize(matrix));
  for(const int nonzeros : {0, 1, 2, 10, 15, 16, 100}) {
    Vector<Scalar> b = Vector<Scalar>::Zero(size);
    for(int k = 0; k < nonzeros; ++k)
      b[random.get_int(0, size)] = random_scalar(random, static_cast<Scalar*>(nullptr));
    EXPECT_LE((matrix * cholesky.solve(b) - b).cwiseAbs().maxCoeff(), 1e-13) << nonzeros;
  }
}

TYPED_TEST(Cholesky_factorization, solves_for_several_columns)
{
  typedef typename TypeParam::Matrix::Scalar Scalar;
  CGAL::Random random(4);
  for(const int size : {1, 10, 2000}) {
    const auto matrix = definite_matrix<Scalar>(size, random);
    TypeParam cholesky;
    cholesky.analyze(matrix);
    ASSERT_TRUE(cholesky.factorize(matrix));
    for(const int columns : {0, 1, 7, 8, 9, 20}) {
      typename TypeParam::Columns b(size, columns);
      for(int k = 0; k < columns; ++k)
        b.col(k) = random_vector<Scalar>(size, random);
      const typename TypeParam::Columns x = cholesky.solve_columns(b);
      ASSERT_EQ(x.cols(), columns);
      for(int k = 0; k < columns; ++k)
        EXPECT_LE((matrix * x.col(k) - b.col(k)).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TYPED_TEST(Cholesky_factorization, orders_all_rows)
{
  typedef typename TypeParam::Matrix::Scalar Scalar;
  CGAL::Random random(2);
  const Eigen::VectorXi order =
    TypeParam::fill_reducing_order(definite_matrix<Scalar>(500, random));
  std::vector<char> seen(500, 0);
  for(const int i : order)
    ++seen.at(static_cast<std::size_t>(i));
  EXPECT_EQ(seen, std::vector<char>(500, 1));
}

TYPED_TEST(Cholesky_factorization, finds_a_matrix_that_is_not_positive)
{
  typedef typename TypeParam::Matrix::Scalar Scalar;
  CGAL::Random random(3);
  auto matrix = definite_matrix<Scalar>(100, random);
  matrix.coeffRef(50, 50) = -1;
  TypeParam cholesky;
  cholesky.analyze(matrix);
  EXPECT_FALSE(cholesky.factorize(matrix));
}

// The matrix is 1 - c A with adjacencies A of a grid and a small c. The effect of a corner on a
// vertex is the number of shortest paths, each with a factor c for an edge, up to a relative c^2. A
// large part of the factor is subnormal.
TYPED_TEST(Cholesky_factorization, solves_where_entries_decay)
{
  typedef typename TypeParam::Matrix::Scalar Scalar;
  const int n = 100;
  const double c = 1e-20;
  std::vector<Eigen::Triplet<Scalar>> entries;
  for(int i = 0; i < n * n; ++i) {
    entries.emplace_back(i, i, Scalar(1));
    for(const int j : {i % n > 0 ? i - 1 : i, i >= n ? i - n : i})
      if(j < i)
        entries.emplace_back(j, i, Scalar(-c));
  }
  typename TypeParam::Matrix matrix(n * n, n * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  TypeParam cholesky;
  cholesky.analyze(matrix);
  ASSERT_TRUE(cholesky.factorize(matrix));
  const Vector<Scalar> x = cholesky.solve(Vector<Scalar>::Unit(n * n, 0));
  Vector<double> paths = Vector<double>::Ones(n);
  for(int row = 0; row < 8; ++row)
    for(int i = 0; i < 8; ++i) {
      if(row > 0 && i > 0)
        paths[i] += paths[i - 1];
      const double exact = paths[i] * std::pow(c, row + i);
      EXPECT_LE(std::abs(x[row * n + i] - exact), 1e-14 * exact) << row << ' ' << i;
    }
}

TYPED_TEST(Cholesky_factorization, leaves_subnormal_numbers)
{
  typedef typename TypeParam::Matrix::Scalar Scalar;
  CGAL::Random random(6);
  auto matrix = definite_matrix<Scalar>(500, random);
  volatile double least = std::numeric_limits<double>::min();
  for(const bool is_positive : {true, false}) {
    TypeParam cholesky;
    cholesky.analyze(matrix);
    EXPECT_EQ(cholesky.factorize(matrix), is_positive);
    EXPECT_GT(least / 2, 0);
    matrix.coeffRef(50, 50) = -1;
  }
}

template <typename Scalar>
void expect_solution_in_any_order()
{
  CGAL::Random random(4);
  const auto matrix = definite_matrix<Scalar>(300, random);
  const Vector<Scalar> b = random_vector<Scalar>(300, random);
  const Factorization<Scalar> ordered(matrix, "matrix"),
    backwards(matrix, ordered.order().reverse(), "matrix");
  EXPECT_LE((matrix * ordered.solve(b) - b).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE((matrix * backwards.solve(b) - b).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Factorization, solves_in_any_order)
{
  expect_solution_in_any_order<double>();
  expect_solution_in_any_order<Complex>();
}

TEST(Factorization, names_a_matrix_without_one)
{
  CGAL::Random random(5);
  auto matrix = definite_matrix<double>(20, random);
  for(const double wrong : {-1., 0., std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()}) {
    matrix.coeffRef(10, 10) = wrong;
    EXPECT_THROW(Factorization<double>(matrix, "matrix"), Numerical_error) << wrong;
  }
}

TEST(Factorization, of_nothing)
{
  const Factorization<double> empty(Eigen::SparseMatrix<double>(0, 0), "matrix");
  EXPECT_EQ(empty.solve(Eigen::VectorXd()).size(), 0);
  EXPECT_THROW(Factorization<double>(Eigen::SparseMatrix<double>(3, 3), "matrix"), Numerical_error);
}

// Stores equations with the diagonal as a preconditioner.
struct Equations
{
  Eigen::SparseMatrix<double> matrix;

  Eigen::VectorXd product(const Eigen::VectorXd& x) const { return matrix * x; }
  Eigen::VectorXd preconditioned(const Eigen::VectorXd& r) const
  {
    return r.cwiseQuotient(Eigen::VectorXd(matrix.diagonal()));
  }
};

TEST(Conjugate_gradients, solve)
{
  CGAL::Random random(6);
  for(const int size : {1, 2, 50, 500}) {
    const Equations equations{definite_matrix<double>(size, random)};
    const Eigen::VectorXd b = random_vector<double>(size, random);
    const auto result = solve_by_conjugate_gradients(equations, b, 1e-12, 200);
    EXPECT_EQ(result.status, Iteration_status::converged);
    EXPECT_LE(result.error, 1e-12);
    const Eigen::VectorXd exact = Factorization<double>(equations.matrix, "matrix").solve(b);
    EXPECT_LE((result.solution - exact).norm(), 1e-10 * exact.norm());
  }
}

TEST(Conjugate_gradients, failure_has_a_name)
{
  CGAL::Random random(7);
  const Equations equations{definite_matrix<double>(500, random)};
  Eigen::VectorXd b = random_vector<double>(500, random);
  const auto few = solve_by_conjugate_gradients(equations, b, 1e-12, 3);
  EXPECT_EQ(few.status, Iteration_status::iteration_limit);
  EXPECT_EQ(few.iterations, 3u);
  const Eigen::VectorXd rest = b - equations.product(few.solution);
  EXPECT_NEAR(
    few.error,
    std::sqrt(rest.dot(equations.preconditioned(rest)) / b.dot(equations.preconditioned(b))),
    1e-14);
  EXPECT_EQ(solve_by_conjugate_gradients(equations, b, 1e-30, 1000).status,
            Iteration_status::no_progress);
  b[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solve_by_conjugate_gradients(equations, b, 1e-12, 1000).status,
            Iteration_status::no_progress);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(500);
  EXPECT_EQ(solve_by_conjugate_gradients(equations, zero, 1e-12, 1000).solution, zero);
}

} // namespace Test_factorization
