// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "convex_functions.h"

#include <CGAL/Discrete_conformal_maps/internal/minimization/Hessian_solver.h>
#include <CGAL/Intrinsic_triangulations/Cholesky.h>
#ifdef TEST_SUPERNODAL_CHOLESKY
#include <CGAL/Intrinsic_triangulations/internal/operators/Supernodal_Cholesky.h>
#endif

namespace Test_hessian_solver {

using namespace convex;
namespace internal = CGAL::Discrete_conformal_maps::internal;
using namespace CGAL::Intrinsic_triangulations::internal;

constexpr Eigen::Index side = 30, size = side * side;

// Returns a Laplacian plus the identity, whose inverse has the norm one.
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
  EXPECT_EQ(solver.counts().symbolic_analyses, 1u);

  for(std::size_t k = 0; k < links.size(); k += 100) // as if some edges were flipped
    links[k].j = (links[k].j + side) % size;
  this->expect_solution(solver, matrix_of(links), taken);
  EXPECT_EQ(solver.counts().symbolic_analyses, 2u);
  EXPECT_EQ(solver.counts().orderings, 1u);

  for(std::size_t k = 0; k < links.size(); ++k) // everything is different now
    links[k].j = static_cast<Eigen::Index>(k * k * k + 7) % size;
  this->expect_solution(solver, matrix_of(links), taken);
  EXPECT_EQ(solver.counts().orderings, 2u);
  EXPECT_EQ(solver.counts().factorizations, 4u);
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

TYPED_TEST(Hessian_solver, Shares_an_order)
{
  const auto order = std::make_shared<internal::Shared_order>();
  std::vector<char> taken(size, 1);
  taken[7] = 0;
  typename TestFixture::Solver first(this->rows(taken), order);
  this->expect_solution(first, matrix_of(grid(side)), taken);

  taken.assign(size, 1);
  for(std::size_t i = 0; i < taken.size(); i += 5)
    taken[i] = 0;
  std::vector<Link> links = grid(side);
  for(std::size_t k = 0; k < links.size(); k += 100) // as if some edges were flipped
    links[k].j = (links[k].j + side) % size;
  typename TestFixture::Solver second(this->rows(taken), order);
  this->expect_solution(second, matrix_of(links), taken);
  EXPECT_EQ(second.counts().orderings, 0u);
  EXPECT_EQ(order->counts()->orderings, 1u);
  EXPECT_EQ(order->counts()->symbolic_analyses, 2u);
  EXPECT_EQ(order->counts()->factorizations, 2u);
}

TYPED_TEST(Hessian_solver, Bounds_the_fill_of_a_shared_order)
{
  const auto order = std::make_shared<internal::Shared_order>();
  const std::vector<char> taken(size, 1);
  typename TestFixture::Solver first(this->rows(taken), order), second(this->rows(taken), order);
  this->expect_solution(first, matrix_of(grid(side)), taken);
  std::vector<Link> links = grid(side);
  for(std::size_t k = 0; k < links.size(); ++k) // everything is different
    links[k].j = static_cast<Eigen::Index>(k * k * k + 7) % size;
  this->expect_solution(second, matrix_of(links), taken);
  EXPECT_EQ(second.counts().orderings, 1u);
  this->expect_solution(first, matrix_of(grid(side)), taken); // not disturbed by the new order
}

TEST(Shared_order, Sorts_and_refines)
{
  internal::Shared_order order;
  EXPECT_FALSE(order.refined(std::vector<int>{0, 1})->is_known());
  order.set({3, 0, 4, 1, 2});
  EXPECT_EQ(order.sorted({0, 1, 2, 3}), (std::vector<Eigen::Index>{3, 0, 1, 2}));

  const std::vector<int> origin{0, 0, 2, 3, 4, 3, 1};
  const auto refined = order.refined(origin);
  EXPECT_EQ(refined->order(), (std::vector<Eigen::Index>{3, 5, 0, 1, 4, 6, 2}));
  EXPECT_EQ(refined->counts(), order.counts());
}

// Each point of a grid becomes a clique of two. The factor of the refined order has at most the
// entries of cliques for each entry of the grid.
TYPED_TEST(Hessian_solver, Refined_orders_keep_the_factor_sparse)
{
  const auto order = std::make_shared<internal::Shared_order>();
  typename TestFixture::Solver solver(this->rows(std::vector<char>(size, 1)), order);
  const Matrix matrix = matrix_of(grid(side));
  ASSERT_TRUE(solver.factorize(matrix, Vector::Zero(size)));

  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Eigen::Index> origin, all;
  for(Eigen::Index k = 0; k < 2 * size; ++k) {
    all.push_back(k);
    origin.push_back(k % size);
  }
  for(Eigen::Index c = 0; c < size; ++c)
    for(Matrix::InnerIterator i(matrix, c); i; ++i)
      for(const Eigen::Index p : {i.row(), i.row() + size})
        for(const Eigen::Index q : {c, c + size})
          entries.emplace_back(p, q, p == q ? 3 * i.value() : i.value());
  Matrix doubled(2 * size, 2 * size);
  doubled.setFromTriplets(entries.begin(), entries.end());
  typename TestFixture::Solver pairs(all, order->refined(origin, 2));
  ASSERT_TRUE(pairs.factorize(doubled, Vector::Zero(2 * size)));
  EXPECT_EQ(pairs.counts().orderings, 0u);
  const Vector b = random_vector(2 * size, 1, 5);
  EXPECT_LT((doubled * pairs.solve(b) - b).template lpNorm<Eigen::Infinity>(), 1e-12);
}

} // namespace Test_hessian_solver
