// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/matrices.h"
#include "flat_maps.h"
#include "hard_cones.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>

namespace Test_fixed_triangulation {

using namespace Test_surfaces;
using DCM::Flipping;
using DCM::Map_status;
typedef Eigen::VectorXd Numbers;
typedef CGAL::Discrete_conformal_maps::internal::Flat_triangle<double> Flat_triangle;

// ---- Fixed triangulations ----

Planar_conformal_map flatten_fixed(const Triangulation& t, const Conditions& condition)
{
  const std::vector<double> length = lengths_of(t);
  return DCM::flatten(
    t.mesh(),
    length_parameter(length).vertex_condition_map(as_map(condition)).flipping(Flipping::none));
}

// Returns a triangulation with scaled lengths.
Triangulation scaled(const Triangulation& t, const std::vector<double>& u)
{
  std::vector<double> length = lengths_of(t);
  for(Edge_index e : t.mesh().edges())
    length[e] *= std::exp((u[t.mesh().vertex(e, 0)] + u[t.mesh().vertex(e, 1)]) / 2);
  return Triangulation(t.mesh(), length_parameter(length));
}

// Returns an energy of a fixed triangulation with so random lengths that many faces are not
// triangles.
DCM::Conformal_energy<> wild_energy(const Numbers& target)
{
  const Triangulation t(random_sphere(30, 3));
  return {t.mesh(), t.length_map(), target, Flipping::none};
}

// Returns the least slack of the triangle inequality of scaled lengths in a face, relative to the
// longest length.
double least_slack(const Planar_conformal_map& map)
{
  const std::vector<double> length = scaled_lengths(map);
  double result = 1;
  for(Face_index f : mesh_C(map).faces()) {
    std::array<double, 3> side;
    std::size_t s = 0;
    for(Halfedge_index h : IT::sides(f, mesh_C(map)))
      side[s++] = length[mesh_C(map).edge(h)];
    std::sort(side.begin(), side.end());
    result = (std::min)(result, (side[0] + side[1] - side[2]) / side[2]);
  }
  return result;
}

// Returns conditions that fix the scale factors of three vertices of a tetrahedron.
Conditions around_apex(double curvature)
{
  Conditions result = as_log_scales({0, 0, 0, 0});
  result[0] = Vertex_condition::curvature(curvature);
  return result;
}

// ---- Triangles ----

TEST(Flat_triangle, beyond_the_triangle_inequality_angles_are_limits)
{
  const Flat_triangle triangle({1, 3, 1.5}), degenerate({1, 3, 2});
  for(const Flat_triangle& t : {triangle, degenerate}) {
    EXPECT_TRUE(t.is_flat());
    EXPECT_EQ(t.angle(0), std::acos(-1.)); // opposite to side 1
    EXPECT_EQ(t.angle(1), 0);
    EXPECT_EQ(t.angle(2), 0);
  }
  EXPECT_FALSE(Flat_triangle({1, 3, 2.0001}).is_flat());
}

// The derivative of a corner by its scale factor is compared with a finite difference. Angles do
// not depend on the unit of lengths, in the range with finite squares of lengths.
TEST(Flat_triangle, angles_in_any_unit)
{
  const std::array<double, 3> side{3, 5, 4};
  const Flat_triangle expected(side);
  for(int exponent : {-500, -300, -200, 200, 300, 500}) {
    std::array<double, 3> scaled;
    std::transform(side.begin(), side.end(), scaled.begin(),
                   [&](double x) { return std::ldexp(x, exponent); });
    const Flat_triangle triangle(scaled);
    EXPECT_FALSE(triangle.is_flat());
    EXPECT_LT(triangle.angle_error(), 1e-13);
    for(std::size_t s = 0; s < 3; ++s)
      EXPECT_EQ(triangle.angle(s), expected.angle(s)) << exponent;
  }
  EXPECT_NEAR(expected.angle(0), std::acos(0.), 1e-15);
}

TEST(Flat_triangle, derivative_of_an_angle)
{
  const std::array<double, 3> side{2, 2.5, 1.7};
  const double step = 1e-5;
  const auto angle = [&](std::size_t s, double u) {
    std::array<double, 3> scaled = side;
    scaled[s] *= std::exp(u / 2);
    scaled[(s + 2) % 3] *= std::exp(u / 2);
    return Flat_triangle(scaled).angle(s);
  };
  const Flat_triangle triangle(side);
  for(std::size_t s = 0; s < 3; ++s)
    EXPECT_NEAR(-(triangle.cotangent((s + 1) % 3) + triangle.cotangent((s + 2) % 3)) / 2,
                (angle(s, step) - angle(s, -step)) / (2 * step), 1e-9);
}

// ---- The energy ----

TEST(Fixed_energy, gradient_is_the_derivative_of_the_value)
{
  const Numbers target = random_numbers(30, 1, 2);
  DCM::Conformal_energy<> energy = wild_energy(target);
  std::size_t flat = 0;
  for(unsigned int seed = 0; seed < 5; ++seed) {
    const Numbers u = random_numbers(30, 2, seed), d = random_numbers(30, 1, seed + 100);
    const double step = 1e-4;
    energy.evaluate(u + step * d);
    const double above = energy.value();
    energy.evaluate(u - step * d);
    const double below = energy.value();
    energy.evaluate(u);
    flat += energy.number_of_flat_faces();
    EXPECT_EQ(energy.surface().number_of_flips(), 0u);
    EXPECT_NEAR((above - below) / (2 * step), energy.gradient().dot(d), 1e-5);
  }
  EXPECT_GT(flat, 20u);
}

TEST(Fixed_energy, Hessian_is_the_derivative_of_the_gradient)
{
  const Numbers target = random_numbers(30, 1, 2), u = random_numbers(30, 2, 7),
                d = random_numbers(30, 1, 8);
  DCM::Conformal_energy<> energy = wild_energy(target);
  const double step = 1e-6;
  energy.evaluate(u + step * d);
  const std::size_t flat = energy.number_of_flat_faces();
  const Numbers above = energy.gradient();
  energy.evaluate(u - step * d);
  const Numbers below = energy.gradient();
  ASSERT_EQ(energy.number_of_flat_faces(), flat); // no face becomes flat in between
  energy.evaluate(u);
  EXPECT_LT((energy.Hessian() * d - (above - below) / (2 * step)).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Fixed_energy, is_convex_where_faces_become_flat)
{
  DCM::Conformal_energy<> energy = wild_energy(random_numbers(30, 1, 2));
  const Numbers d = random_numbers(30, 1, 9);
  std::set<std::size_t> flat;
  double last = -1e300;
  for(double t = -4; t <= 4; t += 0.01) {
    energy.evaluate(t * d);
    flat.insert(energy.number_of_flat_faces());
    EXPECT_GE(energy.gradient().dot(d), last - 1e-12);
    last = energy.gradient().dot(d);
  }
  EXPECT_GT(flat.size(), 10u);
}

// ---- Success ----

TEST(Fixed_triangulation, takes_scaling_back)
{
  for(const Triangulation& t :
      {Triangulation(flat_torus(5, 4, 1).mesh, length_parameter(flat_torus(5, 4, 1).lengths())),
       Triangulation(unit_sphere(3)), Triangulation(perturbed(embedded_torus(8, 6), 0.1, 5))}) {
    const std::vector<double> u = random_values(t.mesh().number_of_vertices(), 0.1, 6);
    const Planar_conformal_map map = flatten_fixed(scaled(t, u), as_curvatures(curvatures(t)));
    ASSERT_EQ(map.status(), Map_status::success);
    for(std::size_t v = 0; v < u.size(); ++v)
      EXPECT_NEAR(log_scale(map, v) + u[v], log_scale(map, 0) + u[0], 1e-9) << v;
    check_layout(map);
    EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-9);
    EXPECT_EQ(map.number_of_flips(Layer::B) + map.number_of_flips(Layer::C), 0u);
    for(Edge_index e : mesh_A(map).edges())
      EXPECT_EQ(mesh_C(map).vertex(e, 0), mesh_A(map).vertex(e, 0));
  }
}

// On a surface with boundary, the faces of the input in the plane are flat triangles with scaled
// sides.
TEST(Fixed_triangulation, lays_out_the_faces_of_a_disk)
{
  const Mesh disk =
    perturbed(grid(6, 5, [](double x, double y) { return Point(x, y, 0.2 * x * y); }), 0.1, 3);
  const Triangulation t(disk);
  const Planar_conformal_map map = flatten_fixed(t, default_conditions(t.mesh()));
  ASSERT_EQ(map.status(), Map_status::success);
  check_conditions(map, t.mesh(), default_conditions(t.mesh()), 1e-12);
  check_layout(map);
  const auto position = [&](Vertex_index v) { return map(corner(mesh_A(map), v)); };
  for(Edge_index e : t.mesh().edges()) {
    const Vertex_index v = t.mesh().vertex(e, 0), w = t.mesh().vertex(e, 1);
    EXPECT_NEAR(std::abs(position(v) - position(w)),
                t.length(e) * std::exp((map.log_scale(v) + map.log_scale(w)) / 2), 1e-10);
  }
}

// If no edge needs a flip, both maps are equal.
TEST(Fixed_triangulation, is_that_which_flips_if_nothing_is_to_flip)
{
  const Triangulation sphere(unit_sphere(3));
  const Conditions condition = as_curvatures(curvatures(sphere));
  const Triangulation t =
    scaled(sphere, random_values(sphere.mesh().number_of_vertices(), 0.01, 3));
  const Planar_conformal_map one = flatten_fixed(t, condition), two = flatten(t, condition);
  ASSERT_EQ(two.number_of_flips(Layer::B) + two.number_of_flips(Layer::C), 0u);
  for(std::size_t v = 0; v < condition.size(); ++v)
    EXPECT_NEAR(log_scale(one, v), log_scale(two, v), 1e-10);
}

// ---- Failure ----

// Three faces have an angle sum of at most three pi around their vertex. A face with an angle of pi
// has no inside.
TEST(Fixed_triangulation, a_vertex_may_need_more_angle_than_its_faces_have)
{
  const Triangulation t(tetrahedron());
  for(double curvature : {-0.9 * pi, -pi, -1.1 * pi, -1.9 * pi}) {
    const Conditions condition = around_apex(curvature);
    const Planar_conformal_map fixed = flatten_fixed(t, condition), free = flatten(t, condition);
    EXPECT_EQ(free.status(), Map_status::success) << curvature;
    check_conditions(free, t.mesh(), condition, 1e-10);
    if(curvature > -pi) {
      EXPECT_NE(fixed.status(), Map_status::no_minimum);
      continue;
    }
    EXPECT_EQ(fixed.status(),
              curvature < -pi ? Map_status::no_minimum : Map_status::triangle_inequality);
    for(Face_index f : mesh_C(fixed).faces())
      EXPECT_FALSE(fixed.is_laid_out(f));
  }
}

// The status follows from the scaled lengths in the result.
TEST(Fixed_triangulation, fails_where_flips_succeed)
{
  std::size_t successes = 0, failures = 0;
  for(const auto& [m, seed] : traced(12, near_degenerate_mesh)) {
    const Planar_conformal_map free = DCM::flatten(m.mesh);
    // Needles may be smaller than the rounding errors of positions.
    EXPECT_TRUE(free.status() == Map_status::success || free.status() == Map_status::not_conformal);
    ASSERT_LT(free.max_curvature_error(), 1e-10);
    const Triangulation t(m.mesh);
    Conditions condition = default_conditions(t.mesh());
    for(Vertex_index v : free.cones())
      condition[v] = Vertex_condition::log_scale(0);
    const Planar_conformal_map fixed = flatten_fixed(t, condition);
    if(fixed.status() == Map_status::success) {
      ++successes;
      check_conditions(fixed, t.mesh(), condition, 1e-6); // by the cosine law
    } else {
      ++failures;
      EXPECT_EQ(fixed.status(), Map_status::triangle_inequality);
      EXPECT_LE(least_slack(fixed), 1e-15);
    }
  }
  EXPECT_GT(successes, 2u);
  EXPECT_GT(failures, 5u);
}

// With flips, a map always exists.
TEST(Fixed_triangulation, fails_with_hard_cones_where_flips_succeed)
{
  std::size_t failures = 0;
  for(unsigned int seed : seeds(30)) {
    const Mesh mesh = coarse_surface(seed % 5, seed);
    const Triangulation t(mesh);
    const Conditions condition = as_curvatures(hard_cones(mesh, seed));
    const Planar_conformal_map free = flatten(t, condition), fixed = flatten_fixed(t, condition);
    ASSERT_EQ(free.status(), Map_status::success);
    EXPECT_LT(free.max_curvature_error(), 1e-10);
    if(fixed.status() == Map_status::success)
      check_conditions(fixed, t.mesh(), condition, 1e-6);
    else
      ++failures;
  }
  EXPECT_GT(failures, 20u);
}

// Enumerators are numbered from zero, and the value after the last one has no text.
TEST(Map_status, every_value_has_a_name_and_a_message)
{
  std::set<std::string> names, messages;
  for(int i = 0; i <= int(Map_status::not_glued); ++i) {
    names.insert(DCM::to_string(Map_status(i)));
    messages.insert(DCM::message(Map_status(i)));
  }
  EXPECT_EQ(names,
            (std::set<std::string>{"success", "not_converged", "triangle_inequality", "no_minimum",
                                   "wrong_curvature", "not_laid_out", "layout_collapsed",
                                   "not_closed", "not_circular", "not_rectangular", "not_convex",
                                   "not_inscribed", "not_conformal", "not_glued"}));
  EXPECT_EQ(messages.size(), names.size());
  EXPECT_EQ(messages.count("unknown"), 0u);
  EXPECT_EQ(DCM::to_string(Map_status(int(Map_status::not_glued) + 1)), std::string("unknown"));
}

} // namespace Test_fixed_triangulation
