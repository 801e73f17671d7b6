// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "equality.h"
#include "tied_meshes.h"

#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Flipped_paths.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/path_on_input.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>

#include <queue>

namespace Test_flipped_paths {

using namespace Test_surfaces;
using Halfedges = std::vector<Halfedge_index>;
using Pairs = std::vector<std::pair<Vertex_index, Vertex_index>>;

Pairs random_pairs(const Delta_complex& mesh, std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  Pairs result;
  while(result.size() < n) {
    const Vertex_index v = random_vertex(mesh, random);
    result.emplace_back(v, random_vertex(mesh, random));
  }
  return result;
}

// ---- Paths along edges ----

// Returns rounded distances from a vertex: the least values with d(w) <= d(v) + l(vw) for all
// edges.
template <typename Surface>
std::vector<double> distances_along_edges(const Surface& surface, Vertex_index source)
{
  const Delta_complex& mesh = surface.mesh();
  std::vector<double> result(mesh.num_vertices(), std::numeric_limits<double>::infinity());
  result[source] = 0;
  for(bool has_changed = true; has_changed;) {
    has_changed = false;
    for(Halfedge_index h : mesh.halfedges()) {
      const double d = result[mesh.source(h)] + get(surface.length_map(), mesh.edge(h));
      if(d < result[mesh.target(h)]) {
        result[mesh.target(h)] = d;
        has_changed = true;
      }
    }
  }
  return result;
}

// Returns the path that the documentation promises, backwards: of the halfedges that end a shortest
// path, the one with the least index.
template <typename Surface>
Halfedges expected_path(const Surface& surface, Vertex_index source, Vertex_index target)
{
  const Delta_complex& mesh = surface.mesh();
  const auto distance = distances_along_edges(surface, source);
  Halfedges result;
  if(distance[target] == std::numeric_limits<double>::infinity())
    return result;
  for(Vertex_index v = target; v != source; v = mesh.source(result.back())) {
    Halfedge_index last;
    for(Halfedge_index h : mesh.halfedges())
      if(mesh.target(h) == v && !last.is_valid() &&
         distance[mesh.source(h)] + get(surface.length_map(), mesh.edge(h)) == distance[v])
        last = h;
    result.push_back(last);
  }
  std::reverse(result.begin(), result.end());
  return result;
}

// Checks paths with searches from both ends, and with searches by landmarks: more than 256
// searches.
template <typename Surface>
void check_edge_paths(const Surface& surface, std::size_t n, unsigned int seed)
{
  const Pairs pairs = random_pairs(surface.mesh(), n, seed);
  IT::Shortest_edge_paths search(surface);
  for(const auto& [v, w] : pairs) {
    const Halfedges path = search.path(v, w);
    ASSERT_EQ(path, expected_path(surface, v, w)) << v << " " << w;
    ASSERT_EQ(path, IT::shortest_edge_path(surface, v, w)) << v << " " << w;
  }
}

TEST(Shortest_edge_paths, as_by_definition)
{
  for(const Named_mesh& m : traced(meshes()))
    check_edge_paths(Triangulation(m.mesh).input(), 300, 1);
}

TEST(Shortest_edge_paths, with_ties)
{
  for(std::uint64_t seed : seeds(10))
    check_edge_paths(Triangulation(tied_mesh(seed).mesh).input(), 300, 2);
  const Mesh plane = grid(12, 9, [](double x, double y) { return Point(4 * x, 3 * y, 0); });
  check_edge_paths(Triangulation(plane).input(), 300, 3);
}

// The complexes have loops and parallel edges, and lengths of different magnitudes.
TEST(Shortest_edge_paths, on_glued_complexes)
{
  for(const Named_complex& c : traced(complexes())) {
    std::vector<double> length = random_lengths(c.mesh, 4);
    for(std::size_t e = 0; e < length.size(); ++e)
      length[e] *= std::ldexp(1., static_cast<int>(e % 7) * 4 - 12);
    const auto map =
      boost::make_function_property_map<Edge_index>([&](Edge_index e) { return length[e.idx()]; });
    check_edge_paths(IT::Surface_view(c.mesh, map), 40, 5);
  }
}

TEST(Shortest_edge_paths, between_components)
{
  for(const Mesh& mesh : {four_components(), five_components()})
    check_edge_paths(Triangulation(mesh).input(), 300, 6);
}

// ---- Taking flips back ----

template <typename Traits>
void check_rewinding(IT::Intrinsic_triangulation<Traits> t, unsigned int seed)
{
  IT::Edge_paths<Traits> paths(t);
  const std::string before = text_of(t);
  const Delta_complex mesh = t.mesh();
  CGAL::Random random(seed);
  for(const auto& [v, w] : random_pairs(t.mesh(), 20, seed)) {
    if(t.mesh().is_isolated(v) || t.mesh().is_isolated(w))
      continue;
    const Halfedges start = IT::shortest_edge_path(t.intrinsic(), v, w);
    const double length = [&, v = v, w = w] {
      IT::Intrinsic_triangulation<Traits> copy = t;
      IT::Edge_paths<Traits> fresh(copy);
      fresh.add_path(IT::shortest_edge_path(copy.intrinsic(), v, w));
      fresh.shorten();
      return fresh.length(0);
    }();
    const std::size_t index = paths.add_path(start);
    EXPECT_EQ(index, 0u);
    paths.shorten();
    EXPECT_EQ(paths.length(0), length);
    paths.rewind();
    EXPECT_EQ(paths.number_of_flips(), 0u);
    EXPECT_EQ(text_of(t), before);
    expect_equal(t.mesh(), mesh);
  }
}

TEST(Edge_paths, flips_are_taken_back)
{
  for(const Named_mesh& m : traced(meshes())) {
    check_rewinding(Triangulation(m.mesh), 1);
    check_rewinding(IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>>(m.mesh), 2);
  }
  for(const Named_triangulation& t : traced(triangulations()))
    check_rewinding(t.triangulation, 3);
}

TEST(Edge_paths, loops_are_taken_back)
{
  for(const Flat_surface& surface : {flat_torus(5, 4, 1), flat_torus(2, 1, 2)}) {
    Triangulation t = triangulation<Triangulation::Traits>(surface);
    IT::Edge_paths paths(t);
    const std::string before = text_of(t);
    const Delta_complex mesh = t.mesh();
    CGAL::Random random(1);
    for(int i = 0; i < 30; ++i) {
      Halfedges walk;
      for(Vertex_index v(0); walk.size() < 9 || v != Vertex_index(0);) {
        Halfedges outgoing;
        IT::for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) { outgoing.push_back(h); });
        walk.push_back(
          outgoing[static_cast<std::size_t>(random.get_int(0, static_cast<int>(outgoing.size())))]);
        v = mesh.target(walk.back());
      }
      paths.add_loop(walk);
      paths.shorten();
      paths.rewind();
      EXPECT_EQ(text_of(t), before);
      expect_equal(t.mesh(), mesh);
    }
  }
}

// ---- Many pairs ----

void expect_same(const IT::Flipped_path<double>& a, const IT::Flipped_path<double>& b,
                 const Delta_complex& mesh)
{
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.number_of_flips, b.number_of_flips);
  EXPECT_EQ(a.path.length, b.path.length);
  EXPECT_EQ(a.length_along_edges, b.length_along_edges);
  ASSERT_EQ(a.path.places.size(), b.path.places.size());
  for(std::size_t i = 0; i < a.path.places.size(); ++i) {
    const auto &p = a.path.places[i], &q = b.path.places[i];
    EXPECT_EQ(IT::halfedge_of(p), IT::halfedge_of(q));
    EXPECT_EQ(IT::face_location(p, mesh), IT::face_location(q, mesh));
  }
}

IT::Flipped_path<double> path_alone(Triangulation t, Vertex_index v, Vertex_index w)
{
  IT::Edge_paths paths(t);
  paths.add_path(IT::shortest_edge_path(t.intrinsic(), v, w));
  const double before = paths.length(0);
  const auto status = paths.shorten();
  return {status, paths.number_of_flips(), IT::path_on_input(t, paths.halfedges(0)), before};
}

void check_pairs(const Triangulation& t)
{
  const Pairs pairs = random_pairs(t.mesh(), 60, 4);
  const auto paths = IT::flipped_paths(t, pairs);
  ASSERT_EQ(paths.size(), pairs.size());
  for(std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [v, w] = pairs[i];
    if(v != w && paths[i].path.length < std::numeric_limits<double>::infinity())
      expect_same(paths[i], path_alone(t, v, w), t.input_mesh());
    else {
      EXPECT_EQ(paths[i].path.places.size(), 0u);
      EXPECT_TRUE(IT::shortest_edge_path(t.intrinsic(), v, w).empty());
      EXPECT_EQ(v == w, paths[i].path.length == 0);
    }
  }
#ifdef CGAL_LINKED_WITH_TBB
  const auto parallel =
    IT::flipped_paths(t, pairs, IT::parameters::concurrency_tag(CGAL::Parallel_tag()));
  for(std::size_t i = 0; i < pairs.size(); ++i)
    expect_same(parallel[i], paths[i], t.input_mesh());
#endif
}

TEST(Flipped_paths, as_each_alone)
{
  for(const Named_mesh& m : traced(meshes()))
    check_pairs(Triangulation(m.mesh));
  for(const Named_triangulation& t : traced(triangulations()))
    check_pairs(t.triangulation);
  for(const Mesh& mesh : {four_components(), five_components()})
    check_pairs(Triangulation(mesh));
}

} // namespace Test_flipped_paths
