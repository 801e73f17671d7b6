// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "archetypes.h"
#include "convex_functions.h"

#include <CGAL/Discrete_conformal_maps/Ceres_minimizer.h>
#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace {

using namespace convex;
using CGAL::Discrete_conformal_maps::Ceres_minimizer;
using CGAL::Discrete_conformal_maps::Default_minimization_visitor;
using CGAL::Discrete_conformal_maps::Minimization_domain;
using CGAL::Discrete_conformal_maps::Newton_minimizer;
typedef CGAL::Discrete_conformal_maps::Minimization_status Status;

constexpr Eigen::Index side = 10;
constexpr std::size_t grid_size = side * side;

// The gradient is below 1e-6, the inverse of the Hessian (max norm) below 100 for these functions.
template <typename Energy>
void expect_agreement(Energy energy, const Minimization_domain& domain)
{
  Vector u = random_vector(grid_size, 30, 2), v = u;
  const auto slow = Ceres_minimizer()(energy, u, domain);
  const auto fast = Newton_minimizer()(energy, v, domain);
  EXPECT_EQ(slow.status, Status::converged);
  EXPECT_EQ(fast.status, Status::converged);
  EXPECT_LE(slow.gradient_norm, 1e-6);
  EXPECT_GT(slow.evaluations, fast.evaluations);
  EXPECT_LE((u - v).lpNorm<Eigen::Infinity>(), 1e-4);
}

Minimization_domain floating() { return {{}, std::vector<std::size_t>(grid_size, 0)}; }

TEST(Ceres_minimizer, archetypes) { archetypes::expect_minimum(Ceres_minimizer(1e-6)); }

TEST(Ceres_minimizer, agrees_with_Newton)
{
  const Vector minimum = random_vector(grid_size, 1, 1);
  expect_agreement(Linked<Quadratic>(grid(side), minimum), floating());
  expect_agreement(Linked<Log_cosh>(grid(side), minimum), floating());
  expect_agreement(Log_sum_exp(triangles(side), minimum), floating());
}

TEST(Ceres_minimizer, fixed_variables)
{
  Minimization_domain domain = floating();
  domain.is_fixed.assign(grid_size, 0);
  domain.is_fixed[5] = domain.is_fixed[50] = 1;
  const Vector minimum = random_vector(grid_size, 1, 1);
  expect_agreement(Linked<Log_cosh>(grid(side), minimum), domain);
}

TEST(Ceres_minimizer, statuses)
{
  const Vector minimum = random_vector(grid_size, 1, 1), start = random_vector(grid_size, 9, 2);
  Linked<Log_cosh> energy(grid(side), minimum);
  Vector u = start;
  EXPECT_EQ(Ceres_minimizer(1e-6, 3)(energy, u, floating()).status, Status::iteration_limit);
  u = start;
  EXPECT_EQ(Ceres_minimizer(0)(energy, u, floating()).status, Status::rounding_limit);
  const Vector no_number = Vector::Constant(grid_size, std::numeric_limits<double>::quiet_NaN());
  u = no_number;
  EXPECT_EQ(Ceres_minimizer()(energy, u, floating()).status, Status::not_finite);
  u = minimum;
  EXPECT_EQ(Ceres_minimizer()(energy, u, floating()).status, Status::converged);
}

struct Interrupting_visitor : Default_minimization_visitor
{
  void after_iteration(std::size_t, double, double) { throw std::runtime_error("enough"); }
};

TEST(Ceres_minimizer, visitor_interrupts)
{
  Linked<Log_cosh> energy(grid(side), random_vector(grid_size, 1, 1));
  Vector u = random_vector(grid_size, 2, 2);
  EXPECT_THROW(Ceres_minimizer()(energy, u, floating(), Interrupting_visitor()),
               std::runtime_error);
}

} // namespace
