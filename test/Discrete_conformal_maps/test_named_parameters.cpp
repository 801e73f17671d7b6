// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sequences of named parameters of this package, of Intrinsic_triangulations, and of CGAL.

#include "flat_maps.h"

#include <functional>
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

} // namespace Test_named_parameters
