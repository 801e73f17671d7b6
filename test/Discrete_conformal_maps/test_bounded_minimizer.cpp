// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "convex_functions.h"

#include <CGAL/Discrete_conformal_maps/Bounded_Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>

#include <Eigen/Dense>

namespace Test_bounded_minimizer {

using namespace convex;
using CGAL::Discrete_conformal_maps::Bounded_Newton_minimizer;
using CGAL::Discrete_conformal_maps::Minimization_domain;
using CGAL::Discrete_conformal_maps::Minimization_result;
using CGAL::Discrete_conformal_maps::Newton_minimizer;
typedef CGAL::Discrete_conformal_maps::Minimization_status Status;

const double infinity = std::numeric_limits<double>::infinity();

// Represents x'Ax/2 - b'x.
struct Quadratic_form
{
  typedef double FT;
  std::size_t size() const { return static_cast<std::size_t>(b.size()); }
  void evaluate(const Vector& u)
  {
    x = u;
    m_gradient = A * u - b;
    m_Hessian = A.sparseView();
  }
  double value() const { return x.dot(A * x) / 2 - b.dot(x); }
  const Vector& gradient() const { return m_gradient; }
  const Matrix& Hessian() const { return m_Hessian; }
  double gradient_error() const
  {
    return 1e-15 * double(size()) *
           (b.cwiseAbs() + A.cwiseAbs() * x.cwiseAbs()).template lpNorm<Eigen::Infinity>();
  }

  Eigen::MatrixXd A;
  Vector b;
  Vector x = Vector();
  Vector m_gradient = Vector();
  Matrix m_Hessian = Matrix();
};

Eigen::MatrixXd columns(const Eigen::MatrixXd& m, const std::vector<Eigen::Index>& c)
{
  return m(c, c);
}

// Returns the minimum of a small form under bounds. Of all active sets, exactly one has an allowed
// point and allowed multipliers.
Vector brute_force_minimum(const Quadratic_form& form, const Vector& lower)
{
  const Eigen::Index n = lower.size();
  for(unsigned set = 0; set < (1u << n); ++set) {
    Vector x = lower;
    std::vector<Eigen::Index> free;
    for(Eigen::Index i = 0; i < n; ++i)
      if(!(set >> i & 1u)) {
        free.push_back(i);
        x[i] = 0;
      }
    const Vector right = form.b - form.A * x;
    const Vector solution = columns(form.A, free).llt().solve(Vector(right(free)));
    x(free) = solution;
    const Vector slope = form.A * x - form.b;
    bool is_minimum = true;
    for(Eigen::Index i = 0; i < n; ++i)
      is_minimum = is_minimum && (set >> i & 1u ? slope[i] >= 0 : x[i] >= lower[i]);
    if(is_minimum)
      return x;
  }
  return {};
}

// Returns a positive definite form with entries of any sign.
Quadratic_form random_form(Eigen::Index n, unsigned seed)
{
  const Vector entries = random_vector(std::size_t(n * n), 1, seed);
  const Eigen::MatrixXd root = Eigen::Map<const Eigen::MatrixXd>(entries.data(), n, n);
  return {root * root.transpose() + 0.05 * Eigen::MatrixXd::Identity(n, n),
          random_vector(std::size_t(n), 2, seed + 1000)};
}

// Returns the greatest error of a condition of the minimum.
template <typename Energy>
double violation(const Energy& energy, const Vector& u, const Vector& lower)
{
  double result = 0;
  for(Eigen::Index i = 0; i < u.size(); ++i) {
    EXPECT_GE(u[i], lower[i]);
    const double g = energy.gradient()[i];
    result = (std::max)(result, u[i] == lower[i] ? -g : std::abs(g));
  }
  return result;
}

TEST(Bounded_Newton_minimizer, finds_the_minimum_of_quadratic_forms)
{
  for(unsigned seed = 1; seed <= 300; ++seed) {
    const Eigen::Index n = 1 + seed % 8;
    const Quadratic_form form = random_form(n, seed);
    const Vector lower = random_vector(std::size_t(n), 1, seed + 2000);
    const Vector expected = brute_force_minimum(form, lower);
    ASSERT_EQ(expected.size(), n);
    Quadratic_form energy = form;
    Vector u = random_vector(std::size_t(n), 3, seed + 3000);
    const auto result = Bounded_Newton_minimizer()(energy, u, lower);
    EXPECT_EQ(result.status, Status::converged) << seed;
    // The inverse is less than 20, and rounding errors of the gradient are of order 1e-14.
    EXPECT_LT((u - expected).template lpNorm<Eigen::Infinity>(), 1e-11) << seed;
    for(Eigen::Index i = 0; i < n; ++i)
      EXPECT_EQ(u[i] == lower[i], expected[i] == lower[i]) << seed;
  }
}

// Every function of one variable has its minimum, or its bound above it.
TEST(Bounded_Newton_minimizer, separable_functions)
{
  std::vector<Link> links;
  for(Eigen::Index i = 0; i < 50; ++i)
    links.push_back({i, i});
  for(const double range : {0., 1., 30., 1000.}) {
    const Vector minimum = random_vector(50, 1, 1), lower = random_vector(50, 2, 2);
    Linked<Log_cosh> energy(links, minimum);
    Vector u = random_vector(50, range, 3);
    EXPECT_EQ(Bounded_Newton_minimizer()(energy, u, lower).status, Status::converged);
    for(Eigen::Index i = 0; i < 50; ++i)
      EXPECT_NEAR(u[i], (std::max)(minimum[i], lower[i]), minimum[i] > lower[i] ? 1e-12 : 0);
  }
}

// Only bounds hold the function, and the total slope is the sum of the slopes at the bounds.
TEST(Bounded_Newton_minimizer, function_that_falls_along_constants)
{
  for(unsigned seed = 1; seed <= 20; ++seed) {
    const Eigen::Index side = 12;
    const std::size_t n = std::size_t(side * side);
    std::vector<Link> links = grid(side, 1, seed);
    struct Energy : Linked<Log_cosh>
    {
      using Linked<Log_cosh>::Linked;
      void evaluate(const Vector& u)
      {
        Linked<Log_cosh>::evaluate(u);
        m_gradient = Linked<Log_cosh>::gradient();
        m_gradient[0] += 0.1;
        m_gradient[50] += 0.01;
      }
      const Vector& gradient() const { return m_gradient; }
      Vector m_gradient;
    } energy(links, random_vector(n, 1, seed + 1));
    const Vector lower = random_vector(n, 5, seed + 2);
    Vector u = random_vector(n, 10, seed + 3);
    const auto result = Bounded_Newton_minimizer()(energy, u, lower);
    EXPECT_EQ(result.status, Status::converged) << seed;
    EXPECT_LE(violation(energy, u, lower), 1e-13) << seed;
    EXPECT_NEAR(energy.gradient().sum(), 0.11, 1e-12);
  }
}

TEST(Bounded_Newton_minimizer, without_bounds_as_Newton_minimizer)
{
  const std::size_t n = 64;
  std::vector<Link> links = grid(8);
  links.push_back({5, 5});
  const Vector minimum = random_vector(n, 1, 1);
  Linked<Log_cosh> one(links, minimum), other(links, minimum);
  Vector u = random_vector(n, 30, 2), v = u;
  const auto result = Bounded_Newton_minimizer()(one, u, Vector::Constant(64, -infinity));
  const auto expected = Newton_minimizer()(other, v);
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_EQ(result.iterations, expected.iterations);
  EXPECT_LT((u - v).template lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(Bounded_Newton_minimizer, start_below_bounds_and_fixed_variables)
{
  const Quadratic_form form = random_form(6, 7);
  Quadratic_form energy = form;
  Minimization_domain domain;
  domain.is_fixed = {0, 1, 0, 0, 1, 0};
  Vector u = Vector::Constant(6, -9), lower = Vector::Zero(6);
  const auto result = Bounded_Newton_minimizer()(energy, u, lower, domain);
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_EQ(u[1], -9);
  EXPECT_EQ(u[4], -9);
  for(Eigen::Index i : {0, 2, 3, 5}) {
    EXPECT_GE(u[i], 0);
    const double g = energy.gradient()[i];
    EXPECT_LE(u[i] == 0 ? -g : std::abs(g), 1e-12);
  }
}

TEST(Bounded_Newton_minimizer, failures_have_names)
{
  Quadratic_form concave{-Eigen::MatrixXd::Identity(2, 2), Vector::Ones(2)};
  Vector u = Vector::Ones(2);
  const Vector lower = Vector::Zero(2);
  EXPECT_EQ(Bounded_Newton_minimizer()(concave, u, lower).status, Status::no_descent);
  Quadratic_form nothing{Eigen::MatrixXd::Identity(2, 2),
                         Vector::Constant(2, std::numeric_limits<double>::quiet_NaN())};
  EXPECT_EQ(Bounded_Newton_minimizer()(nothing, u, lower).status, Status::not_finite);
  Quadratic_form slow{1e-3 * Eigen::MatrixXd::Identity(2, 2), Vector::Ones(2)};
  EXPECT_EQ(Bounded_Newton_minimizer(1e-13, 2)(slow, u, lower).status, Status::iteration_limit);
}

TEST(Bounded_Newton_minimizer, same_input_gives_same_bits)
{
  const Quadratic_form form = random_form(8, 3);
  const Vector lower = random_vector(8, 1, 4);
  Quadratic_form one = form, other = form;
  Vector u = Vector::Zero(8), v = u;
  Bounded_Newton_minimizer()(one, u, lower);
  Bounded_Newton_minimizer()(other, v, lower);
  EXPECT_EQ(u, v);
}

} // namespace Test_bounded_minimizer
