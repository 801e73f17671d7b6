// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef CGAL_EIGEN3_ENABLED

#include "surface_curves.h"

#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Part_means.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/signed_heat_distance.h>

#include <set>

namespace Test_signed_distance {

using namespace Test_surfaces;
using Values = Eigen::VectorXd;

Values exact(const Known_curve& known)
{
  return Eigen::Map<const Values>(known.distance.data(),
                                  static_cast<Eigen::Index>(known.distance.size()));
}

// Returns the mean error in edge lengths.
double mean_error(const Values& computed, const Values& expected, double edge)
{
  return (computed - expected).cwiseAbs().mean() / edge;
}

double max_error(const Values& computed, const Values& expected, double edge)
{
  return (computed - expected).cwiseAbs().maxCoeff() / edge;
}

// Returns the integral of a function over a curve on T2.
double integral(const Triangulation& t, const Curve& curve, const Values& function)
{
  double result = 0;
  for(const auto& s : curve) {
    const auto h = IT::sides(s.face, t.mesh());
    const double length = IT::curve_length(t.intrinsic(), Curve{s});
    for(std::size_t k = 0; k < 3; ++k)
      result += length * (s.source[k] + s.target[k]) / 2 * function[t.mesh().source(h[k]).idx()];
  }
  return result;
}

typedef std::function<Known_curve(std::size_t, CGAL::Random&)> Family;

// Checks that the error shrinks with the edges: it is bounded in edge lengths.
void expect_first_order(const Family& family, double mean, double greatest)
{
  for(const unsigned int seed : {1u, 2u, 3u, 4u})
    for(const std::size_t n : {12u, 24u, 48u, 96u}) {
      CGAL::Random random(seed);
      const Known_curve known = family(n, random);
      SCOPED_TRACE(known.name + ", " + std::to_string(n) + ", seed " + std::to_string(seed));
      const Values computed = IT::signed_heat_distance(known.t.intrinsic(), known.curve());
      EXPECT_LT(mean_error(computed, exact(known), known.edge), mean);
      EXPECT_LT(max_error(computed, exact(known), known.edge), greatest);
    }
}

void expect_first_order_unsigned(const Family& family, double mean)
{
  for(const unsigned int seed : {1u, 2u, 3u})
    for(const std::size_t n : {12u, 24u, 48u, 96u}) {
      CGAL::Random random(seed);
      const Known_curve known = family(n, random);
      SCOPED_TRACE(known.name + ", " + std::to_string(n) + ", seed " + std::to_string(seed));
      const Values computed = IT::heat_distance(known.t.intrinsic(), known.curve());
      EXPECT_LT(mean_error(computed, exact(known).cwiseAbs(), known.edge), mean);
    }
}

// Returns the part of a curve for which `is_kept(i)`.
template <typename Predicate>
Curve part_of(const Curve& curve, const Predicate& is_kept)
{
  Curve result;
  for(std::size_t i = 0; i < curve.size(); ++i)
    if(is_kept(i))
      result.push_back(curve[i]);
  return result;
}

Point place(const Location& p, const Delta_complex& faces, const Mesh& mesh)
{
  const auto h = IT::sides(p.first, faces);
  const auto at = [&](std::size_t k) { return mesh.point(faces.source(h[k])); };
  return CGAL::barycenter(at(0), p.second[0], at(1), p.second[1], at(2), p.second[2]);
}

// Returns a point of a random face, edge or vertex.
Location random_place(const Delta_complex& mesh, std::size_t dimension, CGAL::Random& random)
{
  Location p = random_location(mesh, random);
  const auto k = static_cast<std::size_t>(random.get_int(0, 3));
  if(dimension == 1)
    p.second = IT::barycentric_coordinates(k, p.second[0]);
  if(dimension == 0)
    p.second = IT::barycentric_coordinates(k, 0.);
  return p;
}

// ---- Curves ----

TEST(Surface_curve, follows_shortest_paths)
{
  CGAL::Random random(1);
  for(const Triangulation& t :
      {Triangulation(embedded_torus(12, 8)), triangulation(flat_torus(2, 1, 1)),
       Triangulation(perturbed(unit_square(6, 1), 0.05, 2)), Triangulation(tetrahedron())}) {
    const auto surface = t.input();
    for(int i = 0; i < 30; ++i) {
      const auto dimension = static_cast<std::size_t>(i) % 3;
      const Location p = random_place(surface.mesh(), dimension, random),
                     q = random_place(surface.mesh(),
                                      (dimension + static_cast<std::size_t>(i) / 3) % 3, random);
      IT::Shortest_paths paths(surface);
      paths.add_source(p);
      paths.run();
      const auto path = paths.path(q);
      if(path.places.size() < 2)
        continue;
      const Curve curve = IT::curve_through(surface, path.places);
      EXPECT_EQ(curve.size(), path.places.size() - 1);
      EXPECT_NEAR(IT::curve_length(surface, curve), path.length, 1e-9 * (1 + path.length));
    }
  }
}

// A single search is not longer than necessary.
TEST(Surface_curve, single_shortest_paths)
{
  CGAL::Random random(8);
  for(const Triangulation& t :
      {Triangulation(embedded_torus(24, 12)), triangulation(flat_torus(2, 1, 1))})
    for(std::size_t i = 0; i < 30; ++i) {
      const auto surface = t.input();
      const Location p = random_place(surface.mesh(), i % 3, random),
                     q = random_place(surface.mesh(), i / 3 % 3, random);
      IT::Shortest_paths paths(surface);
      paths.add_source(p);
      paths.run();
      const auto path = IT::shortest_path(surface, p, q);
      EXPECT_NEAR(path.length, paths.distance(q), 1e-12 * (1 + path.length));
      if(path.places.size() > 1) {
        EXPECT_NEAR(IT::curve_length(surface, IT::curve_through(surface, path.places)), path.length,
                    1e-9 * (1 + path.length));
      }
    }
}

// Segments that are mapped back are cut, but cover the same curve.
TEST(Surface_curve, across)
{
  CGAL::Random random(9);
  std::vector<Triangulation> triangulations{Triangulation(unit_sphere(4)),
                                            Triangulation(perturbed(unit_square(5, 1), 0.05, 2)),
                                            triangulation(flat_torus(3, 2, 1))};
  for(Triangulation& t : triangulations)
    flip_at_random(t, 200, 1);
  Triangulation refined(unit_square(3, 1));
  IT::refine(refined, IT::parameters::minimum_angle(28).maximum_circumradius(0.1));
  triangulations.push_back(refined);
  for(const Triangulation& t : triangulations) {
    const IT::Correspondence correspondence(t);
    for(const Side side : {Side::input, Side::intrinsic}) {
      Curve curve;
      for(std::size_t i = 0; i < 200; ++i) {
        const Location p = random_place(t.surface(side).mesh(), i % 3, random);
        Location q = random_place(t.surface(side).mesh(), i / 3 % 3, random);
        curve.push_back({p.first, p.second, q.second});
      }
      const double length = IT::curve_length(t.surface(side), curve);
      const Curve there = IT::curve_across(correspondence, side, curve);
      EXPECT_NEAR(IT::curve_length(t.surface(other(side)), there), length, 1e-9 * length);
      const Curve back = IT::curve_across(correspondence, other(side), there);
      EXPECT_NEAR(IT::curve_length(t.surface(side), back), length, 1e-9 * length);
      for(const auto& segment : back)
        for(const double b : {segment.source[0], segment.source[1], segment.source[2]})
          EXPECT_GE(b, 0);
    }
  }
}

TEST(Surface_curve, of_edges)
{
  const Mesh mesh = unit_square(4, 1);
  const Triangulation t(mesh);
  std::vector<Halfedge_index> halfedges;
  double length = 0;
  for(Halfedge_index h : t.input_mesh().halfedges())
    if(t.input_mesh().is_border(h) || h.idx() % 5 == 0) {
      halfedges.push_back(h);
      length += t.input_length(t.input_mesh().edge(h));
    }
  const Curve curve = IT::curve_along_edges(t.input(), halfedges);
  EXPECT_NEAR(IT::curve_length(t.input(), curve), length, 1e-12);
  for(std::size_t i = 0; i < curve.size(); ++i) {
    const Location p{curve[i].face, curve[i].source}, q{curve[i].face, curve[i].target};
    EXPECT_EQ(place(p, t.input_mesh(), mesh), mesh.point(t.input_mesh().source(halfedges[i])));
    EXPECT_EQ(place(q, t.input_mesh(), mesh), mesh.point(t.input_mesh().target(halfedges[i])));
  }
}

TEST(Surface_curve, points_without_a_common_face)
{
  const Triangulation t(unit_square(4, 1));
  const Location p{Face_index(0), {0.2, 0.3, 0.5}}, q{Face_index(20), {0.2, 0.3, 0.5}};
  EXPECT_THROW(IT::curve_through(t.input(), std::vector{p, q}), IT::Invalid_input);
  EXPECT_TRUE(IT::curve_through(t.input(), std::vector{p}).empty());
}

// ---- Distances from points and curves ----

TEST(Distance_sources, points_in_the_plane)
{
  CGAL::Random random(1);
  for(const std::size_t n : {12u, 24u, 48u, 96u}) {
    const Mesh mesh = unit_square(n, 1);
    Triangulation t(mesh);
    IT::make_Delaunay(t);
    const auto surface = t.intrinsic();
    const IT::Heat_distance<> heat(surface);
    for(int i = 0; i < 12; ++i) {
      const Location p = random_place(t.mesh(), static_cast<std::size_t>(i) % 3, random);
      const Point source = place(p, t.mesh(), mesh);
      IT::Distance_sources sources(surface);
      sources.add(p);
      Values expected(static_cast<Eigen::Index>(mesh.number_of_vertices()));
      for(Vertex_index v : mesh.vertices())
        expected[v.idx()] = std::sqrt(CGAL::squared_distance(mesh.point(v), source));
      EXPECT_LT(mean_error(heat.distances(sources), expected, 1. / static_cast<double>(n)), 0.9);
    }
  }
}

// Distances are compared with exact shortest paths, from several sources of all kinds.
TEST(Distance_sources, points_on_curved_surfaces)
{
  CGAL::Random random(2);
  for(const Mesh& mesh :
      {embedded_torus(48, 24), unit_sphere(16), perturbed(unit_sphere(16), 0.01, 1)}) {
    Triangulation t(mesh);
    IT::make_Delaunay(t);
    const auto surface = t.intrinsic();
    for(const std::size_t number : {1u, 3u, 10u}) {
      IT::Distance_sources sources(surface);
      IT::Shortest_paths paths(surface);
      for(std::size_t i = 0; i < number; ++i) {
        const Location p = random_place(surface.mesh(), i % 3, random);
        sources.add(p);
        paths.add_source(p);
      }
      paths.run();
      const Values computed = IT::heat_distance(surface, sources);
      EXPECT_EQ(computed, IT::Heat_distance<>(surface).distances(sources));
      double error = 0, sum = 0;
      for(Vertex_index v : surface.mesh().vertices()) {
        error += std::abs(computed[v.idx()] - paths.distance(v));
        sum += paths.distance(v);
      }
      EXPECT_LT(error, 0.1 * sum) << number;
    }
  }
}

TEST(Distance_sources, vertices_in_all_forms)
{
  Triangulation t(unit_sphere(6));
  IT::make_Delaunay(t);
  const auto surface = t.intrinsic();
  const Delta_complex& mesh = surface.mesh();
  const Halfedge_index h = IT::first_outgoing_halfedge(Vertex_index(5), mesh);
  const Values expected = IT::heat_distance(surface, Vertex_index(5));
  EXPECT_EQ(expected, IT::heat_distance(surface, IT::Edge_point<double>{h, 0}));
  EXPECT_EQ(expected, IT::heat_distance(surface, IT::Edge_point<double>{mesh.opposite(h), 1}));
  EXPECT_EQ(expected,
            IT::heat_distance(surface, IT::face_location(IT::Edge_point<double>{h, 0}, mesh)));
  EXPECT_EQ(expected, IT::heat_distance(surface, std::vector(3, Vertex_index(5))));
  EXPECT_EQ(expected[5], 0);
}

TEST(Distance_sources, curves)
{
  expect_first_order_unsigned(circle_in_square, 0.4);
  expect_first_order_unsigned(line_in_square, 0.3);
  expect_first_order_unsigned(circle_on_sphere, 0.4);
  expect_first_order_unsigned(circle_on_flat_torus, 0.5);
  expect_first_order_unsigned(parallels_of_torus, 0.4);
}

// A curve along edges is equivalent to its vertices as a source.
TEST(Distance_sources, boundary)
{
  const Mesh mesh = unit_square(24, 1);
  const Triangulation t(mesh);
  std::vector<Halfedge_index> border;
  std::vector<Vertex_index> vertices;
  for(Halfedge_index h : t.input_mesh().halfedges())
    if(t.input_mesh().is_border(h)) {
      border.push_back(h);
      vertices.push_back(t.input_mesh().source(h));
    }
  const Values by_edges = IT::heat_distance(t.input(), IT::curve_along_edges(t.input(), border));
  const Values by_vertices = IT::heat_distance(t.input(), vertices);
  EXPECT_LT((by_edges - by_vertices).cwiseAbs().maxCoeff(), 0.1 / 24);
  for(Vertex_index v : vertices)
    EXPECT_EQ(by_edges[v.idx()], 0);
}

// ---- Signed distances ----

TEST(Signed_heat_distance, lines_are_exact) { expect_first_order(line_in_square, 1e-9, 1e-8); }

TEST(Signed_heat_distance, circles)
{
  expect_first_order(circle_in_square, 0.15, 0.8);
  expect_first_order(circle_on_sphere, 0.1, 1.2);
  expect_first_order(circle_on_flat_torus, 0.5, 3);
  expect_first_order(parallels_of_torus, 0.3, 0.8);
}

// A single flow would round off the level sets, by a third of an edge length.
TEST(Signed_heat_distance, two_circles) { expect_first_order(circles_in_square, 0.3, 1.5); }

TEST(Signed_heat_distance, curvature_jumps) { expect_first_order(stadium_in_square, 0.2, 1.5); }

TEST(Signed_heat_distance, mean_over_the_curve_is_zero)
{
  CGAL::Random random(3);
  const Known_curve known = circle_on_sphere(20, random);
  const Values d = IT::signed_heat_distance(known.t.intrinsic(), known.curve());
  EXPECT_NEAR(integral(known.t, known.curve(), d), 0, 1e-12);
}

TEST(Signed_heat_distance, means_over_all_parts_of_the_curve_are_zero)
{
  CGAL::Random random(6);
  const Known_curve known = circles_in_square(30, random);
  const Mesh mesh = unit_square(30, 1);
  const Curve curve = known.curve();
  const Values d = IT::signed_heat_distance(known.t.intrinsic(), curve);
  for(const bool is_first : {true, false}) {
    const Curve part = part_of(curve, [&](std::size_t i) {
      const Point p = place({curve[i].face, curve[i].source}, known.t.mesh(), mesh);
      return (p.x() + p.y() < 0.95) == is_first;
    });
    EXPECT_NEAR(integral(known.t, part, d), 0, 1e-12);
    EXPECT_GT(part.size(), 10);
  }
}

// Returns dashes of a curve: segments that share no vertex with the faces of segments before.
Curve dashes_of(const Curve& curve, const Delta_complex& mesh)
{
  std::set<std::size_t> used;
  return part_of(curve, [&](std::size_t i) {
    const auto side = IT::sides(curve[i].face, mesh);
    for(const auto h : side)
      if(used.count(mesh.source(h).idx()) > 0)
        return false;
    for(const auto h : side)
      used.insert(mesh.source(h).idx());
    return true;
  });
}

// Returns the function next to `function` in the Dirichlet norm whose means over all segments are
// zero, from dense equations with a multiplier for each segment.
Values next_with_zero_means(const Triangulation& t, const Curve& curve, const Values& function)
{
  const Eigen::MatrixXd laplacian(IT::cotan_laplacian(t.intrinsic()));
  const Eigen::Index n = laplacian.rows(), k = static_cast<Eigen::Index>(curve.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + k, n + k);
  matrix.topLeftCorner(n, n) = laplacian;
  for(Eigen::Index j = 0; j < k; ++j)
    for(Eigen::Index v = 0; v < n; ++v)
      matrix(n + j, v) = matrix(v, n + j) =
        integral(t, {curve[static_cast<std::size_t>(j)]}, Values::Unit(n, v));
  Values right_side = Values::Zero(n + k);
  right_side.head(n) = laplacian * function;
  return matrix.fullPivLu().solve(right_side).head(n);
}

TEST(Signed_heat_distance, means_become_equal_as_by_dense_equations)
{
  CGAL::Random random(8);
  for(const auto family : {circle_in_square, circle_on_sphere, parallels_of_torus}) {
    const Known_curve known = family(14, random);
    const auto surface = known.t.intrinsic();
    const Curve dashes = dashes_of(known.curve(), known.t.mesh());
    EXPECT_GT(dashes.size(), 5u);
    const IT::Mesh_components components(surface.mesh());
    const IT::Poisson_solver<double> poisson(surface);
    Values function = exact(known);
    for(double& value : function)
      value += random.get_double(-known.edge, known.edge);
    const Values expected = next_with_zero_means(known.t, dashes, function);
    IT::internal::Part_means(surface, components, poisson, dashes).equalize(function);
    function.array() -=
      integral(known.t, {dashes[0]}, function) / IT::curve_length(surface, {dashes[0]});
    EXPECT_LT((function - expected).cwiseAbs().maxCoeff(), 1e-9 * known.edge) << known.name;
  }
}

// Segments in distant faces all over a square and a small sphere are parts of their own.
TEST(Signed_heat_distance, many_parts)
{
  Mesh mesh = unit_square(60, 1);
  const auto n = mesh.number_of_vertices();
  CGAL::copy_face_graph(unit_sphere(10), mesh);
  for(std::size_t v = n; v < mesh.number_of_vertices(); ++v) {
    Point& p = mesh.point(Vertex_index(static_cast<unsigned int>(v)));
    p = CGAL::ORIGIN + 1e-9 * (p - CGAL::ORIGIN);
  }
  const Triangulation t(mesh);
  Curve everywhere;
  for(Face_index f : t.mesh().faces())
    everywhere.push_back({f, {1, 0, 0}, {0, 0.5, 0.5}});
  const Curve dots = dashes_of(everywhere, t.mesh());
  EXPECT_GT(dots.size(), 400u);
  const Values d = IT::signed_heat_distance(t.intrinsic(), dots);
  const auto size = static_cast<Eigen::Index>(n);
  const double large = d.head(size).cwiseAbs().maxCoeff(),
               small = d.tail(d.size() - size).cwiseAbs().maxCoeff();
  EXPECT_LT(small, 1e-8);
  for(const auto& dot : dots) {
    const bool is_small = t.mesh().source(t.mesh().halfedge(dot.face)).idx() >= n;
    EXPECT_NEAR(integral(t, {dot}, d) / IT::curve_length(t.intrinsic(), {dot}), 0,
                1e-11 * (is_small ? small : large));
  }
}

TEST(Signed_heat_distance, reversed_curve)
{
  CGAL::Random random(4);
  const Known_curve known = circle_in_square(20, random);
  Curve reversed = known.curve();
  for(auto& segment : reversed)
    std::swap(segment.source, segment.target);
  const IT::Signed_heat_distance distance(known.t.intrinsic());
  EXPECT_LT(
    (distance.distances(known.curve()) + distance.distances(reversed)).cwiseAbs().maxCoeff(),
    1e-12);
}

// One in five segments is missing, at random or in long gaps.
TEST(Signed_heat_distance, gaps)
{
  for(const unsigned int seed : {1u, 2u, 3u}) {
    CGAL::Random random(seed);
    const Known_curve known = circle_in_square(48, random);
    const IT::Signed_heat_distance distance(known.t.intrinsic());
    const Curve dotted =
      part_of(known.curve(), [&](std::size_t) { return random.get_int(0, 5) > 0; });
    EXPECT_LT(mean_error(distance.distances(dotted), exact(known), known.edge), 0.3);
    const Mesh mesh = unit_square(48, 1);
    const Curve whole = known.curve();
    const Point first = place({whole[0].face, whole[0].source}, known.t.mesh(), mesh);
    const Curve open = part_of(whole, [&](std::size_t i) {
      const Point p = place({whole[i].face, whole[i].source}, known.t.mesh(), mesh);
      return CGAL::squared_distance(p, first) > 0.01;
    });
    EXPECT_LT(open.size(), whole.size());
    const Values closed = distance.distances(open);
    EXPECT_LT(mean_error(closed, exact(known), known.edge), 1);
    int wrong = 0;
    for(Vertex_index v : mesh.vertices())
      if(std::abs(known.distance[v.idx()]) > 2 * known.edge &&
         CGAL::squared_distance(mesh.point(v), first) > 0.02 &&
         (closed[v.idx()] < 0) != (known.distance[v.idx()] < 0))
        ++wrong;
    EXPECT_EQ(wrong, 0);
  }
}

// Some segments have the wrong direction.
TEST(Signed_heat_distance, broken_orientation)
{
  CGAL::Random random(5);
  const Known_curve known = circle_in_square(48, random);
  Curve curve = known.curve();
  for(auto& segment : curve)
    if(random.get_int(0, 8) == 0)
      std::swap(segment.source, segment.target);
  const Values d = IT::signed_heat_distance(known.t.intrinsic(), curve);
  EXPECT_LT(mean_error(d, exact(known), known.edge), 1);
}

// Strips bent along the rows of edges pass through themselves in space, and are flat.
TEST(Signed_heat_distance, self_intersecting_mesh)
{
  const std::size_t n = 40;
  std::vector<Kernel::Vector_3> knot{{0, 0, 0}}; // a polygon with two turns
  for(std::size_t i = 0; i < n; ++i) {
    const double angle = 4 * pi * static_cast<double>(i) / static_cast<double>(n);
    knot.push_back(knot.back() + Kernel::Vector_3(std::cos(angle), 0, std::sin(angle)));
  }
  const Mesh flat = grid(n, 20, [](double x, double y) { return Point(x, y, 0); });
  const Mesh bent = grid(n, 20, [&](double x, double y) {
    return CGAL::ORIGIN + knot[static_cast<std::size_t>(x)] + Kernel::Vector_3(0, y, 0);
  });
  Known_curve known = known_curve("circle in a strip", flat, 1, [](const Point& p) {
    return std::hypot(p.x() - 18.3, p.y() - 9.6) - 6;
  });
  const Values on_flat = IT::signed_heat_distance(known.t.intrinsic(), known.curve());
  EXPECT_LT(mean_error(on_flat, exact(known), 1), 0.2);
  Triangulation t(bent);
  const Values on_bent = IT::signed_heat_distance(t.input(), level_set(t.mesh(), known.distance));
  EXPECT_LT(mean_error(on_bent, exact(known), 1), 0.2);
}

TEST(Signed_heat_distance, components)
{
  Mesh mesh = unit_sphere(6);
  const auto n = static_cast<Eigen::Index>(mesh.number_of_vertices());
  CGAL::copy_face_graph(tetrahedron(), mesh);
  mesh.add_vertex(Point(9, 9, 9));
  const Triangulation t(mesh);
  std::vector<double> height;
  for(Vertex_index v : mesh.vertices())
    height.push_back(v.idx() < n ? mesh.point(v).z() - 0.1 : 1);
  const Values d = IT::signed_heat_distance(t.input(), level_set(t.input_mesh(), height));
  EXPECT_TRUE(d.head(n).allFinite());
  EXPECT_TRUE((d.tail(d.size() - n).array() == std::numeric_limits<double>::infinity()).all());
  const Values none = IT::signed_heat_distance(t.input(), Curve());
  EXPECT_TRUE((none.array() == std::numeric_limits<double>::infinity()).all());
}

TEST(Signed_heat_distance, unit_of_length)
{
  CGAL::Random random(6);
  const Known_curve known = circle_on_sphere(12, random);
  const Values expected = IT::signed_heat_distance(known.t.intrinsic(), known.curve());
  for(double factor : {1e-30, 1e30}) {
    const auto length = boost::make_function_property_map<Edge_index>(
      [&](Edge_index e) { return factor * known.t.length(e); });
    const Values computed =
      IT::signed_heat_distance(IT::Surface_view(known.t.mesh(), length), known.curve()) / factor;
    EXPECT_LT((computed - expected).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(Signed_heat_distance, errors)
{
  CGAL::Random random(7);
  const Known_curve known = circle_in_square(12, random);
  Curve cancelling = known.curve();
  for(const auto& s : known.curve())
    cancelling.push_back({s.face, s.target, s.source});
  const IT::Signed_heat_distance distance(known.t.intrinsic());
  EXPECT_THROW(distance.distances(cancelling), IT::Numerical_error);
  for(double factor : {0., -1., std::nan("")})
    EXPECT_THROW(
      IT::Signed_heat_distance(known.t.intrinsic(), IT::parameters::time_step_factor(factor)),
      IT::Invalid_input);
  const Triangulation strip(grid(4000, 1, [](double x, double y) { return Point(x, y, 0); }));
  const Curve across{{Face_index(0), {1, 0, 0}, {0, 0.5, 0.5}}};
  EXPECT_THROW(IT::signed_heat_distance(strip.input(), across), IT::Numerical_error);
}

// Normals that do not flow over the surface give no distances, neither rounded nor wrong ones.
TEST(Signed_heat_distance, short_times_are_right_or_refused)
{
  CGAL::Random random(8);
  int right = 0, refused = 0;
  for(const Known_curve& known : {circle_in_square(12, random), line_in_square(20, random)})
    for(double factor = 4; factor > 1e-300; factor *= factor > 1e-3 ? 0.8 : 1e-10)
      try {
        const IT::Signed_heat_distance distance(known.t.intrinsic(),
                                                IT::parameters::time_step_factor(factor));
        const Values d = distance.distances(known.curve());
        for(Vertex_index v : known.t.mesh().vertices())
          EXPECT_NEAR(d[v.idx()], known.distance[v.idx()], 2 * known.edge) << factor;
        ++right;
      } catch(const IT::Underflow_error&) {
        ++refused;
      }
  EXPECT_GT(right, 10);
  EXPECT_GT(refused, 10);
}

} // namespace Test_signed_distance

#endif // CGAL_EIGEN3_ENABLED
