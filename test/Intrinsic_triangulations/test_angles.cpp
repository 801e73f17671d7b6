// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/angles.h>
#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>

namespace Test_angles {

using namespace Test_surfaces;
namespace IT = CGAL::Intrinsic_triangulations;

std::vector<double> curvatures(Mesh mesh)
{
  auto length = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
  IT::compute_edge_lengths(mesh, length);
  std::vector<double> result(mesh.number_of_vertices(), -1);
  IT::compute_curvatures(
    mesh, length,
    boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, mesh)));
  return result;
}

double sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.);
}

TEST(Angles, of_positions)
{
  Mesh mesh = random_sphere(50, 3);
  auto length = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
  auto angle = mesh.add_property_map<Mesh::Halfedge_index, double>("h:angle", -1).first;
  IT::compute_edge_lengths(mesh, length);
  IT::compute_angles(mesh, length, angle);
  for(const Mesh::Halfedge_index h : mesh.halfedges()) {
    const auto u = mesh.point(mesh.source(h)) - mesh.point(mesh.target(h)),
               v = mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.target(h));
    EXPECT_NEAR(angle[h], std::acos(u * v / std::sqrt(u * u * (v * v))), 1e-7);
    EXPECT_NEAR(angle[h] + angle[mesh.next(h)] + angle[mesh.prev(h)], pi, 1e-12);
  }
}

// The greatest cosine at a corner belongs to the smallest angle.
TEST(Angles, smallest_of_positions)
{
  for(const unsigned seed : {1u, 2u, 3u}) {
    Mesh mesh = random_sphere(50, seed);
    auto length = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
    IT::compute_edge_lengths(mesh, length);
    double cosine = -1;
    for(const Mesh::Halfedge_index h : mesh.halfedges()) {
      const auto u = mesh.point(mesh.source(h)) - mesh.point(mesh.target(h)),
                 v = mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.target(h));
      cosine = (std::max)(cosine, u * v / std::sqrt(u * u * (v * v)));
    }
    EXPECT_NEAR(IT::smallest_angle_in_degrees(mesh, length), 180 / pi * std::acos(cosine), 1e-6);
    EXPECT_EQ(IT::smallest_angle_in_degrees(mesh, length),
              IT::diagnose(mesh, IT::parameters::edge_length_map(length)).statistics().min_angle);
  }
}

TEST(Angles, smallest_without_faces_and_with_flat_ones)
{
  Mesh mesh;
  auto length = mesh.add_property_map<Mesh::Edge_index, double>("e:length", 1).first;
  EXPECT_EQ(IT::smallest_angle_in_degrees(mesh, length), std::numeric_limits<double>::infinity());
  mesh.add_face(mesh.add_vertex(), mesh.add_vertex(), mesh.add_vertex());
  EXPECT_NEAR(IT::smallest_angle_in_degrees(mesh, length), 60, 1e-12);
  length[Mesh::Edge_index(0)] = 2;
  EXPECT_EQ(IT::smallest_angle_in_degrees(mesh, length), 0);
  length[Mesh::Edge_index(0)] = 0;
  EXPECT_EQ(IT::smallest_angle_in_degrees(mesh, length), std::numeric_limits<double>::infinity());
}

TEST(Angles, border_halfedges_have_none)
{
  Mesh mesh = grid(1, 1, [](double x, double y) { return Point(x, y, 0); });
  auto length = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
  auto angle = mesh.add_property_map<Mesh::Halfedge_index, double>("h:angle", -1).first;
  IT::compute_edge_lengths(mesh, length);
  IT::compute_angles(mesh, length, angle);
  for(const Mesh::Halfedge_index h : mesh.halfedges())
    EXPECT_EQ(angle[h] == -1, mesh.is_border(h));
}

TEST(Curvatures, of_known_surfaces)
{
  for(const double k : curvatures(tetrahedron()))
    EXPECT_NEAR(k, pi, 1e-12);
  for(const double k : curvatures(cube()))
    EXPECT_NEAR(k, pi / 2, 1e-12);
  const std::vector<double> flat =
    curvatures(grid(3, 3, [](double x, double y) { return Point(x, y, 0); }));
  for(std::size_t i = 0; i < 16; ++i) {
    const bool is_corner = i % 4 % 3 == 0 && i / 4 % 3 == 0;
    EXPECT_NEAR(flat[i], is_corner ? pi / 2 : 0, 1e-12) << i;
  }
}

TEST(Curvatures, vertices_without_faces_have_none)
{
  Mesh mesh = cube();
  mesh.add_vertex(Point(7, 7, 7));
  EXPECT_EQ(curvatures(mesh).back(), 0);
}

TEST(Curvatures, theorem_of_Gauss_and_Bonnet)
{
  EXPECT_NEAR(sum(curvatures(random_sphere(200, 5))), 4 * pi, 1e-10);
  EXPECT_NEAR(sum(curvatures(embedded_torus(20, 12))), 0, 1e-10);
  EXPECT_NEAR(sum(curvatures(grid(7, 5, [](double x, double y) { return Point(x, y, x * y); }))),
              2 * pi, 1e-10);
}

} // namespace Test_angles
