// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "equality.h"
#include "near_degenerate_meshes.h"
#include "refinement_checks.h"

#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

namespace Test_refine {

using namespace Test_surfaces;
using IT::Refinement_result;
using IT::Refinement_status;
using IT::Remaining_face;
using IT::Remaining_reason;
using IT::Side;

typedef Eigen::VectorXd Values;

// ---- Independent measures, in long double and by the law of cosines ----

Real area(Side side, const Triangulation& t)
{
  const Delta_complex& mesh = side == Side::input ? t.input_mesh() : t.mesh();
  const auto& length = side == Side::input ? t.input_length_map() : t.length_map();
  Real sum = 0;
  for(Face_index f : mesh.faces()) {
    const auto h = IT::sides(f, mesh);
    const Real a = length[mesh.edge(h[0])], b = length[mesh.edge(h[1])],
               c = length[mesh.edge(h[2])];
    sum +=
      std::sqrt((std::max)((a + b + c) * (a + b - c) * (a - b + c) * (b + c - a), Real(0))) / 4;
  }
  return sum;
}

// ---- What every refinement must fulfil ----

void check_structure(const Triangulation& t)
{
  EXPECT_TRUE(t.is_valid(true));
  EXPECT_FALSE(t.mesh().has_garbage());
  EXPECT_TRUE(IT::is_Delaunay(t));
  EXPECT_NEAR(static_cast<double>(area(Side::intrinsic, t) / area(Side::input, t)), 1, 1e-11);
  const IT::Correspondence<> c(t);
  const IT::Common_subdivision<> s(c);
  EXPECT_TRUE(s.mesh().is_valid());
  EXPECT_EQ(Euler_characteristic(s.mesh()), Euler_characteristic(t.input_mesh()));
  EXPECT_EQ(s.mesh().number_of_vertices(), t.mesh().number_of_vertices() + c.number_of_crossings());
}

void check_refined(Triangulation t, double degrees)
{
  const auto vertices = t.mesh().number_of_vertices();
  const Refinement_result result = IT::refine(t, IT::parameters::minimum_angle(degrees));
  EXPECT_EQ(t.mesh().number_of_vertices(), vertices + result.insertions - result.removals);
  EXPECT_EQ(t.number_of_inserted_vertices(), result.insertions - result.removals);
  check_structure(t);
  check_angles(t, degrees, result);
}

bool is_closed(const Delta_complex& mesh)
{
  const auto edges = mesh.edges();
  return std::none_of(edges.begin(), edges.end(), [&](Edge_index e) { return mesh.is_border(e); });
}

// Returns 30 degrees if refinement is proved to end, in exact arithmetic, otherwise 25, which is
// measured.
double highest_bound(const Triangulation& t)
{
  return is_closed(t.input_mesh()) && small_angle_vertices(t).empty() ? 30 : 25;
}

TEST(Refine, small_meshes)
{
  for(const Named_mesh& m : traced(meshes())) {
    const Triangulation t(m.mesh);
    check_refined(t, highest_bound(t));
  }
}

TEST(Refine, Delta_complexes)
{
  for(const auto& [c, seed] : traced(complexes(), 4)) {
    const Triangulation t = triangulation(c.mesh, random_lengths(c.mesh, seed));
    check_refined(t, highest_bound(t));
  }
}

TEST(Refine, triangulations_far_from_Delaunay)
{
  for(const Named_triangulation& t : traced(triangulations()))
    check_refined(t.triangulation, 25);
}

TEST(Refine, data_meshes)
{
  for_each_data_mesh(400000, [](const Mesh& mesh) {
    Triangulation t(mesh);
    check_refined(t, highest_bound(t));
  });
}

TEST(Refine, same_bytes_every_time)
{
  Triangulation a(embedded_torus(5, 4)), b(embedded_torus(5, 4));
  IT::refine(a);
  IT::refine(b);
  EXPECT_GT(a.number_of_inserted_vertices(), 0u);
  EXPECT_EQ(text_of(a), text_of(b));
}

TEST(Refine, again_changes_nothing)
{
  Triangulation t(random_sphere(60, 4));
  IT::refine(t);
  const std::string before = text_of(t);
  const Refinement_result again = IT::refine(t);
  EXPECT_EQ(again.insertions, 0u);
  EXPECT_EQ(text_of(t), before);
}

// ---- Bounds and limits ----

TEST(Refine, maximum_circumradius)
{
  Triangulation t(unit_square(1, 0));
  const double radius = 0.03;
  const auto result = IT::refine(t, IT::parameters::maximum_circumradius(radius));
  EXPECT_EQ(result.status, Refinement_status::bounds_met);
  for(Face_index f : t.mesh().faces()) {
    const auto h = IT::sides(f, t.mesh());
    const Real side = t.length(t.mesh().edge(h[0]));
    EXPECT_LE(side / (2 * std::sin(angle_in_degrees(h[2], t.mesh(), t.length_map()) * pi / 180)),
              radius * (1 + 1e-12));
  }
  check_structure(t);
  check_angles(t, 25, result);
}

TEST(Refine, face_predicate)
{
  Triangulation t(random_sphere(30, 2));
  const auto has_first_vertex = [&](Face_index f) { // with a side that is not short
    for(Halfedge_index h : IT::sides(f, t.mesh()))
      if(t.mesh().source(h) == Vertex_index(0) && t.length(t.mesh().edge(h)) > 0.05)
        return true;
    return false;
  };
  const auto result = IT::refine(t, IT::parameters::face_predicate(has_first_vertex));
  EXPECT_EQ(result.status, Refinement_status::bounds_met);
  for(Face_index f : t.mesh().faces())
    EXPECT_FALSE(has_first_vertex(f));
  check_structure(t);
}

TEST(Refine, number_of_insertions)
{
  Triangulation t(random_sphere(100, 3));
  const auto result = IT::refine(t, IT::parameters::maximum_number_of_insertions(std::size_t(7)));
  EXPECT_EQ(result.status, Refinement_status::insertion_limit);
  EXPECT_EQ(result.insertions, 7u);
  check_structure(t);
  EXPECT_FALSE(result.remaining.empty());
  check_angles(t, 25, result);
}

// Beyond 30 degrees the default is small, unless circumradii are bounded.
TEST(Refine, default_number_of_insertions)
{
  const double any = std::numeric_limits<double>::infinity();
  EXPECT_EQ(IT::default_maximum_number_of_insertions(1000, 30., any), 1020000u);
  EXPECT_EQ(IT::default_maximum_number_of_insertions(1000, 40., 1.), 10000000u);
  EXPECT_EQ(IT::default_maximum_number_of_insertions(1000, 30.5, any), 120000u);
  EXPECT_EQ(IT::default_maximum_number_of_insertions(10000000, 31., any), 10000000u);
  Triangulation t(random_sphere(50, 3));
  const auto result = IT::refine(t, IT::parameters::minimum_angle(45));
  EXPECT_EQ(result.status, Refinement_status::insertion_limit);
  EXPECT_EQ(result.insertions, 100000 + 20 * t.input_mesh().number_of_faces());
  EXPECT_FALSE(result.remaining.empty());
}

// Faces with a circumradius have at most the area of the equilateral triangle.
TEST(Refine, bounds_that_need_too_many_insertions)
{
  const Mesh mesh = random_sphere(50, 3);
  for(const double radius : {1e-3, 1e-20, 1e-320}) {
    Triangulation t(mesh);
    EXPECT_THROW(IT::refine(t, IT::parameters::maximum_circumradius(1e-3 * radius)),
                 IT::Invalid_input);
    EXPECT_EQ(t.number_of_inserted_vertices(), 0u);
    const auto result =
      IT::refine(t, IT::parameters::maximum_circumradius(radius).maximum_number_of_insertions(10));
    EXPECT_EQ(result.status, Refinement_status::insertion_limit);
    EXPECT_EQ(result.insertions, 10u);
  }
  for(const double radius : {0.2, 0.1, 0.05}) {
    Triangulation t(mesh);
    const double least = IT::least_number_of_insertions(t, radius);
    EXPECT_GT(least, 0);
    const auto result = IT::refine(t, IT::parameters::maximum_circumradius(radius));
    EXPECT_GE(double(result.insertions - result.removals), least);
    EXPECT_LE(double(result.insertions - result.removals), 10 * least);
  }
}

// Faces are as wide as a tube that is 10,000 times as long as its circumference, so the edges of
// the input are crossed thousands of times.
TEST(Refine, a_long_tube)
{
  Triangulation t(stretched_along_x(cube(), 40000));
  const auto result = IT::refine(t);
  EXPECT_EQ(result.status, Refinement_status::bounds_met);
  EXPECT_GT(result.insertions, 5000u);
  EXPECT_TRUE(IT::certify_Delaunay(t).is_Delaunay());
  check_structure(t);
  check_angles(t, 25, result);
}

TEST(Refine, number_of_flips)
{
  const Triangulation delaunay = [] {
    Triangulation t(random_sphere(100, 3));
    IT::make_Delaunay(t);
    return t;
  }();
  Triangulation t = delaunay;
  EXPECT_THROW(IT::refine(t, CGAL::parameters::number_of_iterations(std::size_t(0))),
               IT::Flip_limit_exceeded);
  EXPECT_GT(t.number_of_inserted_vertices(), 0u);
  EXPECT_FALSE(t.mesh().has_garbage());
  EXPECT_TRUE(t.is_valid(true));
  IT::refine(t); // goes on from there
  check_structure(t);
  Triangulation with_limit = delaunay, without = delaunay;
  IT::refine(with_limit, CGAL::parameters::number_of_iterations(std::size_t(1000)));
  IT::refine(without);
  EXPECT_EQ(text_of(with_limit), text_of(without));
}

// ---- Visitors ----

// Counts what it sees, and throws `Error` after a given number of changes.
template <typename Error>
struct Counter : IT::Default_refinement_visitor
{
  explicit Counter(std::size_t limit) : limit(limit) {}

  void after_flip(Halfedge_index) { note(flips); }
  void after_insertion(Vertex_index v, const IT::Vertex_inserter<>& inserter)
  {
    EXPECT_TRUE(inserter.triangulation().is_inserted(v));
    note(insertions);
  }
  void after_removal(Vertex_index, Face_index) { note(removals); }

  void note(std::size_t& count)
  {
    ++count;
    if(flips + insertions + removals == limit)
      throw Error("enough");
  }

  std::size_t limit, flips = 0, insertions = 0, removals = 0;
};

template <typename Error>
void check_stopped(const Triangulation& given, std::size_t limit)
{
  Triangulation t = given;
  Counter<Error> counter(limit);
  EXPECT_THROW(IT::refine(t, CGAL::parameters::visitor(std::ref(counter))), Error);
  EXPECT_EQ(counter.flips + counter.insertions + counter.removals, limit);
  EXPECT_FALSE(t.mesh().has_garbage());
  EXPECT_TRUE(t.is_valid(true));
  EXPECT_EQ(t.number_of_inserted_vertices() + counter.removals, counter.insertions);
  IT::refine(t);
  check_structure(t);
}

TEST(Refine, visitor_sees_everything)
{
  std::size_t removals = 0;
  for(const Named_triangulation& named : traced(triangulations())) {
    Triangulation t = named.triangulation, silent = named.triangulation;
    Counter<std::runtime_error> counter(0);
    const auto result = IT::refine(t, CGAL::parameters::visitor(std::ref(counter)));
    EXPECT_EQ(counter.insertions, result.insertions);
    EXPECT_EQ(counter.removals, result.removals);
    EXPECT_GE(counter.flips, result.flips); // those of removals are not in the result
    removals += counter.removals;
    IT::refine(silent);
    EXPECT_EQ(text_of(t), text_of(silent));
  }
  EXPECT_GT(removals, 0u);
}

TEST(Refine, stopped_by_the_visitor)
{
  const Triangulation t(planar_mesh(random_points(25, 1000, 5)));
  Triangulation whole = t;
  Counter<std::runtime_error> counter(0);
  IT::refine(whole, CGAL::parameters::visitor(std::ref(counter)));
  EXPECT_GT(counter.removals, 0u);
  const std::size_t all = counter.flips + counter.insertions + counter.removals;
  for(std::size_t limit = 1; limit <= all; ++limit) {
    check_stopped<std::runtime_error>(t, limit);
    check_stopped<IT::Numerical_error>(t, limit);
    check_stopped<IT::Flip_limit_exceeded>(t, limit);
  }
}

// ---- Narrow vertices ----

TEST(Refine, narrow_cone)
{
  // The mesh is a needle-like pyramid: 4 faces with 1 degree each at the apex.
  const double height = 1 / (2 * std::tan(0.5 * pi / 180));
  const Mesh mesh = make_mesh({{0.5, 0.5, height}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                              {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 3, 2}, {1, 4, 3}});
  Triangulation t(mesh);
  const auto result = IT::refine(t);
  EXPECT_EQ(result.status, Refinement_status::bounds_met_but_excused);
  check_structure(t);
  check_angles(t, 25, result);
  for(const Remaining_face& r : result.remaining)
    EXPECT_EQ(r.vertex, Vertex_index(0));
}

// Faces in the wedge between the constrained sides of a sliver are excused by its tip. Faces in a
// wedge that is not narrow are refined.
TEST(Refine, narrow_wedges)
{
  for(const double degrees : traced({1., 20., 59., 61.})) {
    const double x = std::cos(degrees * pi / 180), y = std::sin(degrees * pi / 180);
    const Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {x, y, 0}}, {{0, 1, 2}});
    Triangulation t(mesh);
    const auto result = IT::refine(t, IT::parameters::maximum_circumradius(0.2));
    check_structure(t);
    check_angles(t, 25, result);
    EXPECT_EQ(result.status == Refinement_status::bounds_met_but_excused, degrees < 25);
  }
}

// ---- Constraints ----

TEST(Refine, constrained_edges_stay)
{
  for(const Named_mesh& m : traced(meshes())) {
    const auto is_constrained = boost::make_function_property_map<Mesh::Edge_index>(
      [](Mesh::Edge_index e) { return e.idx() % 5 == 0; });
    Triangulation t(m.mesh, CGAL::parameters::edge_is_constrained_map(is_constrained));
    std::set<std::size_t> fixed;
    for(Mesh::Edge_index e : m.mesh.edges())
      if(get(is_constrained, e) || m.mesh.is_border(e))
        fixed.insert(e.idx());
    const auto result = IT::refine(t);
    EXPECT_TRUE(result.status == Refinement_status::bounds_met ||
                result.status == Refinement_status::bounds_met_but_excused)
      << to_string(result.status);
    check_structure(t);
    check_angles(t, 25, result);
    check_chains(t, fixed);
  }
}

// Edges are split only in the middle, so every vertex on the boundary has a dyadic position,
// exactly.
TEST(Refine, vertices_on_the_boundary_are_at_dyadic_places)
{
  Triangulation t(unit_square(1, 0));
  IT::refine(t, IT::parameters::maximum_circumradius(0.01));
  std::size_t count = 0;
  for(Vertex_index v : t.mesh().vertices())
    if(t.is_inserted(v) && t.mesh().is_border(v)) {
      const double place = IT::on_edge(t.inserted_vertex(v))->weight[1] * 1024;
      EXPECT_EQ(place, std::floor(place));
      EXPECT_TRUE(place > 0 && place < 1024);
      ++count;
    }
  EXPECT_GT(count, 100u);
}

// A circumcenter that falls on an edge of the input is moved onto it, so that no piece has zero
// length.
TEST(Refine, no_short_pieces_on_regular_grids)
{
  Triangulation t(grid(6, 6, [](double x, double y) { return Point(8 * x, y, 0); }));
  IT::refine(t);
  check_structure(t);
  const IT::Correspondence<> c(t);
  for(Edge_index e : t.mesh().edges()) {
    double before = 0;
    for(IT::Correspondence<>::size_type p = 0; p < c.number_of_crossings(Side::intrinsic, e); ++p) {
      const double place = c.crossing(Side::intrinsic, Halfedge_index(2 * e.idx()), p).here.t;
      EXPECT_GT(place - before, 1e-6);
      before = place;
    }
    EXPECT_GT(1 - before, 1e-6);
  }
}

// ---- What it is for ----

// Returns positions of the vertices of T2, from the positions of the input.
std::vector<Point> positions(const Triangulation& t, const Mesh& mesh)
{
  const IT::Correspondence<> c(t);
  const IT::Common_subdivision<> s(c);
  std::vector<Point> result(s.mesh().number_of_vertices());
  const auto result_map =
    boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, s.mesh()));
  IT::interpolate(Side::input, s, mesh.points(), result_map);
  result.resize(t.mesh().number_of_vertices());
  return result;
}

Mesh terrible_mesh(std::size_t n)
{
  return grid(n, n, [n](double x, double y) { // rows sheared against each other, columns of needles
    const double u = x / static_cast<double>(n), v = y / static_cast<double>(n);
    const double shear = std::sin(25 * v) * u * (1 - u);
    return Point(u + 0.95 * shear, v, 0);
  });
}

TEST(Refine, Poisson_is_of_second_order)
{
  std::vector<double> errors;
  const std::vector<double> radii{0.08, 0.04, 0.02};
  const Mesh mesh = terrible_mesh(9);
  for(double radius : radii) {
    Triangulation t(mesh);
    IT::refine(t, IT::parameters::maximum_circumradius(radius));
    const std::vector<Point> place = positions(t, mesh);
    Values u(Eigen::Index(place.size())), f(u.size());
    for(Eigen::Index i = 0; i < u.size(); ++i) {
      const Point& p = place[std::size_t(i)];
      u[i] = std::sin(pi * p.x()) * std::sin(2 * pi * p.y()) + 2 * p.x() - p.y();
      f[i] = 5 * pi * pi * std::sin(pi * p.x()) * std::sin(2 * pi * p.y());
    }
    const auto is_fixed = boost::make_function_property_map<Vertex_index>(
      [&](Vertex_index v) { return t.mesh().is_border(v); });
    const Values error = IT::solve_poisson(t.intrinsic(), f, is_fixed, u) - u;
    errors.push_back(std::sqrt(error.dot(IT::mass_matrix(t.intrinsic()) * error)));
  }
  for(std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_GT(std::log2(errors[i - 1] / errors[i]), 1.7) << errors[i - 1] << ' ' << errors[i];
}

TEST(Refine, heat_distance_on_a_terrible_mesh)
{
  const Mesh terrible = terrible_mesh(9);
  Triangulation t(terrible), good(unit_square(60, 1));
  IT::refine(t, IT::parameters::maximum_circumradius(0.01));
  IT::make_Delaunay(good);
  const std::vector<Point> place = positions(t, terrible);
  const auto distance =
    IT::heat_distance(t.intrinsic(), std::vector<Vertex_index>{Vertex_index(0)});
  const auto on_good =
    IT::heat_distance(good.intrinsic(), std::vector<Vertex_index>{Vertex_index(0)});
  const auto error = [](double d, const Point& p) { return d - std::hypot(p.x(), p.y()); };
  double mean = 0, mean_on_good = 0;
  for(Vertex_index v : t.mesh().vertices())
    mean += std::abs(error(distance[Eigen::Index(v.idx())], place[v.idx()]));
  const Mesh good_mesh = unit_square(60, 1);
  for(Vertex_index v : good_mesh.vertices())
    mean_on_good += std::abs(error(on_good[Eigen::Index(v.idx())], good_mesh.point(v)));
  mean /= double(t.mesh().number_of_vertices());
  mean_on_good /= double(good_mesh.number_of_vertices());
  EXPECT_NEAR(mean, mean_on_good, 0.01); // of a square with side 1
  EXPECT_LT(mean, 0.01);
}

} // namespace Test_refine
