// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/convex_polyhedron.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/glue_boundary.h>

#include <boost/pending/disjoint_sets.hpp>

// Archimedean solids are folded from nets.
using namespace Test_surfaces;

namespace {

// ---- Solids ----

typedef std::array<double, 3> Coordinates;

// States the permutations of coordinates, and their signs.
enum class Symmetry
{
  all_permutations,
  even_permutations,
  even_number_of_minus_signs, // and all permutations
  snub_cube,                  // an even number of plus signs for even permutations only
  snub_dodecahedron           // even permutations, and an even number of plus signs
};

bool is_allowed(Symmetry symmetry, bool is_even_permutation, bool is_even_number_of_plus)
{
  switch(symmetry) {
    case Symmetry::all_permutations: return true;
    case Symmetry::even_permutations: return is_even_permutation;
    case Symmetry::even_number_of_minus_signs: return !is_even_number_of_plus;
    case Symmetry::snub_cube: return is_even_permutation == is_even_number_of_plus;
    default: return is_even_permutation && is_even_number_of_plus;
  }
}

struct Solid
{
  const char* name;
  std::size_t vertices, edges;
  double circumradius; // of edges of length 1
  Symmetry symmetry;
  std::vector<Coordinates> seeds;
};

std::vector<Point> vertices_of(const Solid& solid)
{
  const std::array<std::array<std::size_t, 3>, 6> permutations{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
  std::vector<Point> result;
  for(const Coordinates& seed : solid.seeds)
    for(std::size_t p = 0; p < 6; ++p)
      for(unsigned signs = 0; signs < 8; ++signs) {
        Coordinates x;
        std::size_t plus = 0;
        for(std::size_t c = 0; c < 3; ++c) {
          const bool is_minus = (signs >> c & 1) != 0;
          x[c] = (is_minus ? -1 : 1) * seed[permutations[p][c]];
          plus += !is_minus;
        }
        const Point point(x[0], x[1], x[2]);
        const auto is_same = [&](const Point& q) {
          return CGAL::squared_distance(point, q) < 1e-12;
        };
        if(is_allowed(solid.symmetry, p < 3, plus % 2 == 0) &&
           std::none_of(result.begin(), result.end(), is_same))
          result.push_back(point);
      }
  return result;
}

// Returns the root of x^3 = a x^2 + b x + c near 1.8.
double cubic_root(double a, double b, double c)
{
  double x = 1.8;
  for(int i = 0; i < 50; ++i)
    x -= (x * (x * (x - a) - b) - c) / (x * (3 * x - 2 * a) - b);
  return x;
}

std::vector<Solid> solids()
{
  const double s = std::sqrt(2.), r = std::sqrt(5.), g = (1 + r) / 2, h = 1 / g;
  const double t = cubic_root(1, 1, 1), x = cubic_root(0, 2, g), a = x - 1 / x,
               b = x * g + g * g + g / x;
  using S = Symmetry;
  return {
    {"truncated tetrahedron",
     12,
     18,
     std::sqrt(22.) / 4,
     S::even_number_of_minus_signs,
     {{1, 1, 3}}},
    {"cuboctahedron", 12, 24, 1, S::all_permutations, {{1, 1, 0}}},
    {"truncated cube", 24, 36, std::sqrt(7 + 4 * s) / 2, S::all_permutations, {{s - 1, 1, 1}}},
    {"truncated octahedron", 24, 36, std::sqrt(10.) / 2, S::all_permutations, {{0, 1, 2}}},
    {"rhombicuboctahedron", 24, 48, std::sqrt(5 + 2 * s) / 2, S::all_permutations, {{1, 1, 1 + s}}},
    {"truncated cuboctahedron",
     48,
     72,
     std::sqrt(13 + 6 * s) / 2,
     S::all_permutations,
     {{1, 1 + s, 1 + 2 * s}}},
    {"snub cube", 24, 60, std::sqrt((3 - t) / (4 * (2 - t))), S::snub_cube, {{1, 1 / t, t}}},
    {"icosidodecahedron", 30, 60, g, S::even_permutations, {{0, 0, g}, {0.5, g / 2, g * g / 2}}},
    {"truncated dodecahedron",
     60,
     90,
     std::sqrt(74 + 30 * r) / 4,
     S::even_permutations,
     {{0, h, 2 + g}, {h, g, 2 * g}, {g, 2, g + 1}}},
    {"truncated icosahedron",
     60,
     90,
     std::sqrt(58 + 18 * r) / 4,
     S::even_permutations,
     {{0, 1, 3 * g}, {1, 2 + g, 2 * g}, {g, 2, 2 * g + 1}}},
    {"rhombicosidodecahedron",
     60,
     120,
     std::sqrt(11 + 4 * r) / 2,
     S::even_permutations,
     {{1, 1, g * g * g}, {g * g, g, 2 * g}, {2 + g, 0, g * g}}},
    {"truncated icosidodecahedron",
     120,
     180,
     std::sqrt(31 + 12 * r) / 2,
     S::even_permutations,
     {{h, h, 3 + g},
      {2 * h, g, 1 + 2 * g},
      {h, g * g, 3 * g - 1},
      {2 * g - 1, 2, 2 + g},
      {g, 3, 2 * g}}},
    {"snub dodecahedron",
     60,
     150,
     2.155837375115639701836629076693,
     S::snub_dodecahedron,
     {{2 * a, 2, 2 * b},
      {a + b / g + g, -a * g + b + h, a / g + b * g - 1},
      {-a / g + b * g + 1, -a + b / g - g, a * g + b - h},
      {-a / g + b * g - 1, a - b / g - g, a * g + b + h},
      {a + b / g - g, a * g - b + h, a / g + b * g + 1}}}};
}

// ---- Nets ----

template <typename P>
double distance_of(const P& p, const P& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

// Stores a polygon in the plane, and its sides that are glued.
struct Net
{
  Mesh mesh;
  std::vector<std::pair<Halfedge_index, Halfedge_index>> pairs;
  std::vector<Vertex_index> vertex_of_solid; // of each vertex
};

// Returns edges of a mesh that form a random spanning tree of its vertices.
std::vector<char> random_tree(const Mesh& mesh, std::mt19937& random)
{
  std::vector<Edge_index> edges(mesh.edges().begin(), mesh.edges().end());
  std::shuffle(edges.begin(), edges.end(), random);
  boost::disjoint_sets_with_storage<> parts(mesh.number_of_vertices());
  for(Vertex_index v : mesh.vertices())
    parts.make_set(v.idx());
  std::vector<char> result(mesh.number_of_edges(), 0);
  for(Edge_index e : edges) {
    const std::size_t a = mesh.vertex(e, 0).idx(), b = mesh.vertex(e, 1).idx();
    if(parts.find_set(a) != parts.find_set(b)) {
      parts.union_set(a, b);
      result[e] = 1;
    }
  }
  return result;
}

// Lays the face of `h`, whose ends have their places, and all faces that follow across edges that
// are not cut. `place` and `corner` belong to the sources of halfedges.
void lay_out(Halfedge_index h, const Mesh& mesh, const std::vector<char>& is_cut, Net& net,
             std::vector<std::size_t>& corner, std::vector<Point>& place)
{
  const auto distance = [&](Halfedge_index x) {
    return distance_of(mesh.point(mesh.source(x)), mesh.point(mesh.target(x)));
  };
  const Halfedge_index next = mesh.next(h), last = mesh.prev(h);
  const Point &p = place[corner[h]], &q = place[corner[next]];
  const double c = distance(h), b = distance(last), a = distance(next),
               x = (b * b + c * c - a * a) / (2 * c), y = std::sqrt(b * b - x * x);
  const Kernel::Vector_3 u = (q - p) / c, v(-u.y(), u.x(), 0);
  corner[last] = place.size();
  place.push_back(p + x * u + y * v);
  net.vertex_of_solid.push_back(mesh.source(last));
  for(Halfedge_index side : {next, last})
    if(!is_cut[mesh.edge(side)]) {
      const Halfedge_index o = mesh.opposite(side);
      corner[o] = corner[mesh.next(side)];
      corner[mesh.next(o)] = corner[side];
      lay_out(o, mesh, is_cut, net, corner, place);
    }
}

// Cuts a convex mesh along a tree of edges, and unfolds it.
Net unfolded(const Mesh& mesh, const std::vector<char>& is_cut)
{
  Net result;
  std::vector<std::size_t> corner(mesh.number_of_halfedges());
  // All faces follow across its other sides.
  const Halfedge_index first =
    *std::find_if(mesh.halfedges().begin(), mesh.halfedges().end(),
                  [&](Halfedge_index h) { return is_cut[mesh.edge(h)] != 0; });
  const double length = std::sqrt(
    CGAL::squared_distance(mesh.point(mesh.source(first)), mesh.point(mesh.target(first))));
  std::vector<Point> place{Point(0, 0, 0), Point(length, 0, 0)};
  corner[first] = 0;
  corner[mesh.next(first)] = 1;
  result.vertex_of_solid = {mesh.source(first), mesh.target(first)};
  lay_out(first, mesh, is_cut, result, corner, place);
  Triangles triangles;
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    triangles.push_back({corner[h], corner[mesh.next(h)], corner[mesh.prev(h)]});
  }
  result.mesh = make_mesh(place, triangles);
  const auto in_net = [&](Halfedge_index h) {
    return result.mesh.halfedge(Vertex_index(unsigned(corner[h])),
                                Vertex_index(unsigned(corner[mesh.next(h)])));
  };
  for(Edge_index e : mesh.edges())
    if(is_cut[e])
      result.pairs.emplace_back(in_net(mesh.halfedge(e)), in_net(mesh.opposite(mesh.halfedge(e))));
  return result;
}

} // namespace

TEST(Archimedean_solids, have_equal_edges_and_their_circumradius)
{
  for(const Solid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    const std::vector<Point> points = vertices_of(solid);
    ASSERT_EQ(points.size(), solid.vertices);
    const Mesh hull = convex_hull(points);
    ASSERT_EQ(hull.number_of_vertices(), solid.vertices);
    std::mt19937 random(5);
    for(int sample = 0; sample < 2; ++sample) {
      Net net = unfolded(hull, random_tree(hull, random));
      EXPECT_EQ(net.mesh.number_of_vertices(), 2 * (solid.vertices - 1));
      const auto length = net.mesh.add_property_map<Edge_index, double>("e:length").first;
      IT::compute_edge_lengths(net.mesh, length);
      IT::Glued_surface glued = IT::glue_boundary(net.mesh, length, net.pairs);
      const IT::Convex_polyhedron p = IT::convex_polyhedron(
        glued.mesh, IT::parameters::edge_length_map(IT::stored_length_map<double>(glued.mesh)));
      EXPECT_TRUE(p.certificate().is_convex());
      ASSERT_EQ(p.points().size(), solid.vertices);
      // The closed forms are known.
      double edge = std::numeric_limits<double>::infinity();
      CGAL::Kernel_traits<IT::Convex_polyhedron::Point>::Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
      for(const auto& v : p.points()) {
        sum += v - CGAL::ORIGIN;
        for(const auto& w : p.points())
          if(&v != &w)
            edge = (std::min)(edge, distance_of(v, w));
      }
      const IT::Convex_polyhedron::Point center = CGAL::ORIGIN + sum / double(solid.vertices);
      std::size_t edges = 0;
      for(const auto& v : p.points()) {
        EXPECT_NEAR(distance_of(v, center), edge * solid.circumradius, 1e-9 * edge);
        for(const auto& w : p.points())
          edges += &v != &w && distance_of(v, w) < edge * (1 + 1e-9);
      }
      EXPECT_EQ(edges, 2 * solid.edges);
      // Every vertex has its position.
      std::vector<Vertex_index> folded(solid.vertices);
      for(Vertex_index v : net.mesh.vertices())
        folded[net.vertex_of_solid[v].idx()] = glued.vertices[v];
      for(std::size_t i = 0; i < points.size(); ++i)
        for(std::size_t j = 0; j < i; ++j)
          EXPECT_NEAR(distance_of(p.point(folded[i]), p.point(folded[j])),
                      distance_of(points[i], points[j]), 1e-9 * edge);
    }
  }
}
