// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests check meshes of the common subdivision, with positions, texture coordinates and
// parents.

#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/common_subdivision_mesh.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>

namespace Test_common_subdivision_mesh {

using namespace Test_surfaces;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Kernel_traits<Point>::Kernel Kernel;
typedef std::array<Face_index, 3> Parents;

// Stores a mesh with all data that are written.
template <std::size_t size>
struct Written
{
  typedef std::array<double, size> Image;
  typedef std::array<double, size + 1> Homogeneous;

  template <typename Map>
  Written(const Map& map, const Mesh& input)
  {
    DCM::common_subdivision(map, mesh,
                            DCM::parameters::input_point_map(input.points())
                              .texture_coordinates_map(image)
                              .homogeneous_texture_coordinates_map(homogeneous)
                              .parent_vertex_map(vertex)
                              .parent_edge_map(edge)
                              .parent_face_map(face));
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Halfedge_index, Image> image =
    mesh.add_property_map<Mesh::Halfedge_index, Image>("h:image").first;
  Mesh::Property_map<Mesh::Halfedge_index, Homogeneous> homogeneous =
    mesh.add_property_map<Mesh::Halfedge_index, Homogeneous>("h:homogeneous").first;
  Mesh::Property_map<Mesh::Vertex_index, Vertex_index> vertex =
    mesh.add_property_map<Mesh::Vertex_index, Vertex_index>("v:parent").first;
  Mesh::Property_map<Mesh::Edge_index, Edge_index> edge =
    mesh.add_property_map<Mesh::Edge_index, Edge_index>("e:parent").first;
  Mesh::Property_map<Mesh::Face_index, Parents> face =
    mesh.add_property_map<Mesh::Face_index, Parents>("f:parent").first;
};

// Returns the barycentric coordinates of a point in the plane of a face.
std::array<double, 3> coordinates_in(Face_index f, const Mesh& mesh, const Point& p)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  const Point corner[] = {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                          mesh.point(mesh.target(mesh.next(h)))};
  const auto normal = CGAL::cross_product(corner[1] - corner[0], corner[2] - corner[0]);
  std::array<double, 3> result;
  for(std::size_t c = 0; c < 3; ++c)
    result[c] = CGAL::cross_product(corner[(c + 1) % 3] - p, corner[(c + 2) % 3] - p) * normal /
                (normal * normal);
  return result;
}

// Checks that faces are parts of their parents and cover each of these once, and that edges lie on
// their parents.
template <std::size_t size>
void expect_cut(const Written<size>& written, const Mesh& input)
{
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(written.mesh));
  std::vector<double> area(input.number_of_faces(), 0);
  for(Face_index f : written.mesh.faces()) {
    area[written.face[f][0]] += polygon_area(f, written.mesh);
    for(Vertex_index v : vertices_around_face(written.mesh.halfedge(f), written.mesh))
      for(const double x : coordinates_in(written.face[f][0], input, written.mesh.point(v)))
        EXPECT_GT(x, -1e-9);
  }
  for(Face_index f : input.faces())
    EXPECT_NEAR(area[f] / PMP::face_area(f, input), 1, 1e-9);
  std::vector<double> length(input.number_of_edges(), 0);
  for(Edge_index e : written.mesh.edges())
    if(written.edge[e].is_valid())
      length[written.edge[e]] += PMP::edge_length(e, written.mesh);
  for(Edge_index e : input.edges())
    EXPECT_NEAR(length[e] / PMP::edge_length(e, input), 1, 1e-9);
  for(Vertex_index v : written.mesh.vertices())
    EXPECT_EQ(written.vertex[v], v.idx() < input.number_of_vertices() ? v : Vertex_index());
  for(Vertex_index v : input.vertices())
    EXPECT_EQ(written.mesh.point(v), input.point(v));
}

double gap(const std::complex<double>& z, const std::array<double, 2>& p)
{
  return std::hypot(z.real() - p[0], z.imag() - p[1]);
}

double gap(const std::array<double, 2>& p, const std::array<double, 2>& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}

double gap(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// Checks that the map, evaluated along the crossings, agrees with the interpolation of corners.
// `project` maps homogeneous coordinates to points.
template <std::size_t size, typename Map, typename Project>
void expect_images(const Written<size>& written, const Mesh& input, const Map& map,
                   const Project& project)
{
  for(Face_index f : written.mesh.faces()) {
    std::array<double, size + 1> mean{};
    Kernel::Vector_3 middle = CGAL::NULL_VECTOR;
    const double n = written.mesh.degree(f);
    for(Halfedge_index h : halfedges_around_face(written.mesh.halfedge(f), written.mesh)) {
      EXPECT_LT(gap(project(written.homogeneous[h]), written.image[h]), 1e-6);
      for(std::size_t c = 0; c <= size; ++c)
        mean[c] += written.homogeneous[h][c] / n;
      middle += (written.mesh.point(written.mesh.target(h)) - CGAL::ORIGIN) / n;
    }
    const Face_index parent = written.face[f][0];
    const auto image = map({parent, coordinates_in(parent, input, CGAL::ORIGIN + middle)});
    const auto expected = project(mean);
    EXPECT_LT(gap(image, expected), 1e-6);
  }
}

TEST(Common_subdivision_mesh, of_flat_maps)
{
  const auto project = [](const std::array<double, 3>& z) {
    return std::array<double, 2>{z[0] / z[2], z[1] / z[2]};
  };
  const Mesh closed = random_sphere(60, 3);
  for(const Mesh& mesh : {closed, punctured(closed, {0, 30}), embedded_torus(7, 5)}) {
    const Planar_conformal_map map = DCM::flatten(mesh);
    ASSERT_EQ(map.status(), DCM::Map_status::success);
    const Written<2> written(map, mesh);
    expect_cut(written, mesh);
    expect_images(written, mesh, map, project);
  }
}

TEST(Common_subdivision_mesh, of_hyperbolic_maps)
{
  const Mesh mesh = plate_with_holes(2);
  const DCM::Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(mesh);
  const Written<2> written(map, mesh);
  expect_cut(written, mesh);
  expect_images(written, mesh, map, [&](const std::array<double, 3>& z) {
    const std::complex<double> p = map.to_disk(z);
    return std::array<double, 2>{p.real(), p.imag()};
  });
}

TEST(Common_subdivision_mesh, of_spherical_maps)
{
  const Mesh closed = random_sphere(60, 3);
  for(const Mesh& mesh : {closed, punctured(closed, {7})}) {
    const DCM::Spherical_conformal_map map = DCM::map_to_sphere(mesh);
    const Written<3> written(map, mesh);
    expect_cut(written, mesh);
    expect_images(written, mesh, map, map.project);
    Mesh on_sphere;
    DCM::common_subdivision(map, on_sphere);
    EXPECT_EQ(on_sphere.number_of_faces(), written.mesh.number_of_faces());
    for(Vertex_index v : mesh.vertices())
      EXPECT_LT(gap(map.position(v),
                    {on_sphere.point(v).x(), on_sphere.point(v).y(), on_sphere.point(v).z()}),
                1e-15);
  }
}

// Elements are added to another type of mesh, with isolated vertices.
TEST(Common_subdivision_mesh, of_other_types)
{
  Mesh mesh = punctured(random_sphere(40, 5), {3});
  mesh.add_vertex(Point(9, 9, 9));
  const Planar_conformal_map map = DCM::flatten(mesh);
  Mesh expected;
  const auto np = DCM::parameters::input_point_map(mesh.points());
  DCM::common_subdivision(map, expected, np);
  EXPECT_TRUE(expected.is_isolated(Vertex_index(40)));
  EXPECT_EQ(expected.point(Vertex_index(40)), Point(9, 9, 9));
  CGAL::Polyhedron_3<Kernel> polyhedron;
  for(std::size_t n = 1; n < 3; ++n) {
    DCM::common_subdivision(map, polyhedron, np);
    EXPECT_EQ(polyhedron.size_of_vertices(), n * expected.number_of_vertices());
    EXPECT_EQ(polyhedron.size_of_facets(), n * expected.number_of_faces());
    EXPECT_EQ(polyhedron.size_of_halfedges(), n * expected.number_of_halfedges());
  }
}

} // namespace Test_common_subdivision_mesh
