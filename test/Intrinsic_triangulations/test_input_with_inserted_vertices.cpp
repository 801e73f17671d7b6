// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "equality.h"

#include <CGAL/Intrinsic_triangulations/input_with_inserted_vertices.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

namespace Test_input_with_inserted_vertices {

using namespace Test_surfaces;

typedef IT::Face_location<double> Location;

template <typename NamedParameters>
Triangulation refined(Triangulation t, const NamedParameters& np)
{
  IT::make_Delaunay(t);
  IT::refine(t, np);
  t.collect_garbage();
  return t;
}

// Refines with faces that are small compared with edges of length one.
Triangulation refined(const Triangulation& t)
{
  return refined(t, IT::parameters::maximum_circumradius(0.3));
}

double area(Face_index f, const Delta_complex& mesh, const Triangulation::Edge_length_map& length)
{
  const Halfedge_index h = mesh.halfedge(f);
  const long double a = length[mesh.edge(h)], b = length[mesh.edge(mesh.next(h))],
                    c = length[mesh.edge(mesh.prev(h))];
  const long double product = (a + b + c) * (a + b - c) * (a - b + c) * (b + c - a);
  return static_cast<double>(std::sqrt((std::max)(product, 0.0L)) / 4);
}

// Checks that the areas of the faces in each input face add up to its area.
void expect_areas(const Triangulation& t)
{
  std::vector<double> sum(t.input_mesh().num_faces(), 0);
  for(Face_index f : t.mesh().faces())
    sum[t.input_location(t.mesh().halfedge(f)).first] += area(f, t.mesh(), t.length_map());
  for(Face_index f : t.input_mesh().faces()) {
    const double expected = area(f, t.input_mesh(), t.input_length_map());
    EXPECT_NEAR(sum[f], expected,
                1e-7 * expected); // Heron's formula loses half of the digits in thin faces
  }
}

void check(const Triangulation& r)
{
  const Triangulation t = IT::input_with_inserted_vertices(r);
  ASSERT_TRUE(t.is_valid(true));
  EXPECT_EQ(t.number_of_inserted_vertices(), r.number_of_inserted_vertices());
  EXPECT_EQ(t.mesh().number_of_edges(), r.mesh().number_of_edges());
  EXPECT_EQ(t.mesh().number_of_faces(), r.mesh().number_of_faces());
  std::size_t shared = 0, on_edges = 0;
  for(Edge_index e : t.mesh().edges()) {
    EXPECT_LE(t.coordinates().normal_coordinate(e), 0);
    EXPECT_FALSE(t.is_constrained(e));
    shared += t.coordinates().is_shared(e);
  }
  for(Vertex_index v : t.mesh().vertices())
    if(t.is_inserted(v)) {
      EXPECT_EQ(IT::face_location(t.inserted_vertex(v), t.input_mesh()),
                IT::face_location(r.inserted_vertex(v), r.input_mesh()));
      on_edges += IT::on_edge(t.inserted_vertex(v)) != nullptr;
    }
  EXPECT_EQ(shared, t.input_mesh().number_of_edges() + on_edges);
  expect_areas(t);
  expect_equal(t, triangulation_of(text_of(t)));
}

// Checks that the triangulation equals the Delaunay triangulation of these vertices, which is
// unique on a surface without symmetries.
void expect_same_Delaunay_triangulation(const Triangulation& r)
{
  Triangulation t = IT::input_with_inserted_vertices(r);
  IT::make_Delaunay(t);
  const std::vector<double> expected = sorted_lengths(r), found = sorted_lengths(t);
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-9);
}

TEST(Input_with_inserted_vertices, of_all_surfaces)
{
  std::size_t inserted = 0;
  for(const Named_complex& c : traced(complexes())) {
    const Triangulation r = refined(triangulation(c.mesh, random_lengths(c.mesh, 1)));
    inserted += r.number_of_inserted_vertices();
    check(r);
    expect_same_Delaunay_triangulation(r);
  }
  EXPECT_GT(inserted, 300u);
}

TEST(Input_with_inserted_vertices, is_the_input_without_any)
{
  for(const Named_mesh& m : traced(meshes())) {
    const Triangulation input(m.mesh);
    Triangulation flipped(m.mesh);
    IT::make_Delaunay(flipped);
    expect_equal(IT::input_with_inserted_vertices(flipped), input);
  }
}

Point place(Vertex_index v, const Triangulation& t, const Mesh& mesh)
{
  if(!t.is_inserted(v))
    return mesh.point(v);
  const auto [f, b] = IT::face_location(t.inserted_vertex(v), t.input_mesh());
  const Halfedge_index h = t.input_mesh().halfedge(f);
  return CGAL::barycenter(mesh.point(mesh.source(h)), b[0], mesh.point(mesh.target(h)), b[1],
                          mesh.point(mesh.target(mesh.next(h))), b[2]);
}

TEST(Input_with_inserted_vertices, is_straight_in_space)
{
  for(const Named_mesh& m : traced(meshes())) {
    double size = 0;
    for(const Point& p : m.mesh.points())
      size = (std::max)(size, std::sqrt(CGAL::squared_distance(p, Point(0, 0, 0))));
    const Triangulation t = IT::input_with_inserted_vertices(
      refined(Triangulation(m.mesh), IT::parameters::maximum_circumradius(size / 8)));
    EXPECT_GT(t.number_of_inserted_vertices(), 0u);
    for(Edge_index e : t.mesh().edges()) {
      const Point p = place(t.mesh().vertex(e, 0), t, m.mesh),
                  q = place(t.mesh().vertex(e, 1), t, m.mesh);
      EXPECT_NEAR(t.length(e), std::sqrt(CGAL::squared_distance(p, q)), 1e-13 * size);
    }
  }
}

TEST(Input_with_inserted_vertices, refuses_vertices_that_rounding_has_moved)
{
  Triangulation t(tetrahedron());
  IT::Vertex_inserter<> inserter(t);
  inserter.insert({Face_index(0), {0.5, 0.25, 0.25}});
  Triangulation good = IT::input_with_inserted_vertices(t);
  EXPECT_TRUE(good.is_valid(true));
  // The vertex is on an edge, but not inserted as its vertex.
  t.split_face({Face_index(1), {0.5, 0.5, 0}}, {{0, 0, 0}, {0, 0, 0}},
               Location(Face_index(1), {0.5, 0.5, 0}));
  EXPECT_THROW(IT::input_with_inserted_vertices(t), IT::Numerical_error);
}

TEST(Input_with_inserted_vertices, of_data_meshes)
{
  for_each_data_mesh(100000, [](const Mesh& mesh) {
    const Triangulation r = refined(Triangulation(mesh), IT::parameters::minimum_angle(25));
    const Triangulation t = IT::input_with_inserted_vertices(r);
    EXPECT_TRUE(t.is_valid(true));
    EXPECT_EQ(t.mesh().number_of_vertices(), r.mesh().number_of_vertices());
  });
}

} // namespace Test_input_with_inserted_vertices
