// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/Hyperbolic_tiling.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

namespace Test_hyperbolic_tiling {

using namespace Test_surfaces;

// Returns the direction in which the geodesic from `p` to `z` starts.
double direction(const Complex& p, const Complex& z)
{
  return std::arg((z - p) / (1. - std::conj(p) * z));
}

// Returns the area of the polygon with these corners, by Gauss and Bonnet.
double hyperbolic_area(const std::vector<Complex>& corner)
{
  double result = -2 * pi;
  const std::size_t n = corner.size();
  for(std::size_t i = 0; i < n; ++i) {
    const double angle =
      direction(corner[i], corner[(i + n - 1) % n]) - direction(corner[i], corner[(i + 1) % n]);
    result += pi - (angle > 0 ? angle : angle + 2 * pi);
  }
  return result;
}

TEST(Hyperbolic_tiling, has_the_area_of_the_surface)
{
  for(const int genus : {2, 3}) {
    const auto map = DCM::uniformize_hyperbolic(plate_with_holes(genus));
    const DCM::Hyperbolic_tiling tiling(map, 0);
    EXPECT_NEAR(hyperbolic_area(tiling.corners()), 4 * pi * (genus - 1), 1e-8);
    EXPECT_GE(tiling.side_motions().size(), std::size_t(4 * genus));
  }
}

// Each side has a motion, and its image side has the inverse motion. The images have corners of the
// domain, at least the ends of the side.
TEST(Hyperbolic_tiling, images_lie_across_sides)
{
  const auto map = DCM::uniformize_hyperbolic(plate_with_holes(2));
  const DCM::Hyperbolic_tiling tiling(map, 0);
  const auto& motions = tiling.side_motions();
  const auto& corners = tiling.corners();
  const auto is_near = [](const Complex& z, const Complex& w) { return std::abs(z - w) < 1e-7; };
  for(const auto& m : motions) {
    const auto is_inverse = [&](const auto& o) { return is_near((m * o)(0), 0); };
    EXPECT_TRUE(std::any_of(motions.begin(), motions.end(), is_inverse));
    std::size_t shared = 0;
    for(const Complex& z : corners)
      shared += std::any_of(corners.begin(), corners.end(),
                            [&](const Complex& w) { return is_near(m(z), w); });
    EXPECT_GE(shared, 2u);
  }
  EXPECT_EQ(tiling.tiles(0).size(), 1u);
  EXPECT_EQ(tiling.tiles(1, 0).size(), 1 + motions.size());
  const auto tiles = tiling.tiles(2);
  EXPECT_GT(tiles.size(), 1 + motions.size());
  for(std::size_t i = 0; i < tiles.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(is_near(tiles[i].motion(0), tiles[j].motion(0)));
}

// The circle passes through both points, and meets the unit circle at right angles.
TEST(Geodesic_center, is_that_of_an_orthogonal_circle)
{
  CGAL::Random random(3);
  for(int i = 0; i < 100; ++i) {
    const Complex z = std::polar(0.9 * random.get_double(), 7 * random.get_double()),
                  w = std::polar(0.9 * random.get_double(), 7 * random.get_double());
    const Complex c = DCM::geodesic_center(z, w);
    EXPECT_NEAR(std::norm(z - c) / (std::norm(c) - 1), 1, 1e-6);
    EXPECT_NEAR(std::norm(w - c) / (std::norm(c) - 1), 1, 1e-6);
  }
}

} // namespace Test_hyperbolic_tiling
