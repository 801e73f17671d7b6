// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests check the coarse triangulation as a mesh in space, and meshes of common subdivisions.

#include "simplified_surfaces.h"

#include <CGAL/Intrinsic_simplification/coarse_mesh.h>
#include <CGAL/Intrinsic_simplification/common_subdivision_mesh.h>
#include <CGAL/Intrinsic_triangulations/common_subdivision_mesh.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <optional>

namespace Test_coarse_mesh {

using namespace Test_surfaces;
namespace PMP = CGAL::Polygon_mesh_processing;

struct Written
{
  Written(const Mesh& input, std::size_t n)
  {
    Evolving_surface surface(input);
    const Surface_level fine(surface);
    simplify(surface, number_of_vertices(n));
    left = surface.mesh().number_of_vertices();
    area = area_of(surface);
    quality = IS::coarse_mesh(surface, fine, mesh,
                              IS::parameters::input_point_map(input.points())
                                .parent_vertex_map(parent)
                                .location_map(location));
  }

  Mesh mesh;
  Mesh::Property_map<Vertex_index, IS::Surface_map::Location> location =
    mesh.add_property_map<Vertex_index, IS::Surface_map::Location>("v:location").first;
  Mesh::Property_map<Vertex_index, Vertex_index> parent =
    mesh.add_property_map<Vertex_index, Vertex_index>("v:parent").first;
  IS::Coarse_mesh_quality quality;
  std::size_t left;
  double area;
};

Point point_at(Face_index f, const std::array<double, 3>& weight, const Mesh& mesh)
{
  const Halfedge_index h = mesh.halfedge(f);
  return CGAL::barycenter(mesh.point(mesh.source(h)), weight[0], mesh.point(mesh.target(h)),
                          weight[1], mesh.point(mesh.target(mesh.next(h))), weight[2]);
}

TEST(Coarse_mesh, is_ordinary_with_vertices_of_the_input)
{
  for(const Mesh& input : {random_sphere(100, 1), embedded_torus(9, 6), tetrahedron(), cube(),
                           punctured(random_sphere(80, 2), {0, 40}), bipyramid(30, 2)})
    for(const std::size_t n : {1, 4, 10, 50}) {
      SCOPED_TRACE(std::to_string(input.number_of_vertices()) + " to " + std::to_string(n));
      const Written written(input, n);
      EXPECT_TRUE(has_distinct_simplices(written.mesh) &&
                  CGAL::is_valid_polygon_mesh(written.mesh));
      EXPECT_EQ(written.mesh.number_of_vertices(),
                written.left + written.quality.inserted_vertices);
      EXPECT_EQ(CGAL::is_closed(written.mesh), CGAL::is_closed(input));
      std::size_t inserted = 0;
      for(Vertex_index v : written.mesh.vertices()) {
        const auto& [face, weight] = written.location[v];
        EXPECT_NE(face.is_valid(), written.parent[v].is_valid());
        if(written.parent[v].is_valid()) {
          EXPECT_EQ(written.mesh.point(v), input.point(written.parent[v]));
          continue;
        }
        ++inserted;
        EXPECT_LT(CGAL::squared_distance(written.mesh.point(v), point_at(face, weight, input)),
                  1e-24);
      }
      EXPECT_EQ(inserted, written.quality.inserted_vertices);
    }
}

// Vertices are inserted, and neither the topology nor the area changes.
TEST(Coarse_mesh, simplicial_triangulations)
{
  const auto characteristic = [](const Delta_complex& mesh) {
    return int(mesh.number_of_vertices() + mesh.number_of_faces()) - int(mesh.number_of_edges());
  };
  for(unsigned seed : seeds(20))
    for(const Named_complex& c : traced(complexes())) {
      Evolving_surface surface(triangulation(c.mesh, random_lengths(c.mesh, seed)));
      const double area = area_of(surface);
      const std::size_t inserted = IS::internal::make_simplicial(surface);
      EXPECT_TRUE(has_distinct_simplices(surface.mesh()));
      EXPECT_EQ(surface.mesh().number_of_vertices(), c.mesh.number_of_vertices() + inserted);
      EXPECT_EQ(characteristic(surface.mesh()), characteristic(c.mesh));
      EXPECT_NEAR(area_of(surface), area, 1e-12 * area);
      EXPECT_LE(inserted, 5 * c.mesh.number_of_edges());
    }
}

// Returns a surface with a third of the vertices. Returns nothing if rounding leaves no angles at a
// vertex of the input.
std::optional<Evolving_surface> simplified_Delaunay(const Mesh& input)
{
  IT::Intrinsic_triangulation<> tri(input);
  IT::make_Delaunay(tri);
  try {
    Evolving_surface result(tri);
    simplify(result, number_of_vertices(input.number_of_vertices() / 3));
    return result;
  } catch(const IT::Numerical_error&) {
    return {};
  }
}

// Faces are so thin that rounding hides the positions of circumcenters.
TEST(Coarse_mesh, of_hard_meshes)
{
  std::size_t inserted = 0, simplified = 0, meshes = 0;
  for_each_hard_mesh([&](const Mesh& input) {
    ++meshes;
    if(std::optional<Evolving_surface> surface = simplified_Delaunay(input)) {
      ++simplified;
      inserted += IS::internal::make_simplicial(*surface);
      EXPECT_TRUE(has_distinct_simplices(surface->mesh()));
    }
  });
  EXPECT_GT(inserted, 100u);
  EXPECT_GE(simplified + 2, meshes);
}

// No vertices, or only flat ones, are removed.
TEST(Coarse_mesh, of_the_same_surface)
{
  const Mesh square = grid(6, 6, [](double x, double y) { return Point(x, y, 0); });
  for(const auto& [input, n] :
      {std::pair(cube(), std::size_t(8)), std::pair(square, std::size_t(5)),
       std::pair(square, std::size_t(4))}) {
    const Written written(input, n);
    EXPECT_EQ(written.quality.deviation(), 0);
    EXPECT_EQ(written.quality.flipped_faces, 0u);
    EXPECT_EQ(written.quality.self_intersections, 0u);
    EXPECT_NEAR(PMP::area(written.mesh), PMP::area(input), 1e-12);
    EXPECT_NEAR(PMP::area(written.mesh), written.area, 1e-12);
  }
}

double distance_by_samples(const Point& p, const Mesh& mesh)
{
  double result = 1e300;
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    const Point a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h)),
                c = mesh.point(mesh.target(mesh.next(h)));
    const int n = 60;
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j)
        result = (std::min)(
          result, CGAL::squared_distance(p, a + double(i) / n * (b - a) + double(j) / n * (c - a)));
  }
  return std::sqrt(result);
}

// Distances are compared with many points on all faces.
TEST(Coarse_mesh, deviation)
{
  const Mesh input = random_sphere(60, 4);
  const Written written(input, 12);
  double expected = 0;
  for(Vertex_index v : input.vertices())
    expected = (std::max)(expected, distance_by_samples(input.point(v), written.mesh));
  EXPECT_NEAR(written.quality.distance_to_coarse, expected, 0.03 * expected);
  EXPECT_LE(written.quality.distance_to_coarse, expected);
  EXPECT_GT(written.quality.distance_to_fine, 0);
}

// A sheet is folded flat: its unfolded part is seen from the other side.
TEST(Coarse_mesh, counts_flipped_and_degenerate_faces)
{
  Mesh mesh;
  for(const Point& p :
      {Point(0, 0, 0), Point(1, 0, 0), Point(0.3, 0.3, 1), Point(0, 1, 0), Point(0.5, 0.5, -1)})
    mesh.add_vertex(p);
  const auto add = [&](unsigned a, unsigned b, unsigned c) {
    mesh.add_face(Vertex_index(a), Vertex_index(b), Vertex_index(c));
  };
  add(0, 1, 2);
  add(1, 3, 2);
  add(3, 0, 2);
  const Surface_level fine{Evolving_surface(mesh)};
  Evolving_surface surface(mesh);
  const Surface_level same(surface);
  const IS::Surface_map map(surface, same, same);
  IS::internal::Space_mesh space =
    IS::internal::mesh_in_space(same.mesh(), [&](Vertex_index v) { return mesh.point(v); });
  IS::internal::Space_mesh bent = space;
  const auto measured = [&] { return IS::internal::measured(map, space, bent); };
  EXPECT_EQ(measured().flipped_faces, 0u);
  bent.point(Vertex_index(2)) = IS::internal::Space::Point_3(2, 2, 0); // beyond one side
  EXPECT_EQ(measured().degenerate_faces, 0u);
  EXPECT_GT(measured().self_intersections, 0u);
  bent.point(Vertex_index(2)) = IS::internal::Space::Point_3(0.5, 0, 0); // on another
  EXPECT_EQ(measured().degenerate_faces, 1u);
  bent = space;
  for(Vertex_index v : bent.vertices()) // seen in a mirror
    bent.point(v) =
      IS::internal::Space::Point_3(-bent.point(v).x(), bent.point(v).y(), bent.point(v).z());
  EXPECT_GE(measured().flipped_faces, 1u);
}

TEST(Common_subdivision_mesh, of_levels_and_correspondences)
{
  const Mesh input = punctured(random_sphere(80, 2), {0});
  Evolving_surface surface(input);
  const Surface_level fine(surface);
  simplify(surface, number_of_vertices(std::size_t(15)));
  const Surface_level coarse(surface);
  const auto np = IS::parameters::input_point_map(input.points());
  for(const bool of_levels : {true, false}) {
    Mesh mesh;
    const auto parents =
      mesh.add_property_map<Face_index, std::array<Face_index, 2>>("f:parents").first;
    if(of_levels)
      IS::common_subdivision(Surface_map(surface, fine, coarse), mesh, np.parent_face_map(parents));
    else {
      IT::Intrinsic_triangulation<> tri(input);
      IT::make_Delaunay(tri);
      IT::common_subdivision(IT::Correspondence<>(tri), mesh, np.parent_face_map(parents));
    }
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    std::vector<double> area(input.number_of_faces(), 0);
    std::set<Face_index> others;
    for(Face_index f : mesh.faces()) {
      area[parents[f][0]] += polygon_area(f, mesh);
      others.insert(parents[f][1]);
    }
    for(Face_index f : input.faces())
      EXPECT_NEAR(area[f] / PMP::face_area(f, input), 1, 1e-6);
    EXPECT_EQ(others.size(), of_levels ? coarse.mesh().number_of_faces() : input.number_of_faces());
  }
}

} // namespace Test_coarse_mesh
