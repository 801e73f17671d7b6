// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests use sequences of named parameters of this package, of Intrinsic_triangulations, and
// of CGAL.

#include "../Intrinsic_triangulations/refined_meshes.h"
#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace Test_named_parameters {

using namespace Test_surfaces;
namespace np = DCM::parameters;

struct Stage_recorder : DCM::Default_flattening_visitor
{
  std::vector<DCM::Flattening_stage> stages;
  void start(DCM::Flattening_stage stage) { stages.push_back(stage); }
};

TEST(Named_parameters, of_all_packages_chain_in_any_order)
{
  const Triangulation t(random_sphere(12, 1));
  const std::vector<double> length = lengths_of(t);
  Conditions condition(12);
  condition[0] = condition[4] = condition[8] = Vertex_condition::log_scale(0.1);
  const auto map = as_map(condition);
  const auto lengths =
    boost::make_function_property_map<Edge_index>([&](Edge_index e) { return 3 * length[e]; });
  Stage_recorder one, other;
  const Planar_conformal_map first = DCM::flatten(t.mesh(), np::visitor(std::ref(one))
                                                              .vertex_condition_map(map)
                                                              .maximum_log_scale(100)
                                                              .edge_length_map(lengths)),
                             second = DCM::flatten(t.mesh(), np::edge_length_map(lengths)
                                                               .maximum_log_scale(1)
                                                               .vertex_condition_map(map)
                                                               .visitor(std::ref(other))
                                                               .maximum_log_scale(100));
  EXPECT_EQ(one.stages, other.stages);
  EXPECT_FALSE(one.stages.empty());
  for(Vertex_index v : t.mesh().vertices())
    EXPECT_EQ(first.log_scale(v), second.log_scale(v));
  EXPECT_EQ(first.log_scale(Vertex_index(4)), 0.1);
}

// Scale factors are within the bound if cones are placed, and beyond it if not.
TEST(Named_parameters, cones_are_placed_as_is_said)
{
  const Mesh mesh = punctured(random_sphere(40, 6), {0});
  const double bound = 0.01;
  const Conditions conditions = default_conditions(Triangulation(mesh).mesh());
  const auto map = as_map(conditions);
  const auto is_within = [&](const Planar_conformal_map& m) {
    const auto vertices = mesh.vertices();
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](Vertex_index v) { return std::abs(m.log_scale(v)) <= bound + 1e-9; });
  };
  const auto expect_cones = [&](const Planar_conformal_map& m, bool has_cones) {
    EXPECT_EQ(m.status(), DCM::Map_status::success);
    EXPECT_EQ(!m.cones().empty(), has_cones);
    EXPECT_EQ(is_within(m), has_cones);
  };
  using DCM::Cones;
  for(const auto& [cones, has_cones] :
      {std::pair(Cones::automatic, true), {Cones::greedy, true}, {Cones::none, false}}) {
    expect_cones(DCM::flatten(mesh, np::maximum_log_scale(bound).cones(cones)), has_cones);
    expect_cones(
      DCM::flatten(mesh, np::cones(cones).vertex_condition_map(map).maximum_log_scale(bound)),
      has_cones);
  }
  expect_cones(DCM::flatten(mesh, np::maximum_log_scale(bound)), true);
  expect_cones(DCM::flatten(mesh, np::vertex_condition_map(map)), false);
}

// Areas around vertices change by the square of the factor of lengths; the stricter bound counts.
TEST(Named_parameters, cones_bound_the_distortion_of_areas)
{
  const Mesh mesh = random_sphere(60, 3);
  const auto cones = [&](const auto& parameters) { return DCM::flatten(mesh, parameters).cones(); };
  for(const double distortion : {1.5, 20., 1e4}) {
    const Planar_conformal_map map =
      DCM::flatten(mesh, np::maximum_area_distortion(distortion).cones(DCM::Cones::greedy));
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    for(Vertex_index v : mesh.vertices())
      EXPECT_LE(std::max(std::exp(2 * map.log_scale(v)), std::exp(-2 * map.log_scale(v))),
                distortion * (1 + 1e-9));
    const double log_scale = std::log(distortion) / 2;
    EXPECT_EQ(cones(np::maximum_log_scale(log_scale)), map.cones());
    EXPECT_EQ(cones(np::maximum_log_scale(2 * log_scale).maximum_area_distortion(distortion)),
              map.cones());
    EXPECT_EQ(cones(np::maximum_log_scale(log_scale).maximum_area_distortion(2 * distortion)),
              map.cones());
  }
  for(const double wrong : {1., 0.5, -1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(DCM::flatten(mesh, np::maximum_area_distortion(wrong)), IT::Invalid_input);
}

// Exchanged cones keep the bound, and the promises of the map. A round sphere needs fewer cones.
TEST(Named_parameters, cones_are_exchanged_within_the_bound)
{
  std::size_t greedy = 0, exchanged = 0;
  for(const Mesh& mesh : {unit_sphere(16), random_sphere(200, 1), random_sphere(200, 2),
                          punctured(random_sphere(100, 6), {0}), plate_with_holes(2)})
    for(const double bound : {0.7, 1., 1.4}) {
      const auto with = [&](DCM::Cones cones) {
        return DCM::flatten(mesh, np::maximum_log_scale(bound).cones(cones));
      };
      const Planar_conformal_map map = with(DCM::Cones::exchanged);
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      for(Vertex_index v : mesh.vertices())
        if(!mesh.is_border(v)) {
          EXPECT_LE(std::abs(map.log_scale(v)), bound + 1e-9);
        }
      for(Vertex_index v : map.cones())
        EXPECT_EQ(map.log_scale(v), 0);
      exchanged += map.cones().size();
      greedy += with(DCM::Cones::greedy).cones().size();
    }
  EXPECT_LT(exchanged, greedy);
}

// Represents a visitor with functions that are not constant, whose copies count together.
struct Counting_visitor : DCM::Default_flattening_visitor
{
  void start(DCM::Flattening_stage) { ++own, ++*all; }

  std::size_t own = 0;
  std::shared_ptr<std::size_t> all = std::make_shared<std::size_t>(0);
};

// Checks that `run(v)` calls a function with a visitor, and with one that `std::ref()` refers to.
template <typename Run>
void expect_notified(const Run& run)
{
  Counting_visitor copied, referred;
  run(copied);
  run(std::ref(referred));
  EXPECT_GT(*copied.all, 0u);
  EXPECT_EQ(copied.own, 0u);
  EXPECT_EQ(referred.own, *copied.all);
}

TEST(Named_parameters, take_visitors_and_references_to_them)
{
  const Mesh sphere = random_sphere(20, 1), plate = plate_with_holes(2);
  expect_notified([&](const auto& v) { DCM::flatten(sphere, np::visitor(v)); });
  expect_notified([&](const auto& v) { DCM::map_to_sphere(sphere, np::visitor(v)); });
  expect_notified([&](const auto& v) { DCM::uniformize_hyperbolic(plate, np::visitor(v)); });
}

} // namespace Test_named_parameters
