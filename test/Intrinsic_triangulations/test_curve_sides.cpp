// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef CGAL_EIGEN3_ENABLED

#include "surface_curves.h"

#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Curve_sides.h>
#include <CGAL/Intrinsic_triangulations/signed_distance.h>

namespace Test_curve_sides {

using namespace Test_surfaces;
typedef std::optional<std::vector<int>> Sides;

Sides sides_of(const Delta_complex& mesh, const Curve& curve)
{
  return IT::internal::Curve_sides<double>(mesh, curve)();
}

int sign(double x) { return (x > 0) - (x < 0); }

Curve reversed(Curve curve)
{
  for(auto& segment : curve)
    std::swap(segment.source, segment.target);
  return curve;
}

// Distances are exact distances from the polygon, with the sign of the known distance.
TEST(Signed_distance, known_curves)
{
  for(const auto& family : {circle_in_square, circles_in_square, stadium_in_square, line_in_square,
                            circle_on_sphere, parallels_of_torus, circle_on_flat_torus})
    for(const std::size_t n : {12u, 48u}) {
      CGAL::Random random(1);
      const Known_curve known = family(n, random);
      SCOPED_TRACE(known.name + ", " + std::to_string(n));
      const auto d = IT::signed_distance(known.t, known.curve());
      EXPECT_EQ(d.method, IT::Distance_method::exact);
      IT::Shortest_paths paths(known.t.intrinsic());
      paths.add_source(known.curve());
      paths.run();
      for(const Vertex_index v : known.t.mesh().vertices()) {
        EXPECT_EQ(std::abs(d.distance[v.idx()]), paths.distance(v));
        EXPECT_EQ(sign(d.distance[v.idx()]), sign(known.distance[v.idx()]));
      }
      const auto back = IT::signed_distance(known.t, reversed(known.curve()));
      for(std::size_t v = 0; v < d.distance.size(); ++v)
        EXPECT_NEAR(back.distance[v], -d.distance[v], 1e-12 * known.edge);
    }
}

TEST(Signed_distance, line_is_exact)
{
  const Known_curve known =
    known_curve("line", unit_square(24, 1), 1. / 24, [](const Point& p) { return p.x() - 0.3; });
  const auto d = IT::signed_distance(known.t, known.curve());
  for(std::size_t v = 0; v < d.distance.size(); ++v)
    EXPECT_NEAR(d.distance[v], known.distance[v], 1e-14);
}

// Returns random faces.
std::vector<char> random_region(const Delta_complex& mesh, double share, CGAL::Random& random)
{
  std::vector<char> result(mesh.num_faces(), 0);
  for(const Face_index f : mesh.faces())
    result[f.idx()] = random.get_double() < share;
  return result;
}

// The boundary of any region along edges is known to have the region on its left. Vertices whose
// faces are all in the region are on the left.
TEST(Curve_sides, boundaries_of_regions)
{
  CGAL::Random random(3);
  for(const Triangulation& t :
      {Triangulation(unit_sphere(8)), Triangulation(unit_square(9, 1)),
       Triangulation(embedded_torus(12, 8)), triangulation(flat_torus(2, 1, 1))})
    for(const double share : {0.02, 0.1, 0.3, 0.5, 0.9}) {
      const Delta_complex& mesh = t.mesh();
      const std::vector<char> region = random_region(mesh, share, random);
      const auto is_inside = [&](Halfedge_index h) {
        return !mesh.is_border(h) && region[mesh.face(h).idx()];
      };
      std::vector<Halfedge_index> halfedges;
      for(const Halfedge_index h : mesh.halfedges())
        if(is_inside(h) && !is_inside(mesh.opposite(h)))
          halfedges.push_back(h);
      if(halfedges.empty())
        continue;
      std::vector<int> expected(mesh.num_vertices(), 0);
      for(const Halfedge_index h : mesh.halfedges())
        if(!mesh.is_border(h))
          expected[mesh.source(h).idx()] = is_inside(h) ? -1 : 1;
      for(const Halfedge_index h : halfedges)
        expected[mesh.source(h).idx()] = expected[mesh.target(h).idx()] = 0;
      const Sides sides = sides_of(mesh, IT::curve_along_edges(t.intrinsic(), halfedges));
      ASSERT_TRUE(sides);
      EXPECT_EQ(*sides, expected);
    }
}

// Curves across edges of another triangulation, also through its vertices, have the same sides.
TEST(Curve_sides, on_another_triangulation)
{
  CGAL::Random random(4);
  for(const Mesh& mesh :
      {unit_sphere(8), embedded_torus(12, 8), perturbed(unit_square(9, 1), 0.02, 2)}) {
    Triangulation t(mesh);
    flip_at_random(t, 300, 5);
    const IT::Correspondence correspondence(t);
    const std::vector<char> region = random_region(t.input_mesh(), 0.3, random);
    std::vector<Halfedge_index> halfedges;
    for(const Halfedge_index h : t.input_mesh().halfedges()) {
      const Halfedge_index o = t.input_mesh().opposite(h);
      const auto is_inside = [&](Halfedge_index x) {
        return !t.input_mesh().is_border(x) && region[t.input_mesh().face(x).idx()];
      };
      if(is_inside(h) && !is_inside(o))
        halfedges.push_back(h);
    }
    const Curve curve = IT::curve_along_edges(t.input(), halfedges);
    const Sides on_input = sides_of(t.input_mesh(), curve);
    const Sides across = sides_of(t.mesh(), IT::curve_across(correspondence, Side::input, curve));
    ASSERT_TRUE(on_input && across);
    EXPECT_EQ(*on_input, *across);
  }
}

// Ends inside a face need not meet.
TEST(Curve_sides, inside_a_face)
{
  Mesh mesh;
  mesh.add_face(mesh.add_vertex(Point(0, 0, 0)), mesh.add_vertex(Point(1, 0, 0)),
                mesh.add_vertex(Point(0, 1, 0)));
  const Triangulation t(mesh);
  const Face_index f(0);
  const auto corner = IT::sides(f, t.mesh());
  std::vector<int> expected(3, 1);
  expected[t.mesh().source(corner[0]).idx()] = -1;
  const Curve across{{f, {0.5, 0.5, 0}, {0.3, 0.3, 0.4}}, {f, {0.3, 0.3, 0.4}, {0.5, 0, 0.5}}};
  EXPECT_EQ(sides_of(t.mesh(), across), expected);
  for(int& side : expected)
    side = -side;
  EXPECT_EQ(sides_of(t.mesh(), reversed(across)), expected);
  EXPECT_FALSE(sides_of(t.mesh(), {across[0]}));
  const Curve loop{{f, {0.6, 0.2, 0.2}, {0.2, 0.6, 0.2}},
                   {f, {0.2, 0.6, 0.2}, {0.2, 0.2, 0.6}},
                   {f, {0.2, 0.2, 0.6}, {0.6, 0.2, 0.2}}};
  EXPECT_EQ(sides_of(t.mesh(), loop), std::vector<int>(3, 1));
  EXPECT_EQ(sides_of(t.mesh(), reversed(loop)), std::vector<int>(3, -1));
  EXPECT_FALSE(sides_of(t.mesh(), {loop[0], loop[1]}));
  const Curve eight{{f, {0.8, 0.1, 0.1}, {0.2, 0.4, 0.4}},
                    {f, {0.2, 0.4, 0.4}, {0.2, 0.6, 0.2}},
                    {f, {0.2, 0.6, 0.2}, {0.6, 0.1, 0.3}},
                    {f, {0.6, 0.1, 0.3}, {0.8, 0.1, 0.1}}};
  EXPECT_FALSE(sides_of(t.mesh(), eight));
}

// The boundary of a face separates a sphere. After flips, the face is a thin region that meets some
// edges only between its ends.
TEST(Curve_sides, thin_faces_after_flips)
{
  for(unsigned int seed = 0; seed < 300; ++seed) {
    Mesh mesh = random_sphere(5 + seed % 9, seed);
    for(const Vertex_index v : mesh.vertices()) {
      const Point p = mesh.point(v);
      mesh.point(v) = Point(p.x(), 0.1 * p.y(), 0.1 * p.z());
    }
    Triangulation t(mesh);
    IT::make_Delaunay(t);
    const IT::Correspondence correspondence(t);
    for(const Face_index f : t.input_mesh().faces()) {
      const auto around = IT::sides(f, t.input_mesh());
      std::vector<int> expected(t.mesh().num_vertices(), 1);
      for(const Halfedge_index h : around)
        expected[t.input_mesh().source(h).idx()] = 0;
      const Curve curve = IT::curve_along_edges(t.input(), around);
      EXPECT_EQ(sides_of(t.mesh(), IT::curve_across(correspondence, Side::input, curve)), expected);
    }
  }
}

TEST(Signed_distance, method)
{
  const Triangulation t(embedded_torus(24, 12));
  const auto meridian = [&](std::size_t i, bool is_forward) {
    std::vector<Location> places;
    for(std::size_t k = 0; k <= 12; ++k) {
      const auto v = Vertex_index(static_cast<unsigned>(12 * i + (is_forward ? k : 12 - k) % 12));
      places.push_back(IT::face_location(
        IT::Edge_point<double>{IT::first_outgoing_halfedge(v, t.mesh()), 0}, t.mesh()));
    }
    return IT::curve_through(t.intrinsic(), places);
  };
  const Curve one = meridian(0, true);
  EXPECT_EQ(IT::signed_distance(t, one).method, IT::Distance_method::heat);
  EXPECT_THROW(
    IT::signed_distance(t, one, IT::parameters::distance_method(IT::Distance_method::exact)),
    IT::Invalid_input);
  Curve two = one;
  for(const auto& segment : meridian(9, false))
    two.push_back(segment);
  EXPECT_EQ(IT::signed_distance(t, two).method, IT::Distance_method::exact);
  EXPECT_EQ(IT::signed_distance(t, two, IT::parameters::time_step_factor(1.)).method,
            IT::Distance_method::heat);
  Curve same = one;
  for(const auto& segment : meridian(9, true))
    same.push_back(segment);
  EXPECT_EQ(IT::signed_distance(t, same).method, IT::Distance_method::heat);
}

TEST(Signed_distance, components_and_coarse_meshes)
{
  Mesh mesh = tetrahedron();
  const std::size_t n = mesh.number_of_vertices();
  CGAL::copy_face_graph(tetrahedron(), mesh);
  const Triangulation t(mesh);
  std::vector<Halfedge_index> around;
  for(const Halfedge_index h : IT::sides(Face_index(0), t.mesh()))
    around.push_back(h);
  const auto d = IT::signed_distance(t, IT::curve_along_edges(t.intrinsic(), around));
  EXPECT_EQ(d.method, IT::Distance_method::exact);
  for(const Vertex_index v : t.mesh().vertices()) {
    bool is_on_curve = false;
    for(const Halfedge_index h : around)
      is_on_curve |= t.mesh().source(h) == v;
    if(v.idx() >= n)
      EXPECT_EQ(d.distance[v.idx()], std::numeric_limits<double>::infinity());
    else if(is_on_curve)
      EXPECT_EQ(d.distance[v.idx()], 0);
    else
      EXPECT_GT(d.distance[v.idx()], 0);
  }
  EXPECT_EQ(IT::signed_distance(t, Curve()).distance[0], std::numeric_limits<double>::infinity());
}

// A segment without length on a second component is no source there.
TEST(Curve_sides, segments_without_length_are_ignored)
{
  const Mesh part = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  Mesh two = part;
  two += part;
  const Triangulation t(two);
  const auto diagonal = t.mesh().halfedge(Vertex_index(0), Vertex_index(2));
  Curve curve = IT::curve_along_edges(t.intrinsic(), std::array{diagonal});
  const Curve point{{Face_index(2), {1, 0, 0}, {1, 0, 0}}};
  const auto alone = IT::signed_distance(t, curve);
  curve.insert(curve.end(), point.begin(), point.end());
  const auto both = IT::signed_distance(t, curve);
  EXPECT_EQ(both.method, IT::Distance_method::exact);
  EXPECT_EQ(both.distance, alone.distance);
  EXPECT_EQ(both.distance[4], std::numeric_limits<double>::infinity());
  EXPECT_NEAR(std::abs(both.distance[1]), std::sqrt(0.5), 1e-15);
  for(auto method :
      {IT::Distance_method::automatic, IT::Distance_method::exact, IT::Distance_method::heat})
    EXPECT_THROW(IT::signed_distance(t, point, IT::parameters::distance_method(method)),
                 IT::Invalid_input);
}

} // namespace Test_curve_sides

#endif // CGAL_EIGEN3_ENABLED
