// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_maps.h"
#include "hard_cones.h"

#include <CGAL/subdivision_method_3.h>

#include <cstddef>
#include <string>

namespace Test_hard_cones {

using namespace Test_surfaces;

Mesh smooth_surface(int genus)
{
  Mesh result = plate_with_holes(genus);
  CGAL::Subdivision_method_3::Loop_subdivision(
    result, CGAL::parameters::number_of_iterations(genus < 2 ? 3 : 2));
  return result;
}

class Hard_cones : public testing::TestWithParam<int>
{};

TEST_P(Hard_cones, are_reached)
{
  const Mesh mesh = smooth_surface(GetParam());
  const Triangulation t(mesh);
  for(unsigned int seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Conditions condition = as_curvatures(hard_cones(mesh, seed));
    const Planar_conformal_map map = flatten(t, condition);
    EXPECT_EQ(map.minimization().status, DCM::Minimization_status::converged);
    EXPECT_LT(map.max_curvature_error(), 1e-10);
    EXPECT_LT(map.minimization().gradient_error, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Genus, Hard_cones, testing::Range(0, 5));

// Flat with greedy cones, or it is said what is wrong, by an exception or the status: a triangle whose
// lengths have no area in double precision cannot be doubled along its boundary.
TEST(Near_degenerate_meshes, are_flattened_or_refused)
{
  std::size_t refused = 0;
  for(unsigned int seed = 0; seed < 120; ++seed) {
    const Named_mesh input = near_degenerate_mesh(seed);
    SCOPED_TRACE(input.name + ' ' + std::to_string(seed));
    try {
      const Planar_conformal_map map = DCM::flatten(input.mesh);
      if(map.minimization().status == DCM::Minimization_status::rounding_limit) {
        ++refused;
        continue;
      }
      EXPECT_EQ(map.minimization().status, DCM::Minimization_status::converged);
      EXPECT_LT(map.max_curvature_error(), 1e-10);
    } catch(const IT::Numerical_error&) {
      ++refused;
    }
  }
  EXPECT_LE(refused, 1u);
}

} // namespace Test_hard_cones
