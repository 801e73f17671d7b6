// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests flatten and remove single vertices.

#include "evolving_surfaces.h"

namespace Test_removal {

using namespace Test_surfaces;

// Returns lengths of a surface, with the lengths of the flattened star.
std::vector<double> flattened_lengths(const Evolving_surface& s, const Flattened_star& star)
{
  std::vector<double> result(s.mesh().num_edges());
  for(Edge_index e : s.mesh().edges())
    result[e] = s.surface().length(e);
  for(std::size_t n = 0; n < star.size(); ++n)
    result[s.mesh().edge(star[n].halfedge)] = star.flat_length(n);
  return result;
}

template <typename Check>
void for_each_flattened_star(const Check& check)
{
  for(const Named_complex& c : traced(complexes()))
    for(unsigned int seed : seeds(5)) {
      const Evolving_surface s = evolving(c.mesh, seed);
      Flattened_star star;
      for(Vertex_index v : s.mesh().vertices())
        if(s.flatten(v, star) == Removal_status::possible) {
          const std::vector<double> lengths = flattened_lengths(s, star);
          check(s, star, [&](Edge_index e) { return lengths[e]; });
        }
    }
}

TEST(Flattening, the_center_becomes_flat)
{
  for_each_flattened_star([](const Evolving_surface& s, const Flattened_star& star, auto length) {
    const double flat = is_on_border(star.center(), s.mesh()) ? pi : 2 * pi;
    EXPECT_NEAR(angle_sums(s.mesh(), length)[star.center()], flat, angle_tolerance);
    Flattened_star sharpened = star;
    EXPECT_TRUE(sharpened.sharpen());
    EXPECT_NEAR(star.scale_factor(), sharpened.scale_factor(), 1e-6);
    const double factor = std::exp(star.scale_factor() / 2);
    for(std::size_t n = 0; n < star.size(); ++n) {
      const bool is_loop = star[n].neighbor == star.center();
      EXPECT_NEAR(star.flat_length(n), star[n].length * (is_loop ? factor * factor : factor),
                  1e-12);
      EXPECT_EQ(star[n].length, s.surface().length(star[n].halfedge));
    }
  });
}

TEST(Flattening, angle_changes_are_those_of_the_neighbors)
{
  for_each_flattened_star([](const Evolving_surface& s, const Flattened_star& star, auto length) {
    std::vector<double> change = angle_sums(s.mesh(), length);
    const std::vector<double> before = angle_sums(s.mesh(), lengths_of(s));
    for(Vertex_index v : s.mesh().vertices())
      change[v] -= before[v];
    double weights = 0;
    for(std::size_t n = 0; n < star.size(); ++n) {
      change[star[n].neighbor] -= star[n].angle_change;
      weights += star[n].weight;
    }
    EXPECT_NEAR(weights, 1, 1e-12);
    for(Vertex_index v : s.mesh().vertices())
      EXPECT_NEAR(v == star.center() ? 0 : change[v], 0, angle_tolerance);
  });
}

// Half of the digits of the scale factor are correct, and of a sine near the angle pi.
TEST(Flattening, area_change)
{
  for_each_flattened_star([](const Evolving_surface& s, const Flattened_star& star, auto length) {
    EXPECT_NEAR(star.area_change(), area_of(s.mesh(), length) - area_of(s), 1e-6);
  });
}

TEST(Flattening, outgoing_halfedges_are_in_order)
{
  for_each_flattened_star([](const Evolving_surface& s, const Flattened_star& star, auto) {
    for(std::size_t n = 0; n < star.number_of_corners(); ++n)
      EXPECT_EQ(IT::next_around_source(star[n].halfedge, s.mesh()), star[star.next(n)].halfedge);
    EXPECT_EQ(star.is_border(), is_on_border(star.center(), s.mesh()));
  });
}

// Returns three triangles around a vertex.
Delta_complex tripod() { return glue({{1, 4, -2}, {2, 5, -3}, {3, 6, -1}}); }

Removal_status status_of(const Evolving_surface& s, Vertex_index v)
{
  Flattened_star star;
  return s.flatten(v, star);
}

Vertex_index inner_vertex(const Delta_complex& mesh)
{
  for(Vertex_index v : mesh.vertices())
    if(!is_on_border(v, mesh))
      return v;
  return {};
}

// With equal outgoing halfedges, the center would have to be the center of the circumcircle of the
// other three edges.
TEST(Flattening, a_star_around_an_obtuse_triangle_cannot_become_flat)
{
  const Delta_complex mesh = tripod();
  const Vertex_index v = inner_vertex(mesh);
  const auto status = [&](double side) {
    return status_of(Evolving_surface(triangulation(mesh, {3, 3, 3, 1, 1, side})), v);
  };
  EXPECT_EQ(status(1.41), Removal_status::possible);
  EXPECT_EQ(status(1.42), Removal_status::not_flattenable);
}

TEST(Flattening, scale_of_the_tip_of_a_regular_tetrahedron)
{
  // The center of the unit triangle has the distance 1 / sqrt(3).
  const Evolving_surface s(tetrahedron());
  Flattened_star star;
  ASSERT_EQ(s.flatten(Vertex_index(0), star), Removal_status::possible);
  ASSERT_TRUE(star.sharpen());
  EXPECT_NEAR(star.scale_factor(), -std::log(3.), 1e-13);
  for(std::size_t n = 0; n < 3; ++n) {
    EXPECT_NEAR(star[n].weight, 1 / 3., 1e-13);
    EXPECT_NEAR(star[n].angle_change, -pi / 3, 1e-8); // half of the digits, as costs need them
  }
}

TEST(Flattening, what_cannot_be_flattened)
{
  const Delta_complex tip = cone(false);
  for(Vertex_index v : tip.vertices())
    EXPECT_EQ(status_of(evolving(tip, 1), v),
              is_on_border(v, tip) ? Removal_status::border_loop : Removal_status::low_degree);
  EXPECT_EQ(status_of(evolving(flat_torus(1, 1, 0).mesh, 1), Vertex_index(0)),
            Removal_status::self_face);
  Mesh mesh = octahedron();
  const Vertex_index alone = mesh.add_vertex({5, 5, 5});
  Evolving_surface s(mesh);
  EXPECT_EQ(status_of(s, alone), Removal_status::isolated);
  s.protect(Vertex_index(2));
  EXPECT_EQ(status_of(s, Vertex_index(2)), Removal_status::protected_vertex);
  EXPECT_EQ(status_of(s, Vertex_index(1)), Removal_status::possible);
}

TEST(Flattening, every_status_has_its_text)
{
  std::vector<std::string> texts;
  for(int n = 0; n < IS::number_of_removal_statuses; ++n)
    texts.emplace_back(to_string(static_cast<Removal_status>(n)));
  std::sort(texts.begin(), texts.end());
  EXPECT_EQ(std::unique(texts.begin(), texts.end()), texts.end());
  EXPECT_EQ(std::count(texts.begin(), texts.end(), "unknown"), 0);
}

// Removes vertices while one can be removed; the number of vertices removed.
std::size_t remove_all(Evolving_surface& s)
{
  const int characteristic = Euler_characteristic(s.mesh());
  Flattened_star star;
  std::size_t removed = 0;
  for(bool has_changed = true; has_changed;) {
    has_changed = false;
    for(std::size_t n = 0; n < s.mesh().num_vertices(); ++n) {
      const Vertex_index v(static_cast<Delta_complex::size_type>(n));
      if(s.mesh().is_removed(v))
        continue;
      const auto before = state_of(s);
      if(s.flatten(v, star) == Removal_status::possible &&
         s.remove(star) == Removal_status::possible) {
        has_changed = true;
        ++removed;
        EXPECT_TRUE(s.mesh().is_removed(v));
        expect_valid(s, characteristic);
      } else
        EXPECT_TRUE(state_of(s) == before) << "trace of " << v;
    }
  }
  return removed;
}

TEST(Removal, keeps_the_surface_valid)
{
  std::size_t removed = 0;
  for(const auto& [c, seed] : traced(complexes(), 5)) {
    Evolving_surface s = evolving(c.mesh, seed);
    s.make_Delaunay();
    removed += remove_all(s);
  }
  EXPECT_GT(removed, 500u);
}

// No sphere has fewer vertices; some end with a few more that cannot be flattened.
TEST(Removal, most_spheres_end_with_three_vertices)
{
  int least = 0;
  for(unsigned int seed = 0; seed < 20; ++seed) {
    Evolving_surface s(random_sphere(30, seed));
    s.make_Delaunay();
    remove_all(s);
    least += s.mesh().number_of_vertices() == 3 ? 1 : 0;
  }
  EXPECT_GT(least, 10);
}

// Loops must be flipped away.
TEST(Removal, the_last_vertex_of_a_torus_is_one)
{
  for(unsigned int seed = 0; seed < 20; ++seed) {
    Evolving_surface s(triangulation(flat_torus(3, 2, seed)));
    s.make_Delaunay();
    remove_all(s);
    EXPECT_EQ(s.mesh().number_of_vertices(), 1u) << "seed " << seed;
    EXPECT_NEAR(area_of(s), 3 * 2 * (1000. * 900 + 130. * 270), 1e-6);
  }
}

TEST(Removal, in_a_flat_polygon_nothing_moves)
{
  for(unsigned int seed : seeds(10)) {
    const Mesh mesh = planar_mesh(random_points(40, 1000, seed));
    Evolving_surface s(mesh);
    s.make_Delaunay();
    Flattened_star star;
    for(Vertex_index v : mesh.vertices())
      if(!mesh.is_border(v)) {
        ASSERT_EQ(s.flatten(v, star), Removal_status::possible);
        EXPECT_NEAR(star.scale_factor(), 0, 1e-12);
        ASSERT_EQ(s.remove(star), Removal_status::possible);
      }
    for(Edge_index e : s.mesh().edges())
      EXPECT_NEAR(s.surface().length(e),
                  std::sqrt(CGAL::squared_distance(mesh.point(s.mesh().vertex(e, 0)),
                                                   mesh.point(s.mesh().vertex(e, 1)))),
                  1e-9);
  }
}

// A vertex is in the middle of a square, and its last flip leaves it on the new edge.
TEST(Removal, a_vertex_on_a_diagonal)
{
  Evolving_surface s(grid(2, 2, [](double x, double y) { return Point(x, y, 0); }));
  Flattened_star star;
  ASSERT_EQ(s.flatten(Vertex_index(4), star), Removal_status::possible);
  ASSERT_EQ(s.remove(star), Removal_status::possible);
  EXPECT_NEAR(area_of(s), 4, 1e-12);
  // The midpoints of the sides, which are straight, can be removed, too.
  for(const unsigned int v : {1u, 3u, 5u, 7u}) {
    ASSERT_EQ(s.flatten(Vertex_index(v), star), Removal_status::possible);
    ASSERT_EQ(s.remove(star), Removal_status::possible);
  }
  EXPECT_EQ(s.mesh().number_of_faces(), 2u);
  EXPECT_NEAR(area_of(s), 4, 1e-12);
}

TEST(Removal, constrained_edges_stay)
{
  const Mesh mesh = random_sphere(60, 3);
  const auto is_chosen = [&](Edge_index e) { return e.idx() % 17 == 0; };
  const auto constrained = boost::make_function_property_map<Edge_index>(is_chosen);
  Evolving_surface s(mesh, CGAL::parameters::edge_is_constrained_map(constrained));
  s.make_Delaunay();
  std::vector<double> before;
  for(Edge_index e : mesh.edges())
    before.push_back(s.surface().length(e));
  EXPECT_GT(remove_all(s), 5u);
  for(Edge_index e : mesh.edges())
    if(is_chosen(e)) {
      ASSERT_FALSE(s.mesh().is_removed(e));
      EXPECT_EQ(s.mesh().vertex(e, 0), mesh.vertex(e, 0));
      EXPECT_EQ(s.surface().length(e), before[e]);
    }
}

} // namespace Test_removal
