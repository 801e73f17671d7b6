// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "known_surfaces.h"
#include "refined_meshes.h"
#include "unfolding.h"

#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/tufted_cover.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

// These tests check distances by the method that suits the surface.
namespace Test_geodesic_distances {

using namespace Test_surfaces;
using Method = IT::Distance_method;
const double infinity = std::numeric_limits<double>::infinity();

Vertex_index vertex(std::size_t v) { return Vertex_index(static_cast<unsigned>(v)); }

template <typename Np>
auto by_heat(const Np& np)
{
  return np.distance_method(Method::heat);
}
auto by_heat() { return IT::parameters::distance_method(Method::heat); }

// ---- The default is exact ----

TEST(Geodesic_distances, are_exact_by_default)
{
  for(const Named_mesh& m : std::vector<Named_mesh>{
        {"cube", cube()},
        {"spikes", perturbed(random_sphere(9, 4), 0.8, 1)},
        {"holes", punctured(perturbed(embedded_torus(4, 3), 0.3, 6), {1, 16})}}) {
    SCOPED_TRACE(m.name);
    const Triangulation t(m.mesh);
    Unfolding<> unfolding(t.input());
    for(std::size_t i = 0; i < m.mesh.number_of_vertices(); ++i) {
      const auto of_mesh = IT::geodesic_distances(m.mesh, vertex(i));
      const auto of_surface = IT::geodesic_distances(t.input(), vertex(i));
      EXPECT_EQ(of_mesh.method, Method::exact);
      EXPECT_EQ(of_mesh.distance, of_surface.distance);
      EXPECT_FALSE(of_mesh.error);
      const auto truth = unfolding.distances(i).value();
      for(std::size_t j = 0; j < m.mesh.number_of_vertices(); ++j)
        EXPECT_NEAR(of_mesh.distance[j], truth[j], 1e-13);
    }
  }
}

// The numbers equal the distances with all windows kept, on surfaces with many bends.
TEST(Geodesic_distances, are_those_of_shortest_paths)
{
  for(unsigned int seed = 0; seed < 4; ++seed) {
    const Mesh mesh = perturbed(embedded_torus(40, 30), 0.5, seed);
    const Triangulation t(mesh);
    const std::vector<Location> points{{Face_index(5 + seed), {0.2, 0.3, 0.5}},
                                       {Face_index(90), {0.5, 0.5, 0}}};
    IT::Shortest_paths paths(t.input());
    for(const Location& p : points)
      paths.add_source(p);
    paths.run();
    const auto result = IT::geodesic_distances(t.input(), points);
    for(Vertex_index v : mesh.vertices())
      EXPECT_EQ(result.distance[v.idx()], paths.distance(v));
  }
}

// ---- Ten thousand vertices ----

double greatest(const std::vector<double>& distances)
{
  return *std::max_element(distances.begin(), distances.end());
}

// Subdividing flat faces does not change distances, which are known by brute force on few large
// faces.
TEST(Geodesic_distances, on_fine_meshes_as_by_unfolding_coarse_ones)
{
  for(const Named_mesh& m : std::vector<Named_mesh>{
        {"box", perturbed(cube(), 0.2, 1)},
        {"spikes", perturbed(random_sphere(9, 4), 0.8, 1)},
        {"rough torus", perturbed(embedded_torus(4, 3), 0.5, 3)},
        {"holes", punctured(perturbed(embedded_torus(4, 3), 0.3, 6), {1, 16})}}) {
    SCOPED_TRACE(m.name);
    const auto n = static_cast<std::size_t>(std::sqrt(19900. / m.mesh.number_of_faces()));
    const Fine_mesh fine = fine_mesh(m.mesh, n, 0.3);
    CGAL::Random random(5);
    std::vector<Vertex_index> sample;
    std::vector<Location> on_coarse;
    for(int i = 0; i < 12; ++i) {
      sample.push_back(vertex(std::size_t(random.get_int(0, int(fine.on_coarse.size())))));
      on_coarse.push_back(fine.on_coarse[sample.back().idx()]);
    }
    const Triangulation t(m.mesh);
    Unfolding<> unfolding(t.input(), on_coarse);
    const std::size_t first = m.mesh.number_of_vertices();
    std::vector<double> least(first + sample.size(), infinity);
    std::vector<Vertex_index> sources;
    for(std::size_t i = 0; i < 4; ++i) {
      sources.push_back(sample[i]);
      const auto result = IT::geodesic_distances(fine.mesh, sources);
      EXPECT_EQ(result.method, Method::exact);
      const auto truth = unfolding.distances(first + i).value();
      for(std::size_t j = 0; j < sample.size(); ++j) {
        least[j] = (std::min)(least[j], truth[first + j]);
        EXPECT_NEAR(result.distance[sample[j].idx()], least[j], 1e-14 * greatest(result.distance));
      }
    }
  }
}

// In a convex domain, all distances are distances in the plane, also from all vertices on its
// boundary.
TEST(Geodesic_distances, in_a_square_with_ten_thousand_vertices)
{
  const Mesh mesh = unit_square(99, 7);
  std::vector<Vertex_index> boundary;
  for(Vertex_index v : mesh.vertices())
    if(mesh.is_border(v))
      boundary.push_back(v);
  for(const auto& sources : {std::vector{vertex(5050)}, std::vector{vertex(0)}, boundary}) {
    const auto result = IT::geodesic_distances(mesh, sources);
    EXPECT_EQ(result.method, Method::exact);
    for(Vertex_index v : mesh.vertices()) {
      double least = infinity;
      for(Vertex_index s : sources)
        least = (std::min)(least, CGAL::squared_distance(mesh.point(s), mesh.point(v)));
      EXPECT_NEAR(result.distance[v.idx()], std::sqrt(least), 1e-14);
    }
  }
}

// A tetrahedron whose opposite edges are equal is the plane modulo rotations by pi around the
// points of a lattice.
TEST(Geodesic_distances, on_a_tetrahedron_with_ten_thousand_vertices)
{
  const Mesh coarse = make_mesh({{1, 2, 3}, {-1, -2, 3}, {-1, 2, -3}, {1, -2, -3}},
                                {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  const Fine_mesh fine = fine_mesh(coarse, 70, 0.3);
  const double side = std::sqrt(20.), x = (20. + 40 - 52) / (2 * side); // 01 and 02, against 12
  const Complex a(side, 0), b(x, -std::sqrt(40 - x * x));
  const std::array<std::array<Complex, 4>, 4> corner{// by faces and vertices
                                                     std::array<Complex, 4>{0, a, b, 0},
                                                     {0, a, 0, a - b},
                                                     {0, 0, b, b - a},
                                                     {0, a, b, a + b}};
  const auto place = [&](std::size_t v) {
    const auto& [f, w] = fine.on_coarse[v];
    Complex result = 0;
    Halfedge_index h = coarse.halfedge(f);
    for(std::size_t k = 0; k < 3; ++k, h = coarse.next(h))
      result += w[k] * corner[f.idx()][coarse.source(h).idx()];
    return result;
  };
  const auto result = IT::geodesic_distances(fine.mesh, vertex(4321));
  const Complex p = place(4321);
  for(std::size_t v = 0; v < fine.on_coarse.size(); ++v) {
    double least = infinity;
    for(int i = -3; i <= 3; ++i)
      for(int j = -3; j <= 3; ++j)
        for(const Complex& q : {place(v), -place(v)})
          least = (std::min)(least, std::abs(q + 2. * (double(i) * a + double(j) * b) - p));
    EXPECT_NEAR(result.distance[v], least, 1e-13) << v;
  }
}

TEST(Geodesic_distances, from_the_whole_boundary)
{
  const std::size_t n = 20;
  const Mesh mesh =
    grid(n, n, [&](double x, double y) { return Point(x / double(n), y / double(n), 0); });
  std::vector<Vertex_index> boundary;
  for(Vertex_index v : mesh.vertices())
    if(mesh.is_border(v))
      boundary.push_back(v);
  const auto exact = IT::geodesic_distances(mesh, boundary);
  for(Vertex_index v : mesh.vertices()) {
    const Point p = mesh.point(v);
    EXPECT_NEAR(exact.distance[v.idx()], (std::min)({p.x(), 1 - p.x(), p.y(), 1 - p.y()}), 1e-14);
  }
  const auto heat = IT::geodesic_distances(mesh, boundary, by_heat());
  EXPECT_EQ(heat.method, Method::heat);
  ASSERT_TRUE(heat.error);
  EXPECT_EQ(heat.error->number_of_vertices, (n - 1) * (n - 1));
  for(Vertex_index v : mesh.vertices())
    EXPECT_GE(heat.distance[v.idx()], exact.distance[v.idx()] - 1e-12); // straight lines in space
}

TEST(Geodesic_distances, what_is_out_of_reach)
{
  Mesh mesh = make_mesh({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}});
  const Vertex_index alone = mesh.add_vertex(Point(5, 5, 5));
  for(const Method method : {Method::automatic, Method::exact, Method::heat}) {
    const auto np = IT::parameters::distance_method(method);
    EXPECT_EQ(IT::geodesic_distances(mesh, alone, np).distance,
              (std::vector<double>{infinity, infinity, infinity, 0}));
    const auto both = IT::geodesic_distances(mesh, std::array{alone, vertex(0), vertex(0)}, np);
    EXPECT_EQ(both.distance[3], 0);
    EXPECT_EQ(both.distance[0], 0);
    EXPECT_GE(both.distance[1], 1 - 1e-12);
    const auto none = IT::geodesic_distances(mesh, std::vector<Vertex_index>(), np);
    EXPECT_EQ(none.distance, std::vector<double>(4, infinity));
  }
}

// ---- Heat ----

// On two triangles, heat is wrong by a third without positions. With them, two values are the
// distances in space.
TEST(Geodesic_distances, heat_says_how_wrong_it_is)
{
  const Mesh mesh = make_mesh({Point(0, 0, 0), Point(1, 3, 0), Point(2, 0, 0), Point(1, -3, 0)},
                              {{0, 2, 1}, {0, 3, 2}});
  Triangulation t(mesh);
  const auto surface = t.input();
  const std::vector<double> truth{2, std::sqrt(10.), 0, std::sqrt(10.)};
  const auto on_surface = IT::geodesic_distances(surface, vertex(2), by_heat());
  ASSERT_TRUE(on_surface.error);
  double greatest = 0, sum = 0;
  for(std::size_t v : {0u, 1u, 3u}) {
    greatest = (std::max)(greatest, std::abs(on_surface.distance[v] - truth[v]) / truth[v]);
    sum += std::abs(on_surface.distance[v] - truth[v]) / truth[v];
  }
  EXPECT_NEAR(on_surface.error->greatest, greatest, 1e-12);
  EXPECT_NEAR(on_surface.error->ninety_percent, greatest, 1e-12);
  EXPECT_NEAR(on_surface.error->mean, sum / 3, 1e-12);
  EXPECT_EQ(on_surface.error->number_of_vertices, 3u);
  EXPECT_GT(greatest, 0.1);

  const auto in_space = IT::geodesic_distances(mesh, vertex(2), by_heat());
  for(std::size_t v = 0; v < 4; ++v)
    EXPECT_GE(in_space.distance[v], truth[v] * (1 - 1e-12));
  EXPECT_GT(in_space.number_of_raised_vertices, 0u);
}

// The estimate is the error of all vertices if all can be compared.
TEST(Geodesic_distances, estimates_are_true)
{
  for(unsigned int seed = 0; seed < 6; ++seed) {
    const Mesh mesh = perturbed(embedded_torus(20, 12), 0.1 * (seed + 1), seed);
    const auto exact = IT::geodesic_distances(mesh, vertex(7));
    const auto heat = IT::geodesic_distances(mesh, vertex(7), by_heat());
    std::vector<double> errors;
    for(std::size_t v = 0; v < exact.distance.size(); ++v)
      if(v != 7)
        errors.push_back(std::abs(heat.distance[v] / exact.distance[v] - 1));
    std::sort(errors.begin(), errors.end());
    ASSERT_TRUE(heat.error);
    EXPECT_EQ(heat.error->number_of_vertices, errors.size());
    EXPECT_NEAR(heat.error->greatest, errors.back(), 1e-12);
    const double share =
      double(
        std::count_if(errors.begin(), errors.end(),
                      [&](double e) { return e <= heat.error->ninety_percent * (1 + 1e-12); })) /
      double(errors.size());
    EXPECT_GE(share, 0.9);
    EXPECT_LE(share, 0.9 + 1. / double(errors.size()) + 1e-12);
  }
}

TEST(Geodesic_distances, estimate_for_heat_distances)
{
  Triangulation t(perturbed(embedded_torus(20, 12), 0.3, 1));
  IT::make_Delaunay(t);
  const IT::Heat_distance<> heat(t.intrinsic());
  const auto distance = heat.distances(vertex(7));
  const auto error = IT::estimate_error(t.intrinsic(), vertex(7), distance);
  EXPECT_EQ(error.number_of_vertices, 239u);
  EXPECT_GT(error.mean, 0);
  EXPECT_LT(error.mean, 0.2);
  const auto same = IT::estimate_error(t.intrinsic(), vertex(7),
                                       std::vector<double>(distance.begin(), distance.end()));
  EXPECT_EQ(same.greatest, error.greatest);
}

// Only distances that are known exactly are compared.
TEST(Geodesic_distances, estimates_leave_out_what_is_not_known)
{
  const IT::Heat_error<double> none({1, 2}, {0, infinity}, infinity);
  EXPECT_EQ(none.number_of_vertices, 0u);
  EXPECT_EQ(none.greatest, 0);
  const IT::Heat_error<double> some({0, 1.5, 9, 5}, {0, 1, 2, infinity}, 1.5);
  EXPECT_EQ(some.number_of_vertices, 1u);
  EXPECT_EQ(some.greatest, 0.5);
  EXPECT_EQ(some.greatest_distance, 1);
}

TEST(Geodesic_distances, curves_and_points_of_a_mesh)
{
  const Mesh mesh = perturbed(unit_sphere(6), 0.05, 1);
  const Triangulation t(mesh);
  const auto path = IT::shortest_path(t.input(), Location(Face_index(3), {0.2, 0.3, 0.5}),
                                      Location(Face_index(100), {0.3, 0.3, 0.4}));
  const auto curve = IT::curve_through(t.input(), path.places);
  const auto exact = IT::geodesic_distances(mesh, curve);
  IT::Shortest_paths paths(t.input());
  paths.add_source(curve);
  paths.run();
  for(Vertex_index v : mesh.vertices())
    EXPECT_EQ(exact.distance[v.idx()], paths.distance(v));
  const auto heat = IT::geodesic_distances(mesh, curve, by_heat());
  ASSERT_TRUE(heat.error);
  EXPECT_GT(heat.error->mean, 0);
  EXPECT_LT(heat.error->mean, 0.2);
}

TEST(Geodesic_distances, of_polyhedra_and_lengths)
{
  const Mesh mesh = perturbed(unit_sphere(3), 0.05, 1);
  CGAL::Polyhedron_3<Kernel> polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  std::vector<std::size_t> in_mesh; // of the vertices of the polyhedron, by their positions
  for(const auto v : vertices(polyhedron))
    in_mesh.push_back(static_cast<std::size_t>(
      std::find(mesh.points().begin(), mesh.points().end(), v->point()) - mesh.points().begin()));
  const auto source =
    static_cast<std::size_t>(std::find(in_mesh.begin(), in_mesh.end(), 4u) - in_mesh.begin());
  const auto expected = IT::geodesic_distances(mesh, vertex(4)).distance;
  const auto found = IT::geodesic_distances(polyhedron, vertex(source)).distance;
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t v = 0; v < found.size(); ++v)
    EXPECT_NEAR(found[v], expected[in_mesh[v]], 1e-13);
  const Triangulation t(mesh);
  const auto np = IT::parameters::edge_length_map(t.input_length_map());
  EXPECT_EQ(IT::geodesic_distances(mesh, vertex(4), np).distance, expected);
  const auto heat = IT::geodesic_distances(mesh, vertex(4), by_heat(np));
  EXPECT_EQ(heat.method, Method::heat);
}

TEST(Geodesic_distances, of_soups_are_by_heat)
{
  const std::vector<Point> points{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1),
                                  Point(0, -1, 0)};
  const std::vector<std::array<std::size_t, 3>> triangles{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const auto cover = IT::tufted_cover(points, triangles);
  Triangulation t(cover.mesh());
  const IT::Tufted_surface<> surface(cover, t.intrinsic());
  const auto result = IT::geodesic_distances(surface, vertex(0));
  EXPECT_EQ(result.method, Method::heat);
  EXPECT_FALSE(result.error);
  EXPECT_THROW(
    IT::geodesic_distances(surface, vertex(0), IT::parameters::distance_method(Method::exact)),
    IT::Invalid_input);
}

} // namespace Test_geodesic_distances
