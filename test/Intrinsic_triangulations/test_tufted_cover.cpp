// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "soups.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/tufted_cover.h>

namespace Test_tufted_cover {

using namespace Test_surfaces;
using Cover = IT::Tufted_cover<Point>;

template <typename Mesh>
std::size_t number_of_components(const Mesh& mesh)
{
  std::vector<std::size_t> component(mesh.number_of_faces());
  std::iota(component.begin(), component.end(), std::size_t(0));
  for(bool has_changed = true; has_changed;) {
    has_changed = false;
    for(Halfedge_index h : mesh.halfedges()) {
      const std::size_t f = mesh.face(h), g = mesh.face(mesh.opposite(h));
      if(component[f] < component[g]) {
        component[g] = component[f];
        has_changed = true;
      }
    }
  }
  return std::set<std::size_t>(component.begin(), component.end()).size();
}

// Checks that corners, sides and faces of the cover are corners, sides and faces of the soup.
template <typename P>
void expect_maps(const IT::Tufted_cover<P>& cover, const Triangles& triangles)
{
  const auto& mesh = cover.mesh();
  ASSERT_TRUE(IT::is_valid_Delta_complex(mesh, true));
  ASSERT_EQ(mesh.number_of_faces(), 2 * triangles.size());
  ASSERT_EQ(2 * mesh.number_of_edges(), 3 * mesh.number_of_faces());
  for(Halfedge_index h : mesh.halfedges()) {
    ASSERT_FALSE(mesh.is_border(h));
    const auto [t, i] = cover.input_side(h);
    EXPECT_EQ(t, Cover::input_face(mesh.face(h)));
    const std::size_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
    const bool is_back = Cover::is_back(mesh.face(h));
    EXPECT_EQ(cover.input_vertex(mesh.source(h)), is_back ? to : from);
    EXPECT_EQ(cover.input_vertex(mesh.target(h)), is_back ? from : to);
    if(h.idx() % 2 == 0) {
      EXPECT_EQ(h.idx() / 2, 3 * t + i);
    }
  }
}

// Returns the angle of a triangle around the side from `from` to `to`.
double angle(const Soup& soup, std::size_t from, std::size_t to, std::size_t t)
{
  std::size_t apex = 0;
  for(const std::size_t v : soup.triangles[t])
    if(v != from && v != to)
      apex = v;
  typedef Kernel::Vector_3 Vector_3;
  Vector_3 z = soup.points[to] - soup.points[from];
  z = z / std::sqrt(z.squared_length());
  Vector_3 x(0.3, 0.5, 0.7);
  x = x - (x * z) * z;
  const Vector_3 w = soup.points[apex] - soup.points[from];
  return std::atan2(w * CGAL::cross_product(z, x), w * x);
}

double turn(double from, double to)
{
  const double full = 2 * std::acos(-1.);
  const double result = std::fmod(to - from, full);
  return result < 0 ? result + full : result;
}

std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>>
faces_at_edges(const Triangles& triangles)
{
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> result;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    for(std::size_t i = 0; i < 3; ++i)
      result[std::minmax({triangles[t][i], triangles[t][(i + 1) % 3]})].push_back(t);
  return result;
}

// Checks that no triangle is between the two glued ones, on their side. Equal triangles are
// excluded.
void expect_neighbors_by_angle(const Soup& soup, const Cover& cover)
{
  const auto at_edge = faces_at_edges(soup.triangles);
  for(Halfedge_index h : cover.mesh().halfedges()) {
    const std::size_t from = cover.input_vertex(cover.mesh().source(h));
    const std::size_t to = cover.input_vertex(cover.mesh().target(h));
    const std::size_t t = Cover::input_face(cover.mesh().face(h));
    const std::size_t u = Cover::input_face(cover.mesh().face(cover.mesh().opposite(h)));
    const double own = angle(soup, from, to, t);
    const double to_next = t == u ? 7 : turn(own, angle(soup, from, to, u));
    for(const std::size_t other : at_edge.at(std::minmax({from, to})))
      if(const double other_turn = turn(own, angle(soup, from, to, other)); other_turn > 1e-12) {
        EXPECT_GE(other_turn, to_next - 1e-9);
      }
  }
}

// ---- Gluing ----

TEST(Tufted_cover, of_one_triangle_is_a_pillow)
{
  const auto cover = IT::tufted_cover(3, Triangles{{0, 1, 2}});
  expect_maps(cover, {{0, 1, 2}});
  EXPECT_EQ(cover.mesh().number_of_vertices(), 3u);
}

TEST(Tufted_cover, of_a_closed_surface_is_two_copies)
{
  for(const Mesh& mesh : {tetrahedron(), octahedron(), cube(), random_sphere(30, 1)}) {
    const Soup soup = soup_of(mesh);
    const Cover cover = IT::tufted_cover(soup.points, soup.triangles);
    expect_maps(cover, soup.triangles);
    EXPECT_EQ(cover.mesh().number_of_vertices(), 2 * mesh.number_of_vertices());
    EXPECT_EQ(number_of_components(cover.mesh()), 2u);
    for(Halfedge_index h : cover.mesh().halfedges())
      EXPECT_EQ(Cover::is_back(cover.mesh().face(h)),
                Cover::is_back(cover.mesh().face(cover.mesh().opposite(h))));
  }
}

TEST(Tufted_cover, of_a_moebius_band_is_a_torus)
{
  const Soup soup = moebius_band(9);
  const Cover cover = IT::tufted_cover(soup.points, soup.triangles);
  expect_maps(cover, soup.triangles);
  const auto& mesh = cover.mesh();
  EXPECT_EQ(number_of_components(mesh), 1u);
  EXPECT_EQ(mesh.number_of_vertices() + mesh.number_of_faces(), mesh.number_of_edges());
}

TEST(Tufted_cover, vertices_are_fans)
{
  // Two triangles touch in a vertex, and another vertex is isolated.
  const Cover cover = IT::tufted_cover(
    std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, 1, 0}, {5, 5, 5}},
    Triangles{{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(cover.mesh().number_of_vertices(), 6u);
  EXPECT_EQ(cover.number_of_input_vertices(), 6u);
  EXPECT_EQ(cover.input_vertex(Vertex_index(6)), 6u); // the first one that is inserted
  EXPECT_EQ(cover.mesh().point(Vertex_index(0)), Point(0, 0, 0));
}

TEST(Tufted_cover, follows_angles)
{
  for(unsigned int seed : seeds(100)) {
    const Soup soup = random_soup(seed);
    const Cover cover = IT::tufted_cover(soup.points, soup.triangles);
    expect_maps(cover, soup.triangles);
    expect_neighbors_by_angle(soup, cover);
  }
}

// Angles differ by less than the rounding unit.
TEST(Tufted_cover, compares_angles_exactly)
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  std::vector<int> heights{3, -2, 0, 5, -7, 1};
  do {
    Soup soup{{{0, 0, 0}, {0, 0, 1}}, {}};
    for(const int height : heights) {
      soup.triangles.push_back({0, 1, soup.points.size()});
      soup.points.emplace_back(1, height * tiny, 0.5);
    }
    const Cover cover = IT::tufted_cover(soup.points, soup.triangles);
    for(Halfedge_index h : cover.mesh().halfedges())
      if(cover.input_vertex(cover.mesh().source(h)) == 0 &&
         cover.input_vertex(cover.mesh().target(h)) == 1) {
        const auto height = [&](Halfedge_index x) {
          return heights[Cover::input_face(cover.mesh().face(x))];
        };
        const int above = height(h), next = height(IT::opposite(h));
        int expected = -7;
        for(const int other : heights)
          if(other > above && (expected <= above || other < expected))
            expected = other;
        EXPECT_EQ(next, expected);
      }
  } while(std::next_permutation(heights.begin(), heights.begin() + 4));
}

// Opposite half planes are distinguished, and any of them can be a reference.
TEST(Tufted_cover, knows_half_planes)
{
  const std::vector<std::array<int, 2>> directions{{1, 0},  {-1, 0}, {0, 1},
                                                   {0, -1}, {1, 1},  {-1, -1}};
  Soup soup{{{0, 0, 0}, {0, 0, 1}}, {}};
  for(const auto& d : directions) {
    soup.triangles.push_back({0, 1, soup.points.size()});
    soup.points.emplace_back(d[0], d[1], 0.25);
  }
  expect_neighbors_by_angle(soup, IT::tufted_cover(soup.points, soup.triangles));
}

// Equal triangles lie on each other like sheets, however their corners are named.
TEST(Tufted_cover, stacks_equal_triangles)
{
  for(unsigned int seed : seeds(50)) {
    CGAL::Random random(seed);
    Soup soup{{{0, 0, 0}, {1, 0.25, 0.5}, {0.25, 1, 0.25}}, {}};
    for(int i = random.get_int(1, 7); i > 0; --i) {
      std::array<std::size_t, 3> t{0, 1, 2};
      CGAL::cpp98::random_shuffle(t.begin(), t.end(), random);
      soup.triangles.push_back(t);
    }
    const Cover cover = IT::tufted_cover(soup.points, soup.triangles);
    expect_maps(cover, soup.triangles);
    EXPECT_EQ(number_of_components(cover.mesh()), soup.triangles.size());
    EXPECT_EQ(cover.mesh().number_of_vertices(), 3 * soup.triangles.size());
  }
}

TEST(Tufted_cover, takes_exact_points)
{
  typedef CGAL::Simple_cartesian<CGAL::Exact_rational>::Point_3 Exact_point;
  const Soup soup = random_soup(3);
  std::vector<Exact_point> points;
  for(const Point& p : soup.points)
    points.emplace_back(p.x(), p.y(), p.z());
  const auto exact = IT::tufted_cover(points, soup.triangles);
  const Cover cover = IT::tufted_cover(soup.points, soup.triangles);
  for(Halfedge_index h : cover.mesh().halfedges())
    EXPECT_EQ(cover.mesh().next(h), exact.mesh().next(h));
}

TEST(Tufted_cover, takes_flat_triangles_and_coinciding_points)
{
  const std::vector<Point> points{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {1, 0, 0}, {0, 0, 1}};
  const Triangles triangles{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}, {0, 2, 3}};
  expect_maps(IT::tufted_cover(points, triangles), triangles);
}

// ---- Lengths ----

TEST(Tufted_cover, without_positions_follows_indices)
{
  const Triangles triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {4, 0, 1}};
  const auto cover = IT::tufted_cover(6, triangles);
  expect_maps(cover, triangles);
  for(Halfedge_index h : cover.mesh().halfedges())
    if(cover.input_vertex(cover.mesh().source(h)) == 0 &&
       cover.input_vertex(cover.mesh().target(h)) == 1) {
      EXPECT_EQ(Cover::input_face(cover.mesh().face(IT::opposite(h))),
                (Cover::input_face(cover.mesh().face(h)) + 1) % 4);
    }
}

TEST(Tufted_cover, without_positions_follows_indices_in_any_soup)
{
  for(unsigned int seed : seeds(50)) {
    const Soup soup = random_soup(seed);
    const auto cover = IT::tufted_cover(soup.points.size(), soup.triangles);
    expect_maps(cover, soup.triangles);
    const auto at_edge = faces_at_edges(soup.triangles);
    for(Halfedge_index h : cover.mesh().halfedges()) {
      const std::size_t from = cover.input_vertex(cover.mesh().source(h));
      const std::size_t to = cover.input_vertex(cover.mesh().target(h));
      if(from > to)
        continue;
      const std::vector<std::size_t>& faces = at_edge.at({from, to});
      const auto face =
        std::find(faces.begin(), faces.end(), Cover::input_face(cover.mesh().face(h)));
      ASSERT_NE(face, faces.end());
      const std::size_t next = face + 1 == faces.end() ? faces.front() : *(face + 1);
      EXPECT_EQ(Cover::input_face(cover.mesh().face(IT::opposite(h))), next);
    }
  }
}

TEST(Tufted_cover, takes_lengths_of_sides)
{
  const Triangles triangles{{0, 1, 2}, {1, 0, 3}, {4, 0, 1}};
  const auto cover = IT::tufted_cover(5, triangles);
  std::vector<std::array<double, 3>> lengths{{1, 2, 2.5}, {1, 1.5, 2}, {3, 1, 3}};
  const auto map = cover.edge_length_map(lengths);
  for(Halfedge_index h : cover.mesh().halfedges()) {
    const auto [t, i] = cover.input_side(h);
    EXPECT_EQ(get(map, cover.mesh().edge(h)), lengths[t][i]);
  }
  lengths[2][1] = 1.25;
  EXPECT_THROW(cover.edge_length_map(lengths), IT::Invalid_input);
}

// ---- Errors ----

std::string error(const std::vector<std::vector<int>>& triangles)
{
  try {
    IT::tufted_cover(3, triangles);
  } catch(const IT::Invalid_input& e) {
    return e.what();
  }
  return "";
}

TEST(Tufted_cover, names_what_is_wrong)
{
  EXPECT_EQ(error({{0, 1, 2}, {0, 1, 2, 2}}), "face 1 is not a triangle");
  EXPECT_EQ(error({{0, 1}}), "face 0 is not a triangle");
  EXPECT_EQ(error({{0, 1, 3}}), "face 0 names a vertex that does not exist");
  EXPECT_EQ(error({{0, -1, 2}}), "face 0 names a vertex that does not exist");
  EXPECT_EQ(error({{0, 2, 2}}), "face 0 names the same vertex twice");
  EXPECT_EQ(error({{2, 1, 2}}), "face 0 names the same vertex twice");
  EXPECT_EQ(error({}), "");
}

TEST(Tufted_cover, refuses_points_that_are_not_finite)
{
  for(const double x : {std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(
      IT::tufted_cover(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, x, 0}}, Triangles{{0, 1, 2}}),
      IT::Invalid_input);
}

} // namespace Test_tufted_cover
