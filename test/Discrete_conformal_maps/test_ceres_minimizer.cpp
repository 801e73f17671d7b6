// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "archetypes.h"
#include "convex_functions.h"
#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/Ceres_minimizer.h>
#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>
#include <CGAL/subdivision_method_3.h>

namespace Test_ceres_minimizer {

using namespace convex;
namespace DCM = CGAL::Discrete_conformal_maps;
namespace surfaces = Test_surfaces;
using DCM::Ceres_minimizer;
using DCM::Default_minimization_visitor;
using DCM::Minimization_domain;
using DCM::Newton_minimizer;
typedef DCM::Minimization_status Status;

constexpr Eigen::Index side = 10;
constexpr std::size_t grid_size = side * side;

// Checks that the minimizers agree. The inverse of the Hessian (max norm) is below 100 for these
// functions.
template <typename Energy>
void expect_agreement(Energy energy, const Minimization_domain& domain)
{
  Vector u = random_vector(grid_size, 30, 2), v = u;
  const auto slow = Ceres_minimizer()(energy, u, domain);
  const auto fast = Newton_minimizer()(energy, v, domain);
  EXPECT_EQ(slow.status, Status::converged);
  EXPECT_EQ(fast.status, Status::converged);
  EXPECT_LE(slow.gradient_norm, (std::max)(1e-13, slow.gradient_error));
  EXPECT_LE((u - v).lpNorm<Eigen::Infinity>(),
            1e-12 + 100 * (slow.gradient_error + fast.gradient_error));
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

// Represents an energy that claims to have no rounding errors.
struct Without_error : Linked<Log_cosh>
{
  using Linked<Log_cosh>::Linked;
  double gradient_error() const { return 0; }
};

TEST(Ceres_minimizer, statuses)
{
  const Vector minimum = random_vector(grid_size, 1, 1), start = random_vector(grid_size, 9, 2);
  Linked<Log_cosh> energy(grid(side), minimum);
  Vector u = start;
  const auto stopped = Ceres_minimizer(1e-13, 2)(energy, u, floating());
  EXPECT_EQ(stopped.status, Status::iteration_limit);
  EXPECT_EQ(stopped.iterations, 2u);
  u = start;
  Without_error exact(grid(side), minimum);
  Minimization_domain domain = floating();
  domain.is_fixed.assign(grid_size, 0);
  domain.is_fixed[0] = 1;
  const auto rounded = Ceres_minimizer(0)(exact, u, domain);
  EXPECT_EQ(rounded.status, Status::rounding_limit);
  EXPECT_LE(rounded.gradient_norm, 1e-13);
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

// ---- Surfaces ----

template <typename Map>
void expect_equal_scales(const surfaces::Mesh& mesh, const Map& slow, const Map& fast)
{
  EXPECT_EQ(slow.status(), DCM::Map_status::success);
  EXPECT_EQ(slow.minimization().status, Status::converged);
  EXPECT_LT(slow.minimization().factorizations, fast.minimization().factorizations);
  double greatest = 0;
  for(surfaces::Vertex_index v : mesh.vertices())
    greatest = (std::max)(greatest, std::abs(slow.log_scale(v) - fast.log_scale(v)));
  EXPECT_LE(greatest, 1e-10);
}

TEST(Ceres_minimizer, flattens_as_Newton_does)
{
  for(unsigned seed = 0; seed < 3; ++seed) {
    const surfaces::Mesh mesh = surfaces::random_sphere(3000, seed);
    std::vector<DCM::Vertex_condition> condition(3000, DCM::Vertex_condition::curvature(0));
    for(std::size_t v : {0u, 700u, 1400u, 2100u})
      condition[v] = DCM::Vertex_condition::curvature(surfaces::pi);
    const auto conditions = DCM::parameters::vertex_condition_map(surfaces::as_map(condition));
    expect_equal_scales(mesh, DCM::flatten(mesh, conditions.minimizer(Ceres_minimizer())),
                        DCM::flatten(mesh, conditions));
  }
}

TEST(Ceres_minimizer, makes_surfaces_hyperbolic_as_Newton_does)
{
  for(int genus : {2, 3}) {
    surfaces::Mesh mesh = surfaces::plate_with_holes(genus);
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(3));
    EXPECT_GT(mesh.number_of_vertices(), 2000u);
    expect_equal_scales(
      mesh, DCM::uniformize_hyperbolic(mesh, DCM::parameters::minimizer(Ceres_minimizer())),
      DCM::uniformize_hyperbolic(mesh));
  }
}

} // namespace Test_ceres_minimizer
