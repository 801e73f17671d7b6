// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "weights.h"

#include <CGAL/Intrinsic_triangulations/certify_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Exact_weighted_flipping.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Supporting_triangles.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/weighted_laplacian.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <Eigen/LU>

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

namespace {

typedef boost::multiprecision::int256_t Big_integer;

// Returns whether no lifted point lies below the plane of the lifted corners of a face. Coordinates
// and weights are integers.
bool is_supported(const std::array<Vertex_index, 3>& corner, const std::vector<Point_2>& points,
                  const std::vector<double>& weights)
{
  typedef std::array<Big_integer, 3> Lifted;
  const auto lifted = [&](std::size_t v) {
    const Big_integer x(points[v].x()), y(points[v].y());
    return Lifted{x, y, x * x + y * y - Big_integer(weights[v])};
  };
  const Lifted origin = lifted(corner[0].idx());
  const auto from_origin = [&](std::size_t v) {
    Lifted p = lifted(v);
    for(std::size_t c = 0; c < 3; ++c)
      p[c] -= origin[c];
    return p;
  };
  const Lifted u = from_origin(corner[1].idx()), v = from_origin(corner[2].idx());
  const Lifted normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                      u[0] * v[1] - u[1] * v[0]};
  EXPECT_GT(normal[2], 0);
  for(std::size_t i = 0; i < points.size(); ++i)
    if(const Lifted p = from_origin(i); normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] < 0)
      return false;
  return true;
}

} // namespace

// Integers decide about each face and each vertex. The greater weights hide vertices, and ties are
// frequent if there are few values of weights.
TEST(Weighted_Delaunay, has_no_vertex_below_a_face)
{
  CGAL::Random random(14);
  std::size_t faces = 0, hidden = 0;
  for(std::size_t n : {10, 50, 200, 500})
    for(double size : {30., 1e6})
      for(double range : {1e-12, 1e-3, 0.3, 3.}) {
        std::set<Point_2> distinct;
        while(distinct.size() < n)
          distinct.emplace(std::round(random.get_double(-size, size)),
                           std::round(random.get_double(-size, size)));
        const std::vector<Point_2> points(distinct.begin(), distinct.end());
        std::vector<double> weights;
        for(double w : random_numbers(n, -range * size * size / double(n),
                                      range * size * size / double(n), random))
          weights.push_back(std::round(w));
        Triangulation t(planar_mesh(points));
        flip_at_random(t, n, random);
        const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
        const std::set<Vertex_index> left_out(result.hidden_vertices.begin(),
                                              result.hidden_vertices.end());
        for(Face_index f : t.mesh().faces()) {
          std::array<Vertex_index, 3> corner;
          for(std::size_t s = 0; s < 3; ++s)
            corner[s] = t.mesh().source(IT::sides(f, t.mesh())[s]);
          if(std::none_of(corner.begin(), corner.end(),
                          [&](Vertex_index v) { return left_out.count(v) > 0; })) {
            EXPECT_TRUE(is_supported(corner, points, weights)) << n << ' ' << size << ' ' << range;
            ++faces;
          }
        }
        hidden += left_out.size();
      }
  EXPECT_GT(faces, 6000u);
  EXPECT_GT(hidden, 100u);
}

namespace {

// Returns the greatest error of the weights of hidden vertices, relative to `scale`. Their lifted
// points lie in the triangles of the visible ones.
double error_of_hidden_weights(const std::vector<Point_2>& points,
                               const std::vector<double>& weights,
                               const std::vector<double>& raised, double scale)
{
  typedef CGAL::Regular_triangulation_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Regular;
  typedef Regular::Weighted_point Lifted;
  std::vector<Lifted> lifted;
  for(std::size_t i = 0; i < points.size(); ++i)
    lifted.emplace_back(Regular::Bare_point(points[i].x(), points[i].y()), weights[i]);
  const Regular t(lifted.begin(), lifted.end());
  double result = 0;
  for(auto v = t.hidden_vertices_begin(); v != t.hidden_vertices_end(); ++v) {
    const auto f = t.locate(v->point());
    const auto circle = t.geom_traits().construct_weighted_circumcenter_2_object()(
      f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
    // An expression of GMP would refer to numbers that no longer exist.
    const CGAL::Exact_rational weight =
      CGAL::squared_distance(v->point().point(), circle) -
      CGAL::squared_distance(f->vertex(0)->point().point(), circle) +
      f->vertex(0)->point().weight();
    const std::size_t i =
      std::size_t(std::find(lifted.begin(), lifted.end(), v->point()) - lifted.begin());
    result = (std::max)(result, std::abs(CGAL::to_double(weight) - raised[i]) / scale);
  }
  return result;
}

} // namespace

// Weights of hidden vertices depend on each other until the visible ones are known.
TEST(Weighted_Delaunay, gives_hidden_vertices_the_weights_of_visible_ones)
{
  CGAL::Random random(12);
  for(std::size_t n : {20, 100, 400})
    for(double range : {1., 1e3, 1e6, 1e9})
      for(int sample = 0; sample < 3; ++sample) {
        const std::vector<Point_2> points = random_points(n, random);
        const std::vector<double> weights = random_numbers(n, 0, range / double(n), random);
        Triangulation t(planar_mesh(points));
        const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
        EXPECT_EQ(result.hidden_vertices, regular_triangulation(points, weights).second);
        EXPECT_LT(error_of_hidden_weights(points, weights, result.weights, 1 + range), 1e-12);
        EXPECT_TRUE(t.is_valid());
      }
}

// Rounding of such weights exceeds the heights of the other lifted points.
TEST(Weighted_Delaunay, has_digits_for_great_weights)
{
  CGAL::Random random(17);
  for(const double weight : {1e12, 1e16, 1e20, 1e25})
    for(int sample = 0; sample < 5; ++sample) {
      const std::vector<Point_2> points = random_points(40, random);
      std::vector<double> weights(points.size(), 0.);
      weights.back() = weight;
      Triangulation t(planar_mesh(points));
      const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
      EXPECT_EQ(result.hidden_vertices, regular_triangulation(points, weights).second);
      EXPECT_GT(result.hidden_vertices.size(), 10u);
      EXPECT_TRUE(
        IT::certify_weighted_Delaunay(t, map_of(weights), result.hidden_vertices).is_Delaunay())
        << weight << ' ' << sample;
    }
}

TEST(Weighted_Delaunay, refuses_weights_beyond_its_digits)
{
  Triangulation t((cube()));
  std::vector<double> weights(8, 0.);
  for(const double weight : {1e40, 1e76}) {
    weights[3] = weight;
    EXPECT_THROW(IT::make_weighted_Delaunay(t, map_of(weights)), IT::Numerical_error);
    EXPECT_TRUE(t.is_valid());
  }
  for(const double weight : {1e77, 1e308, -1e308}) {
    weights[3] = weight;
    EXPECT_THROW(IT::make_weighted_Delaunay(t, map_of(weights)), IT::Invalid_input);
    EXPECT_THROW(IT::certify_weighted_Delaunay(t, map_of(weights), {}), IT::Invalid_input);
  }
}

TEST(Supporting_triangles, solve_cycles_of_vertices)
{
  CGAL::Random random(13);
  for(const double near : {1., 1e-3, 1e-6})
    for(int sample = 0; sample < 20; ++sample) {
      const Eigen::Index n = random.get_int(2, 40), all = n + 3;
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(all, all);
      Eigen::VectorXd constant(all);
      std::vector<double> weights = random_numbers(std::size_t(all), -1, 1, random);
      IT::internal::Supporting_triangles<double> triangles;
      for(Eigen::Index i = 0; i < all; ++i) {
        constant[i] = i < n ? random.get_double(-1, 1) : weights[std::size_t(i)];
        if(i >= n)
          continue;
        IT::internal::Supporting_triangle<double> triangle{constant[i], {}};
        double rest = 1; // the visible corner has a part of up to `near`
        for(int c = 2; c >= 0; --c) {
          const auto j =
            c == 2 ? n + random.get_int(0, 3) : Eigen::Index(random.get_int(0, int(n)));
          const double part =
            c == 0 ? rest : rest * random.get_double(0.1, 0.9) * (c == 2 ? near : 1);
          rest -= part;
          triangle.part[std::size_t(c)] = {Vertex_index(unsigned(j)), part};
          matrix(i, j) -= part;
        }
        triangles.set(Vertex_index(unsigned(i)), triangle);
      }
      triangles.set_weights(weights);
      const Eigen::VectorXd expected = matrix.fullPivLu().solve(constant);
      for(Eigen::Index i = 0; i < all; ++i)
        EXPECT_NEAR(weights[std::size_t(i)], expected[i], 1e-9 / near);
    }
}

// Vertices that hide each other have no weight.
TEST(Supporting_triangles, refuse_vertices_without_a_visible_one)
{
  IT::internal::Supporting_triangles<double> triangles;
  for(unsigned v = 0; v < 2; ++v) {
    const Vertex_index other(1 - v);
    triangles.set(Vertex_index(v), {1., {std::pair(other, 0.5), {other, 0.25}, {other, 0.25}}});
  }
  std::vector<double> weights(2, 0.);
  EXPECT_THROW(triangles.set_weights(weights), IT::Numerical_error);
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

// Returns points in the square and, ever smaller, around its center, where coordinates have room.
std::vector<Point_2> nested_points(std::size_t n, double ratio, CGAL::Random& random)
{
  std::vector<Point_2> result;
  for(double size = 1; size > 1e-32; size *= ratio)
    for(const Point_2& p : random_points(n, random))
      result.emplace_back(size * p.x(), size * p.y());
  return result;
}

// Returns parts of the distances to the nearest points, with squares that are numbers of type
// `double`.
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

// Rounded lengths do not determine angles between such near points.
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

// Dual edges are orthogonal to edges: coordinates of a flat domain are harmonic inside, for any
// weights.
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
