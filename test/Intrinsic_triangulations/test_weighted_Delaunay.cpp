// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "weights.h"

#include <CGAL/Intrinsic_triangulations/internal/weights/Exact_weighted_flipping.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/weighted_laplacian.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace Test_weighted_Delaunay {

using namespace Test_weights;

namespace {

// Returns the mesh of a triangulation of the convex hull of points.
Mesh planar_mesh(const std::vector<Point_2>& points)
{
  typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Exact_kernel> Vertex;
  CGAL::Delaunay_triangulation_2<Exact_kernel, CGAL::Triangulation_data_structure_2<Vertex>> t;
  std::vector<std::pair<Point_2, std::size_t>> numbered;
  std::vector<Point> corners;
  for(const Point_2& p : points) {
    numbered.emplace_back(p, numbered.size());
    corners.emplace_back(p.x(), p.y(), 0);
  }
  t.insert(numbered.begin(), numbered.end());
  Triangles triangles;
  for(auto f : t.finite_face_handles())
    triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return make_mesh(corners, triangles);
}

Edges edges_without(const std::vector<Vertex_index>& hidden, const Triangulation& t)
{
  const std::set<Vertex_index> left_out(hidden.begin(), hidden.end());
  Edges result;
  for(Edge_index e : t.mesh().edges()) {
    const Vertex_index v = t.mesh().vertex(e, 0), w = t.mesh().vertex(e, 1);
    if(left_out.count(v) == 0 && left_out.count(w) == 0)
      result.insert(ordered<std::size_t>(v.idx(), w.idx()));
  }
  return result;
}

std::vector<Point_2> random_points(std::size_t n, CGAL::Random& random)
{
  std::vector<Point_2> result;
  while(result.size() < n)
    result.emplace_back(random.get_double(-1, 1), random.get_double(-1, 1));
  return result;
}

void flip_at_random(Triangulation& t, std::size_t flips, CGAL::Random& random)
{
  for(std::size_t i = 0; i < flips; ++i)
    if(const auto h = random_index<Halfedge_index>(t.mesh().num_halfedges(), random);
       t.is_flippable(h))
      t.flip(h);
}

} // namespace

TEST(Weighted_Delaunay, is_the_regular_triangulation_of_a_flat_domain)
{
  CGAL::Random random(1);
  std::size_t hidden_vertices = 0;
  for(std::size_t n : {5, 20, 100, 400})
    for(double range : {1e-9, 0.01, 0.1, 1., 10.})
      for(int sample = 0; sample < 5; ++sample) {
        const std::vector<Point_2> points = random_points(n, random);
        const std::vector<double> weights =
          random_numbers(n, -range / double(n), range / double(n), random);
        const auto [edges, hidden] = regular_triangulation(points, weights);
        Triangulation t(planar_mesh(points));
        const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
        EXPECT_EQ(result.hidden_vertices, hidden);
        EXPECT_EQ(edges_without(hidden, t), edges) << n << ' ' << range << ' ' << sample;
        EXPECT_TRUE(IT::is_weighted_Delaunay(t, result.weight_map()));
        EXPECT_TRUE(t.is_valid());
        hidden_vertices += hidden.size();
      }
  EXPECT_GT(hidden_vertices, 1000);
}

TEST(Weighted_Delaunay, holds_in_fifty_digits_and_is_unique)
{
  CGAL::Random random(2);
  for(unsigned int seed = 0; seed < 10; ++seed) {
    Triangulation t(random_sphere(60, seed)), u = t;
    std::vector<double> weights(60);
    for(std::size_t i = 0; i < 60; ++i) {
      double least = 10;
      for(Halfedge_index h : CGAL::halfedges_around_target(
            Vertex_index(static_cast<Delta_complex::size_type>(i)), t.mesh()))
        least = (std::min)(least, t.length(t.mesh().edge(h)));
      weights[i] = std::pow(random.get_double(0, 0.7) * least, 2);
    }
    const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
    EXPECT_TRUE(result.hidden_vertices.empty());
    EXPECT_GT(least_dual_edge(t, weights), -1e-9);
    EXPECT_TRUE(t.is_valid());
    flip_at_random(u, 300, random);
    IT::make_weighted_Delaunay(u, map_of(weights));
    std::map<std::pair<Vertex_index, Vertex_index>, std::multiset<long>> lengths_of_t, lengths_of_u;
    for(Edge_index e : t.mesh().edges()) {
      lengths_of_t[ordered(t.mesh().vertex(e, 0), t.mesh().vertex(e, 1))].insert(
        std::lround(1e7 * t.length(e)));
      lengths_of_u[ordered(u.mesh().vertex(e, 0), u.mesh().vertex(e, 1))].insert(
        std::lround(1e7 * u.length(e)));
    }
    EXPECT_EQ(lengths_of_t, lengths_of_u);
  }
}

namespace {

// Points in the square and, smaller each time, around its middle. There, coordinates have room.
std::vector<Point_2> nested_points(std::size_t n, double ratio, CGAL::Random& random)
{
  std::vector<Point_2> result;
  for(double size = 1; size > 1e-32; size *= ratio)
    for(const Point_2& p : random_points(n, random))
      result.emplace_back(size * p.x(), size * p.y());
  return result;
}

// Parts of the distances to the nearest points, with squares that are numbers of type `double`.
std::vector<double> short_radii(const std::vector<Point_2>& points, CGAL::Random& random)
{
  std::vector<double> result;
  for(const Point_2& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for(const Point_2& q : points)
      if(p != q)
        least = (std::min)(least, std::hypot(p.x() - q.x(), p.y() - q.y()));
    int exponent = 0;
    const double part = std::frexp(least * random.get_double(0, 0.5), &exponent);
    result.push_back(std::ldexp(std::floor(part * 0x1p26), exponent - 26));
  }
  return result;
}

} // namespace

// Rounded lengths say nothing about angles between points that are so close.
TEST(Weighted_Delaunay, exact_decisions_give_the_regular_triangulation_of_near_points)
{
  CGAL::Random random(7);
  std::size_t flips = 0;
  for(const double ratio : {1e-2, 1e-8, 1e-15, 1e-30})
    for(int sample = 0; sample < 5; ++sample) {
      const std::vector<Point_2> points = nested_points(12, ratio, random);
      const std::vector<double> radii = short_radii(points, random);
      std::vector<double> weights;
      for(const double r : radii)
        weights.push_back(r * r);
      Triangulation t(planar_mesh(points));
      IT::Default_flip_visitor visitor;
      const auto result = IT::internal::flip_exactly_with_circles(t, map_of(radii), visitor);
      const auto [edges, hidden] = regular_triangulation(points, weights);
      EXPECT_EQ(hidden, result.hidden_vertices);
      EXPECT_EQ(edges_without({}, t), edges) << ratio << ' ' << sample;
      EXPECT_TRUE(t.is_valid());
      flips += result.flips;
    }
  EXPECT_GT(flips, 20u);
}

TEST(Weighted_Delaunay, exact_decisions_find_hidden_points)
{
  const std::vector<Point_2> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {1.5, 1}};
  Triangulation t(planar_mesh(points));
  IT::Default_flip_visitor visitor;
  const std::vector<double> radii{0, 0, 0, 0, 2, 0};
  const auto result = IT::internal::flip_exactly_with_circles(t, map_of(radii), visitor);
  const std::vector<Vertex_index> hidden = regular_triangulation(points, {0, 0, 0, 0, 4, 0}).second;
  ASSERT_EQ(hidden, std::vector<Vertex_index>{Vertex_index(5)});
  ASSERT_FALSE(result.hidden_vertices.empty());
  for(Vertex_index v : result.hidden_vertices)
    EXPECT_EQ(v, hidden[0]);
}

TEST(Weighted_Delaunay, equal_weights_are_none)
{
  for(unsigned int seed = 0; seed < 5; ++seed)
    for(double weight : {-3., 0., 2.}) {
      Triangulation t(random_sphere(200, seed)), u = t;
      IT::make_Delaunay(t);
      const std::vector<double> weights(200, weight);
      const auto result = IT::make_weighted_Delaunay(u, map_of(weights));
      EXPECT_TRUE(result.hidden_vertices.empty());
      EXPECT_TRUE(IT::is_Delaunay(u));
      for(Edge_index e : t.mesh().edges())
        EXPECT_EQ(t.length(e), u.length(e));
      EXPECT_LT((IT::cotan_laplacian(t.intrinsic()) -
                 IT::weighted_laplacian(u.intrinsic(), map_of(weights)))
                  .norm(),
                1e-10);
    }
}

TEST(Weighted_Delaunay, hides_vertices_of_any_curvature)
{
  Triangulation t((cube()));
  std::vector<double> weights(8, 0.);
  weights[0] = -100;
  const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
  EXPECT_EQ(result.hidden_vertices, std::vector<Vertex_index>{Vertex_index(0)});
  EXPECT_GT(result.weights[0], -100);
  EXPECT_TRUE(IT::is_weighted_Delaunay(t, result.weight_map()));
  EXPECT_GT(least_dual_edge(t, result.weights), -1e-9);
  EXPECT_TRUE(t.is_valid());
}

TEST(Weighted_Delaunay, constrained_edges_stay)
{
  Mesh mesh = random_sphere(100, 7);
  Triangulation t(mesh);
  CGAL::Random random(3);
  const std::vector<double> weights = random_numbers(100, 0, 0.01, random);
  for(Edge_index e : t.mesh().edges())
    t.set_constrained(e, e.idx() % 3 == 0);
  IT::make_weighted_Delaunay(t, map_of(weights));
  for(Edge_index e : t.mesh().edges())
    if(e.idx() % 3 == 0) {
      EXPECT_TRUE(t.coordinates().is_shared(e));
    }
}

// Dual edges are orthogonal to edges: coordinates of a flat domain are harmonic inside, whatever
// the weights.
TEST(Weighted_laplacian, has_linear_precision)
{
  CGAL::Random random(4);
  const std::vector<Point_2> points = random_points(100, random);
  const std::vector<double> weights = random_numbers(100, -0.3, 0.3, random);
  const Triangulation t(planar_mesh(points));
  const auto laplacian = IT::weighted_laplacian(t.intrinsic(), map_of(weights));
  Eigen::VectorXd x(100), ones = Eigen::VectorXd::Ones(100);
  for(int i = 0; i < 100; ++i)
    x[i] = points[static_cast<std::size_t>(i)].x() + 2 * points[static_cast<std::size_t>(i)].y();
  const Eigen::VectorXd image = laplacian * x, of_ones = laplacian * ones;
  for(Vertex_index v : t.mesh().vertices()) {
    if(!t.mesh().is_border(v)) {
      EXPECT_NEAR(image[int(v.idx())], 0, 1e-9);
    }
    EXPECT_NEAR(of_ones[int(v.idx())], 0, 1e-9);
  }
}

TEST(Power_center, has_equal_power_to_the_corners)
{
  CGAL::Random random(5);
  const std::vector<Point_2> points = random_points(50, random);
  const std::vector<double> weights = random_numbers(50, -1, 1, random);
  const Triangulation t(planar_mesh(points));
  for(Face_index f : t.mesh().faces()) {
    const Halfedge_index h = t.mesh().halfedge(f);
    const auto b = IT::power_center(h, t.intrinsic(), map_of(weights));
    std::array<std::size_t, 3> corner{t.mesh().source(h).idx(), t.mesh().target(h).idx(),
                                      t.mesh().target(t.mesh().next(h)).idx()};
    double x = 0, y = 0;
    for(std::size_t c = 0; c < 3; ++c) {
      x += b[c] * points[corner[c]].x();
      y += b[c] * points[corner[c]].y();
    }
    std::array<double, 3> power;
    for(std::size_t c = 0; c < 3; ++c)
      power[c] = CGAL::squared_distance(Point_2(x, y), points[corner[c]]) - weights[corner[c]];
    const double scale = 1e-9 * (1 + std::abs(power[0])) * (1 + std::abs(x) + std::abs(y));
    EXPECT_NEAR(b[0] + b[1] + b[2], 1, scale);
    EXPECT_NEAR(power[0], power[1], scale);
    EXPECT_NEAR(power[0], power[2], scale);
  }
}

} // namespace Test_weighted_Delaunay
