// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "known_surfaces.h"
#include "path_checks.h"
#include "tied_meshes.h"
#include "unfolding.h"

#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace Test_shortest_paths {

using namespace Test_surfaces;
using View = decltype(std::declval<Triangulation>().input());
using Paths = IT::Shortest_paths<View>;
using Quad = boost::multiprecision::cpp_bin_float_quad;

const double infinity = std::numeric_limits<double>::infinity();

// ---- Brute force ----

void check_by_unfolding(Side side, const Triangulation& t, unsigned int seed)
{
  const Flat_faces faces(side, t);
  const Delta_complex& mesh = faces.mesh();
  const auto surface = t.surface(side);
  CGAL::Random random(seed);
  std::vector<Location> points;
  for(int i = 0; i < 5; ++i)
    points.push_back(random_location(mesh, random));
  for(int i = 0; i < 2; ++i)
    points.push_back(faces.on(faces.sides(points[std::size_t(i)].first)[1], random.get_double()));
  Unfolding<> unfolding(surface, points);
  const std::size_t n = mesh.number_of_vertices();
  const double tolerance = 1e-12 * static_cast<double>(faces.longest_edge());
  for(std::size_t i = 0; i < n + points.size(); ++i) {
    Paths paths(surface);
    i < n ? paths.add_source(Vertex_index(static_cast<unsigned>(i)))
          : paths.add_source(points[i - n]);
    paths.run();
    const auto truth = unfolding.distances(i).value();
    for(std::size_t j = 0; j < n; ++j) {
      const Vertex_index v(static_cast<unsigned>(j));
      EXPECT_NEAR(paths.distance(v), truth[j], tolerance) << i << " " << j;
      expect_valid(paths.path(v), faces, tolerance);
    }
    for(std::size_t j = n; j < n + points.size(); ++j) {
      EXPECT_NEAR(paths.distance(points[j - n]), truth[j], tolerance) << i << " " << j;
      const Path path = paths.path(points[j - n]);
      EXPECT_EQ(IT::face_location(path.places.back(), mesh), points[j - n]);
      expect_valid(path, faces, tolerance);
    }
  }
}

TEST(Shortest_paths, as_by_unfolding_all_sequences_of_faces)
{
  for(const Named_mesh& m : traced(small_meshes()))
    for(unsigned int seed = 0; seed < 2; ++seed) {
      Triangulation t(m.mesh);
      check_by_unfolding(Side::input, t, seed);
      flip_at_random(t, 10, seed);
      check_by_unfolding(Side::intrinsic, t, seed);
    }
}

TEST(Shortest_paths, as_by_unfolding_on_Delta_complexes)
{
  for(const auto& [name, mesh] : traced(glued_complexes()))
    for(unsigned int seed = 0; seed < 3; ++seed)
      check_by_unfolding(Side::input, triangulation(mesh, random_lengths(mesh, seed)), seed);
}

// ---- Visitors ----

// Counts windows, and stops at so many.
struct Stopping_visitor
{
  struct Stop
  {};

  void after_windows(std::size_t number)
  {
    windows += number;
    if(windows >= limit)
      throw Stop();
  }

  std::size_t limit = (std::numeric_limits<std::size_t>::max)();
  std::size_t windows = 0;
};

// However often a search is stopped, it ends with the distances and windows of an uninterrupted
// one.
TEST(Shortest_paths, continue_after_a_visitor_stops_them)
{
  const Mesh mesh = perturbed(embedded_torus(20, 15), 0.5, 1);
  const Triangulation t(mesh);
  Paths whole(t.input()), stopped(t.input());
  Stopping_visitor counter, stopping{100};
  whole.add_source(Vertex_index(7));
  whole.run(IT::parameters::visitor(std::ref(counter)));
  ASSERT_GT(counter.windows, 1000u);
  stopped.add_source(Vertex_index(7));
  std::size_t stops = 0;
  for(bool is_stopped = true; is_stopped; stopping.limit += 100)
    try {
      stopped.run(IT::parameters::visitor(std::ref(stopping)));
      is_stopped = false;
    } catch(const Stopping_visitor::Stop&) {
      ++stops;
    }
  EXPECT_GT(stops, 5u);
  EXPECT_EQ(stopping.windows, counter.windows);
  for(const Vertex_index v : mesh.vertices())
    EXPECT_EQ(stopped.distance(v), whole.distance(v));
}

TEST(Shortest_paths, are_stopped_in_all_functions)
{
  const Mesh mesh = perturbed(embedded_torus(20, 15), 0.5, 1);
  const Triangulation t(mesh);
  const Location p{Face_index(1), {0.2, 0.3, 0.5}}, q{Face_index(300), {0.2, 0.3, 0.5}};
  const auto np = IT::parameters::visitor(Stopping_visitor{20});
  EXPECT_THROW(IT::shortest_path(t.input(), p, q, np), Stopping_visitor::Stop);
  EXPECT_THROW(IT::logarithmic_map(t.input(), p, q, np), Stopping_visitor::Stop);
  EXPECT_THROW(IT::logarithmic_map(t.input(), p, np), Stopping_visitor::Stop);
  EXPECT_THROW(IT::geodesic_distances(t.input(), p, np), Stopping_visitor::Stop);
  EXPECT_THROW(IT::geodesic_distances(mesh, p, np), Stopping_visitor::Stop);
}

// ---- CGAL's shortest paths ----

typedef CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh> CGAL_traits;

void check_with_CGAL(const Mesh& mesh, unsigned int seed)
{
  const Triangulation t(mesh);
  const Flat_faces faces(Side::input, t);
  CGAL::Random random(seed);
  std::vector<CGAL::Surface_mesh_shortest_path<CGAL_traits>> truths;
  truths.reserve(3);
  Paths paths(t.input());
  for(int i = 0; i < 3; ++i) {
    const Location p = random_location(t.input_mesh(), random);
    truths.emplace_back(mesh);
    truths.back().add_source_point(p.first, p.second);
    EXPECT_EQ(paths.add_source(p), static_cast<std::size_t>(i));
  }
  paths.run();
  for(int i = 0; i < 100; ++i) {
    const Location q = random_location(t.input_mesh(), random);
    double d = -1;
    for(auto& truth : truths)
      if(const double x = truth.shortest_distance_to_source_points(q.first, q.second).first; x >= 0)
        d = d < 0 ? x : (std::min)(d, x);
    if(d < 0) {
      EXPECT_EQ(paths.distance(q), infinity);
      EXPECT_TRUE(paths.path(q).places.empty());
      continue;
    }
    EXPECT_NEAR(paths.distance(q), d, 1e-12 * (1 + d));
    expect_valid(paths.path(q), faces, 1e-11 * (1 + d));
  }
}

// Checks that every vertex is the end of a path that is not longer than its pieces, and each source
// is its own source.
void check_itself(const Triangulation& t, Side side)
{
  const Flat_faces faces(side, t);
  Paths paths(t.surface(side));
  CGAL::Random random(1);
  const Location p = random_location(faces.mesh(), random);
  paths.add_source(p);
  paths.add_source(Vertex_index(1));
  paths.run();
  EXPECT_EQ(paths.distance(p), 0);
  EXPECT_EQ(paths.distance(Vertex_index(1)), 0);
  EXPECT_EQ(paths.source(p), 0u);
  EXPECT_EQ(paths.source(Vertex_index(1)), 1u);
  for(Vertex_index v : faces.mesh().vertices())
    if(paths.distance(v) < infinity)
      expect_valid(paths.path(v), faces, 1e-9 * static_cast<double>(faces.longest_edge()));
}

TEST(Shortest_paths, from_three_points_as_in_CGAL)
{
  for(const Named_mesh& m : traced(meshes()))
    for(unsigned int seed = 0; seed < 3; ++seed)
      check_with_CGAL(m.mesh, seed);
}

TEST(Shortest_paths, on_data_meshes_as_in_CGAL)
{
  for_data_meshes(
    {"elephant.off", "pig.off", "anchor.off", "ALSTOM_TEST4.off", "mech-holes-shark.off"},
    [](const Mesh& mesh) { check_with_CGAL(mesh, 1); });
}

TEST(Shortest_paths, on_near_degenerate_meshes)
{
  for(const auto& [m, seed] : traced(60, near_degenerate_mesh))
    check_itself(Triangulation(m.mesh), Side::input);
}

// Angle sums range down to zero: no failure, no NaN. Distances lie between distances in space and
// along edges, up to half of the digits, which is the accuracy of lengths of a flat triangle.
TEST(Shortest_paths, on_hard_meshes)
{
  for(const auto& [m, seed] : traced(120, hard_mesh)) {
    const Triangulation t(m.mesh);
    const auto surface = t.input();
    const Vertex_index source(static_cast<unsigned>(7 * seed % m.mesh.number_of_vertices()));
    Paths paths(surface);
    paths.add_source(source);
    paths.run();
    for(Vertex_index v : surface.mesh().vertices()) {
      double along_edges = 0;
      for(Halfedge_index h : IT::shortest_edge_path(surface, source, v))
        along_edges += t.input_length(surface.mesh().edge(h));
      EXPECT_LE(paths.distance(v), along_edges * (1 + 1e-12)) << v;
      EXPECT_GE(paths.distance(v),
                std::sqrt(CGAL::squared_distance(m.mesh.point(source), m.mesh.point(v))) -
                  1e-6 * along_edges - 1e-14)
        << v;
      EXPECT_NEAR(paths.path(v).length, paths.distance(v), 1e-9 * along_edges) << v;
    }
  }
}

// Compares with unfolding in many digits, unless that takes more than `bound` faces, and returns
// whether it has. Lengths of `double` determine distances on flat faces up to half of these digits;
// all others agree to the last.
bool is_as_in_many_digits(const Named_mesh& m, std::size_t source, std::size_t bound)
{
  SCOPED_TRACE(m.name + ", from " + std::to_string(source));
  const Triangulation t(m.mesh);
  const Vertex_index v(static_cast<unsigned>(source));
  const auto truth = Unfolding<Quad>(t.input()).distances(source, bound);
  if(!truth)
    return false;
  Paths paths(t.input());
  paths.add_source(v);
  paths.run();
  const double farthest = *std::max_element(truth->begin(), truth->end());
  for(Vertex_index w : m.mesh.vertices())
    EXPECT_NEAR(paths.distance(w), (*truth)[w.idx()], 1e-7 * farthest) << w;
  return true;
}

TEST(Shortest_paths, on_hard_meshes_as_in_many_digits)
{
  std::size_t compared = 0;
  for(std::uint64_t seed = 0; seed < 300; ++seed) {
    const Named_mesh m = seed < 240 ? hard_mesh(seed) : near_degenerate_mesh(unsigned(seed));
    if(m.mesh.number_of_faces() <= 140)
      compared += is_as_in_many_digits(m, 7 * seed % m.mesh.number_of_vertices(), 20000);
  }
  EXPECT_GT(compared, 30u);
}

// Paths pass vertices within rounding, very near to their start, or several vertices at one
// position.
TEST(Shortest_paths, that_pass_vertices_within_rounding)
{
  for(const auto& [seed, source] :
      std::vector<std::pair<std::uint64_t, std::size_t>>{{32, 84}, {39, 432}, {138, 180}})
    EXPECT_TRUE(is_as_in_many_digits(hard_mesh(seed), source, 10000000));
}

// By rounding, each of two views can come before the other one, so that separating them would not
// end. Distances are the same in both directions.
TEST(Shortest_paths, from_all_vertices_of_Delaunay_triangulations)
{
  for(const std::uint64_t seed : {24u, 36u, 98u}) {
    SCOPED_TRACE(seed);
    Triangulation t(hard_mesh(seed).mesh);
    IT::make_Delaunay(t);
    std::vector<std::vector<double>> distance;
    for(Vertex_index v : t.mesh().vertices()) {
      IT::Shortest_paths paths(t.intrinsic());
      paths.add_source(v);
      paths.run();
      distance.emplace_back();
      for(Vertex_index w : t.mesh().vertices())
        distance.back().push_back(paths.distance(w));
    }
    for(std::size_t v = 0; v < distance.size(); ++v)
      for(std::size_t w = 0; w < v; ++w)
        EXPECT_NEAR(distance[v][w], distance[w][v], 1e-9 * distance[v][w] + 1e-13) << v << ' ' << w;
  }
}

// Rounded directions miss paths on one of the two triangulations.
TEST(Shortest_paths, of_either_triangulation)
{
  for(const std::uint64_t seed : {38u, 68u, 84u, 108u}) {
    SCOPED_TRACE(seed);
    Triangulation t(hard_mesh(seed).mesh);
    IT::make_Delaunay(t);
    std::vector<std::vector<double>> distance;
    for(Vertex_index v : t.mesh().vertices())
      distance.push_back(
        IT::geodesic_distances(t, v, IT::parameters::distance_method(IT::Distance_method::exact))
          .distance);
    for(std::size_t v = 0; v < distance.size(); ++v)
      for(std::size_t w = 0; w < v; ++w)
        EXPECT_NEAR(distance[v][w], distance[w][v], 1e-7);
  }
}

// With integer coordinates, shortest paths run along edges, through flat vertices, and are not
// unique.
TEST(Shortest_paths, with_ties)
{
  for(std::uint64_t seed : seeds(40))
    check_itself(Triangulation(tied_mesh(seed).mesh), Side::input);
}

Mesh box(double x, double y, double z)
{
  Mesh mesh = cube();
  for(Vertex_index v : mesh.vertices())
    mesh.point(v) = Point(x * mesh.point(v).x(), y * mesh.point(v).y(), z * mesh.point(v).z());
  return mesh;
}

// In Dudeney's puzzle, the spider walks 40 feet, over five of the six sides of the room.
TEST(Shortest_paths, spider_and_fly)
{
  const Mesh room = box(30, 12, 12);
  const Triangulation t(room);
  const Flat_faces faces(Side::input, t);
  Paths paths(t.input());
  paths.add_source(locate({0, 6, 11}, room));
  paths.run();
  const Location fly = locate({30, 6, 1}, room);
  EXPECT_NEAR(paths.distance(fly), 40, 1e-13);
  expect_valid(paths.path(fly), faces, 1e-13);
}

TEST(Shortest_paths, on_cones)
{
  for(const Cone& cone : cones()) {
    CGAL::Random random(2);
    for(int i = 0; i < 30; ++i) {
      const auto place = [&] {
        const Complex v = std::polar(random.get_double(0.1, 1), random.get_double(-pi, pi));
        return IT::trace_geodesic(cone.mesh.input(), cone.apex, v).end;
      };
      const Location p = place(), q = place();
      const Complex from = cone.polar(p), to = cone.polar(q);
      const double turn = std::abs(std::remainder(to.imag() - from.imag(), cone.total));
      Paths paths(cone.mesh.input());
      paths.add_source(p);
      paths.run();
      const Path path = paths.path(q);
      EXPECT_NEAR(path.length,
                  turn < pi ? std::abs(std::polar(to.real(), turn) - from.real())
                            : from.real() + to.real(),
                  1e-12);
      const auto passes_apex = [&](const Path_place& x) {
        return is_vertex(x) && cone.mesh.input_mesh().source(along(x)) == cone.apex;
      };
      EXPECT_EQ(std::any_of(path.places.begin(), path.places.end(), passes_apex), turn >= pi);
    }
  }
}

// Paths around a flat cylinder are straight lines in the plane modulo its girth.
TEST(Shortest_paths, on_cylinders)
{
  for(int twists = 0; twists < 3; ++twists) {
    const Flat_surface surface = flat_cylinder(5, twists);
    Flat_triangulation flat(surface);
    const Flat_places places(Side::input, flat);
    CGAL::Random random(3);
    for(int i = 0; i < 20; ++i) {
      const Location p = random_location(flat->input_mesh(), random);
      const Location q = random_location(flat->input_mesh(), random);
      Paths paths(flat->input());
      paths.add_source(p);
      paths.run();
      const Complex d = places.place(p) - places.place(q);
      const double girth = static_cast<double>(surface.a.x);
      EXPECT_NEAR(paths.distance(q), std::hypot(std::remainder(d.real(), girth), d.imag()), 1e-9);
      expect_valid(paths.path(q), places.faces(), 1e-9);
    }
  }
}

// The surface consists of four unit squares without the first one. The path from corner to corner
// bends at their common corner.
TEST(Shortest_paths, bend_at_the_boundary)
{
  const Triangulation t(
    punctured(grid(2, 2, [](double x, double y) { return Point(x, y, 0); }), {0, 1}));
  Paths paths(t.input());
  paths.add_source(Vertex_index(1));
  paths.run();
  const Path path = paths.path(Vertex_index(3));
  ASSERT_EQ(path.places.size(), 3u);
  for(std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(t.input_mesh().source(along(path.places[k])),
              Vertex_index(static_cast<unsigned>(std::array{1, 4, 3}[k])));
  EXPECT_EQ(path.length, 2);
}

// Distances in a square are known, and powers of two change no digit of them.
TEST(Shortest_paths, are_the_same_at_all_scales)
{
  std::vector<double> expected;
  for(const int exponent : {0, -100, 60, 100}) {
    const double s = std::ldexp(1, exponent);
    const Mesh mesh = grid(6, 6, [s](double x, double y) {
      return Point(s * (3 * x - 1.7 * y), s * (1.7 * x + 3 * y), 0);
    });
    const Triangulation t(mesh);
    std::vector<double> found;
    for(const auto v : vertices(mesh)) {
      Paths paths(t.input());
      paths.add_source(v);
      paths.run();
      for(const auto w : vertices(mesh)) {
        found.push_back(paths.distance(w) / s);
        const double truth = std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w))) / s;
        EXPECT_NEAR(found.back(), truth, 1e-12) << exponent;
      }
    }
    if(exponent == 0)
      expected = found;
    EXPECT_EQ(found, expected) << exponent;
  }
}

// A source that is added later counts only if it is nearer.
TEST(Shortest_paths, sources_one_after_the_other)
{
  const Triangulation t(random_sphere(60, 5));
  CGAL::Random random(4);
  Paths paths(t.input()), all(t.input());
  std::vector<Location> sources;
  for(int i = 0; i < 6; ++i) {
    sources.push_back(random_location(t.input_mesh(), random));
    paths.add_source(sources.back());
    all.add_source(sources.back());
    paths.run();
  }
  all.run();
  for(int i = 0; i < 100; ++i) {
    const Location q = random_location(t.input_mesh(), random);
    EXPECT_NEAR(paths.distance(q), all.distance(q), 1e-14);
    double nearest = infinity;
    std::size_t source = 0;
    for(std::size_t k = 0; k < sources.size(); ++k) {
      Paths one(t.input());
      one.add_source(sources[k]);
      one.run();
      if(one.distance(q) < nearest) {
        nearest = one.distance(q);
        source = k;
      }
    }
    EXPECT_NEAR(all.distance(q), nearest, 1e-14);
    EXPECT_EQ(all.source(q), source);
  }
}

// On T1 and T2 distances are equal.
TEST(Shortest_paths, after_Delaunay_flips)
{
  Triangulation t(perturbed(embedded_torus(9, 7), 0.4, 5));
  IT::make_Delaunay(t);
  const Correspondence c(t);
  CGAL::Random random(5);
  const Location p = random_location(t.mesh(), random);
  Paths on_input(t.input()), on_intrinsic(t.intrinsic());
  on_intrinsic.add_source(p);
  on_input.add_source(IT::point_across(c, Side::intrinsic, p));
  on_input.run();
  on_intrinsic.run();
  for(int i = 0; i < 100; ++i) {
    const Location q = random_location(t.mesh(), random);
    EXPECT_NEAR(on_intrinsic.distance(q),
                on_input.distance(IT::point_across(c, Side::intrinsic, q)), 1e-12);
    expect_valid(on_intrinsic.path(q), Flat_faces(Side::intrinsic, t), 1e-12);
  }
}

TEST(Shortest_paths, other_component)
{
  Mesh mesh = tetrahedron();
  mesh.join(cube());
  const Triangulation t(mesh);
  Paths paths(t.input());
  paths.add_source(Vertex_index(0));
  paths.run();
  EXPECT_EQ(paths.distance(Vertex_index(7)), infinity);
  EXPECT_TRUE(paths.path(Vertex_index(7)).places.empty());
  EXPECT_EQ(paths.path(Vertex_index(0)).places.size(), 1u);
}

// The smallest surfaces are isolated vertices, one face, two faces on all of their sides, and
// sources at one position.
TEST(Shortest_paths, on_the_smallest_surfaces)
{
  Mesh isolated = make_mesh({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}});
  const Vertex_index alone = isolated.add_vertex(Point(5, 5, 5));
  const Triangulation t(isolated);
  Paths paths(t.input());
  EXPECT_EQ(paths.add_source(alone), 0u);
  paths.run();
  EXPECT_EQ(paths.distance(alone), 0);
  EXPECT_EQ(paths.source(alone), 0u);
  EXPECT_EQ(paths.path(alone).length, 0);
  EXPECT_TRUE(paths.path(alone).places.empty());
  EXPECT_EQ(paths.distance(Vertex_index(0)), infinity);
  EXPECT_EQ(paths.add_source(Vertex_index(0)), 1u);
  EXPECT_EQ(paths.add_source(Vertex_index(0)), 2u);
  paths.run();
  EXPECT_EQ(paths.distance(alone), 0);
  EXPECT_EQ(paths.distance(Vertex_index(1)), 1);
  EXPECT_EQ(paths.source(Vertex_index(1)), 1u);

  const auto pillow = glue({{1, 2, 3}, {-3, -2, -1}});
  const Triangulation p = triangulation(pillow, std::vector<double>(3, 1));
  Paths on_pillow(p.input());
  on_pillow.add_source(Location(Face_index(0), {1. / 3, 1. / 3, 1. / 3}));
  on_pillow.run();
  EXPECT_NEAR(on_pillow.distance(Location(Face_index(1), {1. / 3, 1. / 3, 1. / 3})),
              1 / std::sqrt(3.), 1e-15);
}

} // namespace Test_shortest_paths
