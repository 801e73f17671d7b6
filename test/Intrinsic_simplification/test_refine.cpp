// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests refine after simplification, and compose maps.

#include "simplified_surfaces.h"

#include <CGAL/Intrinsic_simplification/Composed_map.h>
#include <CGAL/Intrinsic_simplification/Correspondence_map.h>
#include <CGAL/Intrinsic_simplification/Surface_subdivision.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>

namespace Test_refine {

using namespace Test_surfaces;
using IS::Composed_map;
using IS::Correspondence_map;
using IT::Refinement_result;
using IT::Refinement_status;

double least_angle(Face_index f, const Evolving_surface& s)
{
  double result = 180;
  for(Halfedge_index h : IT::sides(f, s.mesh()))
    result = (std::min)(result, angle_at(h, s.mesh(), lengths_of(s)) * 180 / pi);
  return result;
}

// Checks that faces satisfy the bound or are in the result, and all edges are Delaunay.
void expect_refined(const Evolving_surface& s, double angle, const Refinement_result& result)
{
  ASSERT_TRUE(IT::is_valid_Delta_complex(s.mesh()));
  std::vector<Face_index> remaining;
  for(const auto& f : result.remaining)
    remaining.push_back(f.face);
  for(Face_index f : s.mesh().faces()) {
    const bool is_left = std::count(remaining.begin(), remaining.end(), f) > 0;
    EXPECT_TRUE(is_left ? least_angle(f, s) < angle + 1e-6 : least_angle(f, s) > angle - 1e-6);
  }
  for(Edge_index e : s.mesh().edges()) {
    const Halfedge_index h = s.mesh().halfedge(e);
    if(!s.mesh().is_border(e) && s.surface().can_be_turned(h)) {
      const double opposite = angle_at(s.mesh().prev(h), s.mesh(), lengths_of(s)) +
                              angle_at(s.mesh().prev(IT::opposite(h)), s.mesh(), lengths_of(s));
      EXPECT_LE(opposite, pi + 1e-6);
    }
  }
}

template <typename Visit>
void for_each_random_point(const Delta_complex& mesh, const Visit& visit)
{
  CGAL::Random random(3);
  for(Face_index f : mesh.faces())
    for(int n = 0; n < 3; ++n)
      visit(Location{f, random_coordinates(random)});
}

// Checks that points are mapped back to themselves, also through the intermediate surface.
template <typename First, typename Second, typename Map>
void expect_composed(const First& first, const Second& second, const Map& map)
{
  const Delta_complex &fine = map.fine().mesh(), &coarse = map.coarse().mesh();
  for_each_random_point(fine, [&](const Location& p) {
    const Location q = map.to_coarse(p);
    expect_same_place(second.to_coarse(first.to_coarse(p)), q, coarse);
    expect_same_place(map.to_fine(q), p, fine);
  });
  for_each_random_point(coarse, [&](const Location& q) {
    const Location p = map.to_fine(q);
    expect_same_place(first.to_fine(second.to_fine(q)), p, fine);
    expect_same_place(map.to_coarse(p), q, coarse);
  });
}

TEST(Refine, obeys_the_bound)
{
  for_each_simplified_surface([](const Simplified& s, const Surface_map&) {
    for(const double angle : {15., 25., 30.}) {
      Evolving_surface surface = s.surface;
      const Refinement_result result = IS::refine(surface, IS::parameters::minimum_angle(angle));
      expect_refined(surface, angle, result);
      EXPECT_NE(result.status, Refinement_status::no_room);
      EXPECT_EQ(surface.mesh().number_of_vertices(),
                s.coarse.mesh().number_of_vertices() + result.insertions - result.removals);
      EXPECT_EQ(Euler_characteristic(surface.mesh()), Euler_characteristic(s.coarse.mesh()));
      const double area = area_of(s.surface.mesh(), lengths_of(s.surface));
      EXPECT_NEAR(area_of(surface.mesh(), lengths_of(surface)), area, 1e-9 * area);
    }
  });
}

// The intermediate surface is the coarse one, and the map from it to its refinement is an isometry:
// the map of integer coordinates.
TEST(Refine, makes_what_integer_coordinates_make)
{
  std::size_t inserted = 0;
  for_each_simplified_surface([&](const Simplified& s, const Surface_map&) {
    IT::Intrinsic_triangulation<> tri = s.coarse.triangulation();
    IT::refine(tri);
    const Simplified r = refined_after(s, 25);
    const Surface_map map(r.surface, s.coarse, r.coarse);
    std::vector<double> by_coordinates, by_history;
    for(Edge_index e : tri.mesh().edges())
      by_coordinates.push_back(tri.length(e));
    for(Edge_index e : r.coarse.mesh().edges())
      by_history.push_back(r.coarse.length_map()[e]);
    std::sort(by_coordinates.begin(), by_coordinates.end());
    std::sort(by_history.begin(), by_history.end());
    EXPECT_EQ(by_history, by_coordinates);
    for(Vertex_index v : r.coarse.mesh().vertices()) {
      if(s.coarse.level_vertex(r.coarse.surface_vertex(v)).is_valid())
        continue;
      ++inserted;
      const Location p = IS::preimage_of_vertex(v, map);
      EXPECT_TRUE(std::any_of(tri.inserted_vertices().begin(), tri.inserted_vertices().end(),
                              [&](const auto& m) {
                                const Location q = IT::face_location(m, tri.input_mesh());
                                return are_near(p, q) || meet_at_edge(p, q, s.coarse.mesh());
                              }));
    }
  });
  EXPECT_GT(inserted, 50u);
}

TEST(Refine, maps_are_composed)
{
  for_each_simplified_surface([](const Simplified& s, const Surface_map& first) {
    const Simplified r = refined_after(s, 25);
    const Surface_map second(r.surface, s.coarse, r.coarse), whole(r.surface, s.fine, r.coarse);
    expect_composed(first, second, whole);
  });
}

// A linear function in the plane has a linear prolongation.
TEST(Refine, prolongs_linear_functions_on_a_flat_polygon)
{
  for_each_flat_polygon([](const Mesh& mesh, const Simplified& s, const Surface_map&) {
    const Simplified r = refined_after(s, 25);
    const Surface_map map(r.surface, r.fine, r.coarse);
    const auto value = [](const Point& p) { return p.x() - 2 * p.y() + 3; };
    Eigen::VectorXd fine(mesh.number_of_vertices()), coarse(r.coarse.mesh().number_of_vertices());
    for(Vertex_index v : mesh.vertices())
      fine[v.idx()] = value(mesh.point(v));
    for(Vertex_index v : r.coarse.mesh().vertices())
      coarse[v.idx()] = value(place(IS::preimage_of_vertex(v, map), r.fine, mesh));
    EXPECT_LT((IS::prolongation_matrix(map) * coarse - fine).cwiseAbs().maxCoeff(), 1e-9);
  });
}

TEST(Refine, restriction_is_a_mean)
{
  for_each_simplified_surface([](const Simplified& s, const Surface_map&) {
    const Simplified r = refined_after(s, 30);
    const Surface_map map(r.surface, r.fine, r.coarse);
    const Eigen::SparseMatrix<double> matrix =
      IS::restriction_matrix(IS::prolongation_matrix(map), map);
    const Eigen::VectorXd ones = matrix * Eigen::VectorXd::Ones(matrix.cols());
    for(Eigen::Index v = 0; v < ones.size(); ++v)
      EXPECT_NEAR(ones[v], 1, 1e-12);
  });
}

// Without scaling, the common subdivision has the lengths of coarse edges.
TEST(Refine, keeps_lengths_in_the_plane)
{
  for_each_flat_polygon([](const Mesh& mesh, const Simplified& s, const Surface_map&) {
    const Simplified r = refined_after(s, 25);
    const Surface_map map(r.surface, r.fine, r.coarse);
    const IS::Surface_subdivision<> subdivision(map);
    const auto point = [&](Vertex_index v) {
      return place(IT::face_location(subdivision.place(IS::Level::fine, v), r.fine.mesh()), r.fine,
                   mesh);
    };
    for(Edge_index e : r.coarse.mesh().edges()) {
      double sum = 0;
      for(Halfedge_index h : subdivision.parts_of_coarse_edge(e))
        sum += std::sqrt(CGAL::squared_distance(point(subdivision.mesh().source(h)),
                                                point(subdivision.mesh().target(h))));
      EXPECT_NEAR(sum, r.coarse.length_map()[e], 1e-9);
    }
  });
}

// Simplification can continue: inserted vertices are removed again, and the surface is refined once
// more. Then a curve may return from an edge of the fine level into its previous face. The result
// is a subdivision or an error with this name.
TEST(Refine, takes_turns_with_simplification)
{
  for(const Mesh& mesh : {random_sphere(300, 4), punctured(random_sphere(200, 5), {3}),
                          punctured(random_sphere(200, 1083), {3})}) {
    Evolving_surface surface(mesh);
    const Surface_level fine(surface);
    for(const std::size_t n : {100u, 40u, 20u}) {
      simplify(surface, number_of_vertices(n));
      expect_refined(surface, 25, IS::refine(surface));
      const Surface_level coarse(surface);
      const Surface_map map(surface, fine, coarse);
      for_each_random_point(fine.mesh(), [&](const Location& p) {
        expect_same_place(map.to_fine(map.to_coarse(p)), p, fine.mesh());
      });
      const IS::Surface_subdivision<> subdivision(map,
                                                  IS::Surface_subdivision<>::Bends::of_all_edges);
      EXPECT_EQ(Euler_characteristic(subdivision.mesh()), Euler_characteristic(fine.mesh()));
    }
  }
}

// Checks that the subdivision has the topology and the areas of both levels.
void expect_subdivided(const Evolving_surface& surface, const Surface_level& fine)
{
  const Surface_level coarse(surface);
  const IS::Surface_subdivision<> subdivision(Surface_map(surface, fine, coarse));
  EXPECT_EQ(Euler_characteristic(subdivision.mesh()), Euler_characteristic(fine.mesh()));
  for(const IS::Level side : {IS::Level::fine, IS::Level::coarse}) {
    double parts = 0;
    for(Face_index f : subdivision.mesh().faces())
      parts += subdivision.signed_area(side, f);
    const Surface_level& level = side == IS::Level::fine ? fine : coarse;
    const double whole = area_of(level.mesh(), level.length_map());
    EXPECT_NEAR(parts, whole, 1e-7 * whole);
  }
}

// Coarse edges run side by side for long, around a tube or, through inserted vertices, in circles.
// The subdivision ends.
TEST(Refine, subdivides_with_curves_that_do_not_separate)
{
  for(const unsigned int seed : traced({3u, 10u, 77u, 211u})) {
    const Mesh mesh = near_degenerate_mesh(seed).mesh;
    Evolving_surface surface(mesh);
    const Surface_level fine(surface);
    simplify(surface, number_of_vertices(mesh.number_of_vertices() * 3 / 10 + 1));
    IS::refine(surface, IS::parameters::minimum_angle(20).maximum_number_of_insertions(3000));
    expect_subdivided(surface, fine);
  }
}

// Moves a vertex to the origin, and inserts vertices close to it.
Mesh with_vertices_at_origin(Mesh mesh, double distance, CGAL::Random& random)
{
  const Vertex_index v(0);
  const Point center = mesh.point(v);
  for(Vertex_index w : mesh.vertices())
    mesh.point(w) = CGAL::ORIGIN + (mesh.point(w) - center);
  for(const double d : {100 * distance, 10 * distance, distance}) {
    const Halfedge_index h = mesh.halfedge(v);
    const Point p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(mesh.next(h)));
    const double x = d * random.get_double(1, 8), y = d * random.get_double(1, 8);
    const Vertex_index near = mesh.target(CGAL::Euler::add_center_vertex(h, mesh));
    mesh.point(near) = CGAL::ORIGIN + x * (p - CGAL::ORIGIN) + y * (q - CGAL::ORIGIN);
  }
  return mesh;
}

// Refinement inserts vertices and edges whose distances from a vertex are far below the rounding
// unit of the faces around it. Most of these subdivisions are found, and are right then.
TEST(Refine, subdivides_around_vertices_closer_than_rounding)
{
  CGAL::Random random(1);
  std::size_t tried = 0, failed = 0;
  for(const double distance : traced({1e-12, 1e-16, 1e-20, 1e-28}))
    for(const unsigned int seed : seeds(10)) {
      const Mesh mesh = with_vertices_at_origin(random_sphere(20, seed), distance, random);
      Evolving_surface surface(mesh);
      const Surface_level fine(surface);
      simplify(surface, number_of_vertices(10));
      IS::refine(surface, IS::parameters::minimum_angle(20.));
      ++tried;
      try {
        expect_subdivided(surface, fine);
      } catch(const IT::Numerical_error&) {
        ++failed;
      }
    }
  EXPECT_LE(10 * failed, tried);
}

// The parts of a constrained edge stay together.
TEST(Refine, splits_constrained_edges)
{
  const Mesh mesh = random_sphere(60, 6);
  const auto is_constrained =
    boost::make_function_property_map<Edge_index>([](Edge_index e) { return e.idx() % 17 == 0; });
  Evolving_surface surface(mesh, IS::parameters::edge_is_constrained_map(is_constrained));
  simplify(surface, number_of_vertices(std::size_t(0)));
  const auto length = [&] {
    double sum = 0;
    for(Edge_index e : surface.mesh().edges())
      sum += surface.surface().is_constrained(e) ? surface.surface().length(e) : 0;
    return sum;
  };
  const double before = length();
  const Surface_level coarse(surface);
  expect_refined(surface, 25, IS::refine(surface));
  EXPECT_GT(surface.mesh().number_of_vertices(), coarse.mesh().number_of_vertices());
  EXPECT_NEAR(length(), before, 1e-12 * before);
  const Surface_level refined(surface);
  EXPECT_NO_THROW(IS::Surface_subdivision<>(Surface_map(surface, coarse, refined)));
}

// If rounding leaves decisions undecided, refinement restarts, and so does the history.
TEST(Refine, starts_anew_with_exact_decisions)
{
  struct Restart_counter : IT::Default_refinement_visitor
  {
    void before_exact_flips() { ++restarts; }
    void before_exact_refinement() { ++restarts; }
    int restarts = 0;
  };
  Restart_counter counter;
  for(unsigned seed : traced({1u, 4u, 5u, 9u, 10u})) {
    Evolving_surface surface(hard_mesh(seed).mesh);
    const Surface_level fine(surface);
    IS::refine(surface,
               IS::parameters::maximum_number_of_insertions(5000).visitor(std::ref(counter)));
    const Surface_level refined(surface);
    ASSERT_TRUE(IT::is_valid_Delta_complex(refined.mesh()));
    const Surface_map map(surface, fine, refined);
    for(Vertex_index v : fine.mesh().vertices())
      EXPECT_TRUE(map.coarse_vertex(v).is_valid());
  }
  EXPECT_GT(counter.restarts, 0);
}

TEST(Refine, with_exact_decisions)
{
  for_each_simplified_random_surface([](const Simplified& s, const Surface_map& first) {
    Evolving_surface surface = s.surface;
    const Refinement_result result = IS::refine(surface, IS::parameters::exact_decisions(true));
    EXPECT_TRUE(result.is_exact);
    expect_refined(surface, 25, result);
    const Surface_level refined(surface);
    expect_composed(first, Surface_map(surface, s.coarse, refined),
                    Surface_map(surface, s.fine, refined));
  });
}

// ---- Maps of several kinds ----

// The map leads from a mesh to its refinement by integer coordinates, to its simplification by a
// history, and to a refinement by integer coordinates.
TEST(Composed_map, of_integer_coordinates_and_histories)
{
  for(const Named_mesh& m : traced(meshes())) {
    IT::Intrinsic_triangulation<> start(m.mesh);
    IT::refine(start);
    start.collect_garbage();
    const Simplified s(Evolving_surface(start), start.mesh().number_of_vertices() / 2);
    IT::Intrinsic_triangulation<> end = s.coarse.triangulation();
    IT::refine(end, IS::parameters::minimum_angle(28.));
    end.collect_garbage();
    const Correspondence_map first(start), third(end);
    const Surface_map second(s.surface, s.fine, s.coarse);
    const Composed_map both(first, second);
    const Composed_map all(both, third);
    expect_composed(first, second, both);
    expect_composed(both, third, all);
    EXPECT_EQ(&all.fine().mesh(), &start.input_mesh());
    EXPECT_EQ(&all.coarse().mesh(), &end.mesh());
    const Eigen::SparseMatrix<double, Eigen::RowMajor> p = IS::prolongation_matrix(all);
    for(Vertex_index v : m.mesh.vertices()) {
      const int row = static_cast<int>(v);
      EXPECT_NEAR(p.row(row).sum(), 1, 1e-12);
      const Vertex_index w = all.coarse_vertex(v);
      EXPECT_TRUE(!w.is_valid() || p.coeff(row, static_cast<int>(w)) == 1);
    }
  }
}

} // namespace Test_refine
