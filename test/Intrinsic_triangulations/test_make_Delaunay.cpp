// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "equality.h"
#include "measuring.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/boost/graph/io.h>
#ifdef CGAL_USE_OPENMESH
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

namespace Test_make_Delaunay {

using namespace Test_surfaces;
using Triangulation = IT::Intrinsic_triangulation<>;

// Checks the surface, where `tolerance` is for angles and relative areas.
void expect_same_surface(const Triangulation& t, double tolerance)
{
  EXPECT_TRUE(t.is_valid(true));
  EXPECT_TRUE(IT::is_valid_Delta_complex(t.mesh(), true));
  EXPECT_EQ(t.mesh().number_of_edges(), t.input_mesh().number_of_edges());
  EXPECT_EQ(t.mesh().number_of_faces(), t.input_mesh().number_of_faces());
  EXPECT_NEAR(area_of(t.mesh(), t.length_map()) / area_of(t.input_mesh(), t.input_length_map()), 1,
              tolerance);
  const std::vector<double> before = angle_sums(t.input_mesh(), t.input_length_map()),
                            after = angle_sums(t.mesh(), t.length_map());
  EXPECT_NEAR(std::accumulate(after.begin(), after.end(), 0.), pi * t.mesh().number_of_faces(),
              tolerance);
  for(Vertex_index v : t.mesh().vertices())
    EXPECT_NEAR(after[v], before[v], tolerance) << v;
}

void expect_border_of_input(const Triangulation& t)
{
  for(Edge_index e : t.mesh().edges())
    if(t.mesh().is_border(e)) {
      EXPECT_EQ(t.coordinates().normal_coordinate(e), -1);
      EXPECT_EQ(t.length(e),
                t.input_length(t.input_mesh().edge(t.input_halfedge(t.mesh().halfedge(e)))));
    }
}

struct Counter : IT::Default_flip_visitor
{
  std::size_t flips = 0;
  std::size_t stop = (std::numeric_limits<std::size_t>::max)();

  void after_flip(Halfedge_index)
  {
    if(++flips == stop)
      throw std::runtime_error("enough");
  }
};

// Flips and checks everything; returns the number of flips.
std::size_t check_Delaunay(Triangulation& t, double tolerance = 1e-9)
{
  Counter counter;
  const std::size_t flips = IT::make_Delaunay(t, CGAL::parameters::visitor(std::ref(counter)));
  EXPECT_EQ(flips, counter.flips);
  expect_Delaunay(t);
  expect_same_surface(t, tolerance);
  expect_border_of_input(t);
  EXPECT_EQ(IT::make_Delaunay(t), 0u);
  return flips;
}

using Edge_set = std::multiset<std::pair<std::size_t, std::size_t>>;

Edge_set edge_set(const Delta_complex& mesh)
{
  Edge_set result;
  for(Edge_index e : mesh.edges())
    result.insert(std::minmax<std::size_t>(mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx()));
  return result;
}

Edge_set planar_Delaunay_edges(const std::vector<Vector>& points)
{
  using Plane = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Delaunay_triangulation_2<Plane> delaunay;
  std::map<std::pair<double, double>, std::size_t> index;
  for(const Vector& v : points) {
    const auto x = static_cast<double>(v.x), y = static_cast<double>(v.y);
    index.emplace(std::make_pair(x, y), index.size());
    delaunay.insert(Plane::Point_2(x, y));
  }
  const auto index_of = [&](const Plane::Point_2& p) { return index.at({p.x(), p.y()}); };
  Edge_set result;
  for(auto e = delaunay.finite_edges_begin(); e != delaunay.finite_edges_end(); ++e) {
    const auto segment = delaunay.segment(*e);
    result.insert(std::minmax({index_of(segment.source()), index_of(segment.target())}));
  }
  return result;
}

Point at(double x, double y) { return {x, y, 0}; }

// ---- Inputs ----

template <typename Graph>
double distance(const Graph& g, typename boost::graph_traits<Graph>::edge_descriptor e)
{
  const auto points = get(CGAL::vertex_point, g);
  const auto p = get(points, source(e, g)), q = get(points, target(e, g));
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// Checks that all numbers have the order of the ranges of the graph.
template <typename Graph>
void check_input(const Graph& g)
{
  const Triangulation t(g);
  EXPECT_TRUE(t.is_valid(true));
  std::map<typename boost::graph_traits<Graph>::vertex_descriptor, Delta_complex::size_type> number;
  for(auto v : vertices(g))
    number.emplace(v, static_cast<Delta_complex::size_type>(number.size()));
  EXPECT_EQ(t.input_mesh().number_of_vertices(), number.size());
  Delta_complex::size_type i = 0;
  for(auto e : edges(g)) {
    const Halfedge_index h(2 * i);
    EXPECT_EQ(t.input_mesh().source(h), Vertex_index(number.at(source(e, g))));
    EXPECT_EQ(t.input_mesh().target(h), Vertex_index(number.at(target(e, g))));
    EXPECT_NEAR(t.input_length(Edge_index(i)), distance(g, e), 1e-15);
    ++i;
  }
  EXPECT_EQ(t.input_mesh().number_of_edges(), i);
  Triangulation flipped(t);
  EXPECT_GT(check_Delaunay(flipped), 0u);
}

Mesh rough_sphere() { return perturbed(random_sphere(30, 3), 0.3, 3); }

template <typename Graph>
Graph copy_of(const Mesh& mesh)
{
  Graph result;
  CGAL::copy_face_graph(mesh, result);
  return result;
}

// Returns the message of the exception, or an empty text if the input is accepted.
template <typename Graph, typename... NamedParameters>
std::string refusal(const Graph& g, const NamedParameters&... np)
{
  try {
    Triangulation{g, np...};
  } catch(const IT::Invalid_input& error) {
    return error.what();
  }
  return {};
}

std::string refusal_of_lengths(const std::vector<double>& lengths)
{
  const Delta_complex mesh = glue({{1, 2, 3}, {-3, 4, 5}});
  return refusal(mesh,
                 IT::parameters::edge_length_map(boost::make_function_property_map<Edge_index>(
                   [&](Edge_index e) { return lengths[e.idx()]; })));
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(Make_Delaunay, meshes)
{
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t(m.mesh);
    check_Delaunay(t, 1e-7);
  }
}

TEST(Make_Delaunay, random_metrics_on_all_complexes)
{
  std::size_t flips = 0;
  for(const auto& [c, seed] : traced(complexes(), 20)) {
    Triangulation t = triangulation(c.mesh, random_lengths(c.mesh, seed));
    flips += check_Delaunay(t);
  }
  EXPECT_GT(flips, 300u);
}

TEST(Make_Delaunay, agrees_with_the_planar_triangulation)
{
  for(unsigned int seed : seeds(10)) {
    const std::vector<Vector> points = random_points(20 + 30 * seed, 1 << 19, seed);
    Triangulation t(planar_mesh(points));
    EXPECT_GT(IT::make_Delaunay(t), 0u);
    EXPECT_EQ(edge_set(t.mesh()), planar_Delaunay_edges(points));
    for(Edge_index e : t.mesh().edges()) {
      const double exact = length(points[t.mesh().vertex(e, 0)] - points[t.mesh().vertex(e, 1)]);
      EXPECT_NEAR(t.length(e) / exact, 1, 1e-6);
    }
    EXPECT_TRUE(t.is_valid(true));
  }
}

TEST(Make_Delaunay, sheared_cylinders_come_back_to_short_edges)
{
  for(int twists : traced({0, 1, 10, 1000})) {
    Triangulation t = triangulation(flat_cylinder(1, twists));
    check_Delaunay(t, 1e-5);
    for(Edge_index e : t.mesh().edges()) // 1000, |(300, 700)| and |(700, 700)|
      EXPECT_LT(t.length(e), 1001);
  }
}

TEST(Make_Delaunay, constrained_edges_stay)
{
  const Mesh mesh = rough_sphere();
  Triangulation free(mesh);
  ASSERT_GT(IT::make_Delaunay(free), 0u);
  const auto all = boost::make_function_property_map<Edge_index>([](Edge_index) { return true; });
  Triangulation fixed(mesh, CGAL::parameters::edge_is_constrained_map(all));
  EXPECT_EQ(IT::make_Delaunay(fixed), 0u);
  EXPECT_TRUE(IT::is_Delaunay(fixed));
  const auto is_third = [](Edge_index e) { return e.idx() % 3 == 0; };
  const auto third = boost::make_function_property_map<Edge_index>(is_third);
  Triangulation some(mesh, CGAL::parameters::edge_is_constrained_map(third));
  EXPECT_GT(check_Delaunay(some), 0u);
  for(Edge_index e : some.mesh().edges()) {
    EXPECT_EQ(some.is_constrained(e), is_third(e));
    if(is_third(e)) {
      EXPECT_EQ(some.input_halfedge(some.mesh().halfedge(e)), some.mesh().halfedge(e));
      EXPECT_FALSE(some.is_flippable(some.mesh().halfedge(e)));
    }
  }
}

TEST(Make_Delaunay, limit_of_flips)
{
  const Triangulation input = triangulation(flat_cylinder(3, 20));
  Triangulation t(input);
  const std::size_t needed = IT::make_Delaunay(t);
  for(std::size_t limit = 0; limit < needed; limit += 7) {
    Triangulation limited(input);
    EXPECT_THROW(IT::make_Delaunay(limited, CGAL::parameters::number_of_iterations(limit)),
                 IT::Flip_limit_exceeded);
    EXPECT_TRUE(limited.is_valid(true));
    EXPECT_GT(IT::make_Delaunay(limited), 0u);
    EXPECT_TRUE(limited.is_valid(true));
  }
  Triangulation enough(input);
  EXPECT_EQ(IT::make_Delaunay(enough, CGAL::parameters::number_of_iterations(needed)), needed);
}

TEST(Make_Delaunay, visitor_that_throws)
{
  Triangulation t = triangulation(flat_cylinder(3, 20));
  Counter counter;
  counter.stop = 5;
  EXPECT_THROW(IT::make_Delaunay(t, CGAL::parameters::visitor(std::ref(counter))),
               std::runtime_error);
  EXPECT_EQ(counter.flips, 5u);
  EXPECT_TRUE(t.is_valid(true));
  EXPECT_FALSE(IT::is_Delaunay(t));
  check_Delaunay(t);
}

TEST(Make_Delaunay, caps_of_no_area)
{
  const std::vector<Point> points{at(0, 0), at(2, 0), at(1, 0), at(1, 1), at(1, -1)};
  Triangulation t(make_mesh(points, {{0, 2, 1}, {0, 1, 3}, {0, 4, 2}, {2, 4, 1}}));
  EXPECT_EQ(IT::make_Delaunay(t), 1u);
  expect_Delaunay(t);
  EXPECT_TRUE(t.is_valid(true));
  for(Face_index f : t.mesh().faces())
    EXPECT_NEAR(area_of(f, t.mesh(), t.length_map()), 0.5, 1e-12);
}

// Both faces at the long edge between the points 0 and 3 have no area.
TEST(Make_Delaunay, caps_of_no_area_on_either_side)
{
  const std::vector<Point> points{at(0, 0), at(1, 0), at(2, 0), at(3, 0), at(1.5, 2), at(1.5, -2)};
  Triangulation t(
    make_mesh(points, {{0, 1, 3}, {0, 3, 2}, {0, 2, 4}, {2, 3, 4}, {1, 0, 5}, {3, 1, 5}}));
  EXPECT_GT(IT::make_Delaunay(t), 0u);
  expect_Delaunay(t);
  EXPECT_TRUE(t.is_valid(true));
  EXPECT_NEAR(area_of(t.mesh(), t.length_map()), 6, 1e-9);
  for(Face_index f : t.mesh().faces())
    EXPECT_GT(area_of(f, t.mesh(), t.length_map()), 0.5);
}

TEST(Make_Delaunay, ties_are_kept)
{
  for(double step : traced({1., 0.1, 1e-5, 3e7}))
    for(double angle : traced({0., 0.3, 1.})) {
      const double c = std::cos(angle), s = std::sin(angle);
      Triangulation t(grid(20, 20, [&](double x, double y) {
        return Point(step * (c * x - s * y), step * (s * x + c * y), 0);
      }));
      EXPECT_EQ(IT::make_Delaunay(t), 0u);
      EXPECT_TRUE(IT::is_Delaunay(t));
    }
}

TEST(Make_Delaunay, ties_that_are_sheared)
{
  const auto check = [](const Mesh& mesh) {
    Triangulation t(mesh);
    EXPECT_LT(check_Delaunay(t, 1e-5), 10000u);
  };
  for(double shear : {1., 2., 7., 0.1})
    check(grid(12, 12, [&](double x, double y) { return Point(x + shear * y, y, 0); }));
  check(bipyramid(200, 0));
  check(bipyramid(200, 1));
}

TEST(Make_Delaunay, is_deterministic)
{
  const Mesh mesh = perturbed(embedded_torus(12, 9), 0.5, 8);
  Triangulation a(mesh), b(mesh);
  EXPECT_EQ(IT::make_Delaunay(a), IT::make_Delaunay(b));
  expect_equal(a, b);
}

TEST(Make_Delaunay, data_meshes)
{
  for_each_data_mesh(200000, [](const Mesh& mesh) {
    Triangulation t(mesh);
    IT::make_Delaunay(t);
    expect_Delaunay(t);
    expect_border_of_input(t);
    EXPECT_TRUE(t.is_valid(true));
    flip_to_input(t);
    EXPECT_TRUE(t.is_valid(true));
  });
}

// ---- Inputs ----

TEST(Intrinsic_triangulation, from_Surface_mesh)
{
  Mesh mesh = rough_sphere();
  check_input(mesh);
  mesh.add_vertex(Point(9, 9, 9)); // isolated
  check_input(mesh);
}

TEST(Intrinsic_triangulation, from_Surface_mesh_with_garbage)
{
  Mesh mesh = rough_sphere();
  const Vertex_index v = *mesh.vertices_begin();
  CGAL::Euler::remove_center_vertex(mesh.halfedge(v), mesh);
  CGAL::Euler::remove_face(mesh.halfedge(*std::next(mesh.faces_begin(), 3)), mesh);
  for(Face_index f : mesh.faces())
    if(mesh.degree(f) > 3)
      CGAL::Euler::add_center_vertex(mesh.halfedge(f), mesh);
  for(Vertex_index w : mesh.vertices())
    if(mesh.point(w) == Point(0, 0, 0))
      mesh.point(w) = Point(0.1, 0.2, 0.3);
  ASSERT_TRUE(mesh.has_garbage());
  check_input(mesh);
}

TEST(Intrinsic_triangulation, from_Polyhedron)
{
  check_input(copy_of<CGAL::Polyhedron_3<Kernel>>(rough_sphere()));
}

TEST(Intrinsic_triangulation, from_Linear_cell_complex)
{
  using Traits = CGAL::Linear_cell_complex_traits<3, Kernel>;
  using Complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Traits>::type;
  check_input(copy_of<Complex>(rough_sphere()));
}

#ifdef CGAL_USE_OPENMESH
TEST(Intrinsic_triangulation, from_OpenMesh)
{
  struct Traits : OpenMesh::DefaultTraits
  {
    using Point = OpenMesh::Vec3d;
  };
  check_input(copy_of<OpenMesh::TriMesh_ArrayKernelT<Traits>>(rough_sphere()));
}
#endif

TEST(Intrinsic_triangulation, from_lengths_alone)
{
  for(const Named_complex& c : traced(complexes())) {
    const std::vector<double> lengths = random_lengths(c.mesh, 1);
    const Triangulation t = triangulation(c.mesh, lengths);
    EXPECT_TRUE(t.is_valid(true));
    for(Halfedge_index h : c.mesh.halfedges()) {
      EXPECT_EQ(t.input_mesh().next(h), c.mesh.next(h));
      EXPECT_EQ(t.input_mesh().target(h), c.mesh.target(h));
      EXPECT_EQ(t.input_halfedge(h), h);
      EXPECT_EQ(t.length(t.mesh().edge(h)), lengths[c.mesh.edge(h)]);
    }
  }
}

TEST(Intrinsic_triangulation, positions_from_another_map)
{
  const Mesh mesh = octahedron();
  const auto twice = boost::make_function_property_map<Vertex_index>([&](Vertex_index v) {
    return Point(2 * mesh.point(v).x(), 2 * mesh.point(v).y(), 2 * mesh.point(v).z());
  });
  const Triangulation once(mesh), doubled(mesh, CGAL::parameters::vertex_point_map(twice));
  for(Edge_index e : once.mesh().edges())
    EXPECT_EQ(doubled.length(e), 2 * once.length(e));
}

TEST(Intrinsic_triangulation, copies_are_independent)
{
  const Triangulation original(rough_sphere());
  Triangulation copy(original), assigned;
  assigned = original;
  ASSERT_GT(IT::make_Delaunay(copy), 0u);
  EXPECT_TRUE(original.is_valid(true) && copy.is_valid(true) && assigned.is_valid(true));
  for(Edge_index e : original.mesh().edges()) {
    EXPECT_EQ(original.coordinates().normal_coordinate(e), -1);
    EXPECT_EQ(assigned.coordinates().normal_coordinate(e), -1);
  }
  const Triangulation moved(std::move(copy));
  EXPECT_TRUE(moved.is_valid(true) && IT::is_Delaunay(moved));
}

TEST(Intrinsic_triangulation, empty_input)
{
  Triangulation none, empty{Mesh()};
  EXPECT_EQ(IT::make_Delaunay(none) + IT::make_Delaunay(empty), 0u);
  EXPECT_TRUE(none.is_valid(true) && empty.is_valid(true));
}

// ---- Refusals ----

TEST(Intrinsic_triangulation, refuses_polygons)
{
  Mesh mesh = tetrahedron();
  std::vector<Vertex_index> square;
  for(const Point& p : {at(0, 0), at(1, 0), at(1, 1), at(0, 1)})
    square.push_back(mesh.add_vertex(p));
  mesh.add_face(square);
  EXPECT_EQ(refusal(mesh), "face 4 is not a triangle");
}

TEST(Intrinsic_triangulation, refuses_pinched_vertices)
{
  const std::vector<Point> points{at(0, 0), at(1, 0), at(1, 1), at(-1, 0), at(-1, -1)};
  const Mesh mesh = make_mesh(points, {{0, 1, 2}, {0, 3, 4}});
  ASSERT_EQ(mesh.number_of_faces(), 2u);
  EXPECT_EQ(refusal(mesh), "vertex 0 has more than one vertex fan");
}

TEST(Intrinsic_triangulation, refuses_pinched_vertices_without_boundary)
{
  Delta_complex mesh = glue({{1, 2, 3}, {-3, -2, -1}, {4, 5, 6}, {-6, -5, -4}});
  const Vertex_index v = mesh.target(halfedge_of(1)), w = mesh.target(halfedge_of(4));
  for(Halfedge_index h : mesh.halfedges())
    if(mesh.target(h) == w)
      mesh.set_target(h, v);
  mesh.remove_vertex(w);
  const auto one = boost::make_function_property_map<Edge_index>([](Edge_index) { return 1.; });
  const std::string message = refusal(mesh, IT::parameters::edge_length_map(one));
  EXPECT_TRUE(contains(message, "vertex " + std::to_string(v.idx()))) << message;
  EXPECT_TRUE(contains(message, "more than one vertex fan")) << message;
}

TEST(Intrinsic_triangulation, refuses_edges_without_faces)
{
  Mesh mesh = tetrahedron();
  const Halfedge_index h = mesh.add_edge();
  mesh.set_target(h, mesh.add_vertex(at(5, 5)));
  mesh.set_target(mesh.opposite(h), mesh.add_vertex(at(6, 5)));
  for(Halfedge_index x : {h, mesh.opposite(h)}) {
    mesh.set_halfedge(mesh.target(x), x);
    mesh.set_next(x, mesh.opposite(x));
  }
  EXPECT_EQ(refusal(mesh), "edge 6 has no face");
}

TEST(Intrinsic_triangulation, refuses_edges_of_no_length)
{
  Mesh mesh = tetrahedron();
  mesh.point(Vertex_index(2)) = mesh.point(Vertex_index(3));
  const std::string message = refusal(mesh);
  EXPECT_TRUE(contains(message, "edge ") && contains(message, " between vertices ")) << message;
  EXPECT_TRUE(contains(message, "2") && contains(message, "3")) << message;
}

TEST(Intrinsic_triangulation, refuses_positions_that_are_no_numbers)
{
  for(double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200}) {
    Mesh mesh = tetrahedron();
    mesh.point(Vertex_index(1)) = Point(0, bad, 0);
    EXPECT_TRUE(contains(refusal(mesh), "is zero, not finite")) << bad;
  }
}

TEST(Intrinsic_triangulation, refuses_impossible_lengths)
{
  EXPECT_EQ(refusal_of_lengths({3, 4, 5, 4, 3}), "");
  EXPECT_EQ(refusal_of_lengths({3, 4, 7, 4, 4}), "");
  EXPECT_EQ(refusal_of_lengths({0.1, 0.2, 0.1 + 0.2, 0.2, 0.2}), "");
  EXPECT_EQ(refusal_of_lengths({3, 4, 5, 4, 10}), "the triangle inequality fails in face 1");
  EXPECT_EQ(refusal_of_lengths({3, 4, 7.000001, 4, 4}), "the triangle inequality fails in face 0");
  EXPECT_TRUE(
    contains(refusal_of_lengths({3, 4, 5, 4, -3}), "the length of edge 4 between vertices"));
  EXPECT_TRUE(
    contains(refusal_of_lengths({3, 0, 5, 4, 3}), "the length of edge 1 between vertices"));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(contains(refusal_of_lengths({3, 4, 5, infinity, 3}), "the length of edge 3"));
  EXPECT_TRUE(contains(refusal_of_lengths({3, 4, std::nan(""), 4, 3}), "the length of edge 2"));
}

} // namespace Test_make_Delaunay
