// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Dijkstra_search.h>
#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Tree_cotree.h>
#include <CGAL/Intrinsic_triangulations/geodesic_homology_basis.h>
#include <CGAL/Intrinsic_triangulations/homology_basis.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

namespace Test_homology_basis {

using namespace Test_surfaces;
using Halfedges = std::vector<Halfedge_index>;
using Chain = std::map<std::size_t, std::uint64_t>; // of edges

constexpr std::uint64_t prime = 2147483647;

std::uint64_t inverse(std::uint64_t x)
{
  std::uint64_t result = 1;
  for(std::uint64_t n = prime - 2; n > 0; n /= 2, x = x * x % prime)
    if(n % 2 == 1)
      result = result * x % prime;
  return result;
}

Chain chain(const Halfedges& halfedges)
{
  Chain result;
  for(Halfedge_index h : halfedges) {
    std::uint64_t& sum = result[Edge_index(h).idx()];
    sum = (sum + (h.idx() % 2 == 0 ? 1 : prime - 1)) % prime;
    if(sum == 0)
      result.erase(Edge_index(h).idx());
  }
  return result;
}

// Represents chains of edges modulo a prime, in echelon form.
class Chain_space
{
public:
  // Returns whether the chain was not in the space.
  bool add(Chain c)
  {
    while(!c.empty() && m_row.count(c.begin()->first) > 0) {
      const std::uint64_t factor = prime - c.begin()->second;
      for(const auto& [edge, value] : m_row[c.begin()->first]) {
        c[edge] = (c[edge] + factor * value) % prime;
        if(c[edge] == 0)
          c.erase(edge);
      }
    }
    if(c.empty())
      return false;
    const std::uint64_t factor = inverse(c.begin()->second);
    for(auto& entry : c)
      entry.second = entry.second * factor % prime;
    m_row[c.begin()->first] = c;
    return true;
  }

private:
  std::map<std::size_t, Chain> m_row; // by their first edges
};

// Returns the space of all boundaries of faces.
Chain_space boundaries(const Delta_complex& mesh)
{
  Chain_space result;
  for(Face_index f : mesh.faces()) {
    const auto side = IT::sides(f, mesh);
    result.add(chain({side.begin(), side.end()}));
  }
  return result;
}

bool is_closed(const Halfedges& loop, const Delta_complex& mesh)
{
  for(std::size_t i = 0; i < loop.size(); ++i)
    if(mesh.target(loop[i]) != mesh.source(loop[(i + 1) % loop.size()]) ||
       (loop.size() > 1 && loop[(i + 1) % loop.size()] == mesh.opposite(loop[i])))
      return false;
  return !loop.empty();
}

// Returns the rank of the first homology group of a connected surface.
std::size_t rank(const Delta_complex& mesh)
{
  return std::size_t((border_loops(mesh) == 0 ? 2 : 1) - Euler_characteristic(mesh));
}

// Checks that loops are a basis (over a field): they are independent of each other and of
// boundaries, and their number is the rank.
void expect_basis(const std::vector<Halfedges>& loops, const Delta_complex& mesh,
                  std::size_t expected_rank)
{
  EXPECT_EQ(loops.size(), expected_rank);
  Chain_space space = boundaries(mesh);
  for(const Halfedges& loop : loops) {
    EXPECT_TRUE(is_closed(loop, mesh));
    EXPECT_TRUE(space.add(chain(loop)));
  }
}

// ---- Searches and trees ----

// Shortest paths by Bellman and Ford add the same lengths in the same order.
TEST(Dijkstra_search, against_relaxation)
{
  for(const Named_complex& c : traced(complexes())) {
    const auto lengths = random_lengths(c.mesh, 1);
    const auto t = triangulation(c.mesh, lengths);
    const Delta_complex& mesh = t.mesh();
    IT::Dijkstra_search<Vertex_index, double> search(mesh.num_vertices());
    for(Vertex_index root : {Vertex_index(0), Vertex_index(mesh.num_vertices() - 1)}) {
      std::vector<double> distance(mesh.num_vertices(), 1e300);
      distance[root.idx()] = 0;
      for(std::size_t round = 0; round < mesh.num_vertices(); ++round)
        for(Halfedge_index h : mesh.halfedges())
          distance[mesh.target(h).idx()] =
            (std::min)(distance[mesh.target(h).idx()],
                       distance[mesh.source(h).idx()] + t.length(mesh.edge(h)));
      search.restart();
      search.reach(root, 0);
      double last = 0;
      std::size_t count = 0;
      for(Vertex_index v = search.next(); v.is_valid(); v = search.next(), ++count) {
        EXPECT_EQ(search.distance(v), distance[v.idx()]);
        EXPECT_GE(search.distance(v), last);
        EXPECT_TRUE(search.is_final(v));
        last = search.distance(v);
        if(v != root) {
          const Halfedge_index h = search.entry(v);
          EXPECT_EQ(mesh.target(h), v);
          EXPECT_EQ(distance[mesh.source(h).idx()] + t.length(mesh.edge(h)), last);
        }
        IT::for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
          search.reach(mesh.target(h), distance[v.idx()] + t.length(mesh.edge(h)), h);
        });
      }
      EXPECT_EQ(count, mesh.number_of_vertices());
    }
  }
}

TEST(Mesh_components, against_relaxation)
{
  Mesh m = embedded_torus(6, 5);
  m.add_vertex(Point(9, 9, 9));
  m += random_sphere(20, 3);
  m.add_vertex(Point(8, 8, 8));
  m += punctured(embedded_torus(5, 4), {7, 20});
  const IT::Intrinsic_triangulation<> t(m);
  const Delta_complex& mesh = t.mesh();
  std::vector<std::size_t> first(mesh.num_vertices()); // the first vertex of each component
  for(std::size_t v = 0; v < first.size(); ++v)
    first[v] = v;
  for(std::size_t round = 0; round < first.size(); ++round)
    for(Halfedge_index h : mesh.halfedges())
      first[mesh.target(h).idx()] =
        (std::min)(first[mesh.target(h).idx()], first[mesh.source(h).idx()]);
  const IT::Mesh_components components(mesh);
  EXPECT_EQ(components.size(), 5u);
  std::size_t next = 0;
  for(std::size_t v = 0; v < first.size(); ++v)
    EXPECT_EQ(components[v], first[v] == v ? next++ : components[first[v]]);
}

// Checks that both trees have the correct number of edges and no cycle, and the number of other
// edges is twice the genus.
void expect_trees(const IT::Tree_cotree& trees, const Delta_complex& mesh, std::size_t faces,
                  std::size_t generators)
{
  EXPECT_EQ(trees.number_of_components(), 1u);
  EXPECT_EQ(trees.steps().size(), faces);
  EXPECT_EQ(trees.generators(0).size(), generators);
  std::set<std::size_t> reached, joined;
  for(const auto& step : trees.steps()) {
    EXPECT_EQ(step.entry.is_valid(), !reached.empty());
    if(step.entry.is_valid()) {
      EXPECT_EQ(trees.face(step.entry), step.face);
      EXPECT_EQ(reached.count(trees.face(mesh.opposite(step.entry)).idx()), 1u);
      EXPECT_FALSE(trees.is_open(mesh.edge(step.entry)));
      joined.insert(Edge_index(step.entry).idx());
    }
    EXPECT_TRUE(reached.insert(step.face.idx()).second);
  }
  std::size_t tree = 0, closed = 0;
  std::vector<char> is_connected(mesh.num_vertices(), 0);
  is_connected[mesh
                 .target(mesh.halfedge(trees.generators(0).empty() ? *mesh.edges().begin()
                                                                   : trees.generators(0).front()))
                 .idx()] = 1;
  for(Edge_index e : mesh.edges()) {
    tree += trees.is_in_tree(e);
    closed += !trees.is_open(e);
    EXPECT_FALSE(trees.is_in_tree(e) && !trees.is_open(e));
  }
  EXPECT_EQ(closed, joined.size());
  EXPECT_EQ(tree, mesh.number_of_vertices() - 1);
  for(std::size_t round = 0; round < mesh.num_vertices(); ++round)
    for(Halfedge_index h : mesh.halfedges())
      if(trees.is_in_tree(mesh.edge(h)) && is_connected[mesh.source(h).idx()])
        is_connected[mesh.target(h).idx()] = 1;
  EXPECT_EQ(std::count(is_connected.begin(), is_connected.end(), 1),
            std::ptrdiff_t(mesh.number_of_vertices()));
}

TEST(Tree_cotree, all_surfaces)
{
  for(const Named_complex& c : traced(complexes())) {
    const std::size_t borders = border_loops(c.mesh), faces = c.mesh.number_of_faces();
    const std::size_t twice_genus = rank(c.mesh) + 1 - (std::max)(borders, std::size_t(1));
    expect_trees(IT::Tree_cotree(c.mesh), c.mesh, faces + borders, twice_genus);
    expect_trees(IT::Tree_cotree(c.mesh, IT::Boundary_loops::open), c.mesh,
                 faces + (std::min)(borders, std::size_t(1)), rank(c.mesh));
    if(borders > 0)
      continue;
    for(unsigned int seed = 0; seed < 3; ++seed) {
      const auto t = triangulation(c.mesh, random_lengths(c.mesh, seed));
      std::vector<double> lengths(c.mesh.num_edges());
      for(Edge_index e : c.mesh.edges())
        lengths[e.idx()] = t.length(e);
      const IT::Tree_cotree trees(c.mesh, lengths);
      expect_trees(trees, c.mesh, faces, twice_genus);
      // Each generator is crossed once in either direction.
      const Halfedges relation = trees.relation(0);
      EXPECT_EQ(relation.size(), 2 * twice_genus);
      EXPECT_EQ(std::set<Halfedge_index>(relation.begin(), relation.end()).size(), relation.size());
    }
  }
}

// Edges are closed until only terminals have a single open edge.
TEST(Cut_graph, ends_are_closed)
{
  for(const Named_complex& c : traced(complexes())) {
    std::vector<char> is_terminal(c.mesh.num_vertices(), 0);
    is_terminal.front() = is_terminal.back() = 1;
    IT::Tree_cotree trees(c.mesh);
    trees.close_ends(is_terminal);
    std::vector<int> count(c.mesh.num_vertices(), 0);
    std::size_t seams = 0, open = 0;
    for(Edge_index e : c.mesh.edges()) {
      EXPECT_TRUE(trees.is_open(e) || !trees.is_seam(e));
      seams += trees.is_seam(e);
      open += trees.is_open(e);
      for(unsigned int i : {0u, 1u})
        count[c.mesh.vertex(e, i).idx()] += trees.is_seam(e);
    }
    std::size_t isolated = 0;
    for(Vertex_index v : c.mesh.vertices()) {
      EXPECT_FALSE(count[v.idx()] == 1 && !is_terminal[v.idx()]);
      EXPECT_TRUE(count[v.idx()] > 0 || !is_terminal[v.idx()] || c.mesh.number_of_vertices() == 1);
      isolated += count[v.idx()] == 0;
    }
    // The remaining surface is connected and has the same cycles.
    EXPECT_EQ(open - seams, isolated - (isolated == c.mesh.number_of_vertices() ? 1 : 0));
  }
}

// Each seam begins a corner, which reaches to the next seam around its vertex.
TEST(Cut_graph, corners_lie_between_seams)
{
  for(const Named_complex& c : complexes()) {
    SCOPED_TRACE(c.name);
    IT::Tree_cotree trees(c.mesh);
    trees.close_ends(std::vector<char>(c.mesh.num_vertices(), 0));
    std::map<Halfedge_index, Halfedge_index> first;
    std::set<Vertex_index> without_seam;
    for(Vertex_index v : c.mesh.vertices())
      if(!c.mesh.is_isolated(v)) {
        without_seam.insert(v);
        trees.for_each_corner(v, [&](Halfedge_index h, Halfedge_index corner) {
          EXPECT_EQ(c.mesh.source(h), v);
          EXPECT_TRUE(first.emplace(h, corner).second);
          if(trees.is_seam(Edge_index(h)))
            without_seam.erase(v);
        });
      }
    EXPECT_EQ(first.size(), c.mesh.num_halfedges());
    std::size_t corners = 0;
    for(const auto& [h, corner] : first) {
      corners += h == corner;
      if(trees.is_seam(Edge_index(h)))
        EXPECT_EQ(corner, h);
      else
        EXPECT_EQ(corner, first.at(IT::previous_around_source(h, c.mesh)));
    }
    std::size_t ends_of_seams = 0;
    for(Halfedge_index h : c.mesh.halfedges())
      ends_of_seams += trees.is_seam(Edge_index(h));
    EXPECT_EQ(corners, ends_of_seams + without_seam.size());
  }
}

// ---- Bases ----

TEST(Homology_basis, all_surfaces)
{
  for(const auto& [c, seed] : traced(complexes(), 10)) {
    const auto lengths = random_lengths(c.mesh, seed);
    const auto t = triangulation(c.mesh, lengths);
    expect_basis(IT::homology_basis(t), t.mesh(), rank(t.mesh()));
  }
}

// The expected values are the paths of the loops of the torus.
TEST(Homology_basis, is_integral)
{
  for(unsigned int seed = 0; seed < 20; ++seed) {
    const Flat_surface torus = flat_torus(5, 4, seed);
    const auto t = triangulation(torus);
    const auto loops = IT::homology_basis(t);
    ASSERT_EQ(loops.size(), 2u);
    Vector sum[2] = {{0, 0}, {0, 0}};
    for(std::size_t i = 0; i < 2; ++i)
      for(Halfedge_index h : loops[i])
        sum[i] = sum[i] + torus.vector[h];
    EXPECT_EQ(std::abs(det(sum[0], sum[1])), std::abs(det(torus.a, torus.b))) << seed;
  }
}

TEST(Homology_basis, components_and_isolated_vertices)
{
  Mesh mesh = embedded_torus(6, 5);
  mesh.add_vertex(Point(9, 9, 9));
  mesh += punctured(embedded_torus(5, 4), {7, 20});
  mesh += random_sphere(20, 3);
  const IT::Intrinsic_triangulation<> t(mesh);
  expect_basis(IT::homology_basis(t), t.mesh(), 2 + 3);
}

// ---- Short loops ----

double length(const Halfedges& loop, const IT::Intrinsic_triangulation<>& t)
{
  double sum = 0;
  for(Halfedge_index h : loop)
    sum += t.length(t.mesh().edge(h));
  return sum;
}

double sum_of_lengths(const std::vector<Halfedges>& loops, const IT::Intrinsic_triangulation<>& t)
{
  double sum = 0;
  for(const Halfedges& loop : loops)
    sum += length(loop, t);
  return sum;
}

// Returns the last halfedges of all shortest paths from one vertex, by Bellman and Ford.
std::vector<Halfedge_index> shortest_path_tree(Vertex_index root,
                                               const IT::Intrinsic_triangulation<>& t)
{
  const Delta_complex& mesh = t.mesh();
  std::vector<double> distance(mesh.num_vertices(), 1e300);
  std::vector<Halfedge_index> entry(mesh.num_vertices());
  distance[root.idx()] = 0;
  for(bool has_changed = true; has_changed;) {
    has_changed = false;
    for(Halfedge_index h : mesh.halfedges())
      if(const double d = distance[mesh.source(h).idx()] + t.length(mesh.edge(h));
         d < distance[mesh.target(h).idx()]) {
        distance[mesh.target(h).idx()] = d;
        entry[mesh.target(h).idx()] = h;
        has_changed = true;
      }
  }
  return entry;
}

Halfedges path_to(Vertex_index v, const std::vector<Halfedge_index>& entry,
                  const Delta_complex& mesh)
{
  Halfedges result;
  for(Halfedge_index h = entry[v.idx()]; h.is_valid(); h = entry[mesh.source(h).idx()])
    result.insert(result.begin(), h);
  return result;
}

// Returns the length of a shortest basis. Candidates are the loops that all edges close along the
// shortest paths from all vertices. The shortest independent ones are chosen.
double length_of_shortest_basis(const IT::Intrinsic_triangulation<>& t)
{
  const Delta_complex& mesh = t.mesh();
  std::multimap<double, Chain> loops;
  for(Vertex_index v : mesh.vertices()) {
    const auto entry = shortest_path_tree(v, t);
    for(Edge_index e : mesh.edges()) {
      const Halfedge_index h = mesh.halfedge(e);
      Halfedges loop = path_to(mesh.source(h), entry, mesh);
      loop.push_back(h);
      const Halfedges back = path_to(mesh.target(h), entry, mesh);
      for(auto x = back.rbegin(); x != back.rend(); ++x)
        loop.push_back(mesh.opposite(*x));
      loops.emplace(length(loop, t), chain(loop));
    }
  }
  Chain_space space = boundaries(mesh);
  double sum = 0;
  for(const auto& [l, c] : loops)
    sum += space.add(c) ? l : 0;
  return sum;
}

TEST(Homology_basis, is_shortest)
{
  for(const auto& [c, seed] : traced(complexes(), 3)) {
    const auto t = triangulation(c.mesh, random_lengths(c.mesh, seed));
    const double expected = length_of_shortest_basis(t);
    EXPECT_NEAR(sum_of_lengths(IT::homology_basis(t), t), expected, 1e-12 * expected);
  }
}

double geodesic_length(const Halfedges& loop, const IT::Intrinsic_triangulation<>& t)
{
  IT::Intrinsic_triangulation<> copy = t;
  IT::Edge_paths paths(copy);
  paths.add_loop(loop);
  paths.shorten();
  return paths.length(0);
}

// On a flat torus, geodesics have the lengths of the shortest independent vectors of its lattice.
TEST(Homology_basis, geodesics_of_flat_tori)
{
  const std::vector<std::pair<Vector, Vector>> cells{
    {{1000, 130}, {-270, 900}}, {{1000, 0}, {900, 500}}, {{1000, 0}, {-700, 600}}};
  for(const auto& [right, up] : cells)
    for(unsigned int seed = 0; seed < 5; ++seed) {
      const Flat_surface torus = flat_torus(5, 4, seed, right, up);
      auto t = triangulation(torus);
      IT::make_Delaunay(t); // a shortest geodesic may need many edges of other triangulations
      std::multimap<double, Vector> lattice;
      for(std::int64_t i = -9; i <= 9; ++i)
        for(std::int64_t j = -9; j <= 9; ++j)
          if(i != 0 || j != 0)
            lattice.emplace(length(i * torus.a + j * torus.b), i * torus.a + j * torus.b);
      const Vector shortest = lattice.begin()->second;
      while(det(shortest, lattice.begin()->second) == 0)
        lattice.erase(lattice.begin());
      const auto loops = IT::homology_basis(
        t.intrinsic(), [&](const Halfedges& loop) { return geodesic_length(loop, t); });
      ASSERT_EQ(loops.size(), 2u);
      EXPECT_NEAR(geodesic_length(loops[0], t), length(shortest), 1e-9) << seed;
      EXPECT_NEAR(geodesic_length(loops[1], t), lattice.begin()->first, 1e-9) << seed;
    }
}

// Two base vertices of a torus of revolution find only the outer equator, but the inner one is
// shorter.
TEST(Homology_basis, inner_equator)
{
  const std::size_t n = 24;
  const double turn = 2 * std::acos(-1.) / n;
  Mesh mesh = embedded_torus(n, n);
  for(Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    const double r = std::hypot(p.x(), p.y());
    mesh.point(v) = Point(p.x() * (r - 1) / r, p.y() * (r - 1) / r, p.z());
  }
  const IT::Intrinsic_triangulation<> t(mesh);
  for(const Halfedges& loop : IT::homology_basis(t))
    EXPECT_NEAR(length(loop, t), n * 2 * std::sin(turn / 2), 1e-12);
}

TEST(Homology_basis, all_loops_become_geodesics)
{
  for(const Named_mesh& m : traced(meshes())) {
    IT::Intrinsic_triangulation<> t(m.mesh);
    for(const Halfedges& loop : IT::homology_basis(t)) {
      IT::Intrinsic_triangulation<> copy = t;
      IT::Edge_paths paths(copy);
      paths.add_loop(loop);
      const double before = paths.length(0);
      EXPECT_EQ(paths.shorten(), IT::Shortening_status::geodesic);
      EXPECT_LE(paths.length(0), before * (1 + 1e-12));
      EXPECT_FALSE(paths.halfedges(0).empty()); // not contractible
    }
  }
}

bool has_loop(const Delta_complex& mesh)
{
  return std::any_of(mesh.edges().begin(), mesh.edges().end(),
                     [&](Edge_index e) { return mesh.vertex(e, 0) == mesh.vertex(e, 1); });
}

// Each loop is shortened from a loop along edges, and its pieces on faces add up to its length. The
// ends of an edge that is a loop are one point, which determines no piece.
TEST(Homology_basis, of_geodesics)
{
  for(const Named_complex& c : traced(complexes())) {
    auto t = triangulation(c.mesh, random_lengths(c.mesh, 2));
    IT::make_Delaunay(t);
    const auto loops = IT::geodesic_homology_basis(t);
    EXPECT_EQ(loops.size(), rank(c.mesh));
    double last = 0;
    for(const auto& loop : loops) {
      EXPECT_GE(loop.path.length, last);
      last = loop.path.length;
      EXPECT_LE(loop.path.length, loop.length_along_edges * (1 + 1e-12));
      ASSERT_GE(loop.path.places.size(), 2u);
      if(has_loop(c.mesh))
        continue;
      const auto curve = IT::curve_through(t.input(), loop.path.places);
      EXPECT_NEAR(IT::curve_length(t.input(), curve), loop.path.length, 1e-11 * loop.path.length);
    }
  }
}

} // namespace Test_homology_basis
