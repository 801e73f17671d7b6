// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/more_generators.h"
#include "finite_differences.h"

#include <CGAL/Discrete_conformal_maps/Conformal_energy.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>

#include <Eigen/Cholesky>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace Test_conformal_energy {

using namespace Test_surfaces;
namespace DCM = CGAL::Discrete_conformal_maps;
namespace constants = boost::math::constants;
using Quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;
using Precise = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                              boost::multiprecision::et_off>;
using Numbers = Eigen::VectorXd;

// ---- Lobachevsky's function ----

// Returns the integral from 0 to theta <= pi / 2. The singularity is integrated in closed form. The
// rest is analytic up to pi, and Gauss' rule with 30 points has 45 digits.
Precise integral(const Precise& theta)
{
  if(theta == 0)
    return 0;
  const auto regular = [](const Precise& u) -> Precise { return log(sin(u) / u); };
  return theta - theta * log(2 * theta) -
         boost::math::quadrature::gauss<Precise, 30>::integrate(regular, Precise(0), theta);
}

Precise true_Lobachevsky_function(const Precise& theta)
{
  const Precise pi = constants::pi<Precise>();
  return 2 * theta <= pi ? integral(theta) : Precise(-integral(pi - theta));
}

// Checks the value up to some units in the last place, plus the change by such an error of the
// argument. Near pi, the distance to pi counts, because pi is not a number of type FT.
template <typename FT>
void check_Lobachevsky_function(const FT& theta)
{
  const Precise t(theta), eps(std::numeric_limits<FT>::epsilon());
  const Precise expected = true_Lobachevsky_function(t);
  const Precise slope = log(2 * sin(t) + eps);
  const Precise error = abs(Precise(DCM::Lobachevsky_function(theta)) - expected);
  EXPECT_LE(error, 4 * eps * abs(expected) + eps * t * abs(slope)) << theta;
}

template <typename FT>
void check_Lobachevsky_functions(int steps)
{
  const FT pi = constants::pi<FT>();
  for(int i = 1; i < steps; ++i)
    check_Lobachevsky_function(FT(pi * FT(i) / FT(steps)));
  for(FT tiny(1); tiny > std::numeric_limits<FT>::epsilon() / 1000; tiny /= 7)
    for(const FT& theta : {tiny, FT(pi / 3 - tiny), FT(pi / 3 + tiny), FT(pi / 2 - tiny),
                           FT(pi / 2 + tiny), FT(2 * pi / 3 + tiny), FT(pi - tiny)})
      if(theta > 0 && theta < pi)
        check_Lobachevsky_function(theta);
}

// ---- Surfaces without boundary ----

// The triangulations are not Delaunay.
std::vector<Named_triangulation> surfaces()
{
  std::vector<Named_triangulation> result = closed_surfaces();
  result.push_back({"four components", Triangulation(four_components())});
  return result;
}

Numbers random_targets(const Triangulation& t)
{
  return random_numbers(t.mesh().number_of_vertices(), 2, 5);
}

template <typename Energy>
Energy energy_of(Triangulation t, const Numbers& target)
{
  IT::make_Delaunay(t);
  return {t.mesh(), t.length_map(), target};
}

// Returns the gradient as a function of u, not of the nearest number of type `double`.
template <typename Energy>
std::vector<Quad> precise_gradient(const Energy& energy, const Numbers& target)
{
  const Delta_complex& mesh = energy.surface().mesh();
  std::vector<Quad> result(mesh.number_of_vertices(), 2 * constants::pi<Quad>());
  for(Vertex_index v : mesh.vertices())
    result[v] = mesh.is_isolated(v) ? Quad(0) : Quad(result[v] - Quad(target[int(v)]));
  for(Halfedge_index h : mesh.halfedges())
    result[mesh.source(h)] -= energy.angle(h);
  return result;
}

// ---- Geometries of faces, with the laws of cosines and areas from textbooks ----

struct Flat
{
  template <typename FT>
  using Energy = DCM::Conformal_energy<FT>;

  // Returns the angle between sides a and b.
  static double angle(double a, double b, double c)
  {
    return std::acos((a * a + b * b - c * c) / (2 * a * b));
  }

  // Returns the difference between pi and the sum of angles.
  static double defect(double, double, double) { return 0; }
};

struct Hyperbolic
{
  template <typename FT>
  using Energy = DCM::Hyperbolic_conformal_energy<FT>;

  static double side(double l) { return 2 * std::asinh(l); }

  static double angle(double a, double b, double c)
  {
    const double x = side(a), y = side(b);
    return std::acos((std::cosh(x) * std::cosh(y) - std::cosh(side(c))) /
                     (std::sinh(x) * std::sinh(y)));
  }

  // Uses L'Huilier's formula.
  static double defect(double a, double b, double c)
  {
    const double x = side(a), y = side(b), z = side(c);
    return 4 * std::atan(std::sqrt(std::tanh((x + y + z) / 4) * std::tanh((y + z - x) / 4) *
                                   std::tanh((z + x - y) / 4) * std::tanh((x + y - z) / 4)));
  }
};

template <typename Geometry>
class Conformal_energy : public ::testing::Test
{};

typedef ::testing::Types<Flat, Hyperbolic> Geometries;
TYPED_TEST_SUITE(Conformal_energy, Geometries, );

template <typename Geometry>
double angle_at_source(const Triangulation& t, Halfedge_index h)
{
  const Delta_complex& mesh = t.mesh();
  return Geometry::angle(t.length(mesh.edge(h)), t.length(mesh.edge(mesh.prev(h))),
                         t.length(mesh.edge(mesh.next(h))));
}

// Calls f(surface, energy, target, point) at scale factors far enough apart for many flips.
template <typename Energy, typename Function>
void for_each_point(const Function& f)
{
  for(const Named_triangulation& s : traced(surfaces())) {
    const Numbers target = random_targets(s.triangulation);
    for(const double bound : {0., 3.}) {
      Energy energy = energy_of<Energy>(s.triangulation, target);
      const Numbers u = random_numbers(s.triangulation.mesh().number_of_vertices(), bound, 17);
      energy.evaluate(u);
      f(s.triangulation, energy, target, u);
    }
  }
}

// ---- Lobachevsky's function ----

TEST(Lobachevsky_function, is_precise_in_float) { check_Lobachevsky_functions<float>(200); }
TEST(Lobachevsky_function, is_precise_in_double) { check_Lobachevsky_functions<double>(500); }
TEST(Lobachevsky_function, is_precise_in_long_double)
{
  check_Lobachevsky_functions<long double>(200);
}
TEST(Lobachevsky_function, is_precise_in_quadruple_precision)
{
  check_Lobachevsky_functions<Quad>(200);
}

TEST(Lobachevsky_function, has_its_special_values)
{
  const double pi = constants::pi<double>(), ulp = std::numeric_limits<double>::epsilon();
  EXPECT_EQ(DCM::Lobachevsky_function(0.), 0);
  EXPECT_NEAR(DCM::Lobachevsky_function(pi / 2), 0, ulp);
  EXPECT_NEAR(DCM::Lobachevsky_function(pi), 0, ulp * 40); // the slope there is log(2 ulp)
  EXPECT_NEAR(DCM::Lobachevsky_function(pi / 4), constants::catalan<double>() / 2, ulp);
  // This is the volume of the regular ideal tetrahedron.
  EXPECT_NEAR(3 * DCM::Lobachevsky_function(pi / 3), 1.01494160640965362502, 3 * ulp);
  for(double theta = 0.01; theta < pi / 2; theta += 0.01)
    EXPECT_NEAR(
      DCM::Lobachevsky_function(2 * theta),
      2 * DCM::Lobachevsky_function(theta) + 2 * DCM::Lobachevsky_function(theta + pi / 2), 8 * ulp)
      << theta;
}

// ---- The energy ----

TYPED_TEST(Conformal_energy, gradient_without_scaling_is_that_of_the_Delaunay_triangulation)
{
  typedef typename TypeParam::template Energy<Quad> Energy;
  for(const Named_triangulation& s : traced(surfaces())) {
    Triangulation t = s.triangulation;
    IT::make_Delaunay(t);
    const Delta_complex& mesh = t.mesh();
    const Numbers target = random_targets(t);
    const Energy energy = energy_of<Energy>(s.triangulation, target);
    Numbers defect = Numbers::Constant(target.size(), 2 * constants::pi<double>()) - target;
    for(Halfedge_index h : mesh.halfedges())
      defect[int(mesh.source(h))] -= angle_at_source<TypeParam>(t, h);
    for(Vertex_index v : mesh.vertices())
      EXPECT_NEAR(energy.gradient()[int(v)], mesh.is_isolated(v) ? 0 : defect[int(v)], 1e-12) << v;
  }
}

// Without scaling, a Delaunay triangulation is unchanged.
TYPED_TEST(Conformal_energy, sums_of_the_gradient_are_those_of_Gauss_and_Bonnet)
{
  typedef typename TypeParam::template Energy<Quad> Energy;
  for_each_point<Energy>(
    [](const Triangulation& t, const Energy& energy, const Numbers& target, const auto&) {
      const Delta_complex& mesh = energy.surface().mesh();
      const IT::Mesh_components component(t.mesh());
      std::vector<double> sum(component.size(), 0);
      const double turn = 2 * constants::pi<double>();
      for(Vertex_index v : mesh.vertices())
        if(!mesh.is_isolated(v))
          sum[component[v]] += turn - target[int(v)] - energy.gradient()[int(v)];
      for(Edge_index e : mesh.edges())
        sum[component[mesh.vertex(e, 0)]] -= turn;
      const auto length = [&](Halfedge_index h) {
        return double(energy.surface().scaled_length(mesh.edge(h)));
      };
      for(Face_index f : mesh.faces()) {
        const Halfedge_index h = mesh.halfedge(f);
        sum[component[mesh.target(h)]] +=
          turn + TypeParam::defect(length(h), length(mesh.next(h)), length(mesh.prev(h)));
      }
      for(double x : sum)
        EXPECT_NEAR(x, 0, 1e-12 * double(mesh.number_of_vertices()));
    });
}

// Central differences over 2e-9 have errors of order 1e-18, and 34 digits minus 9 are left.
TYPED_TEST(Conformal_energy, gradient_is_the_derivative_of_the_value)
{
  typedef typename TypeParam::template Energy<Quad> Energy;
  for_each_point<Energy>([](const Triangulation&, Energy energy, const Numbers&, const Numbers& u) {
    const Eigen::MatrixXd directions = random_directions(u.size());
    const Numbers expected = directions.transpose() * energy.gradient();
    energy.move_origin();
    const Eigen::MatrixXd slope =
      central_differences(energy, 1e-9, directions, [&] { return std::array{energy.value()}; });
    for(Eigen::Index i = 0; i < directions.cols(); ++i)
      EXPECT_NEAR(slope(0, i), expected[i], 1e-14 * directions.col(i).lpNorm<1>()) << i;
  });
}

// If four points are on a circle, the Hessian has a kink. Central differences have errors of order
// 1e-14.
TYPED_TEST(Conformal_energy, Hessian_is_the_derivative_of_the_gradient)
{
  typedef typename TypeParam::template Energy<Quad> Energy;
  for_each_point<Energy>(
    [](const Triangulation&, Energy energy, const Numbers& target, const Numbers& u) {
      const Eigen::MatrixXd Hessian = energy.Hessian();
      energy.move_origin();
      const Eigen::MatrixXd slope =
        central_differences(energy, 1e-14, [&] { return precise_gradient(energy, target); });
      for(Eigen::Index i = 0; i < u.size(); ++i)
        for(Eigen::Index k = 0; k < u.size(); ++k)
          EXPECT_NEAR(slope(k, i), Hessian(k, i), 1e-13 * (1 + Hessian(i, i))) << k << ' ' << i;
    });
}

TYPED_TEST(Conformal_energy, Hessian_is_symmetric)
{
  typedef typename TypeParam::template Energy<Quad> Energy;
  for_each_point<Energy>([](const auto&, const Energy& energy, const auto&, const auto&) {
    const Eigen::MatrixXd Hessian = energy.Hessian();
    EXPECT_LT((Hessian - Hessian.transpose()).norm(), 1e-15 * (1 + Hessian.norm()));
  });
}

TEST(Flat_energy, Hessian_has_no_effect_on_constants)
{
  typedef Flat::Energy<Quad> Energy;
  for_each_point<Energy>([](const auto&, const Energy& energy, const auto&, const Numbers& u) {
    const Eigen::MatrixXd Hessian = energy.Hessian();
    EXPECT_LT((Hessian * Numbers::Ones(u.size())).norm(), 1e-14 * (1 + Hessian.norm()));
  });
}

TEST(Hyperbolic_energy, Hessian_is_positive_definite)
{
  typedef Hyperbolic::Energy<Quad> Energy;
  for_each_point<Energy>(
    [](const Triangulation& t, const Energy& energy, const auto&, const auto&) {
      Eigen::MatrixXd Hessian = energy.Hessian();
      for(Vertex_index v : t.mesh().vertices())
        if(t.mesh().is_isolated(v))
          Hessian(int(v), int(v)) = 1;
      EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(Hessian).info(), Eigen::Success);
    });
}

TYPED_TEST(Conformal_energy, is_convex_and_continuous_along_segments)
{
  typedef typename TypeParam::template Energy<double> Energy;
  std::size_t flips = 0;
  for(const Named_triangulation& s : traced(surfaces())) {
    const std::size_t n = s.triangulation.mesh().number_of_vertices();
    auto energy = energy_of<Energy>(s.triangulation, random_targets(s.triangulation));
    const Numbers from = random_numbers(n, 3, 23), way = random_numbers(n, 3, 29) - from;
    energy.evaluate(from);
    const double first = energy.value();
    double integral = 0, slope = -std::numeric_limits<double>::infinity();
    const int steps = 3200; // Simpson's rule: an error of order steps^-3 where a derivative jumps
    for(int i = 0; i <= steps; ++i) {
      energy.evaluate(from + (double(i) / steps) * way);
      const double next = energy.gradient().dot(way);
      EXPECT_GE(next, slope - energy.gradient_error() * way.lpNorm<1>()) << i;
      slope = next;
      integral += next * (i == 0 || i == steps ? 1. : i % 2 == 1 ? 4. : 2.) / (3. * steps);
    }
    EXPECT_NEAR(energy.value() - first, integral, 1e-6);
    flips += energy.surface().number_of_flips();
  }
  EXPECT_GT(flips, 1000u);
}

// Flips by Ptolemy's relation preserve the ideal polyhedron, and so the functions.
TYPED_TEST(Conformal_energy, does_not_depend_on_the_triangulation)
{
  typedef typename TypeParam::template Energy<Quad> Energy;
  for(const Named_triangulation& s : traced(surfaces())) {
    Triangulation t = s.triangulation;
    IT::make_Delaunay(t);
    const auto surface = flipped_at_random<Quad>(t);
    const Delta_complex& mesh = surface.mesh();
    const auto map = boost::make_function_property_map<Edge_index>(
      [&](Edge_index e) { return surface.length(e); });
    const Numbers target = random_targets(t), u = random_numbers(mesh.number_of_vertices(), 2, 37);
    Energy one(t.mesh(), t.length_map(), target), other(mesh, map, target);
    one.evaluate(u);
    other.evaluate(u);
    EXPECT_LT((one.gradient() - other.gradient()).norm(), 1e-14 * double(u.size()));
    EXPECT_LT(abs(one.value() - other.value()), 1e-26 * double(u.size()));
    EXPECT_LT((Eigen::MatrixXd(one.Hessian()) - Eigen::MatrixXd(other.Hessian())).norm(),
              1e-14 * (1 + one.Hessian().norm()));
  }
}

TYPED_TEST(Conformal_energy, gradient_error_bounds_the_error_in_double)
{
  typedef typename TypeParam::template Energy<double> Rounded;
  typedef typename TypeParam::template Energy<Quad> Precise_energy;
  for(const Named_triangulation& s : traced(surfaces()))
    for(const double bound : traced({0., 1., 5., 20.})) {
      const Numbers target = random_targets(s.triangulation);
      Rounded rounded = energy_of<Rounded>(s.triangulation, target);
      Precise_energy precise = energy_of<Precise_energy>(s.triangulation, target);
      const Numbers u = random_numbers(s.triangulation.mesh().number_of_vertices(), bound, 41);
      rounded.evaluate(u);
      precise.evaluate(u);
      EXPECT_LE((rounded.gradient() - precise.gradient()).cwiseAbs().maxCoeff(),
                rounded.gradient_error() + 1e-15);
      if(bound <= 1) {
        EXPECT_LT(rounded.gradient_error(), 1e-10);
      }
    }
}

TYPED_TEST(Conformal_energy, origin_has_the_precision_of_its_type)
{
  typedef typename TypeParam::template Energy<Quad> Energy;
  const Triangulation t(random_sphere(20, 3));
  Energy energy = energy_of<Energy>(t, random_targets(t));
  const Numbers u = random_numbers(20, 1, 43), tiny = 1e-20 * random_numbers(20, 1, 47);
  energy.evaluate(u);
  energy.move_origin();
  energy.evaluate(tiny);
  energy.move_origin();
  energy.evaluate(tiny);
  for(std::size_t i = 0; i < 20; ++i)
    EXPECT_LT(abs(energy.scale_factors()[i] - Quad(u[int(i)]) - 2 * Quad(tiny[int(i)])), 1e-33);
}

TYPED_TEST(Conformal_energy, lengths_out_of_range_give_no_gradient_and_leave_a_way_back)
{
  typedef typename TypeParam::template Energy<double> Energy;
  Energy energy = energy_of<Energy>(Triangulation(random_sphere(20, 3)), Numbers::Zero(20));
  const Numbers before = energy.gradient();
  for(const double u : {2000., -2000., std::nan("")}) {
    energy.evaluate(Numbers::Constant(20, u));
    EXPECT_FALSE(energy.gradient().allFinite());
  }
  energy.evaluate(Numbers::Zero(20));
  EXPECT_LT((energy.gradient() - before).norm(), 1e-12);
}

// ---- Hyperbolic triangles ----

// Returns the angle by the law of cosines with 50 digits. The sides are given as numbers of type
// `double`, l = sinh(x/2).
Precise true_angle(const std::array<double, 3>& l, std::size_t s)
{
  const auto cosh_of = [&](std::size_t i) -> Precise {
    return 1 + 2 * Precise(l[i % 3]) * Precise(l[i % 3]);
  };
  const Precise a = cosh_of(s + 1), b = cosh_of(s), c = cosh_of(s + 2);
  return acos(Precise((b * c - a) / sqrt(Precise((b * b - 1) * (c * c - 1)))));
}

TEST(Hyperbolic_triangle, angles_are_precise_for_sides_of_any_size)
{
  CGAL::Random random(53);
  const double eps = std::numeric_limits<double>::epsilon();
  for(double size = 1e-12; size < 1e5; size *= 10)
    for(int i = 0; i < 20; ++i) {
      const std::array<double, 3> l{size * random.get_double(1, 2), size * random.get_double(1, 2),
                                    size * random.get_double(1, 2)};
      const DCM::internal::Hyperbolic_triangle<double> triangle(l);
      Precise sum = 0;
      for(std::size_t s = 0; s < 3; ++s) {
        const Precise angle = true_angle(l, s);
        sum += angle;
        // Angles of large triangles are small, so relative errors count.
        EXPECT_LE(double(abs(Precise(triangle.angle(s)) - angle) / angle), 40 * eps) << size;
      }
      const Precise defect = constants::pi<Precise>() - sum;
      if(size > 1e-8) // 50 digits less 25 remain for the defect
        EXPECT_LE(double(abs(2 * Precise(triangle.half_defect()) / defect - 1)), 40 * eps) << size;
      else
        EXPECT_NEAR(triangle.angle(0),
                    CGAL::Discrete_conformal_maps::internal::Flat_triangle<double>(l).angle(0),
                    8 * eps);
    }
}

// Half of a regular triangle with angle a satisfies 2 cosh(x/2) sin(a/2) = 1.
TEST(Hyperbolic_triangle, regular_triangles)
{
  const double pi = constants::pi<double>();
  for(int n = 7; n < 1000; n += 13) {
    const double a = 2 * pi / n, cosh = 1 / (2 * std::sin(a / 2)), l = std::sqrt(cosh * cosh - 1);
    const DCM::internal::Hyperbolic_triangle<double> triangle({l, l, l});
    for(std::size_t s = 0; s < 3; ++s) {
      EXPECT_NEAR(triangle.angle(s), a, 1e-14);
      EXPECT_NEAR(triangle.circle_angle(s), (pi - a) / 2, 1e-14);
    }
    EXPECT_NEAR(triangle.half_defect(), (pi - 3 * a) / 2, 1e-14);
  }
}

// One triangle is flat by rounding, and another one is flat.
TEST(Hyperbolic_triangle, flat_triangles_have_angles)
{
  for(const double c : {3., 3.0000000001}) {
    const double l = 1e-9;
    const DCM::internal::Hyperbolic_triangle<double> triangle({l, 2 * l, c * l});
    EXPECT_NEAR(triangle.angle(0) + triangle.angle(1) + triangle.angle(2), constants::pi<double>(),
                1e-8);
    EXPECT_TRUE(std::isfinite(triangle.cotangent(0)));
  }
}

} // namespace Test_conformal_energy
