// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Levels and evolving surfaces are models of IntrinsicSurface.

#include "simplified_surfaces.h"

#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/operators.h>

namespace Test_surface_models {

using namespace Test_surfaces;

TEST(Surface_models, of_one_surface)
{
  for_each_surface([](const Simplified& s, const Surface_map&) {
    const IS::Evolving_surface surface(s.fine.triangulation());
    const Eigen::MatrixXd expected = IT::cotan_laplacian(s.fine);
    EXPECT_EQ(Eigen::MatrixXd(IT::cotan_laplacian(surface)), expected);
    EXPECT_EQ(Eigen::MatrixXd(IT::cotan_laplacian(surface.surface())), expected);
    EXPECT_EQ(Eigen::MatrixXd(IT::cotan_laplacian(s.fine.triangulation().intrinsic())), expected);
    EXPECT_EQ(IT::heat_distance(surface, Vertex_index(0)),
              IT::heat_distance(s.fine, Vertex_index(0)));
  });
}

// The row of a removed vertex is empty.
TEST(Surface_models, with_gaps)
{
  for_each_surface([](const Simplified& s, const Surface_map&) {
    const Eigen::MatrixXd of_surface = IT::mass_matrix(s.surface);
    const Eigen::MatrixXd of_level = IT::mass_matrix(s.coarse);
    EXPECT_NEAR(of_surface.sum(), of_level.sum(), 1e-12 * of_level.sum());
    for(Vertex_index v : s.coarse.mesh().vertices())
      for(Vertex_index w : s.coarse.mesh().vertices())
        EXPECT_NEAR(of_surface.coeff(s.coarse.surface_vertex(v), s.coarse.surface_vertex(w)),
                    of_level.coeff(v, w), 1e-12 * of_level.sum());
  });
}

} // namespace Test_surface_models
