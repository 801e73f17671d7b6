// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "weights.h"

#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/certify_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_rational.h>

namespace Test_weighted_certificates {

using namespace Test_weights;
using IT::Weighted_Delaunay_certificate;

namespace {

// Returns random weights up to a part of the square of the shortest edge at each vertex.
std::vector<double> local_weights(const Mesh& mesh, double part, CGAL::Random& random)
{
  std::vector<double> result(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  for(auto e : mesh.edges())
    for(unsigned int i : {0, 1}) {
      double& square = result[mesh.vertex(e, i).idx()];
      square = (std::min)(square, CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)),
                                                         mesh.point(mesh.vertex(e, 1))));
    }
  for(double& weight : result)
    weight *= random.get_double(-part, part);
  return result;
}

// Returns a mesh of random points in a square, whose coordinates have few digits.
Mesh planar_mesh(std::size_t n, CGAL::Random& random)
{
  CGAL::Delaunay_triangulation_2<Exact_kernel> t;
  while(t.number_of_vertices() < n)
    t.insert(Point_2(random.get_int(-1000, 1001), random.get_int(-1000, 1001)));
  Mesh mesh;
  std::map<decltype(t)::Vertex_handle, Mesh::Vertex_index> index;
  for(auto v : t.finite_vertex_handles())
    index[v] = mesh.add_vertex(Point(v->point().x(), v->point().y(), 0));
  for(auto f : t.finite_face_handles())
    mesh.add_face(index[f->vertex(0)], index[f->vertex(1)], index[f->vertex(2)]);
  return mesh;
}

std::vector<Point_2> plane_points(const Mesh& mesh)
{
  std::vector<Point_2> result;
  for(auto v : mesh.vertices())
    result.emplace_back(mesh.point(v).x(), mesh.point(v).y());
  return result;
}

} // namespace

TEST(Weighted_certificate, confirms_regular_triangulations_with_hidden_points)
{
  CGAL::Random random(1);
  std::size_t hidden = 0;
  for(std::size_t n : {6, 30, 120})
    for(double range : {1e5, 1e7, 1e8})
      for(int sample = 0; sample < 3; ++sample) {
        const Mesh mesh = planar_mesh(n, random);
        std::vector<double> weights =
          random_numbers(n, -range / double(n), range / double(n), random);
        for(double& w : weights)
          w = std::round(w);
        Triangulation t(mesh);
        const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
        EXPECT_EQ(result.hidden_vertices,
                  regular_triangulation(plane_points(mesh), weights).second);
        const Weighted_Delaunay_certificate certificate =
          IT::certify_weighted_Delaunay(t, map_of(weights), result.hidden_vertices);
        EXPECT_TRUE(certificate.is_weighted_Delaunay()) << n << ' ' << range << ' ' << sample;
        EXPECT_EQ(certificate.undecided(), 0u);
        hidden += result.hidden_vertices.size();
      }
  EXPECT_GT(hidden, 100u);
}

// On lattices with such weights, points are hidden by as little as a rounding error. Then rounding
// gives hidden vertices their own weights.
TEST(Weighted_certificate, names_vertices_that_are_hidden_by_less_than_rounding)
{
  CGAL::Random random(13);
  std::size_t rounded_away = 0;
  for(int sample = 0; sample < 200; ++sample) {
    const double spacing = random.get_double(0.1, 10);
    const Mesh mesh =
      grid(3, 3, [&](double x, double y) { return Point(x * spacing, y * spacing, 0); });
    std::vector<double> weights;
    for(std::size_t i = 0; i < mesh.number_of_vertices(); ++i)
      weights.push_back(random.get_int(-2, 3) * 0.25 * spacing * spacing);
    Triangulation t(mesh);
    const auto result =
      IT::make_weighted_Delaunay(t, map_of(weights), IT::parameters::exact_decisions(true));
    EXPECT_EQ(result.hidden_vertices, regular_triangulation(plane_points(mesh), weights).second)
      << sample;
    EXPECT_TRUE(IT::certify_weighted_Delaunay(t, map_of(weights), result.hidden_vertices)
                  .is_weighted_Delaunay())
      << sample;
    for(Vertex_index v : result.hidden_vertices)
      rounded_away += result.weights[v.idx()] == weights[v.idx()];
  }
  EXPECT_GT(rounded_away, 0u);
}

// In the plane, the lifted point of a hidden vertex lies in a triangle of visible ones.
TEST(Weighted_certificate, encloses_the_weights_of_hidden_points)
{
  typedef CGAL::Exact_rational Number;
  typedef IT::Euclidean_geometry_traits<double> Traits;
  CGAL::Random random(2);
  std::size_t checked = 0;
  for(int sample = 0; sample < 10; ++sample) {
    const Mesh mesh = planar_mesh(40, random);
    std::vector<double> weights = random_numbers(40, -1e5, 1e5, random);
    Triangulation t(mesh);
    const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
    IT::internal::Vertex_weights enclosed(weights);
    for(Vertex_index v : result.hidden_vertices)
      enclosed.hidden()[v];
    const IT::internal::Edge_courses<Traits> courses(t, IT::Concurrency());
    EXPECT_TRUE(IT::internal::Hidden_weights<Traits>(t, courses, enclosed).enclose().empty());
    const auto [edges, hidden] = regular_triangulation(plane_points(mesh), weights);
    const auto lifted = [&](Vertex_index v) {
      const Number x(mesh.point(v).x()), y(mesh.point(v).y());
      return std::array<Number, 3>{x, y, x * x + y * y - Number(weights[v.idx()])};
    };
    for(const auto& [v, weight] : enclosed.hidden()) {
      const auto p = lifted(v);
      std::optional<Number> height; // of the lower hull of the visible points over the vertex
      for(Vertex_index a : mesh.vertices())
        for(Vertex_index b : mesh.vertices())
          for(Vertex_index c : mesh.vertices()) {
            if(a >= b || b >= c || edges.count({a.idx(), b.idx()}) == 0 ||
               edges.count({b.idx(), c.idx()}) == 0 || edges.count({a.idx(), c.idx()}) == 0)
              continue;
            const std::array<std::array<Number, 3>, 3> corner{lifted(a), lifted(b), lifted(c)};
            const auto doubled_area = [](const auto& q, const auto& r, const auto& s) {
              return Number((r[0] - q[0]) * (s[1] - q[1]) - (s[0] - q[0]) * (r[1] - q[1]));
            };
            const Number whole = doubled_area(corner[0], corner[1], corner[2]);
            std::array<Number, 3> part;
            for(std::size_t i = 0; i < 3; ++i)
              part[i] = doubled_area(p, corner[(i + 1) % 3], corner[(i + 2) % 3]) / whole;
            if(std::any_of(part.begin(), part.end(), [](const Number& x) { return x < 0; }))
              continue;
            const Number z =
              part[0] * corner[0][2] + part[1] * corner[1][2] + part[2] * corner[2][2];
            if(!height || z < *height)
              height = z;
          }
      ASSERT_TRUE(height.has_value());
      const Number exact = p[0] * p[0] + p[1] * p[1] - *height;
      IT::internal::Long_float value = weight.value;
      Number difference = exact;
      for(int part = 0; part < 24; ++part) {
        difference -= Number(static_cast<double>(value));
        value -= IT::internal::Long_float(static_cast<double>(value));
      }
      EXPECT_LE(CGAL::abs(difference), Number(weight.error));
      EXPECT_LT(weight.error, 1e-280);
      ++checked;
    }
  }
  EXPECT_GT(checked, 50u);
}

namespace {

// Expects that with greater weights than the least ones all vertices are visible, and with smaller
// weights the same vertices are hidden.
void expect_least_weights(const Mesh& mesh, const std::vector<double>& weights)
{
  Triangulation t(mesh);
  const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
  const auto changed = [&](double change) {
    std::vector<double> of_all = weights;
    for(Vertex_index v : result.hidden_vertices)
      of_all[v.idx()] = result.weights[v.idx()] + change;
    return of_all;
  };
  const auto certify = [&](const std::vector<double>& of_all) {
    return IT::certify_weighted_Delaunay(t, map_of(of_all), result.hidden_vertices);
  };
  EXPECT_TRUE(certify(weights).is_weighted_Delaunay());
  EXPECT_TRUE(certify(changed(-1e-9)).is_weighted_Delaunay());
  EXPECT_EQ(certify(changed(1e-9)).visible_vertices, result.hidden_vertices);
  EXPECT_TRUE(IT::make_weighted_Delaunay(t, map_of(changed(1e-9))).hidden_vertices.empty());
}

} // namespace

TEST(Weighted_certificate, finds_the_least_weights)
{
  CGAL::Random random(3);
  for_data_meshes({"cube.off", "blob.off", "sphere.off", "tetrahedron.off"}, [&](const Mesh& mesh) {
    for(double part : {0.5, 2., 5.})
      expect_least_weights(mesh, local_weights(mesh, part, random));
  });
}

TEST(Weighted_certificate, confirms_data_meshes)
{
  CGAL::Random random(9);
  for_each_data_mesh(60000, [&](const Mesh& mesh) {
    const std::vector<double> weights = local_weights(mesh, 1, random);
    Triangulation t(mesh);
    const auto result =
      IT::make_weighted_Delaunay(t, map_of(weights), IT::parameters::exact_decisions(true));
    EXPECT_TRUE(IT::certify_weighted_Delaunay(t, map_of(weights), result.hidden_vertices)
                  .is_weighted_Delaunay());
  });
}

TEST(Weighted_certificate, names_wrong_edges_and_vertices)
{
  CGAL::Random random(4);
  const Mesh mesh = random_sphere(60, 4);
  const std::vector<double> weights = local_weights(mesh, 0.5, random);
  Triangulation t(mesh);
  const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
  ASSERT_TRUE(result.hidden_vertices.empty());
  int flipped = 0;
  for(Edge_index e : t.mesh().edges()) {
    const Halfedge_index h = t.mesh().halfedge(e);
    if(!t.is_flippable(h))
      continue;
    t.flip(h);
    const auto certificate = IT::certify_weighted_Delaunay(t, map_of(weights), {});
    EXPECT_EQ(
      std::count(certificate.non_Delaunay_edges.begin(), certificate.non_Delaunay_edges.end(), e),
      1);
    EXPECT_TRUE(certificate.is_geodesic());
    t.flip(h);
    ++flipped;
  }
  EXPECT_GT(flipped, 50);
  const std::vector<Vertex_index> visible{Vertex_index(7)};
  EXPECT_FALSE(IT::certify_weighted_Delaunay(t, map_of(weights), visible).is_weighted_Delaunay());
  std::vector<double> lower = weights;
  lower[7] -= 100;
  EXPECT_FALSE(IT::certify_weighted_Delaunay(t, map_of(lower), {}).is_weighted_Delaunay());
}

// No geodesic passes a corner of a square, so that nothing hides it.
TEST(Weighted_certificate, corners_of_the_boundary_are_visible)
{
  const Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  Triangulation t(mesh);
  const std::vector<Vertex_index> corner{Vertex_index(1)};
  const auto certificate =
    IT::certify_weighted_Delaunay(t, map_of(std::vector<double>(4, 0.)), corner);
  EXPECT_EQ(certificate.visible_vertices, corner);
  EXPECT_TRUE(certificate.is_Delaunay());
}

// The diagonal of a square is a tie for weights with equal sums on both diagonals.
TEST(Weighted_certificate, decides_ties_exactly)
{
  const Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>> exact(mesh);
  const Triangulation rounded(mesh);
  for(const double change : {0., std::ldexp(1., -50), -std::ldexp(1., -50)}) {
    const std::vector<double> weights{0.125 + change, 0.25, 0.375, 0.25};
    for(const Weighted_Delaunay_certificate& c :
        {IT::certify_weighted_Delaunay(exact, map_of(weights), {}),
         IT::certify_weighted_Delaunay(rounded, map_of(weights), {})}) {
      EXPECT_EQ(c.ties.size(), change == 0 ? 1u : 0u);
      EXPECT_EQ(c.is_weighted_Delaunay(), change >= 0);
      EXPECT_EQ(c.undecided(), 0u);
    }
  }
}

// Let all angles at the apex of a pyramid add up to less than pi / 2. Then the corner hides it
// for which the weight minus the squared distance is greatest.
TEST(Weighted_certificate, apex_of_a_narrow_cone_has_the_weight_of_one_corner)
{
  CGAL::Random random(6);
  for(const double height : {5., 8., 30.})
    for(int sample = 0; sample < 5; ++sample) {
      std::vector<Point> points;
      Triangles triangles;
      const std::size_t n = 5;
      for(std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * CGAL_PI * double(i) / double(n);
        points.emplace_back(std::cos(angle), std::sin(angle), 0.2 * random.get_double(-1, 1));
        triangles.push_back({i, (i + 1) % n, n});
      }
      points.emplace_back(0, 0, height);
      const Mesh mesh = make_mesh(points, triangles);
      Triangulation t(mesh);
      std::vector<double> weights = random_numbers(n + 1, -0.2, 0.2, random);
      weights[n] = -1e4;
      double expected = -std::numeric_limits<double>::infinity();
      for(std::size_t i = 0; i < n; ++i)
        expected = (std::max)(expected, weights[i] - CGAL::squared_distance(points[i], points[n]));
      const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
      ASSERT_EQ(result.hidden_vertices, std::vector<Vertex_index>{Vertex_index(unsigned(n))});
      EXPECT_NEAR(result.weights[n], expected, 1e-9 * std::abs(expected));
      EXPECT_TRUE(IT::certify_weighted_Delaunay(t, map_of(weights), result.hidden_vertices)
                    .is_weighted_Delaunay());
    }
}

TEST(Weighted_certificate, constrained_edges_satisfy_no_condition)
{
  CGAL::Random random(7);
  const Mesh mesh = random_sphere(80, 5);
  Triangulation t(mesh);
  const std::vector<double> weights = local_weights(mesh, 0.9, random);
  for(Edge_index e : t.mesh().edges())
    t.set_constrained(e, e.idx() % 4 == 0);
  const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
  EXPECT_TRUE(IT::certify_weighted_Delaunay(t, map_of(weights), result.hidden_vertices)
                .is_weighted_Delaunay());
  std::size_t violated = 0;
  for(Edge_index e : t.mesh().edges())
    if(t.is_constrained(e)) {
      t.set_constrained(e, false);
      violated += !IT::certify_weighted_Delaunay(t, map_of(weights), {}).is_weighted_Delaunay();
      t.set_constrained(e, true);
    }
  EXPECT_GT(violated, 0u);
}

TEST(Weighted_certificate, refuses_weights_that_are_no_numbers)
{
  const Triangulation t(random_sphere(10, 1));
  for(double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    std::vector<double> weights(10, 0.);
    weights[3] = bad;
    EXPECT_THROW(IT::certify_weighted_Delaunay(t, map_of(weights), {}), IT::Invalid_input);
  }
}

TEST(Weighted_certificate, inverse_in_a_tower_of_roots)
{
  typedef IT::internal::Root_tower<CGAL::Exact_rational> Tower;
  Tower tower(3);
  for(int square : {2, 3, 5})
    ASSERT_TRUE(tower.root(square).has_value());
  CGAL::Random random(8);
  for(int trial = 0; trial < 50; ++trial) {
    Tower::Element x(8, CGAL::Exact_rational(0));
    for(auto& coefficient : x)
      coefficient = random.get_int(-3, 4);
    if(Tower::is_zero(x))
      continue;
    Tower::Element product;
    tower.add_product(x, tower.inverse(x), CGAL::POSITIVE, product);
    product[0] -= 1;
    EXPECT_TRUE(Tower::is_zero(product));
  }
}

} // namespace Test_weighted_certificates
