// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "subdivision_checks.h"

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>

namespace Test_common_subdivision {

using namespace Test_surfaces;
std::vector<Edge_index> parent_edges(Side side, const Subdivision& s)
{
  std::vector<Edge_index> result;
  for(Edge_index e : s.mesh().edges())
    result.push_back(s.parent_edge(side, e));
  return result;
}

void check_triangles(Subdivision& s, const Triangulation& t)
{
  const std::array<std::vector<Edge_index>, 2> before{parent_edges(Side::input, s),
                                                      parent_edges(Side::intrinsic, s)};
  std::size_t triangles = 0;
  for(Face_index f : s.mesh().faces())
    triangles += sides_of(f, s).size() - 2;
  s.triangulate();
  EXPECT_TRUE(s.mesh().is_valid(true));
  EXPECT_EQ(s.mesh().number_of_faces(), triangles);
  for(Face_index f : s.mesh().faces())
    EXPECT_EQ(sides_of(f, s).size(), 3u);
  for(std::size_t i = 0; i < 2; ++i) {
    std::vector<Edge_index> expected = before[i];
    expected.resize(s.mesh().number_of_edges()); // a cut has no parent
    EXPECT_EQ(parent_edges(both_sides[i], s), expected);
  }
  check_measures(s, t);
}

// Checks a triangulated copy, if one exists.
template <typename Any_subdivision>
void check_copies(const Any_subdivision& s, const Triangulation& t)
{
  if constexpr(std::is_copy_constructible_v<Any_subdivision>) {
    const auto parents = parent_edges(Side::input, s);
    Any_subdivision copy(s);
    check_triangles(copy, t);
    EXPECT_EQ(parent_edges(Side::input, s), parents);
  }
}

TEST(Common_subdivision, is_one_of_both_triangulations)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const Correspondence c(t.triangulation);
    Subdivision s(c);
    check_numbers(s, c);
    check_pieces(s, c);
    check_measures(s, t.triangulation);
    check_triangles(s, t.triangulation);
  }
}

TEST(Common_subdivision, of_equal_triangulations_is_the_input)
{
  for(const Named_complex& complex : traced(complexes())) {
    const Triangulation t = triangulation(complex.mesh, random_lengths(complex.mesh, 1));
    const Subdivision s{Correspondence(t)};
    EXPECT_EQ(s.mesh().number_of_vertices(), complex.mesh.number_of_vertices());
    EXPECT_EQ(s.mesh().number_of_edges(), complex.mesh.number_of_edges());
    EXPECT_EQ(s.mesh().number_of_faces(), complex.mesh.number_of_faces());
    for(Edge_index e : s.mesh().edges())
      EXPECT_EQ(s.parent_edge(Side::input, e), s.parent_edge(Side::intrinsic, e));
  }
}

TEST(Common_subdivision, isolated_vertices_keep_their_numbers)
{
  Mesh mesh;
  const std::vector<std::size_t> isolated{0, 3, 7};
  const Mesh torus = embedded_torus(5, 4);
  std::vector<Vertex_index> number;
  for(Vertex_index v : torus.vertices()) {
    while(std::count(isolated.begin(), isolated.end(), mesh.number_of_vertices()) > 0)
      mesh.add_vertex(Point(9, 9, 9));
    number.push_back(mesh.add_vertex(torus.point(v)));
  }
  for(Face_index f : torus.faces()) {
    const Halfedge_index h = torus.halfedge(f);
    mesh.add_face(number[torus.source(h)], number[torus.target(h)],
                  number[torus.target(torus.next(h))]);
  }
  Triangulation t(mesh);
  EXPECT_GT(IT::make_Delaunay(t), 0u);
  const Correspondence c(t);
  const Subdivision s(c);
  check_numbers(s, c);
  check_measures(s, t);
  for(Vertex_index v : s.mesh().vertices()) {
    const bool is_isolated = std::count(isolated.begin(), isolated.end(), v.idx()) > 0;
    EXPECT_EQ(s.mesh().is_isolated(v), is_isolated);
    EXPECT_EQ(IT::halfedge_of(s.place(Side::input, v)).is_valid(), !is_isolated);
    EXPECT_EQ(IT::halfedge_of(s.place(Side::intrinsic, v)).is_valid(), !is_isolated);
  }
}

// The coordinates at each corner are one of the positions of its vertex in the face.
TEST(Common_subdivision, coordinates_at_corners)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const Subdivision s{Correspondence(t.triangulation)};
    for(Side side : both_sides) {
      const Flat_faces faces(side, t.triangulation);
      for(Halfedge_index h : s.mesh().halfedges()) {
        const Location p = s.location(side, h);
        EXPECT_EQ(p.first.is_valid(), !s.mesh().is_border(h));
        if(s.mesh().is_border(h))
          continue;
        const auto places = places_in(side, p.first, s.mesh().target(h), s, faces);
        EXPECT_EQ(std::count(places.begin(), places.end(), p), 1);
        const Halfedge_index parent = s.parent_halfedge(side, h);
        EXPECT_TRUE(!parent.is_valid() || faces.mesh().face(parent) == p.first);
      }
    }
  }
}

TEST(Common_subdivision, positions_in_space)
{
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t(m.mesh);
    flip_at_random(t, 20 * m.mesh.number_of_edges(), 1);
    const Correspondence c(t);
    IT::Common_subdivision<IT::Euclidean_geometry_traits<>, Point> s(c);
    const auto points = boost::make_function_property_map<Vertex_index>(
      [&](Vertex_index v) { return m.mesh.point(v); });
    IT::interpolate(Side::input, s, points, s.mesh().points());
    for(Vertex_index v : m.mesh.vertices())
      EXPECT_EQ(s.mesh().point(v), m.mesh.point(v));
    Flat_faces faces(Side::intrinsic, t);
    std::vector<double> length(t.mesh().number_of_edges());
    for(Edge_index e : s.mesh().edges())
      if(const Edge_index parent = s.parent_edge(Side::intrinsic, e); parent.is_valid())
        length[parent] += std::sqrt(CGAL::squared_distance(s.mesh().point(s.mesh().vertex(e, 0)),
                                                           s.mesh().point(s.mesh().vertex(e, 1))));
    for(Edge_index e : t.mesh().edges())
      EXPECT_NEAR(length[e] / t.length(e), 1, 1e-9);
  }
}

TEST(Common_subdivision, linear_functions_in_the_plane_from_either_side)
{
  for(unsigned int seed : seeds(5)) {
    Flat_triangulation flat(flat_grid(7, 6, seed));
    flat.flip_at_random(2000, seed);
    const Correspondence c(*flat);
    Subdivision s(c);
    const auto linear = boost::make_function_property_map<Vertex_index>([&](Vertex_index v) {
      const Vector p = flat.surface().point[v];
      return 3 + 0.7 * static_cast<double>(p.x) - 0.2 * static_cast<double>(p.y);
    });
    auto from_input = s.mesh().add_property_map<Vertex_index, double>("v:a").first;
    auto from_intrinsic = s.mesh().add_property_map<Vertex_index, double>("v:b").first;
    IT::interpolate(Side::input, s, linear, from_input);
    IT::interpolate(Side::intrinsic, s, linear, from_intrinsic);
    for(Vertex_index v : s.mesh().vertices()) {
      EXPECT_NEAR(from_input[v], from_intrinsic[v], 1e-12 * 7000);
      if(s.is_vertex(Side::input, v)) {
        EXPECT_EQ(from_input[v], get(linear, v));
        EXPECT_EQ(from_intrinsic[v], get(linear, v));
      }
    }
  }
}

TEST(Common_subdivision, agrees_with_an_arrangement_of_segments)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Exact>>;
  const auto exact = [](const Vector& p) {
    return Exact::Point_2(static_cast<double>(p.x), static_cast<double>(p.y));
  };
  for(unsigned int seed : seeds(6)) {
    Flat_triangulation flat(seed % 2 == 0 ? flat_grid(5, 4, seed)
                                          : flat_polygon(random_points(40, 1 << 19, seed)));
    if(seed % 2 == 0)
      flat.flip_at_random(1000, seed);
    else
      flat.make_Delaunay();
    std::vector<Exact::Segment_2> segments;
    for(const Delta_complex* mesh : {&flat->input_mesh(), &flat->mesh()})
      for(Edge_index e : mesh->edges())
        segments.emplace_back(exact(flat.surface().point[mesh->vertex(e, 0)]),
                              exact(flat.surface().point[mesh->vertex(e, 1)]));
    Arrangement arrangement;
    CGAL::insert(arrangement, segments.begin(), segments.end());
    const Subdivision s{Correspondence(*flat)};
    EXPECT_EQ(s.mesh().number_of_vertices(), arrangement.number_of_vertices());
    EXPECT_EQ(s.mesh().number_of_edges(), arrangement.number_of_edges());
    EXPECT_EQ(s.mesh().number_of_faces() + 1, arrangement.number_of_faces());
    EXPECT_GT(s.mesh().number_of_vertices(), flat->mesh().number_of_vertices() + 20);
  }
}

TEST(Common_subdivision, copies_and_moved_ones_are_independent)
{
  Triangulation t(embedded_torus(5, 4));
  EXPECT_GT(IT::make_Delaunay(t), 0u);
  Subdivision s{Correspondence(t)};
  check_copies(s, t);
  Subdivision moved(std::move(s));
  check_triangles(moved, t);
}

TEST(Common_subdivision, of_the_empty_surface)
{
  const Triangulation t;
  EXPECT_TRUE(Subdivision(Correspondence(t)).mesh().is_empty());
}

} // namespace Test_common_subdivision
