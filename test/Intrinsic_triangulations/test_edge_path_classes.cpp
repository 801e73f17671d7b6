// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "hard_meshes.h"
#include "known_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/path_on_input.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>
#include <boost/pending/disjoint_sets.hpp>

// Geodesics by flips stay in their homotopy class, and are geodesics of the exact surface.

namespace Test_edge_path_classes {

using namespace Test_surfaces;
using Halfedges = std::vector<Halfedge_index>;
using Exact_triangulation = IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>>;

// ---- Homotopy ----

// Represents a 2 x 2 matrix of determinant one, modulo a prime.
struct Matrix
{
  static constexpr std::uint64_t prime = 2147483647;
  std::uint64_t a = 1, b = 0, c = 0, d = 1;

  friend Matrix operator*(const Matrix& x, const Matrix& y)
  {
    return {(x.a * y.a + x.b * y.c) % prime, (x.a * y.b + x.b * y.d) % prime,
            (x.c * y.a + x.d * y.c) % prime, (x.c * y.b + x.d * y.d) % prime};
  }
  Matrix inverse() const { return {d, (prime - b) % prime, (prime - c) % prime, a}; }
  bool operator==(const Matrix& m) const { return a == m.a && b == m.b && c == m.c && d == m.d; }
};

using Disjoint_sets = boost::disjoint_sets_with_storage<>;

// Returns whether the two were not together.
bool join(std::size_t i, std::size_t k, Disjoint_sets& sets)
{
  const bool result = sets.find_set(i) != sets.find_set(k);
  sets.union_set(i, k);
  return result;
}

// Represents a random homomorphism of the fundamental groupoid: each edge has a matrix, and the
// product around each face is one. On a surface with boundary the group is free, and different
// classes have equal matrices with a probability of about 1e-9. On a closed surface matrices
// commute, which distinguishes classes of homology.
class Holonomy
{
public:
  Holonomy(const Delta_complex& mesh, std::uint64_t seed)
    : m_mesh(mesh), m_is_closed(CGAL::is_closed(mesh)), m_matrix(mesh.num_edges())
  {
    const std::vector<Edge_index> dual_tree = choose(seed);
    complete(dual_tree);
  }

  bool is_closed() const { return m_is_closed; }
  // Returns one halfedge for each generator.
  const Halfedges& generators() const { return m_generators; }

  Matrix operator()(Halfedge_index h) const
  {
    const Matrix& m = m_matrix[Edge_index(h).idx()];
    return IT::is_first_halfedge(h) ? m : m.inverse();
  }

  Matrix operator()(const Halfedges& path) const
  {
    Matrix product;
    for(Halfedge_index h : path)
      product = product * (*this)(h);
    return product;
  }

  bool is_flat() const
  {
    for(Face_index f : m_mesh.faces()) {
      const Halfedge_index h = m_mesh.halfedge(f);
      if(!((*this)(Halfedges{h, m_mesh.next(h), m_mesh.prev(h)}) == Matrix()))
        return false;
    }
    return true;
  }

private:
  // Returns a face; the outside of the boundary is one face.
  std::size_t face(Halfedge_index h) const
  {
    return m_mesh.is_border(h) ? m_mesh.num_faces() : m_mesh.face(h).idx();
  }

  // Chooses random matrices for the edges in neither tree. Returns the edges that the dual tree
  // crosses.
  std::vector<Edge_index> choose(std::uint64_t seed)
  {
    Portable_random random(seed);
    const auto number = [&] { return static_cast<std::uint64_t>(random.get_int(1, 1 << 30)); };
    Disjoint_sets vertices(m_mesh.num_vertices()), faces(m_mesh.num_faces() + 1);
    std::vector<Edge_index> rest, dual_tree;
    for(Edge_index e : m_mesh.edges())
      if(!join(m_mesh.vertex(e, 0).idx(), m_mesh.vertex(e, 1).idx(), vertices))
        rest.push_back(e);
    for(Edge_index e : rest) {
      const Halfedge_index h = m_mesh.halfedge(e);
      if(join(face(h), face(m_mesh.opposite(h)), faces)) {
        dual_tree.push_back(e);
        continue;
      }
      m_generators.push_back(h);
      m_matrix[e.idx()] = Matrix{1, number(), 0, 1};
      if(!m_is_closed)
        m_matrix[e.idx()] = m_matrix[e.idx()] * Matrix{1, 0, number(), 1};
    }
    return dual_tree;
  }

  // Computes the last edge of each face from the others, starting with the leaves of the dual tree.
  // The root is beyond the boundary, or face 0.
  void complete(const std::vector<Edge_index>& dual_tree)
  {
    const std::size_t root = m_is_closed ? 0 : m_mesh.num_faces();
    std::vector<Halfedges> open(m_mesh.num_faces() + 1);
    for(Edge_index e : dual_tree)
      for(Halfedge_index h : {m_mesh.halfedge(e), m_mesh.opposite(m_mesh.halfedge(e))})
        open[face(h)].push_back(h);
    std::vector<std::size_t> leaves;
    for(std::size_t f = 0; f < open.size(); ++f)
      if(open[f].size() == 1 && f != root)
        leaves.push_back(f);
    while(!leaves.empty()) {
      const std::size_t f = leaves.back();
      leaves.pop_back();
      const Halfedge_index h = open[f].front(), o = m_mesh.opposite(h);
      const Matrix m = (*this)(Halfedges{m_mesh.next(h), m_mesh.prev(h)}).inverse();
      m_matrix[Edge_index(h).idx()] = IT::is_first_halfedge(h) ? m : m.inverse();
      Halfedges& across = open[face(o)];
      across.erase(std::find(across.begin(), across.end(), o));
      if(across.size() == 1 && face(o) != root)
        leaves.push_back(face(o));
    }
  }

  const Delta_complex& m_mesh;
  bool m_is_closed;
  std::vector<Matrix> m_matrix;
  Halfedges m_generators;
};

// Returns the matrix along an edge of T2, which is pushed to the sources of the halfedges that it
// crosses.
Matrix along_edge(Halfedge_index e, const Triangulation& t, const Holonomy& holonomy)
{
  if(t.coordinates().is_shared(t.mesh().edge(e)))
    return holonomy(t.input_halfedge(e));
  const Delta_complex& input = t.input_mesh();
  const auto places = IT::path_on_input(t, Halfedges{e}).places;
  Matrix product;
  Halfedge_index h = IT::halfedge_of(places[0]);
  for(std::size_t i = 1; i < places.size(); ++i) {
    const Halfedge_index end = i + 1 < places.size()
                                 ? IT::halfedge_of(places[i])
                                 : input.prev(input.opposite(IT::halfedge_of(places[i - 1])));
    for(; h != end; h = input.next(h))
      product = product * holonomy(h);
    h = input.next(input.opposite(end));
  }
  return product;
}

Matrix along_path(const Halfedges& path, const Triangulation& t, const Holonomy& holonomy)
{
  Matrix product;
  for(Halfedge_index e : path)
    product = product * along_edge(e, t, holonomy);
  return product;
}

// Checks paths through three vertices, with a generator between two of them.
void check_classes(const Mesh& mesh, int n, std::uint64_t seed)
{
  Triangulation t(mesh);
  const Holonomy holonomy(t.input_mesh(), seed);
  ASSERT_TRUE(holonomy.is_flat());
  Portable_random random(seed);
  const auto append = [&](Halfedges& path, Vertex_index v, Vertex_index w) {
    const Halfedges part = IT::shortest_edge_path(t.input(), v, w);
    path.insert(path.end(), part.begin(), part.end());
  };
  for(int i = 0; i < n; ++i) {
    const Delta_complex& input = t.input_mesh();
    const Vertex_index v = random_vertex(input, random), w = random_vertex(input, random);
    const bool is_loop = i % 2 == 1;
    Halfedges path;
    if(const Halfedges& all = holonomy.generators(); !all.empty()) {
      const Halfedge_index g =
        all[static_cast<std::size_t>(random.get_int(0, static_cast<int>(all.size())))];
      append(path, v, input.source(g));
      path.push_back(g);
      append(path, input.target(g), w);
    } else
      append(path, v, w);
    if(is_loop)
      append(path, w, v);
    if(path.empty())
      continue;
    t.reset_to_input();
    IT::Edge_paths paths(t);
    is_loop ? paths.add_loop(path) : paths.add_path(path);
    const double before = paths.length(0);
    paths.shorten();
    EXPECT_LE(paths.length(0), before * (1 + 1e-12));
    const Matrix expected = holonomy(path), found = along_path(paths.halfedges(0), t, holonomy);
    if(is_loop) { // conjugate
      EXPECT_EQ((expected.a + expected.d) % Matrix::prime, (found.a + found.d) % Matrix::prime);
      if(holonomy.is_closed()) {
        EXPECT_EQ(expected.b, found.b);
      }
    } else {
      EXPECT_TRUE(expected == found);
    }
  }
}

TEST(Edge_path_classes, are_kept)
{
  for(const Named_mesh& m : traced(meshes()))
    check_classes(m.mesh, 40, 1);
}

TEST(Edge_path_classes, are_kept_on_hard_meshes)
{
  for(const auto& [m, seed] : traced(48, hard_mesh))
    check_classes(m.mesh, 10, seed);
}

TEST(Edge_path_classes, are_kept_on_data_meshes)
{
  for_data_meshes({"3torus.off", "anchor.off", "elephant.off", "pig.off"}, [](const Mesh& mesh) {
    if(CGAL::is_triangle_mesh(mesh)) {
      check_classes(mesh, 40, 2);
      check_classes(punctured(mesh, {5}), 40, 3); // a free group
    }
  });
}

// ---- Truth ----

// With lengths of type `double`, paths equal the results of exact decisions, on meshes whose angles
// rounding does not resolve.
TEST(Edge_path_classes, are_exact_on_hard_meshes)
{
  for(const auto& [m, seed] : traced(36, hard_mesh)) {
    Triangulation rounded(m.mesh);
    Exact_triangulation exact(m.mesh);
    Portable_random random(seed);
    for(int i = 0; i < 4; ++i) {
      const Halfedges path =
        IT::shortest_edge_path(rounded.input(), random_vertex(rounded.input_mesh(), random),
                               random_vertex(rounded.input_mesh(), random));
      rounded.reset_to_input();
      exact.reset_to_input();
      IT::Edge_paths paths(rounded);
      IT::Edge_paths truth(exact);
      paths.add_path(path);
      truth.add_path(path);
      EXPECT_EQ(paths.shorten(), truth.shorten());
      EXPECT_TRUE(paths.is_geodesic());
      EXPECT_NEAR(paths.length(0), truth.length(0), 1e-11 * truth.length(0));
    }
  }
}

// If a flat surface has no holes, the only geodesic is the shortest path. Rounded lengths determine
// the shape of the thinnest triangles to half of their digits. A search by them finds no path that
// is shorter by more.
TEST(Edge_path_classes, are_shortest_in_flat_disks)
{
  for(std::uint64_t seed : seeds(20)) {
    Portable_random random(seed);
    Triangulation t(saw_teeth(20, 5, random.get_double(0.001, 0.9), false, random));
    for(int i = 0; i < 10; ++i) {
      const Vertex_index v = random_vertex(t.input_mesh(), random),
                         w = random_vertex(t.input_mesh(), random);
      t.reset_to_input();
      IT::Edge_paths paths(t);
      paths.add_path(IT::shortest_edge_path(t.input(), v, w));
      EXPECT_EQ(paths.shorten(), IT::Shortening_status::geodesic);
      IT::Shortest_paths shortest(t.input());
      shortest.add_source(v);
      shortest.run();
      EXPECT_LE(paths.length(0), shortest.distance(w) + 1e-6);
    }
  }
}

} // namespace Test_edge_path_classes
