// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "convex_functions.h"

#include <CGAL/Discrete_conformal_maps/internal/minimization/Hessian_solver.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Simplicial_Cholesky.h>
#ifdef TEST_SUPERNODAL_CHOLESKY
#include <CGAL/Intrinsic_triangulations/internal/operators/Supernodal_Cholesky.h>
#endif

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace convex;
namespace internal = CGAL::Discrete_conformal_maps::internal;
using namespace CGAL::Intrinsic_triangulations::internal;

constexpr Eigen::Index side = 30, size = side * side;

// A Laplacian with one on the diagonal in addition: the norm of its inverse is one.
Matrix matrix_of(const std::vector<Link>& links)
{
  Linked<Quadratic> energy(links, Vector::Zero(size));
  energy.evaluate(Vector::Zero(size));
  Matrix identity(size, size);
  identity.setIdentity();
  return energy.Hessian() + identity;
}

template <typename Cholesky>
class Hessian_solver : public testing::Test
{
protected:
  typedef internal::Hessian_solver<Cholesky> Solver;

  static void expect_solution(Solver& solver, const Matrix& matrix, const std::vector<char>& taken)
  {
    const Vector diagonal = random_vector(size, 1, 3).cwiseAbs();
    ASSERT_TRUE(solver.factorize(matrix, diagonal));
    const Vector b = random_vector(size, 1, 4), x = solver.solve(b);
    const Vector residual = matrix * x + diagonal.cwiseProduct(x) - b;
    for(Eigen::Index i = 0; i < size; ++i)
      if(taken[static_cast<std::size_t>(i)])
        EXPECT_NEAR(residual[i], 0, 1e-12); // norm at most 10, a thousand roundings
      else
        EXPECT_EQ(x[i], 0);
  }

  static std::vector<Eigen::Index> rows(const std::vector<char>& taken)
  {
    std::vector<Eigen::Index> result;
    for(Eigen::Index i = 0; i < size; ++i)
      if(taken[static_cast<std::size_t>(i)])
        result.push_back(i);
    return result;
  }
};

#ifdef TEST_SUPERNODAL_CHOLESKY
typedef testing::Types<Simplicial_Cholesky<double>, Supernodal_Cholesky<double>> Factorizations;
#else
typedef testing::Types<Simplicial_Cholesky<double>> Factorizations;
#endif
TYPED_TEST_SUITE(Hessian_solver, Factorizations, );

TYPED_TEST(Hessian_solver, Follows_the_pattern)
{
  const std::vector<char> taken(size, 1);
  typename TestFixture::Solver solver(this->rows(taken));
  std::vector<Link> links = grid(side);
  this->expect_solution(solver, matrix_of(links), taken);
  for(Link& link : links)
    link.weight *= 2;
  this->expect_solution(solver, matrix_of(links), taken);
  EXPECT_EQ(solver.symbolic_analyses(), 1u);

  for(std::size_t k = 0; k < links.size(); k += 100) // as if some edges were flipped
    links[k].j = (links[k].j + side) % size;
  this->expect_solution(solver, matrix_of(links), taken);
  EXPECT_EQ(solver.symbolic_analyses(), 2u);
  EXPECT_EQ(solver.orderings(), 1u);

  for(std::size_t k = 0; k < links.size(); ++k) // everything is different now
    links[k].j = static_cast<Eigen::Index>(k * k * k + 7) % size;
  this->expect_solution(solver, matrix_of(links), taken);
  EXPECT_EQ(solver.orderings(), 2u);
  EXPECT_EQ(solver.factorizations(), 4u);
}

TYPED_TEST(Hessian_solver, Leaves_rows_out)
{
  std::vector<char> taken(size, 1);
  for(std::size_t i = 0; i < taken.size(); i += 3)
    taken[i] = 0;
  typename TestFixture::Solver solver(this->rows(taken));
  this->expect_solution(solver, matrix_of(grid(side)), taken);
}

TYPED_TEST(Hessian_solver, Matrix_that_is_not_positive)
{
  const std::vector<char> taken(size, 1);
  typename TestFixture::Solver solver(this->rows(taken));
  const Matrix matrix = matrix_of(grid(side));
  EXPECT_FALSE(solver.factorize(matrix, Vector::Constant(size, -2)));
  this->expect_solution(solver, matrix, taken);
}

} // namespace
