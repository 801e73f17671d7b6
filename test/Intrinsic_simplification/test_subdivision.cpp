// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests check the common subdivision of two levels.

#include "../Intrinsic_triangulations/data_meshes.h"
#include "simplified_surfaces.h"

#include <CGAL/Intrinsic_simplification/Surface_subdivision.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <boost/property_map/property_map.hpp>

namespace Test_subdivision {

using namespace Test_surfaces;
using IS::Level;
using Subdivision = IS::Surface_subdivision<>;
using Bends = Subdivision::Bends;

double area(Face_index f, const Surface_level& level)
{
  return area_of(f, level.mesh(), level.length_map());
}

double total_area(const Surface_level& level) { return area_of(level.mesh(), level.length_map()); }

// Checks that the areas of the parts of each face add up to its area.
void expect_areas(const Subdivision& subdivision, Level side, const Surface_level& level)
{
  std::vector<double> sum(level.mesh().number_of_faces(), 0);
  for(Face_index f : subdivision.mesh().faces())
    sum[subdivision.parent_face(side, f)] += subdivision.signed_area(side, f);
  const double total = total_area(level);
  for(Face_index f : level.mesh().faces())
    EXPECT_NEAR(sum[f], area(f, level), 1e-7 * area(f, level) + 1e-12 * total);
}

// Checks that faces are polygons, and their corners lie in the parents.
void expect_polygons(const Subdivision& subdivision)
{
  const auto& mesh = subdivision.mesh();
  ASSERT_TRUE(mesh.is_valid());
  for(Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(h))
      for(const Level side : {Level::fine, Level::coarse}) {
        const Coordinates b = subdivision.coordinates(side, h);
        EXPECT_NEAR(b[0] + b[1] + b[2], 1, 1e-14);
        for(double x : b)
          EXPECT_GE(x, 0);
      }
}

// Returns the position of the target of h in the parent of its face.
Location location(const Subdivision& subdivision, Level side, Halfedge_index h)
{
  return {subdivision.parent_face(side, subdivision.mesh().face(h)),
          subdivision.coordinates(side, h)};
}

// Checks that, seen from every face, the positions on both sides belong together.
void expect_mapped(const Subdivision& subdivision, const Surface_map& map)
{
  const auto& mesh = subdivision.mesh();
  for(Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(h))
      expect_same_place(map.to_coarse(location(subdivision, Level::fine, h)),
                        location(subdivision, Level::coarse, h), map.coarse().mesh());
}

void expect_parents(const Subdivision& subdivision)
{
  const auto& mesh = subdivision.mesh();
  for(Halfedge_index h : mesh.halfedges()) {
    bool has_parent = false;
    for(const Level side : {Level::fine, Level::coarse}) {
      const Halfedge_index parent = subdivision.parent_halfedge(side, h);
      const Delta_complex& level = subdivision.level(side).mesh();
      has_parent = has_parent || parent.is_valid();
      if(parent.is_valid()) {
        EXPECT_EQ(subdivision.parent_halfedge(side, mesh.opposite(h)), level.opposite(parent));
        EXPECT_EQ(mesh.is_border(h), level.is_border(parent));
        EXPECT_TRUE(mesh.is_border(h) ||
                    subdivision.parent_face(side, mesh.face(h)) == level.face(parent));
      } else {
        EXPECT_EQ(subdivision.parent_face(side, mesh.face(h)),
                  subdivision.parent_face(side, mesh.face(mesh.opposite(h))));
      }
    }
    EXPECT_TRUE(has_parent);
  }
}

// Checks that the parts of a coarse edge are a path between its ends, and belong to no other edge.
void expect_parts_of_coarse_edges(const Subdivision& subdivision)
{
  const auto& mesh = subdivision.mesh();
  const Delta_complex& coarse = subdivision.level(Level::coarse).mesh();
  std::size_t parts = 0;
  for(Edge_index e : coarse.edges()) {
    Vertex_index end = Delta_complex::null_vertex();
    for(Halfedge_index h : subdivision.parts_of_coarse_edge(e)) {
      EXPECT_EQ(subdivision.parent_halfedge(Level::coarse, h), coarse.halfedge(e));
      EXPECT_TRUE(end.is_valid() ? mesh.source(h) == end
                                 : subdivision.parent_vertex(Level::coarse, mesh.source(h)) ==
                                     coarse.source(coarse.halfedge(e)));
      end = mesh.target(h);
      ++parts;
    }
    EXPECT_EQ(subdivision.parent_vertex(Level::coarse, end), coarse.target(coarse.halfedge(e)));
  }
  for(Edge_index e : mesh.edges())
    parts -= subdivision.parent_halfedge(Level::coarse, mesh.halfedge(e)).is_valid();
  EXPECT_EQ(parts, 0u);
}

void expect_subdivision(const Simplified& s, const Surface_map& map, Bends bends)
{
  const Subdivision subdivision(map, bends);
  expect_polygons(subdivision);
  expect_parents(subdivision);
  expect_parts_of_coarse_edges(subdivision);
  expect_areas(subdivision, Level::fine, s.fine);
  expect_areas(subdivision, Level::coarse, s.coarse);
  expect_mapped(subdivision, map);
}

TEST(Subdivision, of_all_surfaces)
{
  for_each_surface([](const Simplified& s, const Surface_map& map) {
    expect_subdivision(s, map, Bends::of_coarse_edges);
    expect_subdivision(s, map, Bends::of_all_edges);
  });
}

// No edge passes through a vertex.
TEST(Subdivision, has_positive_polygons)
{
  std::size_t faces = 0;
  for_each_random_surface([&](const Simplified& s, const Surface_map& map) {
    const Subdivision subdivision(map, Bends::of_all_edges);
    for(Face_index f : subdivision.mesh().faces()) {
      EXPECT_GT(subdivision.signed_area(Level::fine, f), -1e-13 * total_area(s.fine));
      EXPECT_GT(subdivision.signed_area(Level::coarse, f), -1e-13 * total_area(s.coarse));
      ++faces;
    }
  });
  EXPECT_GT(faces, 1000u);
}

// Triangles have no negative area on the fine surface, however bent the polygons are.
TEST(Subdivision, triangulates)
{
  std::size_t cut = 0;
  for_each_random_surface([&](const Simplified& s, const Surface_map& map) {
    Subdivision subdivision(map, Bends::of_all_edges);
    const std::size_t before = subdivision.mesh().number_of_faces();
    subdivision.triangulate();
    cut += subdivision.mesh().number_of_faces() - before;
    ASSERT_TRUE(subdivision.mesh().is_valid());
    for(Face_index f : subdivision.mesh().faces()) {
      EXPECT_LE(subdivision.mesh().degree(f), 3u);
      EXPECT_GT(subdivision.signed_area(Level::fine, f), -1e-13 * total_area(s.fine));
    }
    expect_parts_of_coarse_edges(subdivision);
    expect_areas(subdivision, Level::fine, s.fine);
    expect_areas(subdivision, Level::coarse, s.coarse);
  });
  EXPECT_GT(cut, 1000u);
}

// Values at vertices agree with those at all corners of faces.
TEST(Subdivision, interpolates_from_both_levels)
{
  for_each_random_surface([&](const Simplified&, const Surface_map& map) {
    const Subdivision subdivision(map, Bends::of_all_edges);
    const auto value = boost::make_function_property_map<Vertex_index>(
      [](Vertex_index v) { return std::sin(double(v.idx())); });
    for(const Level side : {Level::fine, Level::coarse}) {
      std::vector<double> result(subdivision.mesh().number_of_vertices());
      IT::interpolate(
        side, subdivision, value,
        boost::make_iterator_property_map(result.begin(), boost::identity_property_map()));
      const Delta_complex& level = subdivision.mesh(side);
      for(Halfedge_index h : subdivision.mesh().halfedges())
        if(!subdivision.mesh().is_border(h)) {
          const auto [f, b] = subdivision.location(side, h);
          const auto corner = IT::sides(f, level);
          double expected = 0;
          for(std::size_t c = 0; c < 3; ++c)
            expected += b[c] * get(value, level.source(corner[c]));
          EXPECT_NEAR(result[subdivision.mesh().target(h)], expected, 1e-13);
        }
    }
  });
}

// A level is mapped to itself: the subdivision is the mesh.
TEST(Subdivision, of_one_level)
{
  const Evolving_surface surface(embedded_torus(5, 4));
  const Surface_level level(surface), same(surface);
  const Surface_map map(surface, level, same);
  const Subdivision subdivision(map, Bends::of_all_edges);
  EXPECT_EQ(subdivision.mesh().number_of_vertices(), 20u);
  EXPECT_EQ(subdivision.mesh().number_of_edges(), 60u);
  EXPECT_EQ(subdivision.mesh().number_of_faces(), 40u);
  expect_parents(subdivision);
}

// In the plane every vertex has the same position on both levels, and brute force counts the
// crossings.
TEST(Subdivision, of_a_flat_polygon)
{
  for_each_flat_polygon([](const Mesh& mesh, const Simplified& s, const Surface_map& map) {
    const Subdivision subdivision(map);
    std::size_t expected = 0, found = 0;
    for(Edge_index e : s.coarse.mesh().edges())
      for(Edge_index f : mesh.edges())
        expected += cross(mesh.point(s.coarse.surface_vertex(s.coarse.mesh().vertex(e, 0))),
                          mesh.point(s.coarse.surface_vertex(s.coarse.mesh().vertex(e, 1))),
                          mesh.point(mesh.vertex(f, 0)), mesh.point(mesh.vertex(f, 1)));
    for(Vertex_index v : subdivision.mesh().vertices()) {
      const auto &fine = subdivision.place(Level::fine, v),
                 &coarse = subdivision.place(Level::coarse, v);
      found += IT::on_edge(fine) && IT::halfedge_of(coarse).is_valid();
      EXPECT_LT(std::sqrt(CGAL::squared_distance(
                  place(IT::face_location(fine, s.fine.mesh()), s.fine, mesh),
                  place(IT::face_location(coarse, s.coarse.mesh()), s.coarse, mesh))),
                1e-8);
    }
    EXPECT_EQ(found, expected);
  });
}

// Coarse edges run through vertices and along edges, up to rounding.
TEST(Subdivision, of_a_cube)
{
  for(const unsigned int n : {100u, 30u, 8u}) {
    const Simplified s = simplified_by_curvature(Evolving_surface(subdivided(cube(), 3)), n);
    const Surface_map map(s.surface, s.fine, s.coarse);
    const Subdivision subdivision(map, Bends::of_all_edges);
    expect_polygons(subdivision);
    expect_parents(subdivision);
    expect_parts_of_coarse_edges(subdivision);
    expect_areas(subdivision, Level::fine, s.fine);
    expect_areas(subdivision, Level::coarse, s.coarse);
    for(Face_index f : subdivision.mesh().faces()) {
      EXPECT_TRUE(subdivision.mesh().degree(f) > 2 ||
                  std::abs(subdivision.signed_area(Level::fine, f)) < 1e-12);
      EXPECT_GT(subdivision.signed_area(Level::fine, f), -1e-12);
      EXPECT_GT(subdivision.signed_area(Level::coarse, f), -1e-12);
    }
  }
}

// Edges pass vertices at the distance of rounding errors, several of them side by side.
TEST(Subdivision, with_vertices_as_near_as_rounding)
{
  std::size_t checked = 0;
  CGAL::Random random(1);
  for(const double distance : traced({1e-12, 1e-13, 1e-14, 1e-15, 1e-16}))
    for(unsigned int seed : seeds(20)) {
      const Mesh mesh = with_near_vertices(random_sphere(20, seed), distance, random);
      if(!all_are_apart(mesh))
        continue;
      ++checked;
      for(const unsigned int n : {60u, 30u, 10u, 0u}) {
        const Simplified s(Evolving_surface(mesh), n);
        const Surface_map map(s.surface, s.fine, s.coarse);
        const Subdivision subdivision(map, Bends::of_all_edges);
        expect_polygons(subdivision);
        expect_parents(subdivision);
      }
    }
  EXPECT_GT(checked, 50u);
}

// Edges between inserted vertices are closer to each other than rounding. In `double`, edges of
// some of these levels cross each other.
TEST(Subdivision, of_refined_hard_meshes)
{
  for(std::uint64_t seed = 0; seed < 3 * hard_families.size(); ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = hard_mesh(seed).mesh;
    Evolving_surface surface(mesh);
    const Surface_level fine(surface);
    simplify(surface, number_of_vertices(2 * mesh.number_of_vertices() / 5));
    ASSERT_NO_THROW(
      IS::refine(surface, IS::parameters::minimum_angle(20.).maximum_number_of_insertions(1000)));
    const Surface_level coarse(surface);
    const Surface_map map(surface, fine, coarse);
    const Subdivision subdivision(map);
    expect_polygons(subdivision);
    expect_parents(subdivision);
    expect_parts_of_coarse_edges(subdivision);
  }
}

TEST(Subdivision, keeps_isolated_vertices)
{
  Mesh mesh = random_sphere(50, 8);
  const Vertex_index alone = mesh.add_vertex({3, 3, 3});
  const Simplified s(Evolving_surface(mesh), 10);
  const Surface_map map(s.surface, s.fine, s.coarse);
  const Subdivision subdivision(map);
  EXPECT_TRUE(subdivision.mesh().is_isolated(alone));
  EXPECT_TRUE(subdivision.is_vertex(Level::coarse, alone));
  expect_mapped(subdivision, map);
}

// Checks that polygons without area occur only at coinciding edges, up to the rounding of positions
// that have been mapped through dozens of operations.
void expect_no_negative_areas(const Subdivision& subdivision, Level side)
{
  const double total = total_area(subdivision.level(side));
  double sum = 0;
  for(Face_index f : subdivision.mesh().faces()) {
    const double part = subdivision.signed_area(side, f);
    EXPECT_GT(part, -2e-14 * total);
    sum += part;
  }
  EXPECT_NEAR(sum, total, 1e-8 * total);
}

// Returns the sides of a cube whose bits are set, each cut in two.
Mesh sides_of_cube(unsigned int set)
{
  Mesh mesh;
  for(unsigned int v = 0; v < 8; ++v)
    mesh.add_vertex({v & 1, (v >> 1) & 1, v >> 2});
  for(unsigned int s = 0; s < 6; ++s)
    if((set >> s) & 1) {
      const unsigned int x = s / 2, origin = s % 2 << x;
      const unsigned int y = 1u << (x + 1 + (s + 1) % 2) % 3, z = 1u << (x + 1 + s % 2) % 3;
      const Mesh::Vertex_index a(origin), b(origin + y), c(origin + y + z), d(origin + z);
      mesh.add_face(a, b, c);
      mesh.add_face(a, c, d);
    }
  return mesh;
}

// Midpoints of coarse edges, where refinement inserts vertices, are removed vertices up to
// rounding. Several coarse edges run through one of them.
TEST(Subdivision, where_inserted_vertices_are_removed_ones)
{
  for(unsigned int set = 1; set < 64; ++set)
    for(unsigned int n = 3; n < 8; ++n) {
      Evolving_surface surface(sides_of_cube(set));
      const Surface_level fine(surface);
      IS::simplify(surface, number_of_vertices(n));
      IS::refine(surface, IS::parameters::minimum_angle(20.));
      const Surface_level coarse(surface);
      const Surface_map map(surface, fine, coarse);
      Subdivision subdivision(map);
      expect_areas(subdivision, Level::fine, fine);
      expect_areas(subdivision, Level::coarse, coarse);
      subdivision.triangulate();
      expect_no_negative_areas(subdivision, Level::fine);
    }
}

// ---- Real meshes ----

TEST(Subdivision, of_data_meshes)
{
  for_each_data_mesh(100000, [](const Mesh& mesh) {
    for(const unsigned int n : {mesh.number_of_vertices() / 5, 0u}) {
      const Simplified s(Evolving_surface(mesh), n);
      const Surface_map map(s.surface, s.fine, s.coarse);
      const Subdivision subdivision(map, Bends::of_all_edges);
      expect_parents(subdivision);
      expect_parts_of_coarse_edges(subdivision);
      expect_no_negative_areas(subdivision, Level::fine);
      expect_no_negative_areas(subdivision, Level::coarse);
    }
  });
}

} // namespace Test_subdivision
