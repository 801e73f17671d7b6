// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "convex_functions.h"

#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>

#include <Eigen/Dense>

namespace Test_minimizers {

using namespace convex;
using CGAL::Discrete_conformal_maps::Default_minimization_visitor;
using CGAL::Discrete_conformal_maps::Minimization_domain;
using CGAL::Discrete_conformal_maps::Minimization_result;
using CGAL::Discrete_conformal_maps::Newton_minimizer;
typedef CGAL::Discrete_conformal_maps::Minimization_status Status;

constexpr Eigen::Index side = 10;
constexpr std::size_t grid_size = side * side;
const double nan = std::numeric_limits<double>::quiet_NaN();

Minimization_domain floating(std::size_t size) { return {{}, std::vector<std::size_t>(size, 0)}; }

std::vector<Link> singles(std::size_t size)
{
  std::vector<Link> result;
  for(Eigen::Index i = 0; i < static_cast<Eigen::Index>(size); ++i)
    result.push_back({i, i});
  return result;
}

// Returns the possible distance from the minimum of a point whose gradient is known up to an error:
// first order, twice.
template <typename Energy>
double error_of_point(Energy energy, const Minimization_result& result)
{
  energy.evaluate(energy.minimum());
  const Eigen::MatrixXd inverse =
    Eigen::MatrixXd(energy.Hessian()).completeOrthogonalDecomposition().pseudoInverse();
  const double norm = inverse.cwiseAbs().rowwise().sum().maxCoeff();
  return 2 * norm * (result.gradient_norm + result.gradient_error);
}

template <typename Energy>
Minimization_result expect_minimum(Energy energy, Vector u, bool floats)
{
  const double mean = u.mean();
  const auto result =
    Newton_minimizer()(energy, u, floats ? floating(energy.size()) : Minimization_domain());
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_EQ(result.evaluations, energy.evaluations());
  EXPECT_EQ(energy.gradient().template lpNorm<Eigen::Infinity>(), result.gradient_norm);
  Vector difference = u - energy.minimum();
  if(floats) {
    // The bound is a thousand rounding errors of numbers of the size of the mean of |u|.
    EXPECT_NEAR(u.mean(), mean, 1e-13 * (1 + u.cwiseAbs().mean()));
    difference.array() -= difference.mean();
  }
  EXPECT_LE(difference.template lpNorm<Eigen::Infinity>(), error_of_point(energy, result));
  return result;
}

TEST(Newton_minimizer, quadratic_function_in_one_step)
{
  const Vector minimum = random_vector(grid_size, 1, 1), start = random_vector(grid_size, 1, 2);
  const auto result = expect_minimum(Linked<Quadratic>(grid(side), minimum), start, true);
  EXPECT_EQ(result.iterations, 1u);
  EXPECT_EQ(result.factorizations, 1u);
  EXPECT_EQ(expect_minimum(Linked<Quadratic>(singles(9), random_vector(9, 1, 1)),
                           random_vector(9, 1, 2), false)
              .iterations,
            1u);
}

TEST(Newton_minimizer, starts_at_minimum)
{
  const Vector minimum = random_vector(grid_size, 1, 1);
  const auto result = expect_minimum(Linked<Log_cosh>(grid(side), minimum), minimum, true);
  EXPECT_EQ(result.iterations, 0u);
  EXPECT_EQ(result.factorizations, 0u);
}

class Start : public testing::TestWithParam<double>
{};

TEST_P(Start, separable_function)
{
  const Vector minimum = random_vector(50, 1, 1), start = random_vector(50, GetParam(), 2);
  expect_minimum(Linked<Log_cosh>(singles(50), minimum), start, false);
  expect_minimum(Linked<Sharp_bend>(singles(50), minimum), start, false);
  expect_minimum(Linked<Cubic_ramp>(singles(50), minimum.array() + 1.5), start, false);
}

TEST_P(Start, coupled_function)
{
  const Vector minimum = random_vector(grid_size, 1, 1);
  const Vector start = random_vector(grid_size, GetParam(), 2);
  expect_minimum(Linked<Quadratic>(grid(side), minimum), start, true);
  expect_minimum(Linked<Log_cosh>(grid(side), minimum), start, true);
  expect_minimum(Log_sum_exp(triangles(side), minimum), start, true);
}

// Curvatures are 1e-6 of the curvatures nearby: the minimum lies in an almost linear part of the
// function.
TEST_P(Start, far_minimum)
{
  const Vector minimum = random_vector(grid_size, 7, 1);
  expect_minimum(Log_sum_exp(triangles(side), minimum), random_vector(grid_size, GetParam(), 2),
                 true);
}

INSTANTIATE_TEST_SUITE_P(Near_and_far, Start, testing::Values(0., 1., 30., 1000.));

// The larger the linear part of the function at the start, the fewer links are in the Hessian.
TEST(Newton_minimizer, pattern_changes)
{
  const Vector minimum = random_vector(grid_size, 1, 1);
  const auto result =
    expect_minimum(Linked<Log_cosh>(grid(side), minimum), random_vector(grid_size, 1000, 2), true);
  EXPECT_GT(result.symbolic_analyses, result.orderings);
  EXPECT_GT(result.orderings, 1u);
}

TEST(Newton_minimizer, pattern_stays)
{
  const Vector minimum = random_vector(grid_size, 1, 1);
  const auto result =
    expect_minimum(Linked<Log_cosh>(grid(side), minimum), random_vector(grid_size, 3, 2), true);
  EXPECT_GT(result.factorizations, 2u);
  EXPECT_EQ(result.symbolic_analyses, 1u);
  EXPECT_EQ(result.orderings, 1u);
}

// Between fixed ends a chain of equal springs is stretched evenly.
TEST(Newton_minimizer, fixed_variables)
{
  std::vector<Link> chain;
  for(Eigen::Index i = 0; i < 10; ++i)
    chain.push_back({i, i + 1});
  Linked<Log_cosh> energy(chain, Vector::Zero(11));
  Minimization_domain domain = floating(11);
  domain.is_fixed.assign(11, 0);
  domain.is_fixed[0] = domain.is_fixed[10] = 1;
  Vector u = random_vector(11, 5, 1);
  u[0] = 3;
  u[10] = 8;
  const auto result = Newton_minimizer()(energy, u, domain);
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_EQ(u[0], 3);
  EXPECT_EQ(u[10], 8);
  for(int i = 0; i <= 10; ++i)
    EXPECT_NEAR(u[i], 3 + i / 2.,
                1e-12); // the curvature is 0.79: 50 times 1e-13 is more than needed
}

TEST(Newton_minimizer, all_variables_fixed)
{
  Linked<Log_cosh> energy(grid(3), Vector::Zero(9));
  Vector u = random_vector(9, 1, 1);
  const Vector before = u;
  const auto result = Newton_minimizer()(energy, u, {std::vector<char>(9, 1), {}});
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_EQ(u, before);
}

TEST(Newton_minimizer, no_variables)
{
  Linked<Log_cosh> energy({}, Vector());
  Vector u;
  EXPECT_EQ(Newton_minimizer()(energy, u).status, Status::converged);
}

// Two grids and a single variable are minimized, and one grid has a fixed variable. Every
// correction raises the order of convergence, but not the minimum.
TEST(Newton_minimizer, corrections)
{
  const Vector minimum = random_vector(grid_size, 1, 1), start = random_vector(grid_size, 1, 2);
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for(const std::size_t corrections : {0u, 1u, 3u}) {
    Linked<Log_cosh> energy(grid(side), minimum);
    Vector u = start;
    const auto result =
      Newton_minimizer().correcting_steps(corrections)(energy, u, floating(grid_size));
    EXPECT_EQ(result.status, Status::converged);
    EXPECT_EQ(result.evaluations, energy.evaluations());
    EXPECT_LT(result.iterations, before);
    before = result.iterations;
    Vector difference = u - minimum;
    difference.array() -= difference.mean();
    EXPECT_LE(difference.lpNorm<Eigen::Infinity>(), error_of_point(energy, result));
  }
}

TEST(Newton_minimizer, components)
{
  std::vector<Link> links = grid(4);
  for(Link link : grid(4))
    links.push_back({link.i + 16, link.j + 16});
  const Vector minimum = random_vector(33, 1, 1);
  Linked<Log_cosh> energy(links, minimum);
  Minimization_domain domain = floating(33);
  std::fill(domain.component.begin() + 16, domain.component.end() - 1, 1u);
  domain.component.back() = 2;
  domain.is_fixed.assign(33, 0);
  domain.is_fixed[20] = 1;
  Vector u = random_vector(33, 20, 2);
  const Vector before = u;
  const auto result = Newton_minimizer()(energy, u, domain);
  EXPECT_EQ(result.status, Status::converged);
  EXPECT_EQ(u[20], before[20]);
  EXPECT_EQ(u[32], before[32]);
  EXPECT_NEAR(u.head(16).mean(), before.head(16).mean(), 1e-13);
  const Vector difference = u - minimum;
  for(int i = 0; i < 16; ++i) {
    // The inverse of the Hessian is of order ten.
    EXPECT_NEAR(difference[i], difference[0], 1e-11);
    EXPECT_NEAR(difference[16 + i], difference[20], 1e-11);
  }
}

// Curvatures range from 1e-12 to 1e12 with gradients of order one, and minima have the size of
// each.
TEST(Newton_minimizer, badly_scaled_variables)
{
  std::vector<Link> links = singles(25);
  Vector minimum = random_vector(25, 1, 1);
  for(std::size_t i = 0; i < links.size(); ++i) {
    links[i].scale = std::pow(10., static_cast<double>(i) - 12);
    minimum[static_cast<Eigen::Index>(i)] /= links[i].scale;
  }
  Linked<Log_cosh> energy(links, minimum);
  Vector u = random_vector(25, 1, 2);
  const auto result = Newton_minimizer()(energy, u);
  EXPECT_TRUE(result.status == Status::converged) << to_string(result.status);
  for(std::size_t i = 0; i < links.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    // The curvature is at least 0.4 of the scale.
    EXPECT_NEAR(links[i].scale * u[k], links[i].scale * minimum[k], 1e-12);
  }
}

// Curvatures from 1e-12 to 1e12 are coupled. Positions are rounded by more than the gradient
// allows.
TEST(Newton_minimizer, badly_scaled_links)
{
  for(unsigned seed = 1; seed <= 10; ++seed) {
    const Vector minimum = random_vector(grid_size, 1, seed);
    std::vector<Link> links = grid(side, 12, seed);
    for(Link& link : links)
      link = {link.i, link.j, 1, link.weight, minimum[link.i] - minimum[link.j]};
    Linked<Log_cosh> energy(links, minimum);
    Vector u = minimum + random_vector(grid_size, 1e-12, seed + 1);
    const auto result = Newton_minimizer()(energy, u, floating(grid_size));
    EXPECT_TRUE(result.status == Status::converged || result.status == Status::rounding_limit)
      << to_string(result.status);
    EXPECT_LE(result.gradient_norm, 2 * result.gradient_error) << "seed " << seed;
    EXPECT_LE(result.gradient_error, 1e-3); // 1e12 times the rounding of one, for four links
  }
}

// Linear functions of many slopes have sharp bends between them.
TEST(Newton_minimizer, sharp_bends_far_from_start)
{
  for(unsigned seed = 1; seed <= 10; ++seed) {
    std::vector<Link> links = grid(side, 3, seed);
    for(Link& link : links)
      link = {link.i, link.j, 1, link.weight, 0};
    Linked<Log_cosh> energy(links, Vector::Zero(grid_size));
    Vector u = random_vector(grid_size, 1, seed);
    EXPECT_EQ(Newton_minimizer()(energy, u, floating(grid_size)).status, Status::converged);
  }
}

struct One_variable
{
  typedef double FT;
  std::size_t size() const { return 1; }
  void evaluate(const Vector& u)
  {
    x = u[0];
    m_gradient = Vector::Constant(1, slope(x));
    m_Hessian.resize(1, 1);
    m_Hessian.coeffRef(0, 0) = curvature(x);
    m_Hessian.makeCompressed();
  }
  double value() const { return 0; }
  const Vector& gradient() const { return m_gradient; }
  const Matrix& Hessian() const { return m_Hessian; }
  double gradient_error() const { return 1e-15; }

  double (*slope)(double);
  double (*curvature)(double);
  double x = 0;
  Vector m_gradient = Vector();
  Matrix m_Hessian = Matrix();
};

Minimization_result minimize(One_variable energy, double& x)
{
  Vector u = Vector::Constant(1, x);
  const auto result = Newton_minimizer()(energy, u);
  x = u[0];
  EXPECT_EQ(energy.x, x);
  return result;
}

// The slope is steep and its zero lies between two neighboring numbers.
TEST(Newton_minimizer, rounding_limit)
{
  double x = 1;
  const auto result = minimize({[](double y) { return std::tanh(1e12 * (y - 1 / 3.)) + 0.3; },
                                [](double y) {
                                  const double c = std::cosh(1e12 * (y - 1 / 3.));
                                  return 1e12 / c / c;
                                }},
                               x);
  EXPECT_EQ(result.status, Status::rounding_limit);
  EXPECT_LE(result.gradient_norm, result.gradient_error);
  EXPECT_LT(result.gradient_error, 1e-4); // 1e12 times the distance of numbers at 1/3
}

TEST(Newton_minimizer, linear_function_has_no_minimum)
{
  double x = 1;
  const auto result = minimize({[](double) { return 1.; }, [](double) { return 0.; }}, x);
  EXPECT_EQ(result.status, Status::iteration_limit);
  EXPECT_TRUE(std::isfinite(x));
  EXPECT_LT(x, 1);
}

TEST(Newton_minimizer, component_that_is_not_balanced)
{
  One_variable energy{[](double) { return 1e-3; }, [](double) { return 0.; }};
  Vector u = Vector::Constant(1, 7);
  EXPECT_EQ(Newton_minimizer()(energy, u, floating(1)).status, Status::unbounded);
  EXPECT_EQ(u[0], 7);
}

TEST(Newton_minimizer, not_a_number_at_start)
{
  double x = 1;
  EXPECT_EQ(minimize({[](double) { return nan; }, [](double) { return 1.; }}, x).status,
            Status::not_finite);
  EXPECT_EQ(x, 1);
  EXPECT_EQ(minimize({[](double) { return 1.; }, [](double) { return nan; }}, x).status,
            Status::not_finite);
  EXPECT_EQ(x, 1);
}

TEST(Newton_minimizer, not_a_number_elsewhere)
{
  double x = 1;
  EXPECT_EQ(
    minimize({[](double y) { return y == 1 ? 1. : nan; }, [](double) { return 1.; }}, x).status,
    Status::not_finite);
  EXPECT_EQ(x, 1);
}

// The energy -log(1 - x^2) + x is not defined beyond 1.
TEST(Newton_minimizer, barrier)
{
  for(double start : {-0.9999999, 0., 0.5, 0.9999999}) {
    double x = start;
    const auto result =
      minimize({[](double y) { return std::abs(y) < 1 ? 2 * y / (1 - y * y) + 1 : nan; },
                [](double y) { return 2 * (1 + y * y) / ((1 - y * y) * (1 - y * y)); }},
               x);
    EXPECT_EQ(result.status, Status::converged);
    EXPECT_NEAR(x, 1 - std::sqrt(2.), 1e-13);
  }
}

TEST(Newton_minimizer, concave_function)
{
  double x = 1;
  EXPECT_EQ(minimize({[](double y) { return -y; }, [](double) { return -1.; }}, x).status,
            Status::no_descent);
  EXPECT_EQ(x, 1);
}

// The slope changes its sign at once, and the second derivative does not show it.
TEST(Newton_minimizer, derivatives_that_disagree)
{
  double x = 0;
  const auto result =
    minimize({[](double y) { return y > 0 ? 1. : -1.; }, [](double) { return 1.; }}, x);
  EXPECT_EQ(result.status, Status::no_descent);
  EXPECT_LE(result.evaluations, 42u);
  EXPECT_EQ(x, 0);
}

TEST(Newton_minimizer, iteration_limit)
{
  const Vector minimum = random_vector(grid_size, 1, 1);
  Linked<Log_cosh> energy(grid(side), minimum);
  Vector u = random_vector(grid_size, 100, 2);
  const auto result = Newton_minimizer(1e-13, 3)(energy, u, floating(grid_size));
  EXPECT_EQ(result.status, Status::iteration_limit);
  EXPECT_EQ(result.iterations, 3u);
}

TEST(Newton_minimizer, tolerance)
{
  const Vector minimum = random_vector(grid_size, 1, 1);
  Linked<Log_cosh> energy(grid(side), minimum);
  Vector u = random_vector(grid_size, 3, 2);
  const auto loose = Newton_minimizer(1e-3)(energy, u, floating(grid_size));
  EXPECT_EQ(loose.status, Status::converged);
  EXPECT_LE(loose.gradient_norm, 1e-3);
  EXPECT_GT(loose.gradient_norm, 1e-12);
}

struct Interrupting_visitor : Default_minimization_visitor
{
  void after_iteration(std::size_t iteration, double, double)
  {
    if(iteration == 2)
      throw std::runtime_error("enough");
  }
};

TEST(Newton_minimizer, visitor_interrupts)
{
  Linked<Log_cosh> energy(grid(side), random_vector(grid_size, 1, 1));
  Vector u = random_vector(grid_size, 2, 2);
  energy.evaluate(u);
  const double before = energy.gradient().lpNorm<Eigen::Infinity>();
  EXPECT_THROW(Newton_minimizer()(energy, u, floating(grid_size), Interrupting_visitor()),
               std::runtime_error);
  energy.evaluate(u);
  EXPECT_LT(energy.gradient().lpNorm<Eigen::Infinity>(), before);
}

struct Recording_visitor
{
  void after_iteration(std::size_t iteration, double gradient_norm, double step_length)
  {
    EXPECT_EQ(iteration, gradient_norms.size() + 1);
    EXPECT_GT(step_length, 0);
    gradient_norms.push_back(gradient_norm);
  }
  std::vector<double> gradient_norms;
};

TEST(Newton_minimizer, same_bits_again)
{
  Recording_visitor records[2];
  Vector points[2];
  for(int k : {0, 1}) {
    Linked<Log_cosh> energy(grid(side), random_vector(grid_size, 1, 1));
    points[k] = random_vector(grid_size, 300, 2);
    Newton_minimizer()(energy, points[k], floating(grid_size), records[k]);
  }
  EXPECT_EQ(records[0].gradient_norms, records[1].gradient_norms);
  EXPECT_EQ(points[0], points[1]);
}

TEST(Minimization_status, names)
{
  EXPECT_EQ(to_string(Status::converged), std::string("converged"));
  EXPECT_EQ(to_string(Status::rounding_limit), std::string("rounding_limit"));
  EXPECT_EQ(to_string(Status::iteration_limit), std::string("iteration_limit"));
  EXPECT_EQ(to_string(Status::no_descent), std::string("no_descent"));
  EXPECT_EQ(to_string(Status::unbounded), std::string("unbounded"));
  EXPECT_EQ(to_string(Status::not_finite), std::string("not_finite"));
}

} // namespace Test_minimizers
