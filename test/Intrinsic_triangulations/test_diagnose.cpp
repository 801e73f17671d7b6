// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "testing.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/generators.h>

namespace Test_diagnose {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Defect_kind;
using IT::Input_diagnosis;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Points = std::vector<Point>;
using Rational = CGAL::Exact_rational;
using Polygons = std::vector<std::vector<std::size_t>>;
using Mesh = CGAL::Surface_mesh<Point>;

constexpr std::size_t none = Input_diagnosis::none;

// Returns points in general position, enough for the connectivities below.
Points points(std::size_t n)
{
  Points result;
  for(std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i);
    result.emplace_back(std::cos(t), std::sin(t), 0.1 * t);
  }
  return result;
}

const Polygons tetrahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};

Input_diagnosis diagnose(const Points& p, const Polygons& f)
{
  return IT::diagnose_polygon_soup(p, f);
}

void expect_only(const Input_diagnosis& d, Defect_kind kind, std::size_t count)
{
  for(const IT::Defect_description& description : IT::defect_descriptions)
    EXPECT_EQ(d.count(description.kind), description.kind == kind ? count : 0) << description.name;
  EXPECT_EQ(d.is_valid(), !IT::defect_description(kind).is_fatal);
}

void link(Mesh& mesh, Mesh::Vertex_index v, const std::array<Mesh::Halfedge_index, 3>& h)
{
  const Mesh::Face_index f = mesh.add_face();
  mesh.set_halfedge(f, h[0]);
  for(std::size_t i = 0; i < 3; ++i) {
    mesh.set_next(h[i], h[(i + 1) % 3]);
    mesh.set_face(h[i], f);
    mesh.set_target(h[i], v);
  }
  mesh.set_halfedge(v, h[0]);
}

// Returns the flat torus with a single vertex: three loops, two triangles.
Mesh one_vertex_torus()
{
  Mesh mesh;
  const Mesh::Vertex_index v = mesh.add_vertex(Point(0, 0, 0));
  const Mesh::Halfedge_index a = mesh.add_edge(), b = mesh.add_edge(), c = mesh.add_edge();
  link(mesh, v, {a, b, c});
  link(mesh, v, {mesh.opposite(a), mesh.opposite(b), mesh.opposite(c)});
  return mesh;
}

Input_diagnosis diagnose(Mesh mesh, const std::vector<double>& lengths)
{
  auto map = mesh.add_property_map<Mesh::Edge_index, double>("e:given_length").first;
  for(const Mesh::Edge_index e : mesh.edges())
    map[e] = lengths.at(e);
  return IT::diagnose(mesh, IT::parameters::edge_length_map(map));
}

void expect_clean(const Input_diagnosis& d)
{
  std::ostringstream out;
  out << d;
  EXPECT_EQ(out.str(), "");
  EXPECT_TRUE(d.is_valid());
}

TEST(Diagnose, table_is_complete_and_in_order)
{
  std::set<std::string> names;
  for(std::size_t i = 0; i < IT::defect_descriptions.size(); ++i) {
    const Defect_kind kind = static_cast<Defect_kind>(i);
    const IT::Defect_description& d = IT::defect_description(kind);
    EXPECT_EQ(d.kind, kind);
    EXPECT_NE(std::string(d.sentence), "");
    EXPECT_TRUE(names.insert(d.name).second) << d.name;
  }
  EXPECT_EQ(static_cast<std::size_t>(Defect_kind::VERTEX_WITHIN_ROUNDING) + 1,
            IT::defect_descriptions.size());
}

TEST(Diagnose, every_kind_has_a_message_of_its_own)
{
  for(const IT::Defect_description& d : IT::defect_descriptions) {
    Input_diagnosis diagnosis;
    diagnosis.add(d.kind, {{1, 2}, 3});
    EXPECT_EQ(diagnosis.message(d.kind).find(std::string(d.name) + ": 1, first "), 0u);
    EXPECT_EQ(diagnosis.is_valid(), !d.is_fatal);
    EXPECT_EQ(diagnosis.message().empty(), !d.is_fatal);
    std::ostringstream out;
    out << diagnosis;
    EXPECT_NE(out.str().find(d.sentence), std::string::npos);
  }
}

TEST(Diagnose, message_counts_and_says_where)
{
  Input_diagnosis d;
  for(std::size_t i = 0; i < 100; ++i)
    d.add(Defect_kind::ZERO_LENGTH_EDGE, {{12 + i, 15}, 7});
  d.add(Defect_kind::NON_MANIFOLD_VERTEX, {{4, none}, none});
  EXPECT_EQ(d.message(), "non-manifold vertex: 1, first at vertex 4; "
                         "zero-length edge: 100, first between vertices 12 and 15 (face 7)");
  EXPECT_EQ(d.occurrences(Defect_kind::ZERO_LENGTH_EDGE).size(),
            Input_diagnosis::maximal_number_of_occurrences);
}

TEST(Diagnose, keeps_as_many_occurrences_as_asked_for)
{
  std::vector<std::array<double, 3>> points(100, {0, 0, 0});
  const std::vector<std::vector<std::size_t>> none_used;
  const Input_diagnosis d = IT::diagnose_polygon_soup(points, none_used, 40);
  EXPECT_EQ(d.count(Defect_kind::ISOLATED_VERTEX), 100u);
  EXPECT_EQ(d.occurrences(Defect_kind::ISOLATED_VERTEX).size(), 40u);
}

TEST(Diagnose, tetrahedron_is_clean)
{
  const Input_diagnosis d = diagnose(points(4), tetrahedron);
  expect_clean(d);
  EXPECT_EQ(d.statistics().vertices, 4u);
  EXPECT_EQ(d.statistics().edges, 6u);
  EXPECT_EQ(d.statistics().faces, 4u);
  EXPECT_EQ(d.statistics().euler_characteristic, 2);
  EXPECT_EQ(d.statistics().components, 1u);
  EXPECT_EQ(d.statistics().boundary_loops, 0u);
}

TEST(Diagnose, lengths_and_angles)
{
  const Input_diagnosis d = diagnose({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  expect_clean(d);
  EXPECT_DOUBLE_EQ(d.statistics().min_edge_length, 3);
  EXPECT_DOUBLE_EQ(d.statistics().max_edge_length, 5);
  EXPECT_NEAR(d.statistics().min_angle, std::atan2(3, 4) * 180 / std::acos(-1.), 1e-12);
  EXPECT_EQ(d.statistics().boundary_loops, 1u);
  EXPECT_EQ(d.statistics().euler_characteristic, 1);
}

TEST(Diagnose, empty_input_has_no_angle)
{
  const Input_diagnosis d = diagnose(Points(), Polygons());
  expect_clean(d);
  EXPECT_EQ(d.statistics().components, 0u);
  EXPECT_FALSE(std::isfinite(d.statistics().min_angle));
}

TEST(Diagnose, non_finite_coordinate_is_reported_once)
{
  for(const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    Points p = points(4);
    p[2] = Point(0, bad, 0);
    const Input_diagnosis d = diagnose(p, tetrahedron);
    expect_only(d, Defect_kind::NON_FINITE_COORDINATE, 1);
    EXPECT_EQ(d.occurrences(Defect_kind::NON_FINITE_COORDINATE)[0].vertices[0], 2u);
  }
}

TEST(Diagnose, index_out_of_range)
{
  expect_only(diagnose(points(3), {{0, 1, 2}, {0, 2, 3}}), Defect_kind::FACE_INDEX_OUT_OF_RANGE, 1);
  const std::vector<std::vector<int>> negative = {{0, 1, 2}, {0, 2, -1}};
  expect_only(IT::diagnose_polygon_soup(points(3), negative), Defect_kind::FACE_INDEX_OUT_OF_RANGE,
              1);
}

TEST(Diagnose, repeated_vertex)
{
  const Input_diagnosis d = diagnose(points(4), {{0, 1, 2}, {0, 2, 2}});
  EXPECT_EQ(d.count(Defect_kind::REPEATED_VERTEX_IN_FACE), 1u);
  EXPECT_EQ(d.occurrences(Defect_kind::REPEATED_VERTEX_IN_FACE)[0].face, 1u);
}

TEST(Diagnose, polygons_are_not_triangles)
{
  expect_only(diagnose(points(4), {{0, 1, 2, 3}}), Defect_kind::NON_TRIANGULAR_FACE, 1);
  expect_only(diagnose(points(2), {{0, 1}}), Defect_kind::NON_TRIANGULAR_FACE, 1);
  expect_only(diagnose(points(3), {{0, 1, 2}, {}}), Defect_kind::NON_TRIANGULAR_FACE, 1);
}

TEST(Diagnose, three_faces_at_an_edge)
{
  const Input_diagnosis d = diagnose(points(5), {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  expect_only(d, Defect_kind::NON_MANIFOLD_EDGE, 1);
  const Input_diagnosis::Occurrence& o = d.occurrences(Defect_kind::NON_MANIFOLD_EDGE)[0];
  EXPECT_EQ(o.vertices[0], 0u);
  EXPECT_EQ(o.vertices[1], 1u);
  EXPECT_EQ(o.face, 0u);
}

TEST(Diagnose, inconsistent_orientation)
{
  Polygons faces = tetrahedron;
  std::swap(faces[3][0], faces[3][1]);
  expect_only(diagnose(points(4), faces), Defect_kind::INCONSISTENT_ORIENTATION, 3);
}

TEST(Diagnose, two_fans_at_a_vertex)
{
  const Input_diagnosis d = diagnose(points(5), {{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(d.count(Defect_kind::NON_MANIFOLD_VERTEX), 1u);
  EXPECT_EQ(d.occurrences(Defect_kind::NON_MANIFOLD_VERTEX)[0].vertices[0], 0u);
  EXPECT_EQ(d.statistics().euler_characteristic, 2); // of two disks
  EXPECT_EQ(d.statistics().boundary_loops, 2u);
  EXPECT_EQ(d.statistics().components, 2u);
}

TEST(Diagnose, zero_length_edge)
{
  Points p = points(4);
  p[3] = p[1];
  const Input_diagnosis d = diagnose(p, {{0, 1, 2}, {2, 1, 3}});
  expect_only(d, Defect_kind::ZERO_LENGTH_EDGE, 1);
  EXPECT_EQ(d.message(), "zero-length edge: 1, first between vertices 1 and 3 (face 1)");
}

TEST(Diagnose, tiny_and_huge_lengths)
{
  const auto of_size = [](double x) {
    return diagnose({{0, 0, 0}, {x, 0, 0}, {0, x, 0}}, {{0, 1, 2}});
  };
  for(const double x : {0x1p-127, 1e-30, 1e30, 0x1p126})
    expect_clean(of_size(x));
  for(const double x : {1e-300, 0x1p-129, 0x1p128, 1e150})
    expect_only(of_size(x), Defect_kind::LENGTH_OUT_OF_RANGE, 3);
  const double huge = 1e308;
  const Points p = {{-huge, 0, 0}, {huge, 0, 0}, {0, 1, 0}};
  const Input_diagnosis d = diagnose(p, {{0, 1, 2}});
  EXPECT_EQ(d.count(Defect_kind::INVALID_LENGTH), 1u);
  EXPECT_EQ(d.count(Defect_kind::LENGTH_OUT_OF_RANGE), 2u);
}

TEST(Diagnose, isolated_vertex_is_noted)
{
  const Input_diagnosis d = diagnose(points(5), tetrahedron);
  expect_only(d, Defect_kind::ISOLATED_VERTEX, 1);
  EXPECT_EQ(d.occurrences(Defect_kind::ISOLATED_VERTEX)[0].vertices[0], 4u);
  EXPECT_EQ(d.statistics().vertices, 5u);
  EXPECT_EQ(d.statistics().euler_characteristic, 2);
}

TEST(Diagnose, components_are_noted)
{
  Polygons faces = tetrahedron;
  for(const std::vector<std::size_t>& f : tetrahedron)
    faces.push_back({f[0] + 4, f[1] + 4, f[2] + 4});
  const Input_diagnosis d = diagnose(points(8), faces);
  expect_only(d, Defect_kind::SEVERAL_COMPONENTS, 2);
  EXPECT_EQ(d.occurrences(Defect_kind::SEVERAL_COMPONENTS)[1].face, 4u);
}

TEST(Diagnose, caps_and_needles_are_noted)
{
  const Points cap = {{0, 0, 0}, {0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}};
  expect_only(diagnose(cap, {{0, 1, 2}}), Defect_kind::DEGENERATE_FACE, 1);
  const Points nearly = {{0, 0, 0}, {0.1, 0.1, 0.1}, {0.3, 0.3, std::nextafter(0.3, 1)}};
  const Input_diagnosis d = diagnose(nearly, {{0, 1, 2}});
  EXPECT_EQ(d.count(Defect_kind::DEGENERATE_FACE), 0u);
  EXPECT_EQ(d.count(Defect_kind::NEEDLE_FACE), 1u);
  EXPECT_EQ(d.count(Defect_kind::VERTEX_WITHIN_ROUNDING), 1u);
  const Points needle = {{0, 0, 0}, {1, 0, 0}, {1, 0.01, 0}};
  expect_only(diagnose(needle, {{0, 1, 2}}), Defect_kind::NEEDLE_FACE, 1);
}

// Returns the square of the least height over the square of the greatest coordinate.
Rational squared_relative_height(const std::array<Point, 3>& p)
{
  std::array<CGAL::Simple_cartesian<Rational>::Point_3, 3> q;
  Rational greatest(0), base(0);
  for(std::size_t i = 0; i < 3; ++i) {
    q[i] = {p[i].x(), p[i].y(), p[i].z()};
    for(int k = 0; k < 3; ++k)
      greatest = (std::max)(greatest, Rational(CGAL::abs(q[i][k])));
  }
  for(std::size_t i = 0; i < 3; ++i)
    base = (std::max)(base, Rational(CGAL::squared_distance(q[i], q[(i + 1) % 3])));
  return 4 * CGAL::squared_area(q[0], q[1], q[2]) / (base * greatest * greatest);
}

// The heights of triangles range from far below to far above the rounding errors, in exact
// arithmetic.
TEST(Diagnose, vertices_within_rounding_are_noted)
{
  const double epsilon = std::numeric_limits<double>::epsilon();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::array<int, 2> found{0, 0};
  for(int i = 0; i < 3000; ++i) {
    const auto vector = [&] {
      return Kernel::Vector_3(uniform(random), uniform(random), uniform(random));
    };
    const double scale = std::ldexp(1., i % 100 - 50);
    const Point a = Point(0, 0, 0) + scale * vector(),
                b = a + std::ldexp(scale, -i % 40) * vector();
    const Point c =
      CGAL::barycenter(a, uniform(random), b) + std::ldexp(scale * epsilon, i % 9 - 4) * vector();
    if(CGAL::collinear(a, b, c))
      continue;
    const Input_diagnosis d = diagnose({a, b, c}, {{0, 1, 2}});
    const bool is_low = squared_relative_height({a, b, c}) <= Rational(epsilon) * Rational(epsilon);
    EXPECT_EQ(d.count(Defect_kind::VERTEX_WITHIN_ROUNDING), is_low ? 1u : 0u) << i;
    ++found[is_low];
  }
  EXPECT_GT((std::min)(found[0], found[1]), 300);
}

TEST(Diagnose, vertices_within_rounding_are_named)
{
  const double unit = std::ldexp(1., -52);
  const Points points = {{0, 0, 0}, {1, 0, 0},        {0.25, unit / 4, 0},
                         {1, 1, 0}, {1 + unit, 1, 0}, {1, 2, 0}};
  const Input_diagnosis d = diagnose(points, {{0, 1, 2}, {1, 3, 0}, {3, 4, 5}});
  EXPECT_EQ(d.count(Defect_kind::VERTEX_WITHIN_ROUNDING), 2u);
  EXPECT_EQ(
    d.message(Defect_kind::VERTEX_WITHIN_ROUNDING),
    "vertex within rounding of an edge: 2, first at vertex 2 (face 0), at vertex 3 (face 2)");
  EXPECT_TRUE(diagnose({{0, 0, 0}, {unit, 0, 0}, {0, unit, 0}}, {{0, 1, 2}})
                .count(Defect_kind::VERTEX_WITHIN_ROUNDING) == 0); // small, but near the origin
}

TEST(Diagnose, moebius_strip_has_one_boundary)
{
  const Polygons strip = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}};
  const Input_diagnosis d = diagnose(points(5), strip);
  EXPECT_GT(d.count(Defect_kind::INCONSISTENT_ORIENTATION), 0u);
  EXPECT_EQ(d.count(Defect_kind::NON_ORIENTABLE_COMPONENT), 1u);
  EXPECT_EQ(d.statistics().boundary_loops, 1u);
  EXPECT_EQ(d.statistics().euler_characteristic, 0);
}

// The projective plane has no orientation. Neither reversed faces nor a second component, which has
// one, change that.
TEST(Diagnose, projective_plane_is_not_orientable)
{
  const Polygons plane = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                          {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  for(unsigned int reversed = 0; reversed < 1u << plane.size(); ++reversed) {
    Polygons faces = tetrahedron;
    std::swap(faces[3][0], faces[3][1]);
    for(std::size_t f = 0; f < plane.size(); ++f) {
      faces.push_back({plane[f][0] + 4, plane[f][1] + 4, plane[f][2] + 4});
      if(reversed >> f & 1)
        std::swap(faces.back()[0], faces.back()[1]);
    }
    const Input_diagnosis d = diagnose(points(10), faces);
    ASSERT_EQ(d.count(Defect_kind::NON_ORIENTABLE_COMPONENT), 1u);
    ASSERT_EQ(d.occurrences(Defect_kind::NON_ORIENTABLE_COMPONENT)[0].face, 4u);
  }
}

TEST(Diagnose, annulus_has_two_boundaries)
{
  Polygons faces;
  for(std::size_t i = 0; i < 6; ++i) {
    const std::size_t j = (i + 1) % 6;
    faces.push_back({i, j, i + 6});
    faces.push_back({j, j + 6, i + 6});
  }
  const Input_diagnosis d = diagnose(points(12), faces);
  EXPECT_TRUE(d.is_valid());
  EXPECT_EQ(d.statistics().boundary_loops, 2u);
  EXPECT_EQ(d.statistics().euler_characteristic, 0);
}

TEST(Diagnose, graphs_agree_with_their_soup)
{
  Mesh mesh;
  CGAL::Polyhedron_3<CGAL::Exact_predicates_exact_constructions_kernel> polyhedron;
  using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1);
  CGAL::make_icosahedron(polyhedron, Exact_point(0, 0, 0), 1);
  for(const Input_diagnosis& d : {IT::diagnose(mesh), IT::diagnose(polyhedron)}) {
    expect_clean(d);
    EXPECT_EQ(d.statistics().edges, 30u);
    EXPECT_EQ(d.statistics().euler_characteristic, 2);
    EXPECT_NEAR(d.statistics().min_angle, 60, 1e-9);
  }
}

TEST(Diagnose, vertex_point_map_is_used)
{
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  auto flat = mesh.add_property_map<Mesh::Vertex_index, Point>("v:flat", Point(1, 2, 3)).first;
  const Input_diagnosis d = IT::diagnose(mesh, CGAL::parameters::vertex_point_map(flat));
  expect_only(d, Defect_kind::ZERO_LENGTH_EDGE, 6);
}

TEST(Diagnose, distinct_exact_points_are_not_merged_by_rounding)
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using FT = Exact_kernel::FT;
  CGAL::Surface_mesh<Exact_kernel::Point_3> mesh;
  const FT one_and_a_bit = FT(1) + FT(1e-30);
  CGAL::make_triangle(Exact_kernel::Point_3(1, 0, 0), Exact_kernel::Point_3(one_and_a_bit, 0, 0),
                      Exact_kernel::Point_3(0, 1, 0), mesh);
  EXPECT_EQ(IT::diagnose(mesh).count(Defect_kind::ZERO_LENGTH_EDGE), 0u);
}

TEST(Diagnose, graph_with_pinched_vertex)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(const Point& p : points(5))
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[0], v[3], v[4]);
  ASSERT_EQ(mesh.number_of_faces(), 2u);
  const Input_diagnosis d = IT::diagnose(mesh);
  EXPECT_EQ(d.count(Defect_kind::NON_MANIFOLD_VERTEX), 1u);
  EXPECT_EQ(d.occurrences(Defect_kind::NON_MANIFOLD_VERTEX)[0].vertices[0], 0u);
}

TEST(Diagnose, graph_with_an_edge_without_faces)
{
  Mesh mesh;
  CGAL::make_triangle(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), mesh);
  const Mesh::Halfedge_index h = mesh.add_edge();
  mesh.set_target(h, *mesh.vertices_begin());
  mesh.set_target(mesh.opposite(h), mesh.add_vertex(Point(5, 5, 5)));
  expect_only(IT::diagnose(mesh), Defect_kind::NON_MANIFOLD_EDGE, 1);
}

TEST(Diagnose, loops_and_parallel_edges_are_no_defects)
{
  const Input_diagnosis d = diagnose(one_vertex_torus(), {3, 4, 5});
  expect_clean(d);
  EXPECT_EQ(d.statistics().euler_characteristic, 0);
  EXPECT_EQ(d.statistics().components, 1u);
  EXPECT_EQ(d.statistics().boundary_loops, 0u);
  EXPECT_DOUBLE_EQ(d.statistics().max_edge_length, 5);
}

TEST(Diagnose, given_lengths)
{
  const double infinity = std::numeric_limits<double>::infinity();
  expect_only(diagnose(one_vertex_torus(), {3, 4, 8}), Defect_kind::TRIANGLE_INEQUALITY_VIOLATED,
              2);
  expect_only(diagnose(one_vertex_torus(), {3, 4, 7}), Defect_kind::DEGENERATE_FACE, 2);
  expect_only(diagnose(one_vertex_torus(), {0.1, 0.2, 0.3}), Defect_kind::DEGENERATE_FACE, 2);
  expect_only(diagnose(one_vertex_torus(), {1, 1, 1e-9}), Defect_kind::NEEDLE_FACE, 2);
  expect_only(diagnose(one_vertex_torus(), {1, 1, 0}), Defect_kind::ZERO_LENGTH_EDGE, 1);
  for(const double bad : {-1., infinity, std::nan("")})
    expect_only(diagnose(one_vertex_torus(), {1, bad, 1}), Defect_kind::INVALID_LENGTH, 1);
}

Polygons random_soup(std::mt19937& random, std::size_t number_of_points)
{
  std::uniform_int_distribution<std::size_t> vertex(0, number_of_points - 1), number(1, 8);
  Polygons result(number(random));
  for(std::vector<std::size_t>& face : result)
    face = {vertex(random), vertex(random), vertex(random)};
  return result;
}

// Checks that CGAL's own functions return the same counts for the mesh of the soup.
void expect_statistics_of(const Points& p, const Polygons& f, const Input_diagnosis& d)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(p, f, mesh);
  auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  std::vector<Mesh::Halfedge_index> cycles;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  EXPECT_EQ(d.statistics().boundary_loops, cycles.size());
  EXPECT_EQ(d.statistics().components, PMP::connected_components(mesh, component));
  EXPECT_EQ(d.statistics().edges, mesh.number_of_edges());
  EXPECT_EQ(IT::diagnose(mesh).statistics().euler_characteristic,
            d.statistics().euler_characteristic);
}

TEST(Diagnose, random_soups_as_CGAL_judges_them)
{
  constexpr unsigned seed = 20260101;
  std::mt19937 random(seed);
  std::size_t valid = 0;
  for(int i = 0; i < 5000; ++i) {
    const Points p = points(9);
    const Polygons f = random_soup(random, p.size());
    const Input_diagnosis d = diagnose(p, f);
    const bool is_mesh = CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(f);
    ASSERT_EQ(d.is_valid(), is_mesh) << "seed " << seed << ", soup " << i << ": " << d.message();
    if(is_mesh)
      expect_statistics_of(p, f, d);
    valid += is_mesh;
  }
  EXPECT_GT(valid, 200u);
}

} // namespace Test_diagnose
