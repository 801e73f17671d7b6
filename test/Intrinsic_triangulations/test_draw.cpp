// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/draw_intrinsic_triangulation.h>
#include <CGAL/version.h>

namespace Test_draw {

using namespace Test_surfaces;

#if CGAL_VERSION_MAJOR >= 6

typedef CGAL::Graphics_scene Scene;

TEST(Draw, adds_the_common_subdivision_to_a_scene)
{
  const Mesh mesh = perturbed(embedded_torus(12, 9), 0.1, 1);
  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  const IT::Correspondence<> correspondence(tri);
  IT::Common_subdivision<> subdivision(correspondence);
  for(const bool nofill : {false, true}) {
    Scene scene;
    CGAL::add_to_graphics_scene(tri, mesh.points(), scene, nofill);
    EXPECT_EQ(scene.number_of_elements(Scene::POS_COLORED_SEGMENTS),
              2 * subdivision.mesh().number_of_edges());
    // Polygons of n corners are drawn as n - 2 triangles.
    EXPECT_EQ(scene.number_of_elements(Scene::POS_COLORED_FACES),
              nofill ? 0
                     : 3 * (2 * subdivision.mesh().number_of_edges() -
                            2 * subdivision.mesh().number_of_faces()));
    EXPECT_EQ(scene.bounding_box(), CGAL::Polygon_mesh_processing::bbox(mesh));
  }
}

#endif

} // namespace Test_draw
