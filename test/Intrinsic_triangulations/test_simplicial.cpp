// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "flat_pair.h"
#include "hard_meshes.h"

#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/extrinsic_mesh.h>
#include <CGAL/Intrinsic_triangulations/is_simplicial.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

namespace Test_simplicial {

using namespace Test_surfaces;

typedef IT::Intrinsic_triangulation<> Triangulation;

template <typename Traits>
void expect_simplicial(IT::Intrinsic_triangulation<Traits> tri, double angle)
{
  const IT::Refinement_result result =
    IT::refine(tri, IT::parameters::minimum_angle(angle).simplicial(true));
  EXPECT_TRUE(has_distinct_simplices(tri.mesh()));
  EXPECT_TRUE(IT::is_simplicial(tri.mesh()));
  EXPECT_TRUE(tri.is_valid(true));
  EXPECT_TRUE(IT::is_Delaunay(tri));
  EXPECT_TRUE(std::all_of(result.remaining.begin(), result.remaining.end(), IT::is_excused))
    << IT::to_string(result.status);
  if(angle == 0) {
    EXPECT_TRUE(result.remaining.empty());
  }
}

TEST(Simplicial, definition)
{
  for(const auto& [c, seed] : traced(complexes(), 20)) {
    Triangulation tri = triangulation(c.mesh, random_lengths(c.mesh, seed));
    EXPECT_EQ(IT::is_simplicial(tri.mesh()), has_distinct_simplices(tri.mesh()));
    random_flips(tri, 10, seed);
    EXPECT_EQ(IT::is_simplicial(tri.mesh()), has_distinct_simplices(tri.mesh()));
  }
}

TEST(Simplicial, all_complexes)
{
  for(unsigned seed : seeds(20))
    for(const Named_complex& c : traced(complexes()))
      for(double angle : traced({0., 25., 30.}))
        expect_simplicial(triangulation(c.mesh, random_lengths(c.mesh, seed)), angle);
}

// Two triangles lie on each other, with varying angles. However thin they are, few vertices
// suffice.
TEST(Simplicial, pointed_pillows)
{
  const Delta_complex pillow = glue({{1, 2, 3}, {-3, -2, -1}});
  for(double degrees :
      traced({0.001, 0.1, 1., 10., 29.9, 30.1, 37.5, 44., 45.5, 60., 89., 120., 179.}))
    for(double angle : traced({0., 20., 25., 30.})) {
      const double opposite = 2 * std::sin(degrees * std::acos(-1.) / 360);
      expect_simplicial(triangulation(pillow, {1, 1, opposite}), angle);
    }
  for(double height : traced({1e-1, 1e-2, 1e-3, 1e-4})) {
    Triangulation tri = triangulation(pillow, {1, 1, 2 * std::sqrt(1 - height * height)});
    IT::refine(tri, IT::parameters::simplicial(true));
    EXPECT_LT(tri.number_of_inserted_vertices(), 20u);
  }
}

// The tip of a thin cone has three neighbors only if they are equally far away, up to the square of
// its angle.
TEST(Simplicial, needle_pillows)
{
  const Delta_complex pillow = glue({{1, 2, 3}, {-3, -2, -1}});
  for(double width : traced({1e-3, 1e-5, 1e-6, 1e-7}))
    for(double difference : traced({0., 0.2, 0.5, 0.8, 0.95})) {
      const Triangulation tri = triangulation(pillow, {1, 1 - difference * width, width});
      expect_simplicial(tri, 0);
      Triangulation few = tri;
      IT::refine(few, IT::parameters::minimum_angle(0).simplicial(true));
      EXPECT_LT(few.number_of_inserted_vertices(), 60u);
    }
}

TEST(Simplicial, hard_meshes)
{
  for(unsigned seed : traced({11u, 15u}))
    expect_simplicial(Triangulation(hard_mesh(seed).mesh), 25);
}

TEST(Simplicial, exact_decisions)
{
  for(const Named_mesh& m : traced(meshes())) {
    IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>> tri(m.mesh);
    IT::refine(tri, IT::parameters::minimum_angle(25).simplicial(true));
    EXPECT_TRUE(has_distinct_simplices(tri.mesh()));
    EXPECT_TRUE(IT::certify_Delaunay(tri).is_Delaunay());
  }
}

// ---- In space ----

TEST(Simplicial, mesh_in_space)
{
  for(const std::string& file : data_meshes(300000)) {
    SCOPED_TRACE(file);
    const Mesh mesh = read_mesh(file);
    if(!CGAL::is_triangle_mesh(mesh) || mesh.number_of_faces() == 0 ||
       !CGAL::is_valid_polygon_mesh(mesh))
      continue;
    Triangulation tri(mesh);
    IT::refine(tri, IT::parameters::simplicial(true));
    const Mesh result = IT::extrinsic_mesh(tri, mesh.points());
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(result));
    EXPECT_EQ(result.number_of_faces(), tri.mesh().number_of_faces());
    for(Vertex_index v : mesh.vertices())
      EXPECT_EQ(result.point(v), mesh.point(v));
    // A straight line is not longer than the geodesic.
    for(Edge_index e : result.edges()) {
      const double in_space = std::sqrt(CGAL::squared_distance(result.point(result.vertex(e, 0)),
                                                               result.point(result.vertex(e, 1))));
      EXPECT_LE(in_space, tri.length(e) * (1 + 1e-7));
    }
  }
}

TEST(Simplicial, names_the_face_that_is_not)
{
  const Delta_complex pillow = glue({{1, 2, 3}, {-3, -2, -1}});
  const Triangulation tri = triangulation(pillow, {1, 1, 1});
  const std::vector<Point> points(3);
  try {
    IT::extrinsic_mesh(
      tri, boost::make_iterator_property_map(points.begin(), boost::identity_property_map()));
    FAIL();
  } catch(const IT::Invalid_input& error) {
    EXPECT_EQ(std::string(error.what()).find("face 0 "), 0u) << error.what();
  }
}

} // namespace Test_simplicial
