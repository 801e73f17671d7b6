// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/element_across.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>

namespace Test_surface_points {

using namespace Test_surfaces;
using Triangulation = IT::Intrinsic_triangulation<>;
using Surface_point = IT::Surface_point<double>;
using Edge_location = IT::Edge_location<double>;
using Complex = std::complex<double>;

// Returns a vertex, points of an inner edge and of a border edge, and a point of a face.
std::vector<Surface_point> points_of(const Delta_complex& mesh)
{
  std::vector<Surface_point> result;
  for(Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h)) {
      result.push_back(Edge_location{h, {0.25, 0.75}});
      result.push_back(IT::Vertex_location{h});
      result.push_back(Edge_location{mesh.next(mesh.opposite(h)), {0.5, 0.5}});
      result.push_back(Location(mesh.face(mesh.opposite(h)), {0.25, 0.5, 0.25}));
      break;
    }
  return result;
}

Triangulation disk()
{
  return Triangulation(grid(4, 5, [](double x, double y) { return Point(x, y, x * x - y); }));
}

TEST(Surface_points, vertices_are_ends_of_paths)
{
  Mesh mesh = grid(4, 5, [](double x, double y) { return Point(x, y, x * x - y); });
  const Mesh::Vertex_index isolated = mesh.add_vertex(Point(9, 9, 9));
  const Triangulation t(mesh);
  const Vertex_index v(0);
  IT::Shortest_paths paths(t.input());
  paths.add_source(v);
  paths.run();
  for(const Vertex_index w : t.input_mesh().vertices()) {
    const auto path = IT::shortest_path(t.input(), v, w);
    EXPECT_EQ(path.places.empty(), w == isolated);
    EXPECT_DOUBLE_EQ(path.length, paths.distance(w));
    EXPECT_DOUBLE_EQ(IT::shortest_path(t.input(), w, v).length, paths.distance(w));
  }
}

// All functions return for a point of any kind what they return for its position in a face.
TEST(Surface_points, positions_in_faces)
{
  Triangulation t = disk();
  IT::make_Delaunay(t);
  const IT::Correspondence correspondence(t);
  const Location target(t.input_mesh().faces().begin()[0], {0.5, 0.25, 0.25});
  const auto points = points_of(t.input_mesh());
  ASSERT_EQ(points.size(), 4u);
  for(const Surface_point& p : points) {
    const Location q = IT::face_location(p, t.input_mesh());
    EXPECT_EQ(IT::face_location(q, t.input_mesh()), q);
    EXPECT_EQ(IT::point_across(correspondence, IT::Side::input, p),
              IT::point_across(correspondence, IT::Side::input, q));
    EXPECT_EQ(IT::point_across(t, IT::Side::input, p), IT::point_across(t, IT::Side::input, q));
    EXPECT_EQ(IT::element_across(correspondence, IT::Side::input, p),
              IT::element_across(correspondence, IT::Side::input, q));
    EXPECT_EQ(IT::shortest_path(t.input(), p, target).length,
              IT::shortest_path(t.input(), q, target).length);
    EXPECT_EQ(IT::shortest_path(t.input(), target, p).length,
              IT::shortest_path(t.input(), target, q).length);
    EXPECT_EQ(IT::logarithmic_map(t.input(), target, p).vector,
              IT::logarithmic_map(t.input(), target, q).vector);
    EXPECT_EQ(IT::geodesic_distances(t.input(), p).distance,
              IT::geodesic_distances(t.input(), q).distance);
  }
}

TEST(Surface_points, sources_of_paths)
{
  const Triangulation t = disk();
  IT::Shortest_paths paths(t.input());
  const auto points = points_of(t.mesh());
  for(std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(paths.add_source(points[i]), i);
  paths.run();
  for(std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(paths.distance(points[i]), 0);
    EXPECT_EQ(paths.path(points[i]).length, 0);
    EXPECT_EQ(paths.source(points[i]), i);
  }
}

// The logarithm of the end of a geodesic is its vector, in the frame of a vertex or of a face.
TEST(Surface_points, geodesics)
{
  const Triangulation t = disk();
  for(const Surface_point& p : points_of(t.mesh())) {
    const Location q = IT::face_location(p, t.mesh());
    const Complex vector =
      IT::logarithmic_map(t.input(), p, Location(q.first, {0.5, 0.25, 0.25})).vector;
    const auto walk = IT::trace_geodesic(t.input(), p, vector);
    EXPECT_NEAR(walk.length, std::abs(vector), 1e-14);
    const auto result = IT::logarithmic_map(t.input(), p, walk.end).vector;
    EXPECT_NEAR(std::abs(result - vector), 0, 1e-14);
    if(!IT::is_at_vertex(p)) {
      EXPECT_EQ(IT::trace_geodesic(t.input(), q, vector).end, walk.end);
    } else {
      const Vertex_index v = t.mesh().source(IT::halfedge_of(p));
      EXPECT_EQ(IT::trace_geodesic(t.input(), v, vector).end, walk.end);
      EXPECT_EQ(IT::logarithmic_map(t.input(), v, walk.end).vector, result);
      EXPECT_EQ(IT::logarithmic_map(t.input(), p).size(), t.mesh().number_of_vertices());
    }
    if(IT::on_edge(p)) {
      EXPECT_EQ(IT::trace_geodesic(t.input(), *IT::on_edge(p), vector).end, walk.end);
    }
  }
}

TEST(Surface_points, insertion)
{
  Triangulation t = disk();
  IT::Vertex_inserter inserter(t);
  const std::size_t n = t.mesh().number_of_vertices();
  const auto points = points_of(t.mesh());
  EXPECT_EQ(inserter.insert(points[1]), t.mesh().source(IT::halfedge_of(points[1])));
  EXPECT_EQ(inserter.insert(points[3]), Vertex_index(Vertex_index::size_type(n)));
  EXPECT_EQ(t.mesh().number_of_vertices(), n + 1);
}

} // namespace Test_surface_points
