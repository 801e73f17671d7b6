// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "more_generators.h"
#include "weights.h"

#include <CGAL/Intrinsic_triangulations/internal/weights/Exact_weighted_flipping.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>

#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>
#include <CGAL/Periodic_2_triangulation_face_base_2.h>
#include <CGAL/Periodic_2_triangulation_vertex_base_2.h>

namespace Test_weighted_surfaces {

using namespace Test_weights;

// ---- Flat tori ----

// Represents a torus, the plane modulo the lattice of (1, 0) and (slope, height). Vertices are near
// the points of a grid in the parallelogram of this basis.
struct Flat_torus
{
  double slope, height;
  std::vector<Point_2> points;
  Triangulation triangulation;

  Point_2 copy(std::size_t i, int a, int b) const
  {
    return {points[i].x() + a + b * slope, points[i].y() + b * height};
  }
};

Flat_torus flat_torus(std::size_t m, double slope, double height, CGAL::Random& random)
{
  std::vector<Point_2> points;
  std::vector<Point> anywhere;
  const auto place = [&](std::size_t i) {
    return (double(i) + random.get_double(-0.24, 0.24)) / double(m); // no face is reversed
  };
  for(std::size_t i = 0; i < m; ++i)
    for(std::size_t j = 0; j < m; ++j) {
      const double x = place(i), y = place(j);
      points.emplace_back(x + y * slope, y * height);
      anywhere.emplace_back(0, 0, 0);
    }
  const Mesh mesh = make_mesh(anywhere, lattice(m, m, true, true));
  const auto length = [&](Edge_index e) { // edges are short in the grid
    const std::size_t v = mesh.vertex(e, 0).idx(), w = mesh.vertex(e, 1).idx();
    const auto period = [&](std::size_t from, std::size_t to) {
      return from == 0 && to + 1 == m ? -1 : to == 0 && from + 1 == m ? 1 : 0;
    };
    const int a = period(v / m, w / m), b = period(v % m, w % m);
    return std::hypot(points[w].x() + a + b * slope - points[v].x(),
                      points[w].y() + b * height - points[v].y());
  };
  return {slope, height, points,
          Triangulation(mesh, IT::parameters::edge_length_map(
                                boost::make_function_property_map<Edge_index>(length)))};
}

// Stores the edges that leave each vertex, as ends and lengths.
typedef std::vector<std::tuple<std::size_t, std::size_t, double>> Directed_edges;

Directed_edges edges_of(const Triangulation& t, const std::set<std::size_t>& left_out = {})
{
  Directed_edges result;
  for(Halfedge_index h : t.mesh().halfedges()) {
    const std::size_t v = t.mesh().source(h).idx(), w = t.mesh().target(h).idx();
    if(left_out.count(v) + left_out.count(w) == 0)
      result.emplace_back(v, w, t.length(t.mesh().edge(h)));
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_equal(const Directed_edges& a, const Directed_edges& b)
{
  ASSERT_EQ(a.size(), b.size());
  for(std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(std::get<0>(a[i]), std::get<0>(b[i]));
    EXPECT_EQ(std::get<1>(a[i]), std::get<1>(b[i]));
    EXPECT_NEAR(std::get<2>(a[i]), std::get<2>(b[i]), 1e-9);
  }
}

// Returns the edges of CGAL's regular triangulation of all copies within a distance of the origin
// that leave the copies nearest to it, and the vertices that are hidden there.
std::pair<Directed_edges, std::set<std::size_t>>
lattice_triangulation(const Flat_torus& torus, const std::vector<double>& weights)
{
  std::vector<Point_2> points;
  std::vector<double> copied_weights;
  std::vector<std::size_t> original, nearest(torus.points.size());
  const auto square = [&](std::size_t i) {
    return CGAL::squared_distance(points[i], Point_2(0, 0));
  };
  for(std::size_t v = 0; v < torus.points.size(); ++v) {
    nearest[v] = points.size();
    for(int b = -8; b <= 8; ++b)
      for(int a = -30; a <= 30; ++a)
        if(const Point_2 p = torus.copy(v, a, b); std::hypot(p.x(), p.y()) < 3) {
          points.push_back(p);
          copied_weights.push_back(weights[v]);
          original.push_back(v);
          if(square(points.size() - 1) < square(nearest[v]))
            nearest[v] = points.size() - 1;
        }
  }
  const auto [edges, hidden] = regular_triangulation(points, copied_weights);
  Directed_edges result;
  for(const auto& [i, j] : edges)
    for(const auto& [from, to] : {std::pair{i, j}, std::pair{j, i}})
      if(nearest[original[from]] == from)
        result.emplace_back(original[from], original[to],
                            std::sqrt(CGAL::squared_distance(points[from], points[to])));
  std::sort(result.begin(), result.end());
  const std::set<std::size_t> all_hidden(hidden.begin(), hidden.end());
  std::set<std::size_t> hidden_vertices;
  for(std::size_t v = 0; v < nearest.size(); ++v)
    if(all_hidden.count(nearest[v]) > 0)
      hidden_vertices.insert(v);
  return {result, hidden_vertices};
}

TEST(Weighted_Delaunay, is_the_regular_triangulation_of_a_lattice)
{
  CGAL::Random random(8);
  std::size_t hidden_vertices = 0, flips = 0;
  for(const std::size_t m : {3u, 5u, 9u})
    for(const double range : {1e-9, 0.05, 0.5, 2.})
      for(const double slope : {0., 0.4, 3.3}) {
        Flat_torus torus = flat_torus(m, slope, random.get_double(0.6, 1.2), random);
        const double square = range / double(m * m);
        const std::vector<double> weights = random_numbers(m * m, -square, square, random);
        const auto [edges, hidden] = lattice_triangulation(torus, weights);
        Triangulation& t = torus.triangulation;
        const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
        const std::set<std::size_t> named(result.hidden_vertices.begin(),
                                          result.hidden_vertices.end());
        EXPECT_EQ(named, hidden) << m << ' ' << range << ' ' << slope;
        expect_equal(edges_of(t, named), edges);
        EXPECT_TRUE(t.is_valid());
        hidden_vertices += hidden.size();
        flips += result.flips;
      }
  EXPECT_GT(hidden_vertices, 100u);
  EXPECT_GT(flips, 1000u);
}

TEST(Weighted_Delaunay, with_equal_weights_is_the_periodic_Delaunay_triangulation)
{
  typedef CGAL::Periodic_2_Delaunay_triangulation_traits_2<Exact_kernel> Traits;
  typedef CGAL::Triangulation_vertex_base_with_info_2<
    std::size_t, Traits, CGAL::Periodic_2_triangulation_vertex_base_2<Traits>>
    Vertex;
  typedef CGAL::Periodic_2_triangulation_face_base_2<Traits> Face;
  typedef CGAL::Periodic_2_Delaunay_triangulation_2<
    Traits, CGAL::Triangulation_data_structure_2<Vertex, Face>>
    Periodic_2;
  CGAL::Random random(9);
  for(const std::size_t m : {7u, 12u, 20u}) {
    Flat_torus torus = flat_torus(m, 0, 1, random);
    Periodic_2 periodic(Periodic_2::Iso_rectangle(0, 0, 1, 1));
    for(std::size_t v = 0; v < torus.points.size(); ++v) {
      const Point_2& p = torus.points[v];
      const Point_2 inside(p.x() - std::floor(p.x()), p.y() - std::floor(p.y()));
      torus.points[v] = inside;
      periodic.insert(inside)->info() = v;
    }
    ASSERT_TRUE(periodic.is_triangulation_in_1_sheet());
    periodic.convert_to_1_sheeted_covering();
    Directed_edges edges;
    for(auto e = periodic.edges_begin(); e != periodic.edges_end(); ++e) {
      const std::size_t v = e->first->vertex(periodic.cw(e->second))->info(),
                        w = e->first->vertex(periodic.ccw(e->second))->info();
      const double length = std::sqrt(periodic.segment(*e).squared_length());
      edges.emplace_back(v, w, length);
      edges.emplace_back(w, v, length);
    }
    std::sort(edges.begin(), edges.end());
    IT::make_weighted_Delaunay(torus.triangulation, map_of(std::vector<double>(m * m, 0.3)));
    expect_equal(edges_of(torus.triangulation), edges);
  }
}

// ---- CGAL's meshes ----

// Returns the squares of the shortest edges at vertices.
std::vector<double> least_squares_of_lengths(Triangulation t)
{
  IT::make_Delaunay(t);
  std::vector<double> result(t.mesh().num_vertices(), std::numeric_limits<double>::infinity());
  for(Halfedge_index h : t.mesh().halfedges()) {
    double& least = result[t.mesh().source(h).idx()];
    least = (std::min)(least, std::pow(t.length(t.mesh().edge(h)), 2));
  }
  return result;
}

constexpr std::uintmax_t largest_file = 40000;

// Weights have any sign, and are too small to hide a vertex.
TEST(Weighted_Delaunay, of_data_meshes_holds_in_fifty_digits)
{
  CGAL::Random random(10);
  std::size_t meshes = 0;
  for_each_data_mesh(largest_file, [&](const Mesh& mesh) {
    Triangulation t(mesh);
    std::vector<double> weights = least_squares_of_lengths(t);
    for(double& w : weights)
      w *= std::isfinite(w) ? random.get_double(-0.5, 0.5) : 0;
    const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
    EXPECT_TRUE(IT::is_weighted_Delaunay(t, result.weight_map()));
    EXPECT_TRUE(t.is_valid());
    EXPECT_TRUE(result.hidden_vertices.empty());
    EXPECT_GT(least_dual_edge(t, result.weights), -1e-9);
    ++meshes;
  });
  EXPECT_GT(meshes, 30u);
}

// Some hidden vertices are almost on edges of others, so faces have almost no area.
TEST(Weighted_Delaunay, of_data_meshes_with_hidden_vertices_holds_up_to_rounded_weights)
{
  CGAL::Random random(10);
  std::size_t vertices = 0, hidden = 0;
  for_data_meshes({"icosahedron.off", "cross.off", "hedra.off", "part.off", "ellipsoid.off",
                   "blob.off", "cactus.off"},
                  [&](const Mesh& mesh) {
                    Triangulation t(mesh);
                    std::vector<double> weights = least_squares_of_lengths(t);
                    for(double& w : weights)
                      w *= std::isfinite(w) ? random.get_double(-3, 3) : 0;
                    const auto result = IT::make_weighted_Delaunay(
                      t, map_of(weights), IT::parameters::exact_decisions(true));
                    EXPECT_TRUE(IT::is_weighted_Delaunay(t, result.weight_map()));
                    EXPECT_TRUE(t.is_valid());
                    EXPECT_GT(Dual_edges(t, result.weights).least_change_of_weight(), -1e-14);
                    vertices += weights.size();
                    hidden += result.hidden_vertices.size();
                  });
  EXPECT_GT(hidden, vertices / 4);
}

// Almost all vertices are hidden, in clusters. Weights do not depend on the first triangulation.
TEST(Weighted_Delaunay, of_data_meshes_with_few_visible_vertices_is_unique)
{
  CGAL::Random random(14);
  std::size_t visible = 0, vertices = 0;
  for_data_meshes({"helmet.off", "joint.off", "part.off", "cactus.off"}, [&](const Mesh& mesh) {
    Triangulation t(mesh), u = with_random_flips(mesh, random);
    const std::vector<double> squares = least_squares_of_lengths(t);
    const double range = 1e5 * *std::min_element(squares.begin(), squares.end());
    const std::vector<double> weights = random_numbers(squares.size(), 0, range, random);
    const auto exactly = IT::parameters::exact_decisions(true);
    const auto result = IT::make_weighted_Delaunay(t, map_of(weights), exactly);
    EXPECT_TRUE(t.is_valid());
    EXPECT_GT(Dual_edges(t, result.weights).least_change_of_weight(), -1e-14);
    const auto again = IT::make_weighted_Delaunay(u, map_of(weights), exactly);
    EXPECT_EQ(result.hidden_vertices, again.hidden_vertices);
    for(std::size_t v = 0; v < weights.size(); ++v)
      EXPECT_NEAR(result.weights[v], again.weights[v], 1e-14 * range);
    vertices += weights.size();
    visible += weights.size() - result.hidden_vertices.size();
  });
  EXPECT_LT(visible, vertices / 10);
}

// Circles do not meet, which exact decisions check.
TEST(Weighted_Delaunay, of_data_meshes_is_exact_for_circles)
{
  CGAL::Random random(11);
  std::size_t meshes = 0;
  for_each_data_mesh(largest_file, [&](const Mesh& mesh) {
    Triangulation t(mesh);
    std::vector<double> radii = least_squares_of_lengths(t), weights;
    for(double& r : radii) {
      const float rounded = float(std::isfinite(r) ? std::sqrt(r) * random.get_double(0, 0.5) : 0);
      r = rounded; // with a square of type `double`
      weights.push_back(r * r);
    }
    IT::Default_flip_visitor visitor;
    const auto result = IT::internal::flip_exactly_with_circles(t, map_of(radii), visitor);
    EXPECT_TRUE(result.hidden_vertices.empty());
    EXPECT_TRUE(t.is_valid());
    EXPECT_GT(least_dual_edge(t, weights), -1e-30);
    ++meshes;
  });
  EXPECT_GT(meshes, 30u);
}

// ---- Hidden vertices on lines ----

// Returns the length of an edge of a regular polygon in the unit circle.
double side_of_polygon(std::size_t n) { return 2 * std::sin(pi / double(n)); }

// Returns a cylinder of height 2 whose faces are halves of rectangles.
Mesh regular_cylinder(std::size_t rings, std::size_t n)
{
  std::vector<Point> points;
  Triangles faces;
  for(std::size_t i = 0; i <= rings; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const double angle = 2 * pi * double(j) / double(n);
      points.emplace_back(std::cos(angle), std::sin(angle), 2 * double(i) / double(rings));
      if(i < rings) {
        const std::size_t below = i * n + j, next = i * n + (j + 1) % n;
        faces.push_back({below, next, next + n});
        faces.push_back({below, next + n, below + n});
      }
    }
  return make_mesh(points, faces);
}

double least_relative_area(const Triangulation& t)
{
  double result = 1;
  for(Face_index f : t.mesh().faces()) {
    const auto [a, b, c] = IT::internal::side_lengths(t.mesh().halfedge(f), t);
    result = (std::min)(result, IT::quadrupled_area(a, b, c) / (a * a + b * b + c * c));
  }
  return result;
}

double area_of(const Triangulation& t)
{
  double result = 0;
  for(Face_index f : t.mesh().faces()) {
    const auto [a, b, c] = IT::internal::side_lengths(t.mesh().halfedge(f), t);
    result += IT::quadrupled_area(a, b, c) / 4;
  }
  return result;
}

// A great weight hides vertices that are on lines with others, up to rounding.
TEST(Weighted_Delaunay, leaves_no_face_of_hidden_vertices_without_area)
{
  const std::size_t rings = 8, n = 32;
  const Mesh mesh = regular_cylinder(rings, n);
  for(const std::size_t heavy : {0u, 3u, 100u, 133u})
    for(const double weight : {0.5, 2., 5.}) {
      Triangulation t(mesh);
      std::vector<double> weights(mesh.number_of_vertices(), 0);
      weights[heavy] = weight;
      const auto result = IT::make_weighted_Delaunay(t, map_of(weights));
      EXPECT_FALSE(result.hidden_vertices.empty());
      EXPECT_TRUE(IT::is_weighted_Delaunay(t, result.weight_map()));
      EXPECT_TRUE(t.is_valid());
      EXPECT_GT(least_relative_area(t), 1e-3);
      EXPECT_NEAR(area_of(t), 2 * double(n) * side_of_polygon(n), 1e-11);
      EXPECT_GT(least_dual_edge(t, result.weights), -1e-10);
    }
}

} // namespace Test_weighted_surfaces
